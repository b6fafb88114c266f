using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>How far a jump is charged.</summary>
/// <remarks>Retail: ClientCombatSystem::GetPowerBarLevel @0x0056ADE0.</remarks>
internal struct JumpCharge
{
    private double start;

    /// <summary>The jump key is held and its charge was allowed.</summary>
    public bool IsPending { get; private set; }

    /// <summary>The charge begins.</summary>
    public void Begin(double now) => (start, IsPending) = (now, true);

    /// <summary>The charge is over.</summary>
    public void End() => IsPending = false;

    /// <summary>0 to 1; it stays at 1 when the key is held longer.</summary>
    public readonly float Level(double now, MotionCommand style)
    {
        if (!IsPending) return 0f;
        double time = style == MotionCommand.DualWieldCombat ? MovementFormulas.DualWieldJumpChargeTime : MovementFormulas.JumpChargeTime;
        return (float)Math.Clamp((now - start) / time, 0.0, 1.0);
    }
}
