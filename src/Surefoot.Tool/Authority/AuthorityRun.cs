using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Authority;

/// <summary>Hours of honest play over every place of the demo world, and cheats in between.</summary>
internal sealed class AuthorityRun(AuthorityWorld world)
{
    private const double Hour = 3600;
    private const int CheatsAnHour = 3;

    private readonly List<CheatResult> cheats = [];

    /// <summary>Honest play, hours.</summary>
    internal double Hours { get; private set; }

    /// <summary>Claims of honest players.</summary>
    internal long Claims { get; private set; }

    /// <summary>Courses that were stepped for them.</summary>
    internal long Courses { get; private set; }

    /// <summary>Honest claims that were not accepted, in words.</summary>
    internal List<string> FalseRefusals { get; } = [];

    /// <summary>What became of the cheaters.</summary>
    internal IReadOnlyList<CheatResult> Caught => cheats;

    internal int MissedCheats => cheats.Count(one => !one.IsCaught);

    internal bool IsGood => FalseRefusals.Count == 0 && MissedCheats == 0;

    /// <summary>Plays hours, or parts of one, spread over all places.</summary>
    /// <param name="hours">How many.</param>
    /// <param name="seed">The first one's seed; each hour has the next.</param>
    /// <param name="progress">Told how many visits of how many are done.</param>
    internal void Play(double hours, ulong seed, Action<int, int> progress)
    {
        int rounds = (int)Math.Ceiling(hours), places = DemoPlaces.All.Length, visits = rounds * places;
        double visit = hours * Hour / visits;
        for (int round = 0; round < rounds; round++)
        {
            Dice dice = new(seed + (ulong)round);
            (PhysicsEngine Client, PhysicsEngine Server) engines = (world.CreateEngine(), world.CreateEngine());
            for (int i = 0; i < places; i++)
            {
                Visit(engines, DemoPlaces.All[i], visit, dice.Next());
                progress((round * places) + i + 1, visits);
            }

            int tries = (int)Math.Ceiling(CheatsAnHour * hours / rounds);
            for (int i = 0; i < tries; i++)
                foreach (Cheat cheat in Cheats.All(dice))
                    cheats.Add(CheatTrial.Run(world, engines, cheat, dice.Next()));
        }

        Hours += hours;
    }

    private void Visit((PhysicsEngine Client, PhysicsEngine Server) engines, NamedPlace named, double seconds, ulong seed)
    {
        Position place = new(named.CellId, new Frame(named.Origin, named.Orientation));
        HonestResult result = HonestTrial.Run(world, engines, place, seconds, seed);
        Claims += result.Claims;
        Courses += result.Courses;
        foreach (Objection one in result.Objections)
            FalseRefusals.Add(FormattableString.Invariant(
                $"{named.Name}, seed {seed}, {one.Time - result.Began:0.0} s: {one.Message} {one.Verdict.Outcome}, ") +
                FormattableString.Invariant($"{one.Verdict.Reason}, ") +
                FormattableString.Invariant($"missed {one.Claimed} by {one.Verdict.Miss:0.00} m from {one.Verdict.Position}"));
    }
}
