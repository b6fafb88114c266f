using System.Globalization;

namespace Surefoot.Dats.Tests;

/// <summary>How long properties are searched: SUREFOOT_FUZZ multiplies the number of cases.</summary>
internal static class Fuzz
{
    public static int Factor { get; } =
        int.TryParse(Environment.GetEnvironmentVariable("SUREFOOT_FUZZ"), CultureInfo.InvariantCulture, out int factor) &&
        factor > 0 ? factor : 1;

    public static int Cases(int count) => count * Factor;
}
