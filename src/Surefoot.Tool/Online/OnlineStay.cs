using System.Diagnostics;
using System.Globalization;
using System.Net;
using Surefoot.Client;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Online;

/// <summary>A character's stay on a server, step by step, in real time.</summary>
internal sealed class OnlineStay : ISessionHandler, IDisposable
{
    private const double FrameTime = 1.0 / 60;
    private const double Patience = 60;
    private const double SayEvery = 5;

    /// <summary>Seconds after a walk in which the server's answer to its last step arrives.</summary>
    private const double SettleTime = 1.5;

    private readonly Stopwatch watch = Stopwatch.StartNew();
    private readonly PhysicsDataCache assets;
    private readonly Action<string> say;
    private readonly CancellationToken cancellation;
    private MovementKeys keys;
    private WalkTimes? times;
    private bool wasInWorld;

    /// <summary>Asks a server for a session.</summary>
    /// <param name="server">The server.</param>
    /// <param name="login">Who logs in.</param>
    /// <param name="assets">The files of its world.</param>
    /// <param name="say">Told what is waited for, while that takes long.</param>
    /// <param name="cancellation">Ends the stay.</param>
    internal OnlineStay(
        IPEndPoint server, ClientSessionOptions login, PhysicsDataCache assets, Action<string> say, CancellationToken cancellation)
    {
        this.assets = assets;
        this.say = say;
        this.cancellation = cancellation;
        Session = new WorldSession(server, login);
    }

    internal WorldSession Session { get; }

    internal GameClient? Game { get; private set; }

    internal LocalPlayer Player => Game!.Player!;

    /// <summary>Where the server said last that the player is; null before it has.</summary>
    internal WirePosition? Told { get; private set; }

    /// <summary>Metres from there to where the player is.</summary>
    internal double? Disagreement => Told is not { } told ? null
        : (CellIds.BlockOffset(Player.Body.Position.CellId, told.Cell) + told.Origin - Player.Body.Position.Frame.Origin).Length();

    private double Now => watch.Elapsed.TotalSeconds;

    public void OnStateChanged(SessionState state)
    {
    }

    public void OnMessage(in WireMessage message)
    {
        if (message.Id.Opcode == Opcode.UpdatePosition && message.TryRead(out UpdatePosition update) && update.Guid == Session.Player)
            Told = update.Pack.Position;
    }

    public void Dispose() => Session.Dispose();

    /// <exception cref="ConnectException">The server does not let the account in.</exception>
    internal void LogIn() => Reach(() => Session.State == SessionState.CharacterSelect, "The server let us in, but told no characters.");

    /// <summary>Finds a character of the account, or makes it.</summary>
    /// <exception cref="ConnectException">There is none, or it cannot be made.</exception>
    internal CharacterEntry Find(string name, bool create)
    {
        foreach (CharacterEntry character in Session.Characters!.Value.Characters)
        {
            // Administrators' names begin with a plus sign in this list, and nowhere else.
            if (character.Name.TrimStart('+').Equals(name.TrimStart('+'), StringComparison.OrdinalIgnoreCase)) return character;
        }

        if (!create)
        {
            string names = string.Join(", ", Session.Characters.Value.Characters.Select(one => one.Name));
            throw new ConnectException(
                names.Length == 0 ? $"The account has no character: --create makes '{name}'."
                : $"The account has no character '{name}', but {names}; --create makes one.", ExitCode.CharacterRefused);
        }

        Session.CreateCharacter(NewCharacter.Named(name));
        Reach(() => Session.Creation is not null, $"The server does not answer whether it makes '{name}'.");
        return Session.Creation!.Value is { Result: 1, Character: { } made }
            ? made
            : throw new ConnectException(NewCharacter.Refusal(name, Session.Creation.Value.Result), ExitCode.CharacterRefused);
    }

    /// <summary>Enters the world and stands there.</summary>
    /// <exception cref="ConnectException">The character is refused, or these dat files are not those of the server.</exception>
    internal void Enter(CharacterEntry character)
    {
        Game = new GameClient(assets, new SessionLink(Session, this));
        Session.EnterWorld(character.Guid);
        Reach(() => Session.State != SessionState.Entering, $"The server does not let '{character.Name}' in.");
        if (Session.Refusal is { } refusal) throw ConnectException.Of(refusal, wasInWorld: false);
        wasInWorld = true;
        Until(() => Game.Fault is not null || (Game.IsPlaying && !IsHidden), Patience);
        if (Game.Fault is { } fault) throw new ConnectException($"{fault} Give the server's own files by --dats.", ExitCode.WrongDats);
        if (!Game.IsPlaying)
        {
            throw new ConnectException(
                "The dat files have no ground where the server puts the player: give the server's own files by --dats.",
                ExitCode.WrongDats);
        }

        Wait(SettleTime);
    }

    /// <summary>Has the hands do what a script says, and waits for the server's answer.</summary>
    internal void Walk(IReadOnlyList<WalkLeg> legs)
    {
        double next = Now;
        foreach (WalkLeg leg in legs)
        {
            keys = leg.Keys;
            Player.Controller.SetAutoRun(leg.AutoRun, Now);
            next += leg.Seconds;
            do Frame();
            while (Now < next);
        }

        keys = MovementKeys.None;
        Player.Controller.SetAutoRun(false, Now);
        Until(() => Player.Body is { OnWalkable: true } body && body.Velocity == default, Patience);
        Wait(SettleTime);
    }

    /// <summary>Keeps the time, the keys and the place of each frame from now on.</summary>
    internal WalkTimes Record() => times = new WalkTimes(Player);

    /// <summary>Leaves the world, so that the character and the account are free.</summary>
    internal void LogOff()
    {
        Session.LogOff();
        Until(() => Session.State == SessionState.CharacterSelect, Patience);
    }

    internal void Wait(double seconds) => Until(() => false, seconds);

    private bool IsHidden => (Player.Body.State & PhysicsState.Hidden) != 0;

    private void Reach(Func<bool> reached, string otherwise)
    {
        for (double waited = 0; waited < Patience; waited += SayEvery)
        {
            if (Until(reached, SayEvery)) return;
            say(string.Create(CultureInfo.InvariantCulture, $"waiting for the server, {waited + SayEvery:0} s"));
        }

        throw new ConnectException(otherwise, ExitCode.NoServer);
    }

    private bool Until(Func<bool> holds, double seconds)
    {
        double end = Now + seconds;
        while (!holds() && Now < end) Frame();
        return holds();
    }

    private void Frame()
    {
        cancellation.ThrowIfCancellationRequested();
        double now = Now;
        if (Game is null) Session.Update(this);
        else UpdateGame(now);
        if (Session.State == SessionState.Failed) throw ConnectException.Of(Session.Failure!, wasInWorld);
        double left = FrameTime - (Now - now);
        if (left > 0) Thread.Sleep(TimeSpan.FromSeconds(left));
    }

    private void UpdateGame(double now)
    {
        bool moved = Game!.Update(keys, now);
        Session.Flush();
        if (Game.Player is { } player) times?.Add(player, keys, now, moved);
    }
}
