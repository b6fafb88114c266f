using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>
/// The body of specification 09, 6: it stands on flat ground and every sweep passes unless it is blocked; motions act at once.
/// </summary>
internal sealed class FakeSteeredBody : SteeredBody
{
    internal const uint Cell = 0xA9B40019;
    internal const float Quantum = 1f / 30;

    private readonly FakeSteeredWorld world;
    private Position position;

    internal FakeSteeredBody(FakeSteeredWorld world, uint id, Vector3 origin, float heading = 0)
    {
        this.world = world;
        Id = id;
        position = At(origin, heading);
        world.Bodies.Add(id, this);
    }

    internal override uint Id { get; }

    internal override uint ParentId => Parent?.Id ?? 0;

    internal FakeSteeredBody? Parent { get; set; }

    internal override Position Position => position;

    internal override float Radius => OwnRadius;

    internal override float Height => OwnHeight;

    internal float OwnRadius { get; set; } = 0.5f;

    internal float OwnHeight { get; set; } = 1.8f;

    internal override Vector3 AchievedVelocity => Achieved;

    internal Vector3 Achieved { get; set; }

    internal override bool HasContact => Contact;

    internal bool Contact { get; set; } = true;

    internal override bool HasCell => InWorld;

    internal bool InWorld { get; set; } = true;

    internal override bool IsLocalPlayer => Player;

    internal bool Player { get; set; }

    internal override float PlayerDistance => DistanceFromPlayer;

    internal float DistanceFromPlayer { get; set; } = 30f;

    internal override double Now => world.Now;

    internal override float MaxSpeed => Speed;

    internal override float AdjustedMaxSpeed => Adjusted ?? Speed;

    internal float Speed { get; set; } = 4f;

    internal float? Adjusted { get; set; }

    internal override bool MotionsPending => Pending;

    internal bool Pending { get; set; }

    internal override MoveToManager? MoveTo => Mover;

    internal MoveToManager? Mover { get; private set; }

    /// <summary>Motion of a quantum in the body's own axes, metres.</summary>
    internal Vector3 Root { get; set; }

    /// <summary>No sweep passes.</summary>
    internal bool Blocked { get; set; }

    /// <summary>Placements are refused.</summary>
    internal bool Refuses { get; set; }

    /// <summary>The error of motions that are refused.</summary>
    internal MotionError Refusal { get; set; }

    /// <summary>Motions begun and ended, with the speeds they were asked for.</summary>
    internal List<string> Done { get; } = [];

    /// <summary>Reports of what it tracks.</summary>
    internal List<TargetInfo> Reports { get; } = [];

    /// <summary>Why orders ended.</summary>
    internal List<MotionError> Ended { get; } = [];

    /// <summary>Placements asked for.</summary>
    internal List<Position> Placements { get; } = [];

    /// <summary>The motion of the last quantum after the managers bent it.</summary>
    internal Frame Offset { get; private set; } = Frame.Identity;

    internal float Y => position.Frame.Origin.Y;

    internal InterpolationManager Interpolation => PositionManager!.Interpolation!;

    internal StickyManager Sticky => PositionManager!.Sticky!;

    internal ConstraintManager Leash => PositionManager!.Constraint!;

    internal static Position At(Vector3 origin, float heading = 0)
    {
        Frame frame = new(origin, Quaternion.Identity);
        if (heading != 0) frame.SetHeading(heading);
        return new Position(Cell, frame);
    }

    internal static Position At(float x, float y, float heading = 0) => At(new Vector3(x, y, 0), heading);

    internal MoveToManager Order()
    {
        Mover ??= new MoveToManager(this);
        Mover.Interrupt();
        return Mover;
    }

    internal void Warp(in Position place) => position = place;

    internal override SteeredBody? Find(uint id) => world.Bodies.GetValueOrDefault(id);

    internal override void Wake()
    {
    }

    internal override void SetHeading(float degrees) => position.Frame.SetHeading(degrees);

    internal override bool Place(in Position place)
    {
        Placements.Add(place);
        if (Refuses) return false;
        position = place;
        InWorld = true;
        return true;
    }

    internal override void TeleportHook() => HandleTeleport();

    internal override MotionError DoMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        Normalise(ref motion, ref parameters);
        if (Refusal != MotionError.None) return Refusal;
        Done.Add(FormattableString.Invariant($"do {motion} {parameters.Speed}"));
        return MotionError.None;
    }

    internal override MotionError StopMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        Normalise(ref motion, ref parameters);
        Done.Add($"stop {motion}");
        return MotionError.None;
    }

    internal override void StopCompletely()
    {
        CancelMoveTo();
        Done.Add("halt");
    }

    internal override void OnMoveToEnded(MotionError error) => Ended.Add(error);

    internal override void HandleUpdateTarget(in TargetInfo info)
    {
        Reports.Add(info);
        base.HandleUpdateTarget(info);
    }

    /// <summary>A quantum: its motion, the sweep, and the managers after it. The clock stays.</summary>
    internal void Advance(float quantum = Quantum)
    {
        Frame offset = Frame.Identity;
        offset.Origin = Root;
        AdjustOffset(ref offset, quantum);
        Offset = offset;
        Frame proposal = Frame.Combine(position.Frame, offset);
        if (Blocked) proposal.Origin = position.Frame.Origin;
        position.Frame = proposal;
        Mover?.UseTime();
        UseTime();
    }

    internal void Advance(int quanta)
    {
        for (int i = 0; i < quanta; i++) Advance();
    }

    private static void Normalise(ref MotionCommand motion, ref MovementParameters parameters) =>
        new MotionInterpreter(null, null, new OtherWeenie()).AdjustMotion(ref motion, ref parameters.Speed, parameters.HoldKey);
}

/// <summary>Bodies by id, and the clock of the frame.</summary>
internal sealed class FakeSteeredWorld
{
    internal Dictionary<uint, SteeredBody> Bodies { get; } = [];

    internal double Now { get; set; } = 100;
}
