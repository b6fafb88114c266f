namespace Surefoot.Physics.Motion;

/// <summary>What the game knows about a body beyond its physics. Only the local player's own weenie answers the four questions.</summary>
/// <remarks>Retail: the virtual calls of CWeenieObject that CMotionInterp makes; specification 01, 2.5.</remarks>
public interface IWeenieObj
{
    /// <summary>Is the local player.</summary>
    bool IsThePlayer { get; }

    /// <summary>Is a creature: it needs the ground to move and to jump.</summary>
    bool IsCreature { get; }

    /// <summary>Run rate from its own skill and load; false when it does not know.</summary>
    bool InqRunRate(out float rate);

    /// <summary>Upward speed of a jump with this charge, m/s; false when it does not know.</summary>
    bool InqJumpVelocity(float extent, out float velocity);

    /// <summary>Is not too loaded to jump.</summary>
    bool CanJump(float extent);

    /// <summary>Stamina a jump with this charge costs; false when it does not know.</summary>
    bool JumpStaminaCost(float extent, out int cost);
}

/// <summary>The weenie of a creature or another player: it knows no skills, so the server's speeds hold.</summary>
public sealed class OtherWeenie : IWeenieObj
{
    /// <summary>A weenie of something else than the local player.</summary>
    public OtherWeenie(bool isCreature = true) => IsCreature = isCreature;

    /// <inheritdoc/>
    public bool IsThePlayer => false;

    /// <inheritdoc/>
    public bool IsCreature { get; }

    /// <inheritdoc/>
    public bool InqRunRate(out float rate) => Unknown(out rate);

    /// <inheritdoc/>
    public bool InqJumpVelocity(float extent, out float velocity) => Unknown(out velocity);

    /// <inheritdoc/>
    public bool CanJump(float extent) => false;

    /// <inheritdoc/>
    public bool JumpStaminaCost(float extent, out int cost)
    {
        cost = 0;
        return false;
    }

    private static bool Unknown(out float value)
    {
        value = 0;
        return false;
    }
}
