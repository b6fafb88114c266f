using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>A client's session with a server: login, characters, entering and leaving the world (specification 08, section 3). It reads no
/// clock and knows no socket: datagrams and the time come in, datagrams and messages go out. <see cref="WorldSession"/> gives it both. It
/// is not safe for several threads.</summary>
public sealed class ClientSession
{
    private const double PingInterval = 120;

    private readonly ClientSessionOptions options;
    private readonly ClientLink link;
    private readonly ObjectRequests requests = new();
    private readonly Relay relay;
    private readonly byte[] scratch = new byte[FragmentAssembler.MostLength];
    private double now, opened, lastPing;
    private uint actionStamp, entering;

    /// <summary>A session that has not begun.</summary>
    /// <param name="options">Who logs in.</param>
    /// <param name="sink">Sends datagrams to the server.</param>
    public ClientSession(ClientSessionOptions options, IDatagramSink sink)
    {
        this.options = options;
        relay = new Relay(this);
        link = new ClientLink(
            new LoginRequest(options.Version, LoginRequest.PasswordAuth, 0, options.Stamp, options.Account, options.Password), sink);
    }

    /// <summary>How far it has come.</summary>
    public SessionState State { get; private set; }

    /// <summary>Why the session ended by itself; null while it has not.</summary>
    public SessionFailure? Failure { get; private set; }

    /// <summary>Why the last wish to enter the world was refused; null when it was not.</summary>
    public SessionFailure? Refusal { get; private set; }

    /// <summary>The account's characters and its name as the server keeps it; null before they are known.</summary>
    public CharacterList? Characters { get; private set; }

    /// <summary>Name of the server's world; null before it is known.</summary>
    public ServerName? Server { get; private set; }

    /// <summary>What came of the last character that was to be made; null before.</summary>
    public CharacterCreateResponse? Creation { get; private set; }

    /// <summary>The player's object; 0 outside of the world.</summary>
    public uint Player { get; private set; }

    /// <summary>What the session has counted.</summary>
    public SessionStatistics Statistics => link.Statistics;

    /// <summary>Seconds that the last echo took; null before the first.</summary>
    public double? RoundTrip => link.RoundTrip;

    /// <summary>Seconds since the server was heard last.</summary>
    public double SilentFor => now - link.LastReceived;

    /// <summary>The server's clock now, as last heard and counted on; null before it was heard.</summary>
    public double? ServerTime => link.Clock is { } clock ? clock.ServerTime + (now - clock.At) : null;

    /// <summary>Packets of the server that are waited for.</summary>
    public int MissingPackets => link.MissingPackets;

    /// <summary>Asks the server for a session.</summary>
    /// <param name="now">The time, seconds; it never goes back.</param>
    /// <exception cref="InvalidOperationException">It has begun already.</exception>
    public void Connect(double now)
    {
        if (State != SessionState.Idle)
            throw new InvalidOperationException("A session connects once; make another one.");
        this.now = opened = now;
        State = SessionState.Connecting;
        link.Open(now);
    }

    /// <summary>Takes a datagram that came from the server's address.</summary>
    /// <param name="datagram">Its bytes.</param>
    /// <param name="now">The time, seconds.</param>
    /// <param name="handler">Told what it brings.</param>
    public void Receive(ReadOnlySpan<byte> datagram, double now, ISessionHandler handler)
    {
        this.now = now;
        relay.Handler = handler;
        link.Receive(datagram, now, relay);
        FollowLink(handler);
    }

    /// <summary>Does what time asks for, and sends what has been put together. To be called often: at least every tenth of a
    /// second.</summary>
    /// <param name="now">The time, seconds.</param>
    /// <param name="handler">Told what comes of it.</param>
    public void Update(double now, ISessionHandler handler)
    {
        this.now = now;
        if (State is SessionState.Idle or SessionState.Closed or SessionState.Failed)
            return;
        if (State == SessionState.InWorld)
            UpdateWorld();
        link.Update(now);
        FollowLink(handler);
        bool isLoggingIn = State is SessionState.Connecting or SessionState.LoggingIn;
        if (isLoggingIn && (link.IsOutOfRequests || now - opened > options.LoginTimeout))
            Fail(new SessionFailure(SessionFailureKind.NoAnswer, $"The server did not let us in within {now - opened:0} s."), handler);
        else if (!isLoggingIn && SilentFor > options.SilenceTimeout)
            Fail(new SessionFailure(SessionFailureKind.Silent, $"The server has been silent for {SilentFor:0} s."), handler);
    }

    /// <summary>Sends what has been put together; <see cref="Update"/> does it too.</summary>
    public void Flush() => link.Flush(now);

    /// <summary>Puts a message into packets; game actions get their numbers.</summary>
    /// <returns>False when there is no connection, or the message has no form on the wire.</returns>
    public bool Send<T>(in T message)
        where T : IMessage<T>
    {
        bool isAction = T.Id.Opcode == Opcode.GameAction;
        if (!WireMessage.TryWrite(message, scratch, out int length, isAction ? actionStamp + 1 : 0)
            || !link.Send(scratch.AsSpan(0, length), T.Group, now))
        {
            return false;
        }

        if (isAction)
            actionStamp++;
        return true;
    }

    /// <summary>Puts the bytes of a message into packets as they are.</summary>
    /// <param name="message">A whole message, opcode included.</param>
    /// <param name="group">The group that it travels in.</param>
    /// <returns>False when there is no connection, or the message is too long or too short.</returns>
    public bool Send(ReadOnlySpan<byte> message, MessageGroup group)
        => message.Length is >= 4 and <= FragmentAssembler.MostLength && link.Send(message, group, now);

    /// <summary>Asks for a character to be made; <see cref="Creation"/> and the message tell what came of it.</summary>
    /// <param name="character">The character; the account's name is put in.</param>
    /// <exception cref="InvalidOperationException">Not while characters are selected.</exception>
    public void CreateCharacter(CharacterCreate character)
    {
        CharacterList characters = Selecting();
        Creation = null;
        Send(character with { Account = characters.Account });
    }

    /// <summary>Asks to enter the world.</summary>
    /// <param name="guid">The character.</param>
    /// <exception cref="InvalidOperationException">Not while characters are selected.</exception>
    public void EnterWorld(uint guid)
    {
        Selecting();
        Refusal = null;
        entering = guid;
        State = SessionState.Entering;
        Send(new CharacterEnterWorldRequest());
    }

    /// <summary>Asks to leave the world: six seconds later, or more, characters can be selected again.</summary>
    /// <exception cref="InvalidOperationException">Not in the world.</exception>
    public void LogOff()
    {
        if (State != SessionState.InWorld)
            throw new InvalidOperationException("There is no character in the world.");
        State = SessionState.LoggingOff;
        Send(new LogOffRequest(Player));
    }

    /// <summary>A message for an object came that is not known: it is asked for every 20 s, until 25 s after the last such
    /// message.</summary>
    public void AwaitObject(uint guid) => requests.Await(guid, now);

    /// <summary>The object came, or is not of interest any more.</summary>
    public void ForgetObject(uint guid) => requests.Forget(guid);

    /// <summary>Says goodbye and ends. The account stays in use for two seconds more.</summary>
    public void Close()
    {
        if (State is SessionState.Closed or SessionState.Failed)
            return;
        link.Close(now);
        State = SessionState.Closed;
    }

    private CharacterList Selecting() => State == SessionState.CharacterSelect && Characters is { } characters
        ? characters
        : throw new InvalidOperationException("Characters are selected after the login and after leaving the world.");

    private void UpdateWorld()
    {
        while (requests.TryTakeDue(now, out uint guid))
            Send(new ForceObjDesc(guid));
        if (now - lastPing < PingInterval)
            return;
        lastPing = now;
        Send(new RequestPing());
    }

    private void FollowLink(ISessionHandler handler)
    {
        if (State == SessionState.Connecting && link.State is LinkState.Responding or LinkState.Connected)
            MoveTo(SessionState.LoggingIn, handler);
        if (link.ClosedByServer)
            Fail(new SessionFailure(SessionFailureKind.ClosedByServer, "The server closed the session."), handler);
    }

    private void MoveTo(SessionState state, ISessionHandler handler)
    {
        State = state;
        handler.OnStateChanged(state);
    }

    private void Fail(SessionFailure failure, ISessionHandler handler)
    {
        if (State is SessionState.Closed or SessionState.Failed)
            return;
        Failure = failure;
        link.Close(now);
        MoveTo(SessionState.Failed, handler);
    }

    private void OnMessage(in WireMessage message, ISessionHandler handler)
    {
        bool isRefusal = message.Id.Opcode is Opcode.CharacterError or Opcode.AccountBoot or Opcode.AccountBanned;
        if (link.IsRefusedUnseen && !isRefusal)
            return;
        handler.OnMessage(message);
        switch (message.Id.Opcode)
        {
            case Opcode.CharacterList when message.TryRead(out CharacterList characters):
                Characters = characters;
                if (State is SessionState.Connecting or SessionState.LoggingIn or SessionState.LoggingOff)
                    MoveTo(SessionState.CharacterSelect, handler);
                break;
            case Opcode.ServerName when message.TryRead(out ServerName server):
                Server = server;
                break;
            case Opcode.DddInterrogation:
                Send(new DddInterrogationResponse(1, options.DatFiles, 0, 0));
                break;
            case Opcode.DddBegin or Opcode.DddEnd:
                Send(new DddEnd());
                break;
            case Opcode.CharacterCreateResponse when message.TryRead(out CharacterCreateResponse response):
                NoteCreation(response);
                break;
            case Opcode.EnterWorldServerReady when State == SessionState.Entering:
                Send(new CharacterEnterWorld(entering, Characters!.Value.Account));
                break;
            case Opcode.PlayerCreate when State == SessionState.Entering && message.TryRead(out PlayerCreate player):
                Player = player.Guid;
                lastPing = now;
                MoveTo(SessionState.InWorld, handler);
                break;
            case Opcode.CharacterLogOff:
                LeaveWorld(handler);
                break;
            case Opcode.CharacterError when message.TryRead(out CharacterError error):
                Refuse(error.Code, handler);
                break;
            case Opcode.AccountBoot or Opcode.AccountBanned:
                Fail(Boot(message), handler);
                break;
        }
    }

    /// <summary>No new list comes for a character that was made.</summary>
    private void NoteCreation(CharacterCreateResponse response)
    {
        Creation = response;
        if (response.Character is { } made && Characters is { } characters)
            Characters = characters with { Characters = [.. characters.Characters, made] };
    }

    private void LeaveWorld(ISessionHandler handler)
    {
        Player = 0;
        requests.Clear();
        if (State == SessionState.InWorld)
            MoveTo(SessionState.LoggingOff, handler);
    }

    private void Refuse(uint code, ISessionHandler handler)
    {
        var failure = SessionFailure.OfCode(code);
        if (State != SessionState.Entering || !SessionFailure.IsAboutCharacter(code))
        {
            Fail(failure, handler);
            return;
        }

        Refusal = failure;
        MoveTo(SessionState.CharacterSelect, handler);
    }

    private SessionFailure Boot(in WireMessage message)
    {
        if (message.TryRead(out AccountBanned banned))
        {
            var left = TimeSpan.FromSeconds(banned.SecondsLeft);
            return new SessionFailure(
                SessionFailureKind.AccountBanned, $"The account is banned for {left.TotalHours:0.#} hours{Because(banned.Reason)}");
        }

        string because = Because(message.TryRead(out AccountBoot boot) ? boot.Reason : null);
        if (link.IsVersionRefused)
            return new SessionFailure(SessionFailureKind.VersionRefused, $"The server does not take version {options.Version}{because}");
        return State is SessionState.Connecting or SessionState.LoggingIn && Characters is null
            ? new SessionFailure(SessionFailureKind.LoginRefused, $"The server refused the login{because}")
            : new SessionFailure(SessionFailureKind.Booted, $"The server threw the account out{because}");

        // The server's first sentence is the reason; what follows is advice.
        static string Because(string? reason)
            => string.IsNullOrWhiteSpace(reason) ? "." : $": {reason.Trim().Split(". ")[0].TrimEnd('.')}.";
    }

    /// <summary>Hands messages to the session first and to its user then.</summary>
    private sealed class Relay(ClientSession session) : IMessageReceiver
    {
        public ISessionHandler Handler { get; set; } = null!;

        public void OnMessage(in WireMessage message) => session.OnMessage(message, Handler);
    }
}
