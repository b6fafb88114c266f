using Surefoot.Tool.Conformance.Captures;
using Surefoot.Tool.Conformance.Steering;

namespace Surefoot.Tool.Conformance;

/// <summary>How much of a scene came out the same.</summary>
internal sealed class SceneScore
{
    /// <summary>Walks replayed.</summary>
    public int Cases { get; private set; }

    /// <summary>Walks equal from start to end.</summary>
    public int CasesEqual { get; private set; }

    /// <summary>Walks that are not, and hang on a last bit.</summary>
    public int CasesLastBit { get; private set; }

    /// <summary>Quanta replayed.</summary>
    public int Quanta { get; private set; }

    /// <summary>Quanta equal.</summary>
    public int QuantaEqual { get; private set; }

    /// <summary>Quanta that are not, and hang on a last bit.</summary>
    public int QuantaLastBit { get; private set; }

    internal void Add(in WalkOutcome outcome, bool hangs)
    {
        Cases++;
        if (outcome.First is null) CasesEqual++;
        else if (hangs) CasesLastBit++;
        Quanta += outcome.Quanta;
        QuantaEqual += outcome.Equal;
        QuantaLastBit += outcome.LastBit;
    }
}

/// <summary>
/// How many runs of a family of managers came out the same; those that hang on the last bit of a float are counted apart.
/// </summary>
internal sealed class ManagerScore
{
    /// <summary>Runs replayed.</summary>
    public int Cases { get; private set; }

    /// <summary>Of those, equal to the end.</summary>
    public int CasesEqual { get; private set; }

    /// <summary>Their entries: quanta or messages.</summary>
    public int Entries { get; private set; }

    /// <summary>Entries before the first that differs.</summary>
    public int EntriesEqual { get; private set; }

    /// <summary>Runs that hang on a last bit.</summary>
    public int TightCases { get; private set; }

    /// <summary>Of those, equal to the end.</summary>
    public int TightCasesEqual { get; private set; }

    internal void Add(ManagerResult result)
    {
        int equal = result.Difference is null ? 1 : 0;
        if (result.IsTight)
        {
            TightCases++;
            TightCasesEqual += equal;
            return;
        }

        Cases++;
        CasesEqual += equal;
        Entries += result.Entries;
        EntriesEqual += result.Equal;
    }
}

/// <summary>How many results of a family came out the same.</summary>
internal sealed class OracleScore
{
    /// <summary>Results that no known departure changes.</summary>
    public int Results { get; private set; }

    /// <summary>Of those, equal.</summary>
    public int ResultsEqual { get; private set; }

    /// <summary>Of those, not equal, and hanging on a last bit.</summary>
    public int ResultsLastBit { get; private set; }

    /// <summary>Results that known departures of the peer change.</summary>
    public int Listed { get; private set; }

    /// <summary>Of those, differing as foreseen.</summary>
    public int ListedDiffering { get; private set; }

    /// <summary>Of the unlisted results that differ, those for which the mover's state says why, by reason.</summary>
    public SortedDictionary<string, int> Explained { get; } = new(StringComparer.Ordinal);

    internal void Add(OracleResult result, bool listed)
    {
        bool equal = result.Difference is null;
        if (listed)
        {
            Listed++;
            if (!equal) ListedDiffering++;
            return;
        }

        Results++;
        if (equal) ResultsEqual++;
        else if (result.Departure is { } departure) Explained[departure] = Explained.GetValueOrDefault(departure) + 1;
        else if (result.HangsOnLastBit) ResultsLastBit++;
    }
}

/// <summary>How much of what there was to find in recorded sessions was found.</summary>
internal sealed class CaptureScore
{
    /// <summary>Sessions looked at.</summary>
    public int Sessions { get; private set; }

    /// <summary>Of those, found to be what they are in everything.</summary>
    public int SessionsEqual { get; private set; }

    /// <summary>Datagrams, verdicts on them, and messages.</summary>
    public int Findings { get; private set; }

    /// <summary>Of those, found.</summary>
    public int FindingsEqual { get; private set; }

    internal void Add(IReadOnlyCollection<CaptureResult> session)
    {
        int equal = session.Count(finding => finding.Difference is null);
        Sessions++;
        if (equal == session.Count) SessionsEqual++;
        Findings += session.Count;
        FindingsEqual += equal;
    }
}
