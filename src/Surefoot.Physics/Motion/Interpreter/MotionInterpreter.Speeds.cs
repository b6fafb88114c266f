using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Motion;

/// <content>Normalising commands, and the speeds that follow from a state.</content>
internal sealed partial class MotionInterpreter
{
    private const float BackwardsFactor = -0.65f;
    private const float SidestepFactor = (float)(MovementFormulas.WalkSpeed / (double)MovementFormulas.SidestepSpeed * 0.5);
    private const float RunTurnFactor = 1.5f;
    private const float MaxSidestep = 3f;

    /// <summary>Factor between the forward speed and the run rate: retail has a field for it that nothing writes.</summary>
    private const float SpeedFactor = 1f;

    /// <summary>Left becomes right and back becomes forward, with signed speeds; the run key makes forward a run.</summary>
    /// <remarks>Retail: CMotionInterp::adjust_motion @0x00528010.</remarks>
    public void AdjustMotion(ref MotionCommand motion, ref float speed, HoldKey key)
    {
        if (!IsCreature) return;
        switch (motion)
        {
            case MotionCommand.RunForward:
                return;
            case MotionCommand.TurnLeft:
                (motion, speed) = (MotionCommand.TurnRight, -speed);
                break;
            case MotionCommand.WalkBackwards:
                (motion, speed) = (MotionCommand.WalkForward, (float)((double)BackwardsFactor * speed));
                break;
            case MotionCommand.SideStepLeft:
                (motion, speed) = (MotionCommand.SideStepRight, (float)((double)SidestepFactor * -speed));
                break;
            case MotionCommand.SideStepRight:
                speed = (float)((double)SidestepFactor * speed);
                break;
        }

        if (key == HoldKey.Invalid) key = Raw.CurrentHoldKey;
        if (key == HoldKey.Run) ApplyRunToCommand(ref motion, ref speed);
    }

    /// <summary>What the run key makes of a command.</summary>
    /// <remarks>Retail: CMotionInterp::apply_run_to_command @0x00527BE0. Going backwards stays a walk and is multiplied as well.</remarks>
    private void ApplyRunToCommand(ref MotionCommand motion, ref float speed)
    {
        float rate = RunRate;
        switch (motion)
        {
            case MotionCommand.WalkForward:
                if (speed > 0) motion = MotionCommand.RunForward;
                speed = (float)((double)rate * speed);
                break;
            case MotionCommand.TurnRight:
                speed = (float)((double)RunTurnFactor * speed);
                break;
            case MotionCommand.SideStepRight:
                speed = (float)((double)rate * speed);
                if (Math.Abs(speed) > MaxSidestep) speed = speed > 0 ? MaxSidestep : -MaxSidestep;
                break;
        }
    }

    /// <summary>The weenie's own run rate, or the one a server told; 1 without a weenie.</summary>
    public float RunRate => weenie is null ? 1f : weenie.InqRunRate(out float rate) ? rate : MyRunRate;

    /// <summary>Velocity that the interpreted state stands for, m/s in the body's axes, at most the running speed.</summary>
    /// <remarks>
    /// Retail: CMotionInterp::get_state_velocity @0x00527D50. Not how the body moves on the ground (its animations say that): what it takes
    /// along into a jump.
    /// </remarks>
    public Vector3 GetStateVelocity()
    {
        Vector3 v = Vector3.Zero;
        if (Interpreted.SidestepCommand == MotionCommand.SideStepRight)
            v.X = (float)((double)MovementFormulas.SidestepSpeed * Interpreted.SidestepSpeed);
        if (Interpreted.ForwardCommand == MotionCommand.WalkForward)
            v.Y = (float)((double)MovementFormulas.WalkSpeed * Interpreted.ForwardSpeed);
        else if (Interpreted.ForwardCommand == MotionCommand.RunForward)
            v.Y = (float)((double)MovementFormulas.RunSpeed * Interpreted.ForwardSpeed);
        double limit = (double)MovementFormulas.RunSpeed * RunRate, length = RetailMath.Length(v);
        // A standing body with a run rate below 0, which only a server can tell, has no length to divide by.
        return length > limit && length > 0 ? RetailMath.Scale(v, limit / length) : v;
    }

    /// <summary>Running speed, m/s.</summary>
    /// <remarks>Retail: CMotionInterp::get_max_speed @0x00527CB0.</remarks>
    public float MaxSpeed => (float)((double)MovementFormulas.RunSpeed * RunRate);

    /// <summary>Running speed as it is now: that of the forward motion when it runs, m/s.</summary>
    /// <remarks>Retail: CMotionInterp::get_adjusted_max_speed @0x00527D00.</remarks>
    public float AdjustedMaxSpeed => Interpreted.ForwardCommand == MotionCommand.RunForward
        ? (float)((double)Interpreted.ForwardSpeed / SpeedFactor * MovementFormulas.RunSpeed)
        : MaxSpeed;
}
