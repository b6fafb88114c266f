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
        string demo = DemoWorldCache.GetOrCreate(notice: CommonOptions.Say), path = folder?.FullName ?? demo;
        return new ServedWorld(path, place, HasSameLand(path, demo) ? DemoInhabitants() : []);
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

    /// <summary>A folder that <c>surefoot demo write</c> has written is the demo world, too.</summary>
    private static bool HasSameLand(string folder, string demo)
    {
        if (folder == demo) return true;
        string cells = Path.Combine(folder, DatSet.CellName);
        return File.Exists(cells) && new FileInfo(cells).Length == new FileInfo(Path.Combine(demo, DatSet.CellName)).Length
            && File.ReadAllBytes(cells).AsSpan().SequenceEqual(File.ReadAllBytes(Path.Combine(demo, DatSet.CellName)));
    }

    private static Position PlaceOf(string text)
    {
        if (DemoPlaces.TryFind(text, out NamedPlace place)) return new Position(place.CellId, new Frame(place.Origin, place.Orientation));
        if (!text.Contains(',', StringComparison.Ordinal))
            throw new UsageException($"--start: there is no place '{text}'. Similar: {string.Join(", ", DemoPlaces.Resembling(text))}.");
        try
        {
            Place found = Place.Parse(text);
            if (found.OnGround) throw new UsageException($"--start {text}: the height is missing, as in 0xA9B40001,12,12,0.");
            return found.Position;
        }
        catch (FormatException error)
        {
            throw new UsageException($"--start {error.Message}");
        }
    }
}
