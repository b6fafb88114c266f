using System.Collections.Immutable;
using Surefoot.DemoWorld.Placement;

namespace Surefoot.DemoWorld;

/// <summary>The named places of the demo world, shared by the page, the tool and the tests.</summary>
public static class DemoPlaces
{
    private static readonly Lazy<ImmutableArray<NamedPlace>> DefaultPlaces = new(
        () => WorldPlan.Create(DemoWorldBuilder.DefaultSeed).Places);

    /// <summary>The places of the world that <see cref="DemoWorldBuilder.DefaultSeed"/> makes, the starting place first.</summary>
    public static ImmutableArray<NamedPlace> All => DefaultPlaces.Value;

    /// <summary>The places of a world with another seed.</summary>
    /// <remarks>The names are the same for every seed; some places move with the landscape.</remarks>
    public static ImmutableArray<NamedPlace> For(uint seed)
        => seed == DemoWorldBuilder.DefaultSeed ? All : WorldPlan.Create(seed).Places;

    /// <summary>Looks a place of the default world up by its name or by its title, as the page shows it, without regard to case.</summary>
    public static bool TryFind(string name, out NamedPlace place)
    {
        place = (All.FirstOrDefault(p => p.Name.Equals(name, StringComparison.OrdinalIgnoreCase))
            ?? All.FirstOrDefault(p => p.Title.Equals(name, StringComparison.OrdinalIgnoreCase)))!;
        return place is not null;
    }

    /// <summary>The names that resemble one that nobody has, nearest first; for error messages.</summary>
    public static IEnumerable<string> Resembling(string name)
        => All.Select(p => p.Name).OrderBy(n => Distance(n, name.ToLowerInvariant())).ThenBy(n => n, StringComparer.Ordinal).Take(3);

    private static int Distance(string a, string b)
    {
        int[] row = [.. Enumerable.Range(0, b.Length + 1)];
        for (int i = 1; i <= a.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.Length; j++)
            {
                int substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(substituted, Math.Min(row[j], row[j - 1]) + 1);
            }
        }

        return row[b.Length];
    }
}
