using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>
/// What the managers know of their body and may do to it, and the managers themselves, each made when it is first needed. The abstract
/// members are all that a body has to offer; everything else in this folder is written on top of them.
/// </summary>
/// <remarks>Retail: the members of CPhysicsObj that its managers use; specification 09 and 09b.</remarks>
internal abstract partial class SteeredBody
{
    private PositionManager? position;
    private TargetManager? targets;

    /// <summary>Object id.</summary>
    internal abstract uint Id { get; }

    /// <summary>Id of the object that holds this one, 0 when none does.</summary>
    internal abstract uint ParentId { get; }

    /// <summary>Where it is.</summary>
    internal abstract Position Position { get; }

    /// <summary>Radius, metres.</summary>
    internal abstract float Radius { get; }

    /// <summary>Height, metres.</summary>
    internal abstract float Height { get; }

    /// <summary>Distance covered in the last quantum divided by the quantum, m/s.</summary>
    internal abstract Vector3 AchievedVelocity { get; }

    /// <summary>Touches a plane.</summary>
    internal abstract bool HasContact { get; }

    /// <summary>Is in a cell.</summary>
    internal abstract bool HasCell { get; }

    /// <summary>Is the local player.</summary>
    internal abstract bool IsLocalPlayer { get; }

    /// <summary>Distance from the local player as the last tick found it, metres.</summary>
    internal abstract float PlayerDistance { get; }

    /// <summary>Time of the frame, seconds.</summary>
    internal abstract double Now { get; }

    /// <summary>Running speed, m/s.</summary>
    internal abstract float MaxSpeed { get; }

    /// <summary>Running speed as it is now: that of the forward motion when it runs, m/s.</summary>
    internal abstract float AdjustedMaxSpeed { get; }

    /// <summary>Motions wait to be done.</summary>
    internal abstract bool MotionsPending { get; }

    /// <summary>The move-to manager, or null while none is needed.</summary>
    internal abstract MoveToManager? MoveTo { get; }

    /// <summary>The body with this id, or null when no such object is known.</summary>
    internal abstract SteeredBody? Find(uint id);

    /// <summary>Has the body simulated from now on.</summary>
    internal abstract void Wake();

    /// <summary>Turns the body to a compass heading, degrees.</summary>
    internal abstract void SetHeading(float degrees);

    /// <summary>Puts the body somewhere, or to a free place near by; false when it was refused and nothing changed.</summary>
    /// <remarks>Retail: CPhysicsObj::SetPositionSimple, and SetPosition with the same flags 0x1012.</remarks>
    internal abstract bool Place(in Position place);

    /// <summary>What a teleport ends: <see cref="HandleTeleport"/>, and every touch.</summary>
    internal abstract void TeleportHook();

    /// <summary>Begins a motion, normalised first; the normalised speed is left in the parameters.</summary>
    internal abstract MotionError DoMotion(MotionCommand motion, ref MovementParameters parameters);

    /// <summary>Ends a motion, normalised first; the normalised speed is left in the parameters.</summary>
    internal abstract MotionError StopMotion(MotionCommand motion, ref MovementParameters parameters);

    /// <summary>Ends every motion and whatever move-to is under way.</summary>
    internal abstract void StopCompletely();

    /// <summary>A move-to or turn-to is over, before its motions are ended.</summary>
    /// <param name="error">None when it arrived.</param>
    internal abstract void OnMoveToEnded(MotionError error);

    /// <summary>A report of what the body tracks: movement first, then position.</summary>
    /// <remarks>Retail: CPhysicsObj::HandleUpdateTarget @0x00512BC0.</remarks>
    internal virtual void HandleUpdateTarget(in TargetInfo info)
    {
        if (info.ContextId != 0) return;
        MoveTo?.HandleUpdateTarget(info);
        position?.HandleUpdateTarget(info);
    }

    /// <summary>The group of position managers, made when it is asked for; each time the body wakes.</summary>
    /// <remarks>Retail: CPhysicsObj::MakePositionManager @0x00510210.</remarks>
    internal PositionManager MakePositionManager()
    {
        Wake();
        return position ??= new PositionManager(this);
    }

    /// <summary>The target manager, made when it is asked for.</summary>
    internal TargetManager MakeTargetManager() => targets ??= new TargetManager(this);

    /// <summary>The group of position managers, or null while none is needed.</summary>
    internal PositionManager? PositionManager => position;

    /// <summary>The target manager, or null while none is needed.</summary>
    internal TargetManager? TargetManager => targets;
}
