using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <content>Stairs, up and down.</content>
internal sealed partial class Transition
{
    /// <summary>Why the last probe found no footing, for whoever listens.</summary>
    private TraceReason probeRefusal;

    /// <summary>
    /// Tries to stand on what blocks: footing up to the step-up height above the sphere's bottom lifts the body. True when it
    /// now stands higher; otherwise the position is as before.
    /// </summary>
    /// <remarks>Retail: CTransition::step_up @0x0050B610.</remarks>
    internal bool StepUp(Vector3 normal)
    {
        Collision.VoidContactPlane();
        Path.SteppingUp = true;
        Path.StepUpNormal = normal;
        float height = AirborneProbe, walkableZ = RetailMath.LandingZ;
        if (Object.Has(MoverFlags.OnWalkable))
        {
            walkableZ = RetailMath.FloorZ;
            height = Object.StepUpHeight;
        }

        Path.WalkableAllowance = walkableZ;
        Path.SaveCheckPos();
        Trace?.Tries(this, TransitionResponse.StepUp, normal);
        bool stands = StepDown(height, walkableZ);
        Path.SteppingUp = false;
        Path.Walkable = default;
        Trace?.Settles(this, TransitionResponse.StepUp, normal, stands, probeRefusal);
        if (!stands) Path.RestoreCheckPos();
        return stands;
    }

    /// <summary>
    /// Probes for footing within <paramref name="height"/> below (while stepping up: above) the check position. The position is left where
    /// the probe ended; callers restore it or probe on.
    /// </summary>
    /// <returns>True when footing was found and the place is free.</returns>
    /// <remarks>Retail: CTransition::step_down @0x0050B2A0.</remarks>
    private bool StepDown(float height, float walkableZ)
    {
        Path.NegPolyHit = false;
        Path.SteppingDown = true;
        Path.StepDownAmount = height;
        Path.WalkInterp = 1f;
        Trace?.Tries(this, TransitionResponse.StepDown, Vector3.Zero);
        if (!Path.SteppingUp) Path.AddOffsetToCheckPos(new Vector3(0, 0, -height));
        TransitionState state = TransitionalInsert(AttemptsPerProbe);
        Path.SteppingDown = false;

        if (Trace is not null) probeRefusal = RefusalOfFooting(state, walkableZ);
        bool found = state == TransitionState.OK && Collision.ContactPlaneValid && Collision.ContactPlane.Normal.Z >= walkableZ &&
                     (!Object.Has(MoverFlags.EdgeSlide) || Path.SteppingUp || CheckWalkable(walkableZ));
        if (found)
        {
            probeRefusal = TraceReason.NoRoom;
            Path.BackupInsertType = Path.InsertType;
            Path.InsertType = InsertType.Placement;
            state = TransitionalInsert(1);
            Path.InsertType = Path.BackupInsertType;
            found = state == TransitionState.OK;
        }

        Trace?.Settles(this, TransitionResponse.StepDown, Collision.ContactPlane.Normal, found, probeRefusal);
        return found;
    }

    /// <summary>What speaks against the footing that a probe found; when nothing does, only its support is left to ask about.</summary>
    private TraceReason RefusalOfFooting(TransitionState state, float walkableZ)
    {
        if (state != TransitionState.OK) return TraceReason.Blocked;
        if (!Collision.ContactPlaneValid) return TraceReason.NoFooting;
        return Collision.ContactPlane.Normal.Z >= walkableZ ? TraceReason.BarelySupported : TraceReason.TooSteep;
    }

    /// <summary>Is there footing under the body? Asked by moving down: hitting something means yes.</summary>
    /// <remarks>Retail: CTransition::check_walkable @0x0050AFF0.</remarks>
    private bool CheckWalkable(float walkableZ)
    {
        if (!Object.Has(MoverFlags.OnWalkable) || Path.CheckWalkables()) return true;

        Position position = Path.CheckPos;
        ObjCell? cell = Path.CheckCell;
        double height = Object.StepDownHeight, radius = Path.GlobalSpheres[0].Radius;
        Path.WalkableAllowance = walkableZ;
        Path.CheckingWalkable = true;
        if (Path.SphereCount < 2 && height > 2 * radius) height = (float)(radius / 2);
        if (height > 2 * radius) height = (float)(height / 2);
        Path.AddOffsetToCheckPos(new Vector3(0, 0, (float)-height));
        TransitionState state = TransitionalInsert(1);
        Path.CheckingWalkable = false;
        Path.SetCheckPos(position, cell);
        return state != TransitionState.OK;
    }
}
