using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>What a world does without because it cannot be read, for people.</summary>
/// <param name="Total">How many things.</param>
/// <param name="Lines">One sentence for each kind of them, the first ones only.</param>
internal sealed record LeftOutNotice(long Total, IReadOnlyList<string> Lines)
{
    private const int MostLines = 50;

    /// <summary>Everything could be read.</summary>
    public static LeftOutNotice Nothing { get; } = new(0, []);

    /// <summary>What a list holds now.</summary>
    public static LeftOutNotice Of(LeftOutList list) => new(list.Total, [.. list.Take(MostLines).Select(item => item.ToString())]);
}
