namespace Surefoot.Tool.Conformance;

/// <summary>Takes the cases whose scene begins like a word, and remembers which scenes there were.</summary>
/// <param name="prefix">The word; null takes every case.</param>
internal sealed class SceneFilter(string? prefix)
{
    private const int MostTold = 20;

    private readonly SortedSet<string> seen = new(StringComparer.Ordinal);
    private bool anyTaken;

    /// <summary>Is a case taken?</summary>
    /// <param name="scene">What it was aimed at.</param>
    internal bool Takes(string scene)
    {
        seen.Add(scene);
        bool takes = prefix is null || scene.StartsWith(prefix, StringComparison.OrdinalIgnoreCase);
        anyTaken |= takes;
        return takes;
    }

    /// <summary>Nothing is left to compare when no case was taken.</summary>
    /// <exception cref="UsageException">None was; the message says which scenes there are.</exception>
    internal void RequireAny()
    {
        if (anyTaken) return;
        if (prefix is null)
        {
            throw new UsageException(
                "These files hold nothing to replay: lists of departures and of what there is to find are read beside the recordings " +
                "they belong to.");
        }

        string more = seen.Count > MostTold ? ", ..." : "";
        throw new UsageException($"No scene begins with '{prefix}': there are {string.Join(", ", seen.Take(MostTold))}{more}");
    }
}
