using Surefoot.Client;

namespace Surefoot.Tool.Authority;

/// <summary>Keys as somebody holds them who looks around: mostly ahead, with turns, sidesteps, jumps, walks and pauses.</summary>
internal sealed class KeyScript(Dice dice)
{
    private const MovementKeys Turns = MovementKeys.TurnLeft | MovementKeys.TurnRight;

    private MovementKeys going, turning, jumping, walking;
    private double goUntil, turnUntil, jumpUntil, walkUntil;

    /// <summary>The keys held at a time.</summary>
    internal MovementKeys At(double now)
    {
        if (now >= goUntil) (going, goUntil) = (Go(), now + dice.Roll(0.2, 4));
        if (now >= turnUntil) (turning, turnUntil) = turning == 0 ? (Turn(), now + dice.Roll(0.1, 1.5)) : (0, now + dice.Roll(0.2, 3));
        if (now >= jumpUntil)
            (jumping, jumpUntil) = jumping == 0 ? (MovementKeys.Jump, now + dice.Roll(0.02, 1.1)) : (0, now + dice.Roll(0.5, 8));
        if (now >= walkUntil)
            (walking, walkUntil) = walking == 0 ? (MovementKeys.Walk, now + dice.Roll(0.2, 3)) : (0, now + dice.Roll(2, 15));
        return going | turning | jumping | walking;
    }

    private MovementKeys Go()
    {
        double roll = dice.Roll();
        MovementKeys side = dice.Is(0.5) ? MovementKeys.SidestepLeft : MovementKeys.SidestepRight;
        return roll switch
        {
            < 0.65 => MovementKeys.Forward,
            < 0.75 => MovementKeys.Forward | side,
            < 0.82 => MovementKeys.Back,
            < 0.9 => side,
            _ => MovementKeys.None,
        };
    }

    private MovementKeys Turn() => dice.Is(0.5) ? MovementKeys.TurnLeft : Turns & ~MovementKeys.TurnLeft;
}
