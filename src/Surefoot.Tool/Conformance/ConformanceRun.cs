using System.Text.Json;
using Surefoot.Dats;
using Surefoot.Tool.Commands;
using Surefoot.Tool.Conformance.Captures;
using Surefoot.Tool.Conformance.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>Replays files of recordings, each told apart by itself and opened once.</summary>
/// <param name="folder">The world that walks and a peer's results were recorded in; null where it was not given.</param>
/// <param name="scenes">Which cases.</param>
internal sealed class ConformanceRun(DirectoryInfo? folder, SceneFilter scenes) : IDisposable
{
    private static readonly string[] Patterns = ["*.jsonl", "*.jsonl.gz"];

    private WholeWorld? world;
    private OracleReplay? oracle;

    /// <summary>What came of it so far.</summary>
    internal ConformanceReport Report { get; } = new();

    private WholeWorld World
    {
        get
        {
            if (world is not null) return world;
            if (folder is null) throw new UsageException("Walks, sweeps and placements need the world they were recorded in: --dats DIR");
            world = WholeWorld.Open(folder);
            CommonOptions.SayLeftOut(world.Engine.World.LeftOut);
            return world;
        }
    }

    private OracleReplay Oracle =>
        oracle ??= OracleReplay.Over(World.Cache.Source, World.Engine.World.Landblocks.Select(block => block.Id));

    /// <summary>The files that are meant by files and folders.</summary>
    /// <exception cref="UsageException">A name is empty, or a folder holds no recordings.</exception>
    internal static IEnumerable<string> Files(IEnumerable<string> paths)
    {
        foreach (string path in paths)
        {
            if (string.IsNullOrWhiteSpace(path)) throw new UsageException("The name of a recording is empty.");
            if (!Directory.Exists(path))
            {
                if (!Capture.IsExpectation(path)) yield return path;
                continue;
            }

            string[] found =
            [
                .. Patterns.SelectMany(pattern => Directory.EnumerateFiles(path, pattern, SearchOption.AllDirectories))
                    .Order(StringComparer.Ordinal),
            ];
            if (found.Length == 0) throw new UsageException($"'{path}' holds no recordings ({string.Join(", ", Patterns)})");
            foreach (string file in found) yield return file;
        }
    }

    /// <summary>Replays a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="progress">Told how much is done, of how much.</param>
    /// <exception cref="IOException">There is no such file.</exception>
    /// <exception cref="InvalidDataException">It is damaged; the message names file and line.</exception>
    /// <exception cref="UsageException">It needs a world, and none was given.</exception>
    internal void Add(string path, Action<int, int> progress)
    {
        using VectorFile file = VectorFile.Open(path);
        switch (VectorKinds.Of(file))
        {
            case VectorKind.Walks:
                AddWalks(file, progress);
                break;
            case VectorKind.Oracle:
                AddOracle(file, progress);
                break;
            case VectorKind.Managers:
                AddManagers(file, progress);
                break;
            case VectorKind.Captures:
                Capture capture = Capture.Load(file);
                if (scenes.Takes(capture.Name)) Report.Add(CaptureReplay.Run(capture));
                break;
        }
    }

    /// <inheritdoc/>
    public void Dispose() => world?.Dispose();

    private void AddWalks(VectorFile file, Action<int, int> progress)
    {
        WalkReplay replay = new(World.Engine, World.Cache.GetSetup);
        var outcomes = file.Read(line =>
        {
            WalkCase walk = WalkCase.Parse(line);
            return scenes.Takes(walk.Scene)
                ? InWorld(() => (walk, replay.Run(walk, reseat: true), replay.Run(walk, reseat: false)))
                : default;
        });
        foreach ((WalkCase? walk, WalkOutcome reseated, WalkOutcome free) in outcomes)
        {
            if (walk is not null) Report.Add(walk, reseated, free);
            progress(file.Progress, 100);
        }
    }

    private void AddOracle(VectorFile file, Action<int, int> progress)
    {
        HashSet<string> departures = OracleReplay.DeparturesBeside(file.Path);
        var results = file.Read(line =>
        {
            OracleCase one = OracleCase.Parse(line);
            return scenes.Takes(one.Tag) ? InWorld(() => Oracle.Run(one)) : [];
        });
        foreach (OracleResult result in results.SelectMany(some => some))
        {
            Report.Add(result, departures.Contains(OracleReplay.KeyOf(result.Id, result.Quantum)));
            progress(file.Progress, 100);
        }
    }

    /// <summary>A recording that names what the world does not have is a damaged one, or belongs to another world.</summary>
    private static T InWorld<T>(Func<T> replay)
    {
        try
        {
            return replay();
        }
        catch (Exception e) when (e is DatRecordMissingException or DatFormatException)
        {
            throw new InvalidDataException($"it cannot be replayed in this world: {e.Message}", e);
        }
    }

    private void AddManagers(VectorFile file, Action<int, int> progress)
    {
        var results = file.Read(line =>
        {
            JsonElement recorded = JsonElement.Parse(line);
            return scenes.Takes(ManagerVectors.TagOf(recorded)) ? ManagerVectors.Run(recorded) : null;
        });
        foreach (ManagerResult? result in results)
        {
            if (result is not null) Report.Add(result);
            progress(file.Progress, 100);
        }
    }
}
