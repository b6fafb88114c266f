using System.Numerics;
using Surefoot.Client;
using Surefoot.Dats;

namespace Surefoot.Scenes;

/// <summary>Something that goes on in the demo world: benchmarks time its quanta, and a test pins what comes of them.</summary>
/// <param name="Name">Unique name.</param>
/// <param name="Quanta">Quanta after which its state hash is taken.</param>
/// <param name="Begin">Sets it up over the demo world's files, which the caller keeps open.</param>
public sealed record Scene(string Name, int Quanta, Func<DatSet, SceneRun> Begin)
{
    private const int PlayerQuanta = 240;

    /// <summary>One player who holds some keys.</summary>
    public static IReadOnlyList<Scene> Players { get; } =
    [
        Of("flat", new("runway", MovementKeys.Forward)),
        Of("hills", new("hills", MovementKeys.Forward)),
        Of("unwalkable slope", new("slope-50", MovementKeys.Forward)),
        Of("falling", new("meadow", MovementKeys.None) { Offset = new(0, 30), Airborne = Vector3.Zero }),
        Of("forest", new("forest", MovementKeys.Forward)),
        Of("town", new("town", MovementKeys.Forward)),
        Of("stairs", new("long-stair", MovementKeys.Forward) { Quanta = 45 }),
        Of("corridor", new("dungeon-corridor", MovementKeys.Forward) { Quanta = 90 }),
        Of("jump through a doorway",
            new("house-door", MovementKeys.Forward) { Offset = new(2, 0.05f), Airborne = new(0, 9, 1.5f), Quanta = 20 }),
    ];

    /// <summary>Many bodies at once.</summary>
    public static IReadOnlyList<Scene> Crowds { get; } = [Crowd("crowd, 1.3 m apart", 1.3f), Crowd("crowd, 4 m apart", 4f)];

    /// <summary>All scenes, a tour of every place of the demo world last.</summary>
    public static IReadOnlyList<Scene> All { get; } = [.. Players, .. Crowds, new("tour", TourRun.QuantumCount, dats => new TourRun(dats))];

    /// <summary>The scene with a name.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public static Scene Find(string name) =>
        All.FirstOrDefault(scene => scene.Name == name) ?? throw new ArgumentException($"There is no scene {name}.", nameof(name));

    /// <summary>Runs the scene from its beginning; a hash of the states after every quantum.</summary>
    /// <param name="dats">The demo world's files.</param>
    public ulong Hash(DatSet dats)
    {
        SceneRun run = Begin(dats);
        ulong hash = 0;
        for (int i = 0; i < Quanta; i++)
        {
            run.AdvanceQuantum();
            // A multiplication between them keeps the order of the quanta.
            hash = (hash ^ run.Engine.HashState()) * 0x100000001B3;
        }

        return hash;
    }

    /// <inheritdoc/>
    public override string ToString() => Name;

    private static Scene Of(string name, PlayerAct act) => new(name, PlayerQuanta, dats => new PlayerRun(dats, act));

    private static Scene Crowd(string name, float spacing) => new(name, 120, dats => new CrowdRun(dats, spacing));
}
