using Surefoot.Client;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>A page's player in the physics: keys go to its controller, what the page shows is read off its body.</summary>
/// <param name="server">Its server.</param>
/// <param name="settings">The skills that the server begins with.</param>
/// <param name="nameOf">Names a body by its id.</param>
internal sealed class SimulatedPlayer(
    LoopbackServer server, PlayerSettings settings, Func<uint, (TouchKind Kind, string Name)> nameOf)
    : IWorkbenchPlayer, IMovementObserver
{
    /// <summary>Strength of every player; its capacity is what the burden slider is measured against.</summary>
    public const int Strength = 100;

    // A browser reports its pointer once a frame, and a hand's width should turn half round.
    internal const float PointerSensitivity = 1f;

    private readonly WalkRecorder walk = new(settings);
    private LocalPlayer? player;
    private PlayerWatch? watch;
    private SeenPlayer? seen;
    private Viewer? viewer;
    private SimulatedWorld? world;
    private uint settledCell;
    private PlayerKeys held;
    private MovementKeys keys;
    private byte teleports;

    /// <summary>What the player's body is to tell its decisions to.</summary>
    public TraceBuffer Trace { get; } = new();

    /// <inheritdoc/>
    public PlayerPose Pose => Watch.Pose;

    /// <inheritdoc/>
    public IReadOnlyList<Touch> Touches => Watch.Touches;

    /// <inheritdoc/>
    public WalkReport Walk => new(walk.Command(World.DatFolder), walk.LeftOut);

    /// <summary>What other pages are told of it.</summary>
    public SeenPlayer Seen => seen ?? throw new InvalidOperationException("The player has not entered the world.");

    /// <summary>The others as its page sees them.</summary>
    public Viewer Viewer => viewer ?? throw new InvalidOperationException("The player has not entered the world.");

    /// <summary>Its page wants to be shown where the others are in truth.</summary>
    public bool WantsTruth { get; private set; }

    /// <summary>The player in the physics.</summary>
    public LocalPlayer Player => player ?? throw new InvalidOperationException("The player has not entered the world.");

    private PlayerWatch Watch => watch ?? throw new InvalidOperationException("The player has not entered the world.");

    private SimulatedWorld World => world ?? throw new InvalidOperationException("The player has not entered the world.");

    /// <summary>The numbers of a character with these settings.</summary>
    public static CharacterStats StatsOf(PlayerSettings settings) =>
        new(settings.RunSkill, settings.JumpSkill, Strength: Strength, Burden: settings.Burden);

    /// <summary>Where a place is.</summary>
    public static Position PositionOf(WorkbenchPlace place)
    {
        Position position = new(place.CellId, place.Position);
        position.Frame.SetHeading(-place.Yaw * 180f / MathF.PI);
        return position;
    }

    /// <summary>Takes over the player, once it is in the world.</summary>
    /// <param name="entered">The player.</param>
    /// <param name="around">The world that loads what it may reach.</param>
    /// <param name="shape">Its shape.</param>
    /// <param name="sight">The others as its page sees them.</param>
    /// <param name="now">Seconds.</param>
    public void Enter(LocalPlayer entered, SimulatedWorld around, SetupAsset shape, Viewer sight, double now)
    {
        player = entered;
        watch = new PlayerWatch(entered, Trace, nameOf, around.IsEnclosed);
        seen = new SeenPlayer(player, shape, $"Player {player.Body.Id}", server.RunRate);
        viewer = sight;
        player.Controller.MouseTurning.Inverted = true;
        player.Controller.MouseTurning.Sensitivity = PointerSensitivity;
        world = around;
        walk.Place(player.Body.Position);
        Observe(now);
    }

    /// <summary>True once for each landblock that the player comes into.</summary>
    /// <param name="cellId">Where the player is.</param>
    public bool EnteredBlock(out uint cellId)
    {
        cellId = Pose.CellId;
        if (cellId >> 16 == settledCell >> 16) return false;
        settledCell = cellId;
        return true;
    }

    /// <inheritdoc/>
    public void SetKeys(PlayerKeys keysHeld, double now)
    {
        MovementKeys before = keys;
        held = keysHeld;
        keys = KeyTranslation.Of(held);
        Player.Update(keys, now);
        walk.Act(held, Player.Controller.AutoRun, now);
        bool jumpChanged = ((keys ^ before) & MovementKeys.Jump) != 0;
        if (jumpChanged && Player.Controller.LastRefusal != MotionError.None && !Player.Controller.IsChargingJump)
            Happen(new PlayerEvent(PlayerEventKind.JumpRefused, now, Code: (uint)Player.Controller.LastRefusal));
    }

    /// <inheritdoc/>
    public void MovePointer(PointerButtons buttons, float right, double now)
    {
        bool turns = buttons.HasFlag(PointerButtons.Right);
        Player.Controller.SetMouseButtons(buttons.HasFlag(PointerButtons.Left), turns, now);
        walk.Steer(turns && Player.Controller.UsesMouseTurning);
        if (right != 0) Player.Controller.MoveMouse(right, now);
    }

    /// <inheritdoc/>
    public void UseMouseTurning(bool on, double now) => Player.Controller.UseMouseTurning(on, now);

    /// <inheritdoc/>
    public void ToggleAutoRun(double now)
    {
        Player.Controller.SetAutoRun(!Player.Controller.AutoRun, now);
        walk.Act(held, Player.Controller.AutoRun, now);
    }

    /// <inheritdoc/>
    public void LoseFocus(double now)
    {
        if (Player.Controller.IsChargingJump) walk.Miss("a jump that was given up");
        held = PlayerKeys.None;
        keys = MovementKeys.None;
        Player.Controller.LoseKeyboardFocus(now);
        walk.Act(held, Player.Controller.AutoRun, now);
    }

    /// <inheritdoc/>
    public void Configure(PlayerSettings changed, double now)
    {
        server.SetStats(StatsOf(changed), now);
        Seen.Broadcast.ChangeRunRate(server.RunRate);
        walk.Configure(changed);
    }

    /// <inheritdoc/>
    public void Goto(WorkbenchPlace place, double now)
    {
        PlaceRefusal refusal = World.FindPlace(place, this, out Position position);
        if (refusal == PlaceRefusal.None && Player.Teleport(position, now) != PlacementResult.OK) refusal = PlaceRefusal.NoRoom;
        if (refusal != PlaceRefusal.None)
        {
            Happen(new PlayerEvent(PlayerEventKind.PlaceRefused, now, Code: (uint)refusal));
            return;
        }

        teleports++;
        Seen.Teleported(now);
        Watch.Leap();
        walk.Place(Player.Body.Position);
        Observe(now);
    }

    /// <inheritdoc/>
    public void Use(double now)
    {
        World.UseDoor(this, now);
        walk.Miss("the door");
    }

    /// <inheritdoc/>
    public void Ask(uint creature, CreatureWish wish) => World.Ask(this, creature, wish);

    /// <inheritdoc/>
    public void UseNetwork(NetworkQuality quality, bool showsTruth)
    {
        Viewer.Quality = quality;
        WantsTruth = showsTruth;
    }

    /// <inheritdoc/>
    public bool TryTakeEvent(out PlayerEvent happened) => Watch.TryTakeEvent(out happened);

    /// <inheritdoc/>
    public bool TryTakeSentence(out string sentence)
    {
        sentence = "";
        return false;
    }

    /// <summary>What the server says arrives and the keys act; before the world's tick.</summary>
    public void BeforeTick(double now) => Player.Update(keys, now);

    /// <summary>Looks at the body after the world's tick.</summary>
    public void AfterTick(double now)
    {
        Seen.Broadcast.Update(now);
        Observe(now);
        walk.Observe(Player.Body.Position, Pose, Touches, now);
    }

    private void Observe(double now) => Watch.Observe(teleports, walk.Count, now);

    void IMovementObserver.OnMoveToState(in MoveToState message, double now) => seen?.Broadcast.Take(message, now);

    void IMovementObserver.OnAutonomousPosition(in AutonomousPosition message, double now) => seen?.Broadcast.Take(message, now);

    void IMovementObserver.OnJump(in Jump message, double now)
    {
        seen?.Broadcast.Take(message);
        Happen(new PlayerEvent(PlayerEventKind.Jumped, now, message.Extent));
    }

    private void Happen(in PlayerEvent happened) => Watch.Happen(happened);
}
