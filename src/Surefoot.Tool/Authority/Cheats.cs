namespace Surefoot.Tool.Authority;

/// <summary>All that a judge has to catch.</summary>
internal static class Cheats
{
    /// <summary>A new one of each. Half of those that need not say the truth say that they do not stand on the ground.</summary>
    internal static IEnumerable<Cheat> All(Dice dice) =>
    [
        new FastClock(),
        new FastLegs(),
        new ThroughWall { SaysContact = NotOrTrue(dice) },
        new ClippedCorner { SaysContact = NotOrTrue(dice) },
        new Flight(every: dice.Roll(0.3, 1)) { SaysContact = !dice.Is(0.5) },
        new SuperJump(tells: dice.Is(0.5)),
        new Glide(every: dice.Roll(0.3, 1)) { SaysContact = !dice.Is(0.5) },
        new Rewind { SaysContact = NotOrTrue(dice) },
        new HighSteps { SaysContact = NotOrTrue(dice) },
    ];

    private static bool? NotOrTrue(Dice dice) => dice.Is(0.5) ? false : null;
}
