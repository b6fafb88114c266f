using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>A small server for one client: any account with the password "testpass", one character, one world without anything in
/// it.</summary>
internal sealed class ScriptedServer(IDatagramSink sink) : IMessageReceiver
{
    public const uint Character = 0x50000001;

    private readonly List<byte[]> received = [];
    private string account = "";
    private double verifiedAt, now;
    private uint stamp;
    private bool greeted;

    public ServerLink? Link { get; private set; }

    /// <summary>All messages of the client.</summary>
    public IReadOnlyList<byte[]> Received => received;

    /// <summary>Seconds that the check of a password takes.</summary>
    public double VerifyTime { get; init; } = 0.05;

    /// <summary>A login with this password is refused.</summary>
    public Func<LoginRequest, CharacterError?> Judge { get; init; } = _ => null;

    /// <summary>The answer to a wish to enter the world, when it is refused.</summary>
    public uint? EnterError { get; set; }

    public void Receive(ReadOnlySpan<byte> datagram, ServerPort port, double now)
    {
        this.now = now;
        if (ServerLink.TryReadLogin(datagram) is { } login)
        {
            if (Link is null)
                Begin(login, datagram.Length);
            else
                Link.Repeat(datagram.Length, now);
            return;
        }

        Link?.Receive(datagram, port, now, this);
    }

    public void Update(double now)
    {
        this.now = now;
        if (now >= verifiedAt)
            Link?.Admit();
        if (Link?.State == ServerLinkState.Connected && !greeted)
            Greet();
        Link?.Update(now);
    }

    public void Send<T>(in T message)
        where T : IMessage<T> => Link!.Send(message, Character, ++stamp);

    public void OnMessage(in WireMessage message)
    {
        received.Add(message.Bytes.ToArray());
        switch (message.Id.Opcode)
        {
            case Opcode.DddInterrogationResponse:
                Send(new DddEnd());
                break;
            case Opcode.CharacterCreate when message.TryRead(out CharacterCreate character):
                Send(new CharacterCreateResponse(1, new CharacterEntry(Character, character.Name, 0)));
                break;
            case Opcode.CharacterEnterWorldRequest when EnterError is { } code:
                Send(new CharacterError(code));
                break;
            case Opcode.CharacterEnterWorldRequest:
                Send(new EnterWorldServerReady());
                break;
            case Opcode.CharacterEnterWorld:
                Send(new PlayerCreate(Character));
                break;
            case Opcode.CharacterLogOff:
                Send(new LogOffReply());
                Send(new CharacterList(0, [new CharacterEntry(Character, "Alma", 0)], [], 11, account, 1, 1));
                break;
            case Opcode.GameAction when message.Id.Action == GameActionType.RequestPing:
                Send(new PingResponse());
                break;
        }
    }

    private void Begin(LoginRequest login, int length)
    {
        account = login.Account;
        Link = new ServerLink(new ServerLinkOptions(3, 0xC00C1E, 0x1111, 0x2222), length, sink, now);
        verifiedAt = now + VerifyTime;
        if (login.Password != "testpass")
            Link.Refuse(new AccountBoot(" because the password entered for this account was not correct"), now);
        else if (Judge(login) is { } error)
            Link.Refuse(error, now);
    }

    private void Greet()
    {
        greeted = true;
        Send(new CharacterList(0, [], [], 11, account, 1, 1));
        Send(new ServerName(1, 128, "Test"));
        Send(new DddInterrogation(1, 1, 1, [0, 1]));
    }
}
