using Surefoot.Client;
using Surefoot.Tool.Authority;

namespace Surefoot.Tool.Serving;

/// <summary>The keys of somebody who goes about: runs a while, turns while running, stands, jumps now and then.</summary>
internal sealed class LoadKeys(Dice dice)
{
    private MovementKeys going, turning, jumping;
    private double goUntil, turnUntil, jumpUntil;

    /// <summary>The keys held at a time.</summary>
    internal MovementKeys At(double now)
    {
        if (now >= goUntil)
            (going, goUntil) = dice.Is(0.7) ? (MovementKeys.Forward, now + dice.Roll(2, 6)) : (MovementKeys.None, now + dice.Roll(1, 4));
        if (now >= turnUntil)
        {
            MovementKeys way = dice.Is(0.5) ? MovementKeys.TurnLeft : MovementKeys.TurnRight;
            (turning, turnUntil) = turning == 0 ? (way, now + dice.Roll(0.2, 1.2)) : (0, now + dice.Roll(2, 6));
        }

        if (now >= jumpUntil)
            (jumping, jumpUntil) = jumping == 0 ? (MovementKeys.Jump, now + dice.Roll(0.1, 0.8)) : (0, now + dice.Roll(5, 20));
        return going | turning | jumping;
    }
}
