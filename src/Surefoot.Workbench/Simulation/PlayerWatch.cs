using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>Reads off a player's body what its page shows.</summary>
/// <param name="player">The player.</param>
/// <param name="trace">What its body tells its decisions to.</param>
/// <param name="nameOf">Names a body by its id.</param>
/// <param name="isEnclosed">Whether a cell is a room from which the land is not seen.</param>
internal sealed class PlayerWatch(
    LocalPlayer player, TraceBuffer trace, Func<uint, (TouchKind Kind, string Name)> nameOf, Func<uint, bool> isEnclosed)
{
    private const int MostEventsKept = 64;

    private readonly Queue<PlayerEvent> events = [];
    private readonly SpeedMeter speed = new();
    private readonly List<Touch> touches = [];
    private readonly TouchReader reader = new(nameOf);
    private bool airborne;
    private float fallSpeed;
    private float runRate = 1f;

    /// <summary>What was seen last.</summary>
    public PlayerPose Pose { get; private set; }

    /// <summary>What the player stands on, if anything, and what it touches.</summary>
    public IReadOnlyList<Touch> Touches => touches;

    /// <summary>Something to be told to the page.</summary>
    public void Happen(in PlayerEvent happened)
    {
        events.Enqueue(happened);
        if (events.Count > MostEventsKept) events.Dequeue();
    }

    /// <summary>The oldest event not yet taken.</summary>
    public bool TryTakeEvent(out PlayerEvent happened) => events.TryDequeue(out happened);

    /// <summary>The player was put somewhere else.</summary>
    public void Leap() => speed.Reset();

    /// <summary>Reads the pose off the body.</summary>
    /// <param name="teleports">Counts how often the player was put somewhere else, modulo 256.</param>
    /// <param name="walks">Counts walks begun, modulo 256.</param>
    /// <param name="now">Seconds.</param>
    public void Observe(byte teleports, byte walks, double now)
    {
        PhysicsBody body = player.Body;
        MovementManager movement = player.Movement;
        if (movement.RunRate != runRate)
        {
            runRate = movement.RunRate;
            Happen(new PlayerEvent(PlayerEventKind.RunRateChanged, now, runRate));
        }

        if (airborne && body.HasContact) Happen(new PlayerEvent(PlayerEventKind.Landed, now, fallSpeed));
        airborne = !body.HasContact;
        fallSpeed = airborne ? -body.Velocity.Z : 0;
        MotionSummary motions = movement.Motions;
        Position position = body.Position;
        double time = body.IsActive ? body.SimulatedTime : now;
        Pose = new PlayerPose(
            time,
            position.CellId,
            position.Frame.Origin,
            PlayerPose.YawOf(position),
            Sight.VelocityOf(body),
            speed.At(time, position),
            FlagsOf(body, movement),
            body.HasContact ? body.ContactPlane : default,
            player.Controller.JumpLevel(now),
            body.LastQuantum,
            runRate,
            (uint)motions.Forward,
            motions.ForwardSpeed,
            motions.Sidestep == MotionCommand.None ? 0 : motions.SidestepSpeed,
            motions.Turn == MotionCommand.None ? 0 : motions.TurnSpeed,
            teleports,
            walks);
        reader.Read(trace);
        if (body.HasCell) reader.CopyTo(touches);
        else touches.Clear();
    }

    private PoseFlags FlagsOf(PhysicsBody body, MovementManager movement)
    {
        PoseFlags flags = Sight.FlagsOf(body);
        if (player.Controller.IsChargingJump) flags |= PoseFlags.Charging;
        if (movement.StandingLongJump) flags |= PoseFlags.StandingLongJump;
        if (!body.HasCell) flags |= PoseFlags.Nowhere;
        if (isEnclosed(body.Position.CellId)) flags |= PoseFlags.Enclosed;
        return flags;
    }
}
