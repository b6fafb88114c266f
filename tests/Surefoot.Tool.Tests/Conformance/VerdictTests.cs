using System.Numerics;
using Surefoot.Tool.Conformance;

namespace Surefoot.Tool.Tests.Conformance;

/// <summary>What counts, and against what.</summary>
public class VerdictTests
{
    [Fact, Behaviour("tool.conform.share-is-cut-off", "what is not all never reads 100")]
    public void A_share_that_is_not_all_never_reads_as_all()
    {
        Assert.Equal("99.99 %", new Verdict("walks", "quanta", 100_000, 99_999) { Required = 100 }.Share);
        Assert.Equal("100.00 %", new Verdict("walks", "quanta", 7, 7) { Required = 100 }.Share);
    }

    [Fact, Behaviour("tool.conform.share-is-exact", "the share itself is compared, not what is printed of it")]
    public void The_share_that_is_required_is_compared_exactly()
    {
        Assert.True(new Verdict("walks", "quanta", 1000, 999) { Required = 99.9 }.IsMet);
        Assert.False(new Verdict("walks", "quanta", 100_000, 99_999) { Required = 100 }.IsMet);
    }

    [Theory, Behaviour("tool.conform.last-bit", "rounding alone is at most two units in the last place")]
    [InlineData(2, true)]
    [InlineData(3, false)]
    public void A_difference_hangs_on_a_last_bit_when_rounding_alone_undoes_it(int units, bool hangs)
    {
        Vector3 place = new(12.5f, -3f, 0f);
        Vector3 other = place with { Y = place.Y + (units * (MathF.BitIncrement(place.Y) - place.Y)) };
        Assert.Equal(hangs, LastBit.Decides(place, at => at == other));
        Assert.False(LastBit.Decides(place, at => at == place));
    }
}
