using System.Collections.Immutable;
using System.Numerics;
using Surefoot.DemoWorld.Placement;

namespace Surefoot.DemoWorld;

/// <summary>What a spawned thing of the demo world does.</summary>
public enum DemoSpawnKind
{
    /// <summary>Stands still and blocks.</summary>
    Guard,

    /// <summary>Walks about within its radius.</summary>
    Wanderer,

    /// <summary>One of the crowd: stands still.</summary>
    Crowd,

    /// <summary>A door: closed it blocks, open it is ethereal.</summary>
    Door,
}

/// <summary>A thing that is not in the dat files but spawned, as a server would.</summary>
/// <param name="Name">Unique name in kebab-case.</param>
/// <param name="Kind">What it does.</param>
/// <param name="SetupId">Its setup.</param>
/// <param name="CellId">The cell.</param>
/// <param name="Origin">Metres from the south-west corner of the cell's block.</param>
/// <param name="Heading">Degrees clockwise from north.</param>
/// <param name="WanderRadius">How far it strays (m); 0 when it does not.</param>
public sealed record DemoSpawn(
    string Name, DemoSpawnKind Kind, uint SetupId, uint CellId, Vector3 Origin, float Heading, float WanderRadius)
{
    /// <summary>The heading as a rotation about +z, of length 1.</summary>
    public Quaternion Orientation => new Spot(0, 0, 0, Heading).ToFrame().Rotation;
}

/// <summary>What is to be spawned in the demo world: guards, creatures that wander, a crowd of a hundred, a door.</summary>
public static class DemoSpawns
{
    private static readonly Lazy<ImmutableArray<DemoSpawn>> Default = new(() => WorldPlan.Create(DemoWorldBuilder.DefaultSeed).Spawns);

    /// <summary>The spawns of the world that <see cref="DemoWorldBuilder.DefaultSeed"/> makes.</summary>
    public static ImmutableArray<DemoSpawn> All => Default.Value;
}
