using Surefoot.Physics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>A cheater over the network of an honest player, and the server that judges it.</summary>
internal static class CheatTrial
{
    private const double Longest = 25;

    /// <summary>Two places told are enough to be caught.</summary>
    private const int PlacesAllowed = 2;

    internal static CheatResult Run(
        AuthorityWorld world, (PhysicsEngine Client, PhysicsEngine Server) engines, Cheat cheat, ulong seed)
    {
        Dice dice = new(seed);
        Position place = cheat.Place(dice);
        CharacterStats stats = cheat.Stats(dice);
        double began = engines.Server.Now + 1, frame = HonestTrial.FrameTime(dice);
        SimulatedSession session = new(HonestTrial.Network, dice.Next(), began);
        using PlayedClient client = new(engines.Client, world.Human, world.Motions, place, stats, session);
        engines.Server.World.EnsureLoadedAround(place, 1);
        MovementAuthority authority = new(engines.Server, world.Human, world.Motions, stats);
        if (!authority.TryPlace(client.Position, began)) throw new InvalidDataException($"There is no room for a player at {place}.");
        JudgingServer server = new(engines.Server, authority);
        for (double time = 0; time < Longest && server.Objections.Count == 0; time += frame)
        {
            client.Frame(cheat.Keys(time), frame);
            cheat.Act(client, time, frame);
            server.Now = began + time;
            session.Update(server.Now, Deaf.Instance, server);
        }

        Objection? first = server.Objections.FirstOrDefault();
        double caught = first is null ? double.PositiveInfinity : first.Time - began - cheat.Began;
        bool isOfCheat = first is not null && first.ClaimNumber > cheat.ClaimsBefore && caught >= 0;
        bool isSoon = first is not null &&
            (double.IsFinite(cheat.Limit) ? caught <= cheat.Limit : first.PositionNumber <= cheat.PlacesBefore + PlacesAllowed);
        bool fits = first is not null && cheat.Reasons.Contains(first.Verdict.Reason);
        return new CheatResult(
            cheat.Name, isOfCheat && isSoon && fits, caught, first?.Verdict.Reason ?? ClaimReason.None, $"{place}", frame, seed);
    }
}

/// <summary>What became of a cheater.</summary>
/// <param name="Cheat">What it did.</param>
/// <param name="IsCaught">It was caught in time, for a reason that fits it.</param>
/// <param name="Seconds">From the begin of the cheat to the verdict; infinite when it was not caught.</param>
/// <param name="Reason">The verdict's reason.</param>
/// <param name="Place">Where it began.</param>
/// <param name="Frame">How long the client's frames were, seconds.</param>
/// <param name="Seed">The seed.</param>
internal sealed record CheatResult(
    string Cheat, bool IsCaught, double Seconds, ClaimReason Reason, string Place, double Frame, ulong Seed);
