using Surefoot.Physics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>An honest player at a place, whose keys follow from a seed, and the server that judges it.</summary>
internal static class HonestTrial
{
    /// <summary>The network that an honest player must get through: 200 ± 100 ms, and one datagram in twenty is lost.</summary>
    internal static readonly NetworkQuality Network = new(delay: 0.2, jitter: 0.1, loss: 0.05);

    /// <summary>Seconds that the longest animation of something that stands takes: the mill's.</summary>
    private const double LongestAnimation = 12;

    /// <summary>Frames from 60 to 14 a second.</summary>
    private static readonly double[] FrameTimes = [1.0 / 60, (1.0 / 30) + 1e-9, 0.02, 0.045, 0.07];

    /// <summary>How long a client's frames are, seconds.</summary>
    internal static double FrameTime(Dice dice) => FrameTimes[(int)dice.Roll(0, FrameTimes.Length)];

    /// <summary>Plays for a while.</summary>
    /// <param name="world">The files.</param>
    /// <param name="engines">The client's world and the server's.</param>
    /// <param name="place">Where it begins.</param>
    /// <param name="seconds">How long.</param>
    /// <param name="seed">Of keys, numbers and network.</param>
    internal static HonestResult Run(
        AuthorityWorld world, (PhysicsEngine Client, PhysicsEngine Server) engines, in Position place, double seconds, ulong seed)
    {
        Dice dice = new(seed);
        CharacterStats stats = new((int)dice.Roll(10, 800), (int)dice.Roll(10, 500));
        double frame = FrameTime(dice);
        engines.Server.World.EnsureLoadedAround(place, 1);
        Precede(engines.Server, dice.Roll(0, LongestAnimation));
        double began = engines.Server.Now + 1;
        SimulatedSession session = new(Network, dice.Next(), began);
        using PlayedClient client = new(engines.Client, world.Human, world.Motions, place, stats, session);
        MovementAuthority authority = new(engines.Server, world.Human, world.Motions, stats);
        if (!authority.TryPlace(client.Position, began)) throw new InvalidDataException($"There is no room for a player at {place}.");
        JudgingServer server = new(engines.Server, authority) { GivesIn = true };
        KeyScript keys = new(dice);
        for (double time = 0; time < seconds; time += frame)
        {
            client.Frame(keys.At(time), frame);
            server.Now = began + time;
            session.Update(server.Now, Deaf.Instance, server);
        }

        return new HonestResult(server.Claims, authority.CourseCount, server.Objections, began);
    }

    /// <summary>What moves for ever in a server's world is elsewhere than in the client's, which began when that loaded it.</summary>
    private static void Precede(PhysicsEngine server, double seconds)
    {
        double begin = server.Now;
        for (double time = 0; time < seconds; time += 1) server.Tick(begin + time);
        server.Tick(begin + seconds);
    }
}

/// <summary>What became of an honest player's claims.</summary>
/// <param name="Claims">Claims judged.</param>
/// <param name="Courses">Courses stepped for them.</param>
/// <param name="Objections">Those not accepted.</param>
/// <param name="Began">When it began, seconds.</param>
internal sealed record HonestResult(int Claims, long Courses, IReadOnlyList<Objection> Objections, double Began);

/// <summary>Hears nothing.</summary>
internal sealed class Deaf : IMessageReceiver
{
    internal static Deaf Instance { get; } = new();

    public void OnMessage(in WireMessage message)
    {
    }
}
