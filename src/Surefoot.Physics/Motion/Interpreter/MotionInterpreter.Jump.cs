using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <content>Jumping, leaving the ground and coming back to it.</content>
internal sealed partial class MotionInterpreter
{
    /// <summary>Jump speed without a weenie, m/s.</summary>
    private const float DefaultJumpVelocity = 10f;

    /// <summary>The jump key went down. Standing still it begins a standing long jump: until the jump the body stays where it is.</summary>
    /// <remarks>Retail: CMotionInterp::charge_jump @0x005281C0.</remarks>
    public MotionError ChargeJump()
    {
        MotionError error = JumpChargeIsAllowed(JumpExtent);
        if (error != MotionError.None) return error;
        if (body is not null && Stands(body) && Interpreted.ForwardCommand == MotionCommand.Ready &&
            Interpreted.SidestepCommand == MotionCommand.None && Interpreted.TurnCommand == MotionCommand.None)
            StandingLongJump = true;
        return MotionError.None;
    }

    /// <summary>The charge is over, whether a jump follows or not.</summary>
    /// <remarks>Retail: what ClientCombatSystem::FinishJump @0x0056A9B0 clears in the interpreter.</remarks>
    public void EndJumpCharge() => StandingLongJump = false;

    /// <summary>Jumps: leaves the ground with the velocity of the motion and the upward speed of the charge.</summary>
    /// <param name="extent">Charge, 0 to 1.</param>
    /// <exception cref="ArgumentException">The charge is NaN or infinite.</exception>
    /// <remarks>Retail: CMotionInterp::jump @0x00528780.</remarks>
    public MotionError Jump(float extent)
    {
        if (!float.IsFinite(extent)) throw new ArgumentException("The extent of a jump is not finite.", nameof(extent));
        if (body is null) return MotionError.NoBody;
        body.CancelMoveTo();
        MotionError error = JumpIsAllowed(extent);
        if (error != MotionError.None)
        {
            StandingLongJump = false;
            return error;
        }

        JumpExtent = extent;
        body.SetOnWalkable(false);
        return MotionError.None;
    }

    /// <summary>May the body jump now? The order of the reasons is retail's and decides which one is told.</summary>
    /// <remarks>Retail: CMotionInterp::jump_is_allowed @0x005282B0.</remarks>
    public MotionError JumpIsAllowed(float extent)
    {
        if (body is null || (IsCreature && body.HasGravity && !Stands(body))) return MotionError.NotOnGround;
        if (body.IsFullyConstrained) return MotionError.GeneralFailure;
        if (pending.Count > 0 && pending[0].JumpError != MotionError.None) return pending[0].JumpError;
        MotionError error = JumpChargeIsAllowed(extent);
        if (error != MotionError.None) return error;
        error = MotionAllowsJump(Interpreted.ForwardCommand);
        if (error != MotionError.None) return error;
        return weenie is null || weenie.JumpStaminaCost(extent, out _) ? MotionError.None : MotionError.GeneralFailure;
    }

    /// <summary>Motions during which one cannot jump.</summary>
    /// <remarks>Retail: CMotionInterp::motion_allows_jump @0x005279E0.</remarks>
    public static MotionError MotionAllowsJump(MotionCommand motion) => (uint)motion is
        (>= 0x1000006F and <= 0x10000078) or (>= 0x10000128 and <= 0x10000131) or 0x40000008 or (>= 0x40000016 and <= 0x40000018) or
        (>= 0x4000001E and <= 0x40000039) or (>= 0x41000012 and <= 0x41000014)
        ? MotionError.CannotJumpFromThisPosition
        : MotionError.None;

    /// <remarks>Retail: CMotionInterp::jump_charge_is_allowed @0x00527A50.</remarks>
    private MotionError JumpChargeIsAllowed(float extent)
    {
        if (weenie is not null && !weenie.CanJump(extent)) return MotionError.TooLoadedToJump;
        return Interpreted.ForwardCommand is MotionCommand.Fallen or MotionCommand.Crouch or MotionCommand.Sitting or MotionCommand.Sleeping
            ? MotionError.CannotJumpFromThisPosition
            : MotionError.None;
    }

    /// <summary>The body no longer stands: it takes its motion's velocity along, and the jump's.</summary>
    /// <remarks>Retail: CMotionInterp::LeaveGround @0x00528B00.</remarks>
    public void LeaveGround()
    {
        if (body is null || !IsCreature || !body.HasGravity) return;
        body.SetLocalVelocity(GetLeaveGroundVelocity());
        StandingLongJump = false;
        JumpExtent = 0f;
        RemoveLinkAnimations();
        ApplyCurrentMovement(cancelMoveTo: false, disallowJump: false);
    }

    /// <summary>The body stands again: what is asked of it now acts at once.</summary>
    /// <remarks>Retail: CMotionInterp::HitGround @0x00528AC0.</remarks>
    public void HitGround()
    {
        if (body is null || !IsCreature || !body.HasGravity) return;
        RemoveLinkAnimations();
        ApplyCurrentMovement(cancelMoveTo: false, disallowJump: false);
    }

    /// <summary>
    /// Velocity at leaving the ground, m/s in the body's axes: that of the state and the jump, or what the body has when both are nothing.
    /// </summary>
    /// <remarks>Retail: CMotionInterp::get_leave_ground_velocity @0x005280C0.</remarks>
    public Vector3 GetLeaveGroundVelocity()
    {
        Vector3 v = GetStateVelocity();
        v.Z = GetJumpVelocity();
        return RetailMath.IsZero(v) && body is not null ? body.LocalVelocity : v;
    }

    /// <summary>Upward speed of the jump under way, m/s; 0 without one.</summary>
    /// <remarks>Retail: CMotionInterp::get_jump_v_z @0x00527AA0.</remarks>
    public float GetJumpVelocity()
    {
        if (JumpExtent < RetailMath.Epsilon) return 0f;
        if (weenie is null) return DefaultJumpVelocity;
        return weenie.InqJumpVelocity(Math.Min(JumpExtent, 1f), out float velocity) ? velocity : 0f;
    }
}
