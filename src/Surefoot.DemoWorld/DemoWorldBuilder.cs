using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Buildings;
using Surefoot.DemoWorld.Creatures;
using Surefoot.DemoWorld.Human;
using Surefoot.DemoWorld.Placement;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Things;

namespace Surefoot.DemoWorld;

/// <summary>How far the writing of a world is.</summary>
/// <param name="Step">What is being done.</param>
/// <param name="Share">0 at the start, 1 when all is written.</param>
public readonly record struct DemoWorldProgress(string Step, double Share);

/// <summary>Writes the demo world as real dat files.</summary>
public static class DemoWorldBuilder
{
    /// <summary>The seed of the world that the page, the tool and the tests share.</summary>
    public const uint DefaultSeed = 1999;

    // Where a new character begins on a server that runs on this world.
    private const string Beginning = "town";

    /// <summary>Writes client_portal.dat, client_cell_1.dat and a client_local_English.dat without texts.</summary>
    /// <remarks>
    /// The same seed gives the same bytes. Takes about a second. Existing files of these names are replaced, each at once when it is whole:
    /// several writers at a time do not disturb each other, and the last one's files stay.
    /// </remarks>
    /// <param name="directory">Where to; made when missing.</param>
    /// <param name="seed">Chooses the landscape; the places keep their names.</param>
    /// <param name="progress">Told about each step; null when nobody listens.</param>
    /// <exception cref="ArgumentException">The directory is empty text.</exception>
    /// <exception cref="IOException">A file cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">The directory is not the caller's to write to.</exception>
    public static void Write(string directory, uint seed = DefaultSeed, IProgress<DemoWorldProgress>? progress = null)
    {
        ArgumentException.ThrowIfNullOrWhiteSpace(directory);
        Directory.CreateDirectory(directory);
        progress?.Report(new("planning the world", 0.0));
        var plan = WorldPlan.Create(seed);
        progress?.Report(new("writing the shared records", 0.4));
        WriteFile(Path.Combine(directory, DatSet.PortalName), DatFileKind.Portal, PortalRecords(plan));
        progress?.Report(new("writing the land and its cells", 0.7));
        WriteFile(Path.Combine(directory, DatSet.CellName), DatFileKind.Cell, plan.CellRecords());
        WriteFile(Path.Combine(directory, DatSet.LocalName), DatFileKind.Local, EmptyTables.Local());
        progress?.Report(new("done", 1.0));
    }

    private static IEnumerable<DatRecord> PortalRecords(WorldPlan plan) =>
    [
        RegionRecords.Region(), .. Surfaces.All(), .. HumanBody.All(), .. HumanMotions.All(), .. Hound.All(), .. Behemoth.All(),
        .. Door.All(), .. Arrow.All(), .. NatureShapes.All(),
        .. ObstacleShapes.All(),
        .. Windmill.All(), House.Shell(), House.Interior.Environment(), Dungeon.Interior.Environment(),
        .. CharacterTables.All(), .. CharacterCreation.All(plan.Places.Single(place => place.Name == Beginning)), .. EmptyTables.All(),
    ];

    private static void WriteFile(string path, DatFileKind kind, IEnumerable<DatRecord> records)
    {
        string unfinished = $"{path}.{Guid.NewGuid():N}.tmp";
        try
        {
            var writer = new DatFileWriter(unfinished, kind);
            foreach (var record in records)
                writer.Add(record);
            writer.Complete();
            File.Move(unfinished, path, overwrite: true);
        }
        finally
        {
            File.Delete(unfinished);
        }
    }
}
