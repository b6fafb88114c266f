using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Server;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool.Serving;

/// <summary>The dat files that a server opens, where its players begin, and whom it spawns there.</summary>
internal sealed class ServedWorld : IDisposable
{
    private readonly DatSet dats;

    private ServedWorld(string folder, Position start, IReadOnlyList<WorldSpawn> spawns)
    {
        dats = DatSet.Open(folder);
        Cache = new PhysicsDataCache(dats);
        Start = start;
        Spawns = spawns;
    }

    internal PhysicsDataCache Cache { get; }

    internal Position Start { get; }

    internal IReadOnlyList<WorldSpawn> Spawns { get; }

    /// <summary>Opens a folder, or the demo world.</summary>
    /// <param name="folder">The folder; null for the demo world.</param>
    /// <param name="start">Where players begin: a place of the demo world by name, or a cell and metres; null for the demo world's first
    /// place.</param>
    /// <exception cref="UsageException">There is no such place.</exception>
    internal static ServedWorld Open(DirectoryInfo? folder, string? start = null)
    {
        NamedPlace first = DemoPlaces.All[0];
        Position place = start is null ? new Position(first.CellId, new Frame(first.Origin, first.Orientation)) : PlaceOf(start);
        bool isDemo = folder is null || folder.FullName.StartsWith(DemoWorldCache.Root, StringComparison.Ordinal);
        string path = folder?.FullName ?? DemoWorldCache.GetOrCreate(notice: CommonOptions.Say);
        return new ServedWorld(path, place, isDemo ? DemoInhabitants() : []);
    }

    /// <summary>Whom and what the demo world has: its large creatures hunt.</summary>
    internal static IReadOnlyList<WorldSpawn> DemoInhabitants()
    {
        uint hound = DemoSpawns.All.First(spawn => spawn.Kind == DemoSpawnKind.Wanderer).SetupId;
        return [.. DemoSpawns.All.Select(spawn => new WorldSpawn(
            spawn.Name,
            spawn.Kind switch
            {
                DemoSpawnKind.Door => WorldSpawnKind.Door,
                DemoSpawnKind.Wanderer when spawn.SetupId != hound => WorldSpawnKind.Hunter,
                _ => WorldSpawnKind.Creature,
            },
            spawn.SetupId, new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)), spawn.WanderRadius))];
    }

    public void Dispose() => dats.Dispose();

    private static Position PlaceOf(string name) => DemoPlaces.TryFind(name, out NamedPlace place)
        ? new Position(place.CellId, new Frame(place.Origin, place.Orientation))
        : throw new UsageException(
            $"--start: there is no place '{name}'. Similar: {string.Join(", ", DemoPlaces.Resembling(name))}.");
}
