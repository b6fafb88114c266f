namespace Surefoot.Physics.Tests.Assets;

/// <summary>How much longer than usual to look for counterexamples.</summary>
internal static class Fuzz
{
    internal static int Factor { get; } =
        int.TryParse(Environment.GetEnvironmentVariable("SUREFOOT_FUZZ"), out int factor) && factor > 0 ? factor : 1;
}
