using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <content>What the body calls, and what its managers ask of each other.</content>
internal abstract partial class SteeredBody
{
    /// <summary>From this distance to the local player on, a body is put where a server says it is, metres.</summary>
    private const float FarFromPlayer = 96f;

    /// <inheritdoc cref="IBodyDriver.IsInterpolating"/>
    public bool IsInterpolating => position is { IsInterpolating: true };

    /// <inheritdoc cref="IBodyDriver.IsFullyConstrained"/>
    public bool IsFullyConstrained => position is { IsFullyConstrained: true };

    /// <inheritdoc cref="IBodyDriver.StickyObjectId"/>
    public uint StickyObjectId => position?.StickyObjectId ?? 0;

    /// <inheritdoc cref="IBodyDriver.AdjustOffset"/>
    public void AdjustOffset(ref Frame offset, float quantum) => position?.AdjustOffset(ref offset, quantum);

    /// <summary>First at the end of a quantum, before the motions: what is tracked, and who tracks.</summary>
    /// <param name="physicsTime">Simulated time of the body, seconds.</param>
    public void HandleTargetting(double physicsTime) => targets?.HandleTargetting(physicsTime);

    /// <summary>Last at the end of a quantum: blips, and the end of sticking.</summary>
    public void UseTime() => position?.UseTime();

    /// <inheritdoc cref="IBodyDriver.InterpolateTo"/>
    /// <remarks>Retail: CPhysicsObj::InterpolateTo @0x005104F0.</remarks>
    public void InterpolateTo(in Position place, bool keepHeading) => MakePositionManager().InterpolateTo(place, keepHeading);

    /// <inheritdoc cref="IBodyDriver.StopInterpolating"/>
    public void StopInterpolating() => position?.StopInterpolating();

    /// <inheritdoc cref="IBodyDriver.ConstrainTo"/>
    /// <remarks>Retail: CPhysicsObj::ConstrainTo @0x00510520.</remarks>
    public void ConstrainTo(in Position place, float start, float max) => MakePositionManager().ConstrainTo(place, start, max);

    /// <inheritdoc cref="IBodyDriver.Unconstrain"/>
    public void Unconstrain() => position?.Unconstrain();

    /// <inheritdoc cref="IBodyDriver.StickToObject"/>
    /// <remarks>Retail: CPhysicsObj::stick_to_object @0x005127E0. What a creature holds is stuck to at the creature.</remarks>
    public void StickToObject(uint id)
    {
        PositionManager manager = MakePositionManager();
        SteeredBody? target = Find(id);
        if (target is { ParentId: not 0 }) target = Find(target.ParentId);
        if (target is not null) manager.StickTo(target.Id, target.Radius);
    }

    /// <inheritdoc cref="IBodyDriver.Unstick"/>
    public void Unstick() => position?.Unstick();

    /// <summary>Ends a move-to under way.</summary>
    /// <remarks>Retail: CPhysicsObj::cancel_moveto @0x005101F0.</remarks>
    internal void CancelMoveTo() => MoveTo?.Cancel(MotionError.Cancelled);

    /// <summary>Tracks an object instead of what was tracked so far.</summary>
    /// <remarks>Retail: CPhysicsObj::set_target @0x0050ED30.</remarks>
    internal void SetTarget(uint context, uint id, float radius, double quantum) =>
        MakeTargetManager().SetTarget(context, id, radius, quantum);

    /// <summary>Tracks nothing any more.</summary>
    internal void ClearTarget() => targets?.ClearTarget();

    /// <inheritdoc cref="IBodyDriver.MoveOrTeleport"/>
    /// <remarks>Retail: CPhysicsObj::MoveOrTeleport @0x00516330, and the leash that its caller ties.</remarks>
    public PositionUpdate MoveOrTeleport(in Position place, bool teleported, bool contact)
    {
        PositionUpdate update;
        if (teleported || !HasCell)
        {
            TeleportHook();
            Place(place);
            update = PositionUpdate.Teleported;
        }
        else if (!contact)
        {
            return PositionUpdate.Ignored;
        }
        else if (PlayerDistance >= FarFromPlayer)
        {
            StopInterpolating();
            Place(place);
            update = PositionUpdate.Placed;
        }
        else
        {
            InterpolateTo(place, keepHeading: MoveTo is { IsMovingTo: true });
            update = PositionUpdate.Interpolated;
        }

        // At where the body is now: catching up uses the leash.
        Position here = Position;
        ConstrainTo(here, CorrectionDistances.LeashStart(here.CellId), CorrectionDistances.LeashMax(here.CellId));
        return update;
    }

    /// <inheritdoc cref="IBodyDriver.HandleTeleport"/>
    /// <remarks>Retail: CPhysicsObj::teleport_hook @0x00514ED0, all but its end of touches.</remarks>
    public void HandleTeleport()
    {
        CancelMoveTo();
        Unstick();
        StopInterpolating();
        Unconstrain();
        targets?.EndTracking(TargetStatus.Teleported);
    }

    /// <summary>The body leaves the world: it lets go, and whoever tracks it is told.</summary>
    /// <remarks>Retail: CPhysicsObj::exit_world @0x00514E60, the part of these managers.</remarks>
    public void HandleExitWorld()
    {
        Unstick();
        targets?.EndTracking(TargetStatus.LeftWorld);
    }

    /// <inheritdoc cref="IBodyDriver.AddTo"/>
    public void AddTo(ref StateHash hash)
    {
        position?.AddTo(ref hash);
        MoveTo?.AddTo(ref hash);
        targets?.AddTo(ref hash);
    }
}
