using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>
/// The body of the recorded runs of the managers: it moves freely, without terrain, collision or animation, and obeys motions at once. The
/// managers over it are the real ones. <c>tests/data/remote-vectors/README.md</c> defines it.
/// </summary>
internal sealed class StubBody(StubWorld world, StubSettings settings) : SteeredBody
{
    private const float RightAngleAsSpeed = 1.5707964f;
    private MoveToManager? moveTo;

    internal StubSettings Settings => settings;

    /// <summary>The motion of the last quantum after the managers bent it.</summary>
    internal Frame Offset { get; private set; } = Frame.Identity;

    internal override uint Id => settings.Id;

    internal override uint ParentId => settings.ParentId;

    internal override Position Position => settings.Position;

    internal override float Radius => settings.Radius;

    internal override float Height => settings.Height;

    internal override Vector3 AchievedVelocity => settings.Velocity;

    internal override bool HasContact => settings.Contact;

    internal override bool HasCell => settings.HasCell;

    internal override bool IsLocalPlayer => settings.IsPlayer;

    internal override float PlayerDistance => settings.PlayerDistance;

    internal override double Now => world.Clock;

    internal override float MaxSpeed => settings.Speeds?.Max ?? (float)(4.0 * settings.RunRate);

    internal override float AdjustedMaxSpeed => settings.Speeds?.Adjusted ??
        (float)(4.0 * (settings.Forward == MotionCommand.RunForward ? settings.ForwardSpeed : settings.RunRate));

    internal override bool MotionsPending => settings.PendingQuanta > 0;

    internal override MoveToManager? MoveTo => moveTo;

    internal MoveToManager MakeMoveTo() => moveTo ??= new MoveToManager(this);

    internal override SteeredBody? Find(uint id) => world.Find(id);

    internal override void Wake()
    {
    }

    internal override void SetHeading(float degrees) => settings.Position.Frame.SetHeading(degrees);

    internal override bool Place(in Position place)
    {
        world.Log("place", Id, place, settings.Placing);
        if (!settings.Placing) return false;
        settings.Position = place;
        MoveIntoCellBelow();
        settings.HasCell = true;
        return true;
    }

    internal override void TeleportHook()
    {
        world.Log("teleport-hook", Id);
        HandleTeleport();
    }

    internal override MotionError DoMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        Adjust(ref motion, ref parameters);
        if (settings.Refusal != MotionError.None)
        {
            world.Log("do", Id, motion, parameters.Speed, (int)settings.Refusal);
            return settings.Refusal;
        }

        world.Log("do", Id, motion, parameters.Speed);
        if (motion == MotionCommand.TurnRight) settings.TurnSpeed = parameters.Speed;
        else (settings.Forward, settings.ForwardSpeed) = (motion, parameters.Speed);
        Wait(settings.PendingAfterDo);
        return MotionError.None;
    }

    internal override MotionError StopMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        Adjust(ref motion, ref parameters);
        world.Log("stop", Id, motion);
        if (motion == MotionCommand.TurnRight) settings.TurnSpeed = null;
        else if (motion == settings.Forward) settings.Forward = MotionCommand.Ready;
        Wait(settings.PendingAfterStop);
        return MotionError.None;
    }

    internal override void StopCompletely()
    {
        CancelMoveTo();
        world.Log("halt", Id);
        settings.Forward = MotionCommand.Ready;
        settings.TurnSpeed = null;
        Wait(settings.PendingAfterHalt);
    }

    internal override void OnMoveToEnded(MotionError error)
    {
        if (error != MotionError.None) world.Log("cancel", Id);
    }

    internal override void HandleUpdateTarget(in TargetInfo info)
    {
        world.Log("told", Id, info);
        base.HandleUpdateTarget(info);
    }

    /// <summary>One quantum, seconds.</summary>
    internal void Advance(float quantum)
    {
        Frame offset = RootMotion(quantum);
        AdjustOffset(ref offset, quantum);
        Offset = offset;
        Commit(Frame.Combine(settings.Position.Frame, offset), quantum);
        HandleTargetting(world.Clock);
        moveTo?.UseTime();
        if (settings.PendingQuanta > 0) settings.PendingQuanta--;
        UseTime();
    }

    private Frame RootMotion(float quantum)
    {
        Vector3 velocity = settings.Forward switch
        {
            MotionCommand.WalkForward => new Vector3(0, (float)((double)MovementFormulas.WalkSpeed * settings.ForwardSpeed), 0),
            MotionCommand.RunForward => new Vector3(0, (float)((double)MovementFormulas.RunSpeed * settings.ForwardSpeed), 0),
            _ => Vector3.Zero,
        };
        float turn = settings.TurnSpeed is { } speed ? (float)(-(double)RightAngleAsSpeed * speed) : 0;
        if (settings.Root is { } root) (velocity, turn) = (new Vector3(root.X, root.Y, root.Z), root.W);

        Frame offset = Frame.Identity;
        offset.Origin = settings.Walkable ? RetailMath.Scale(velocity, quantum) : Vector3.Zero;
        offset.RotateGlobal(new Vector3(0, 0, (float)((double)quantum * turn)));
        return offset;
    }

    private void Commit(Frame proposal, float quantum)
    {
        Position before = settings.Position;
        Vector3 from = before.Frame.Origin;
        if (settings.Free == 0 || RetailMath.NearlyEqual(proposal.Origin, from))
        {
            proposal.Origin = from;
            settings.Position.Frame = proposal;
            settings.Velocity = Vector3.Zero;
            return;
        }

        if (settings.Free != 1) proposal.Origin = RetailMath.AddScaled(from, settings.Free, proposal.Origin - from);
        settings.Position.Frame = proposal;
        MoveIntoCellBelow();
        Vector3 moved = before.OffsetTo(settings.Position);
        double inverse = 1.0 / quantum;
        settings.Velocity = new Vector3(
            (float)(inverse * moved.X), (float)((float)inverse * (double)moved.Y), (float)((float)inverse * (double)moved.Z));
    }

    private void MoveIntoCellBelow()
    {
        if (CellIds.IsOutdoor(settings.Position.CellId)) settings.Position.AdjustToOutside();
    }

    /// <summary>As a creature's interpreter does with this run rate and hold key.</summary>
    private void Adjust(ref MotionCommand motion, ref MovementParameters parameters)
    {
        MotionInterpreter interpreter = new(null, null, new OtherWeenie()) { MyRunRate = settings.RunRate };
        interpreter.Raw.CurrentHoldKey = settings.HoldKey;
        interpreter.AdjustMotion(ref motion, ref parameters.Speed, parameters.HoldKey);
    }

    private void Wait(int quanta) => settings.PendingQuanta = Math.Max(settings.PendingQuanta, quanta);
}
