using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

public sealed class LeftOutListTests
{
    [Fact]
    [Behaviour("world.left-out.list.counts-equal-things", "spec/07, 9.1")]
    public void Equal_things_are_one_item_with_a_count_and_keep_where_the_first_was()
    {
        LeftOutList list = new();
        list.Add(Tree(0x02000010) with { FirstIn = 0x12000001 });
        list.Add(Tree(0x02000011));
        list.Add(Tree(0x02000010) with { FirstIn = 0x12000002, Count = 3 });
        Assert.Equal([Tree(0x02000010) with { FirstIn = 0x12000001, Count = 4 }, Tree(0x02000011)], list);
        Assert.Equal((5, 0), (list.Total, list.Unlisted));
    }

    [Fact]
    [Behaviour("world.left-out.list.bounded", "design.md, decision 7")]
    public void A_list_that_is_full_still_counts()
    {
        LeftOutList list = new();
        for (uint id = 0; id < LeftOutList.Capacity + 100; id++) list.Add(Tree(id));
        list.Add(Tree(5));
        list.Add(Tree(LeftOutList.Capacity + 5));
        Assert.Equal(LeftOutList.Capacity, list.Count);
        Assert.Equal((LeftOutList.Capacity + 102, 101), (list.Total, list.Unlisted));
        Assert.Equal(2, list[5].Count);
        Assert.Equal(list.Total, list.Sum(item => item.Count) + list.Unlisted);
    }

    [Fact]
    [Behaviour("world.left-out.list.one-line", "spec/07, 9.1")]
    public void An_item_says_in_one_line_what_is_left_out_why_and_where_the_fault_lies()
    {
        LeftOutItem item = new(LeftOutKind.Room, 0xA9B40101, "the structure 7 does not exist", "/dats/client_cell_1.dat", 0x14);
        Assert.Equal("Room 0xA9B40101: the structure 7 does not exist (client_cell_1.dat, offset 0x14)", item.ToString());
        Assert.Equal(
            "Scenery 0x02000010 × 12, first in 0x12000001: it is missing",
            (Tree(0x02000010) with { FirstIn = 0x12000001, Count = 12 }).ToString());
    }

    private static LeftOutItem Tree(uint id) => new(LeftOutKind.Scenery, id, "it is missing");
}
