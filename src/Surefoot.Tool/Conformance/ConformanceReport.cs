namespace Surefoot.Tool.Conformance;

/// <summary>How much of a scene came out the same.</summary>
internal sealed class SceneScore
{
    /// <summary>Walks replayed.</summary>
    public int Cases { get; private set; }

    /// <summary>Walks equal from start to end.</summary>
    public int CasesEqual { get; private set; }

    /// <summary>Steps replayed.</summary>
    public int Steps { get; private set; }

    /// <summary>Steps equal.</summary>
    public int StepsEqual { get; private set; }

    internal void Add(int steps, int equal, bool whole)
    {
        Cases++;
        Steps += steps;
        StepsEqual += equal;
        if (whole) CasesEqual++;
    }
}

/// <summary>The scores of a set of walks, scene by scene.</summary>
internal sealed class ConformanceReport
{
    private readonly SortedDictionary<string, (SceneScore Reseated, SceneScore Free)> scenes = new(StringComparer.Ordinal);

    internal SceneScore Reseated { get; } = new();

    internal SceneScore FreeRunning { get; } = new();

    /// <summary>First divergence of each walk that diverges when re-seated, then of those that diverge only free-running.</summary>
    internal List<Divergence> Divergences { get; } = [];

    internal IEnumerable<(string Name, SceneScore Reseated, SceneScore Free)> Scenes => scenes.Select(s => (s.Key, s.Value.Reseated, s.Value.Free));

    internal void Add(WalkCase walk, WalkReplay replay)
    {
        if (!scenes.TryGetValue(walk.Scene, out var scene)) scenes[walk.Scene] = scene = (new SceneScore(), new SceneScore());
        var reseated = replay.Run(walk, reseat: true);
        var free = replay.Run(walk, reseat: false);
        scene.Reseated.Add(reseated.Steps, reseated.Equal, reseated.First is null);
        Reseated.Add(reseated.Steps, reseated.Equal, reseated.First is null);
        scene.Free.Add(free.Steps, free.Equal, free.First is null);
        FreeRunning.Add(free.Steps, free.Equal, free.First is null);
        if ((reseated.First ?? free.First) is { } divergence) Divergences.Add(divergence);
    }

    internal object ToJson() => new
    {
        FreeRunning = Score(FreeRunning, s => s.Free),
        Reseated = Score(Reseated, s => s.Reseated),
    };

    private object Score(SceneScore all, Func<(SceneScore Reseated, SceneScore Free), SceneScore> pick) => new
    {
        all.Cases, all.CasesEqual, all.Steps, all.StepsEqual,
        Scenes = scenes.ToDictionary(s => s.Key, s => pick(s.Value)),
    };
}
