using Surefoot.Client;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>The keys of a page as those of a player's controller.</summary>
internal static class KeyTranslation
{
    /// <summary>The same keys.</summary>
    public static MovementKeys Of(PlayerKeys held)
    {
        MovementKeys keys = MovementKeys.None;
        if (held.HasFlag(PlayerKeys.Forward)) keys |= MovementKeys.Forward;
        if (held.HasFlag(PlayerKeys.Back)) keys |= MovementKeys.Back;
        if (held.HasFlag(PlayerKeys.TurnLeft)) keys |= MovementKeys.TurnLeft;
        if (held.HasFlag(PlayerKeys.TurnRight)) keys |= MovementKeys.TurnRight;
        if (held.HasFlag(PlayerKeys.SidestepLeft)) keys |= MovementKeys.SidestepLeft;
        if (held.HasFlag(PlayerKeys.SidestepRight)) keys |= MovementKeys.SidestepRight;
        if (held.HasFlag(PlayerKeys.Walk)) keys |= MovementKeys.Walk;
        if (held.HasFlag(PlayerKeys.Jump)) keys |= MovementKeys.Jump;
        return keys;
    }
}
