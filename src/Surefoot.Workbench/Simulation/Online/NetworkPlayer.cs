using System.Globalization;
using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>A page's player as a client of a server: it logs in, enters the world, and what the page shows is read off its body.</summary>
internal sealed class NetworkPlayer : IWorkbenchPlayer, IMovementObserver, ISessionHandler, IDisposable
{
    /// <summary>Nobody goes so far between two looks, metres: a teleport may be over before anybody looks.</summary>
    private const double Leap = 4;

    private const string CommandsNeedRights = "the server decides who may do that, by commands of its own";

    private readonly OnlineOptions options;
    private readonly PhysicsDataCache cache;
    private readonly WorldSession session;
    private readonly TraceBuffer trace = new();
    private readonly string character;
    private readonly Queue<string> said = [];
    private readonly WalkRecorder walk = new(PlayerSettings.Default);
    private readonly PlayerPose waiting;
    private PlayerWatch? watch;
    private PlayerKeys held;
    private MovementKeys keys;
    private Position here;
    private byte teleports;
    private bool wasAway = true, isOver, isMaking;

    /// <summary>A player whose session begins.</summary>
    /// <param name="cache">Shapes of the server's world.</param>
    /// <param name="options">The server, and who logs in.</param>
    /// <param name="number">How many pages came before.</param>
    /// <param name="place">What the page shows meanwhile.</param>
    /// <param name="now">Seconds.</param>
    /// <param name="clock">The session's clock.</param>
    public NetworkPlayer(
        PhysicsDataCache cache, OnlineOptions options, int number, WorkbenchPlace place, double now, TimeProvider clock)
    {
        this.cache = cache;
        this.options = options;
        string suffix = number == 0 || !options.NumbersPages ? "" : (number + 1).ToString(CultureInfo.InvariantCulture);
        character = options.Character + Letters(suffix);
        waiting = default(PlayerPose) with
        {
            Time = now,
            CellId = place.CellId,
            Position = place.Position,
            Yaw = place.Yaw,
            Flags = PoseFlags.Nowhere,
        };
        session = new WorldSession(options.Server, options.Login with { Account = options.Login.Account + suffix }, clock);
        Say($"Logging in to {options.Server} as {options.Login.Account + suffix} ...");
    }

    /// <summary>The stay in the server's world; null before it begins.</summary>
    public GameClient? Game { get; private set; }

    /// <summary>Its land; null before it is there.</summary>
    public PhysicsWorld? World => Game?.Engine.World;

    /// <summary>Is told in a sentence what becomes of the session.</summary>
    public Action<string>? Notice { get; init; }

    /// <inheritdoc/>
    public PlayerPose Pose => watch?.Pose ?? waiting;

    /// <inheritdoc/>
    public IReadOnlyList<Touch> Touches => watch?.Touches ?? [];

    /// <inheritdoc/>
    public WalkReport Walk => new(walk.Command(null), walk.LeftOut);

    private LocalPlayer? Player => Game?.Player;

    /// <inheritdoc/>
    public bool TryTakeSentence(out string sentence) => said.TryDequeue(out sentence!);

    /// <summary>Time passes: what the server says arrives, the keys act, the login goes on.</summary>
    public void Advance(double now)
    {
        if (isOver) return;
        if (Game is { } game) game.Update(keys, now);
        else session.Update(this);
        if (session.Failure is { } failure) End(failure.Sentence);
        else if (session.State == SessionState.CharacterSelect) Choose();
        if (Game?.Fault is { } fault) End($"{fault} These are not the server's dat files.");
        if (Player is null) return;
        watch ??= Begin(Player);
        Position place = Player.Body.Position;
        bool isAway = !Game!.IsPlaying, leapt = here.CellId != 0 && here.DistanceTo(place) > Leap;
        if (!isAway && (wasAway || leapt)) Arrive();
        wasAway = isAway;
        here = place;
        watch.Observe(teleports, walk.Count, now);
        walk.Observe(Player.Body.Position, Pose, Touches, now);
    }

    /// <inheritdoc/>
    public void SetKeys(PlayerKeys keysHeld, double now)
    {
        MovementKeys before = keys;
        held = keysHeld;
        keys = KeyTranslation.Of(held);
        if (Player is not { } player || isOver) return;
        Game!.Update(keys, now);
        walk.Act(held, player.Controller.AutoRun, now);
        bool jumpChanged = ((keys ^ before) & MovementKeys.Jump) != 0;
        if (jumpChanged && player.Controller.LastRefusal != MotionError.None && !player.Controller.IsChargingJump)
            watch?.Happen(new PlayerEvent(PlayerEventKind.JumpRefused, now, Code: (uint)player.Controller.LastRefusal));
    }

    /// <inheritdoc/>
    public void MovePointer(PointerButtons buttons, float right, double now)
    {
        if (Player is not { } player) return;
        bool turns = buttons.HasFlag(PointerButtons.Right);
        player.Controller.SetMouseButtons(buttons.HasFlag(PointerButtons.Left), turns, now);
        walk.Steer(turns && player.Controller.UsesMouseTurning);
        if (right != 0) player.Controller.MoveMouse(right, now);
    }

    /// <inheritdoc/>
    public void UseMouseTurning(bool on, double now) => Player?.Controller.UseMouseTurning(on, now);

    /// <inheritdoc/>
    public void ToggleAutoRun(double now)
    {
        if (Player is not { } player) return;
        player.Controller.SetAutoRun(!player.Controller.AutoRun, now);
        walk.Act(held, player.Controller.AutoRun, now);
    }

    /// <inheritdoc/>
    public void LoseFocus(double now)
    {
        held = PlayerKeys.None;
        keys = MovementKeys.None;
        if (Player is not { } player) return;
        if (player.Controller.IsChargingJump) walk.Miss("a jump that was given up");
        player.Controller.LoseKeyboardFocus(now);
        walk.Act(held, player.Controller.AutoRun, now);
    }

    /// <inheritdoc/>
    public void Configure(PlayerSettings settings, double now) =>
        Say($"Skills and burden are the server's here: {CommandsNeedRights}.");

    /// <inheritdoc/>
    public void Goto(WorkbenchPlace place, double now)
    {
        if (Player is null) return;
        Position at = SimulatedPlayer.PositionOf(place);
        if (float.IsNaN(at.Frame.Origin.Z) && World?.FindLandblock(at.CellId) is { } block &&
            block.Terrain.TryGetHeight(at.Frame.Origin.X, at.Frame.Origin.Y, out float ground))
            at.Frame.Origin.Z = ground;
        Vector3 o = at.Frame.Origin;
        Quaternion q = at.Frame.Rotation;
        Command(string.Create(
            CultureInfo.InvariantCulture, $"@teleloc 0x{at.CellId:X8} {o.X} {o.Y} {o.Z} {q.W} {q.X} {q.Y} {q.Z}"));
    }

    /// <inheritdoc/>
    public void Use(double now)
    {
        if (Game is not { Player: { } player } game || NetworkSight.NearestDoor(game, player) is not { } door) return;
        session.Send(new Use(door.Id));
        walk.Miss("the door");
    }

    /// <inheritdoc/>
    public void Ask(uint creature, CreatureWish wish)
    {
        if (Player is null) return;
        Command(wish switch
        {
            CreatureWish.Follow => "@follow",
            CreatureWish.Flee => "@flee",
            CreatureWish.Stand => "@stand",
            _ => "@roam",
        });
    }

    /// <inheritdoc/>
    /// <remarks>The network is as it is.</remarks>
    public void UseNetwork(NetworkQuality quality, bool showsTruth)
    {
    }

    /// <inheritdoc/>
    public bool TryTakeEvent(out PlayerEvent happened)
    {
        happened = default;
        return watch?.TryTakeEvent(out happened) == true;
    }

    /// <inheritdoc/>
    public void Dispose() => session.Dispose();

    void IMessageReceiver.OnMessage(in WireMessage message)
    {
        if (message.TryRead(out Chat chat)) Say(chat.Text.Trim());
    }

    void ISessionHandler.OnStateChanged(SessionState state)
    {
    }

    void IMovementObserver.OnMoveToState(in MoveToState message, double now)
    {
    }

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now)
    {
    }

    void IMovementObserver.OnJump(in Jump message, double now) =>
        watch?.Happen(new PlayerEvent(PlayerEventKind.Jumped, now, message.Extent));

    /// <summary>Names of characters have letters only: 12 is ab.</summary>
    private static string Letters(string digits) => string.Concat(digits.Select(digit => (char)('a' + (digit - '1' + 10) % 10)));

    private static (TouchKind Kind, string Name) NameOf(GameClient game, uint id) => game.Others.Find(id) is { } other
        ? ((other.Body.Weenie & WeenieTraits.Player) != 0 ? TouchKind.Player : TouchKind.Body, other.Weenie.Name)
        : (TouchKind.Body, "");

    private void Choose()
    {
        if (Game is not null) return;
        CharacterEntry? found = session.Characters?.Characters
            .Where(one => one.Name.TrimStart('+').Equals(character, StringComparison.OrdinalIgnoreCase))
            .Select(one => (CharacterEntry?)one)
            .FirstOrDefault();
        if (found is null && session.Creation is { } creation)
        {
            if (creation is { Result: 1, Character: { } made }) found = made;
            else End(NewCharacter.Refusal(character, creation.Result));
        }
        else if (found is null && !options.Create)
        {
            End($"The account has no character '{character}': --create makes it.");
        }
        else if (found is null && !isMaking)
        {
            isMaking = true;
            Say($"Making {character} ...");
            session.CreateCharacter(NewCharacter.Named(character));
        }

        if (found is not { } entry) return;
        Say($"{entry.Name} enters {session.Server?.Name ?? "the world"} ...");
        Game = new GameClient(cache, new SessionLink(session, this), new GameClientOptions { Observer = this });
        session.EnterWorld(entry.Guid);
    }

    private PlayerWatch Begin(LocalPlayer player)
    {
        player.Body.Trace = trace;
        player.Controller.MouseTurning.Inverted = true;
        player.Controller.MouseTurning.Sensitivity = SimulatedPlayer.PointerSensitivity;
        GameClient game = Game!;
        return new PlayerWatch(player, trace, id => NameOf(game, id), cell => LandView.IsEnclosed(game.Engine.World, cell));
    }

    /// <summary>The player stands somewhere where it did not walk to.</summary>
    private void Arrive()
    {
        teleports++;
        watch!.Leap();
        walk.Place(Player!.Body.Position);
    }

    /// <summary>What is no part of a player's own movement is asked for by chat, and granted or not.</summary>
    private void Command(string text) => session.Send(new Talk(text));

    private void End(string sentence)
    {
        isOver = true;
        Say(sentence);
    }

    private void Say(string sentence)
    {
        said.Enqueue(sentence);
        Notice?.Invoke($"{options.Server}: {sentence}");
    }
}
