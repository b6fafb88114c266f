namespace Surefoot.Tool.Conformance;

/// <summary>A family of recordings against what is required of it.</summary>
/// <param name="Family">The family.</param>
/// <param name="Measure">What is counted.</param>
/// <param name="Compared">How many of them count: those that hang on a last bit or differ for a known reason do not.</param>
/// <param name="Equal">Of those, equal.</param>
internal sealed record Verdict(string Family, string Measure, int Compared, int Equal)
{
    /// <summary>Percent that have to be.</summary>
    public required double Required { get; init; }

    /// <summary>What does not count, in words.</summary>
    public string Apart { get; init; } = "";

    /// <summary>Required of walks, of which a recorder may have rounded elsewhere.</summary>
    internal const double Walks = 99.9;

    /// <summary>Required of what a peer did, which has departures that nobody listed.</summary>
    internal const double Oracle = 99.9;

    /// <summary>Required of what is exact.</summary>
    internal const double Exact = 100;

    /// <summary>What is required, in words.</summary>
    internal static string Defaults => FormattableString.Invariant(
        $"{Walks} of re-seated quanta and of free-running walks, {Oracle} of a peer's sweeps, placements and quanta, {Exact} of the rest");

    /// <summary>Percent equal.</summary>
    public double Percent => Compared == 0 ? 100 : 100.0 * Equal / Compared;

    /// <summary>Is as much equal as has to be?</summary>
    public bool IsMet => Percent >= Required;

    /// <summary>The share, cut off after two digits: what is not all never reads 100.</summary>
    internal string Share => FormattableString.Invariant($"{Math.Floor(Percent * 100) / 100:0.00} %");

    /// <summary>What is said of a family that falls short.</summary>
    public override string ToString() => FormattableString.Invariant($"{Family}: {Share} of {Measure} equal, {Required} % required");
}
