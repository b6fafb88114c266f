using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Client;

/// <summary>The jump key: it charges a jump while it is held, and jumps when it is let go.</summary>
/// <remarks>Retail: the jump of ClientCombatSystem; specification 01, 4.12 and 09b, 10.</remarks>
internal sealed class JumpKey(MovementManager movement, MovementSender sender)
{
    private double start;

    /// <summary>The key is held and its charge was accepted.</summary>
    public bool IsPending { get; private set; }

    /// <summary>Why the last charge or jump was refused; none when it was not.</summary>
    public MotionError LastRefusal { get; private set; }

    /// <summary>The key went down. No ground is asked for: a charge may begin in the air. Others see the crouch by what is sent.</summary>
    /// <remarks>Retail: ClientCombatSystem::CommenceJump @0x0056AF90.</remarks>
    public void Press(double now)
    {
        if (IsPending) return;
        LastRefusal = movement.Interpreter.ChargeJump();
        if (LastRefusal != MotionError.None) return;
        (start, IsPending) = (now, true);
        sender.SendMoveToState(now);
    }

    /// <summary>The key came up: the charge becomes a jump. Nothing when none is under way.</summary>
    /// <remarks>Retail: ClientCombatSystem::DoJump @0x0056B110.</remarks>
    public void Release(double now)
    {
        if (!IsPending) return;
        float extent = Math.Max(Level(now), MovementFormulas.MinJumpExtent);
        Finish();
        LastRefusal = movement.Interpreter.Jump(extent);
        if (LastRefusal == MotionError.None) sender.SendJump(extent, now);
    }

    /// <summary>The charge is over without a jump: no motion is applied again and nothing is sent.</summary>
    /// <remarks>Retail: ClientCombatSystem::FinishJump @0x0056A9B0.</remarks>
    public void Finish()
    {
        IsPending = false;
        movement.Interpreter.EndJumpCharge();
    }

    /// <summary>How far the jump is charged, 0 to 1; 0 when none is. The style worn at the moment of asking counts.</summary>
    /// <remarks>Retail: ClientCombatSystem::GetPowerBarLevel @0x0056ADE0.</remarks>
    public float Level(double now)
    {
        if (!IsPending) return 0f;
        bool dualWield = movement.Interpreter.Interpreted.CurrentStyle == MotionCommand.DualWieldCombat;
        double full = dualWield ? MovementFormulas.DualWieldJumpChargeTime : MovementFormulas.JumpChargeTime;
        return (float)Math.Clamp((now - start) / full, 0.0, 1.0);
    }
}
