namespace Surefoot.Testing;

/// <summary>How long property tests search: SUREFOOT_FUZZ multiplies their usual number of cases.</summary>
internal static class Fuzz
{
    /// <summary>The usual number of cases times SUREFOOT_FUZZ, at least one.</summary>
    public static int Cases(int usual) =>
        double.TryParse(Environment.GetEnvironmentVariable("SUREFOOT_FUZZ"), System.Globalization.CultureInfo.InvariantCulture,
            out double factor) && factor > 0
            ? (int)Math.Max(1, Math.Min(usual * factor, int.MaxValue))
            : usual;
}
