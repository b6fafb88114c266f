using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

public sealed class CellIdTests
{
    [Theory]
    [Behaviour("world.ids.validity", "spec/05, 6.1; @0x004979A0, @0x00497A90")]
    [InlineData(0xA9B40001u, true, true, 1352, 1440)]
    [InlineData(0xA9B40008u, true, true, 1352, 1447)]
    [InlineData(0xA9B40009u, true, true, 1353, 1440)]
    [InlineData(0xA9B40040u, true, true, 1359, 1447)]
    [InlineData(0x00000001u, true, true, 0, 0)]
    [InlineData(0xFEFE0040u, true, true, 2039, 2039)]
    [InlineData(0xA9B40000u, false, false, -1, -1)]
    [InlineData(0xA9B40041u, false, false, -1, -1)]
    [InlineData(0xA9B4FFFEu, false, false, -1, -1)]
    [InlineData(0xA9B40100u, true, true, -1, -1)]
    [InlineData(0xA9B4FFFFu, true, true, -1, -1)]
    [InlineData(0xFF000001u, true, false, -1, -1)]
    [InlineData(0x00FF0001u, true, false, -1, -1)]
    public void An_id_is_valid_by_its_index_and_its_block(uint id, bool index, bool inbound, int x, int y)
    {
        Assert.Equal(index, CellIds.HasValidIndex(id));
        Assert.Equal(inbound, CellIds.IsValid(id));
        Assert.Equal(x >= 0, CellIds.TryLandCoordinates(id, out int cx, out int cy));
        if (x < 0) return;
        Assert.Equal((x, y), (cx, cy));
        Assert.Equal(id, CellIds.FromLandCoordinates(x, y));
    }

    [Theory]
    [Behaviour("world.ids.from-coordinates", "spec/05, 6.1; @0x004A19A0")]
    [InlineData(1353, 1440, 0xA9B40009u)]
    [InlineData(1000, 700, 0x7D570005u)]
    [InlineData(2039, 2039, 0xFEFE0040u)]
    [InlineData(-1, 5, 0u)]
    [InlineData(2040, 0, 0u)]
    public void Coordinates_name_a_land_cell(int x, int y, uint id) => Assert.Equal(id, CellIds.FromLandCoordinates(x, y));

    [Theory]
    [Behaviour("world.ids.block-offset", "spec/05, 6.2; @0x0043E630")]
    [InlineData(0xA9B40001u, 0xAAB40001u, 192, 0)]
    [InlineData(0xA9B40001u, 0xA9B5003Fu, 0, 192)]
    [InlineData(0xAAB50001u, 0xA9B40012u, -192, -192)]
    [InlineData(0xA9B40001u, 0xA9B40100u, 0, 0)]
    [InlineData(0x00000001u, 0x0102FFFFu, 192, 384)]
    public void Blocks_are_192_metres_apart(uint from, uint to, float x, float y) =>
        Assert.Equal(new Vector3(x, y, 0), CellIds.BlockOffset(from, to));

    [Theory]
    [Behaviour("world.ids.adjust-to-outside", "spec/05, 6.3; @0x005A9BC0")]
    [InlineData(0xA9B40001u, 12.5f, 30.25f, 0xA9B40002u, 12.5f, 30.25f)]
    [InlineData(0xA9B40039u, 192f, 10f, 0xAAB40001u, 0f, 10f)]
    [InlineData(0xA9B40039u, 193.5f, 10f, 0xAAB40001u, 1.5f, 10f)]
    [InlineData(0xA9B40001u, -0.5f, 100f, 0xA8B4003Du, 191.5f, 100f)]
    [InlineData(0xA9B40001u, -0.0001f, 5f, 0xA9B40001u, 0f, 5f)]
    [InlineData(0xA9B40001u, -0.00025f, 5f, 0xA8B40039u, 191.999756f, 5f)]
    [InlineData(0xA9B40001u, -0.001f, -0.001f, 0xA8B30040u, 191.998993f, 191.998993f)]
    [InlineData(0xA9B40008u, 10f, 192f, 0xA9B50001u, 10f, 0f)]
    [InlineData(0xA9B40008u, 191.9999f, 191.9999f, 0xA9B40040u, 191.999893f, 191.999893f)]
    [InlineData(0xA9B40001u, 3f, -24f, 0xA9B30008u, 3f, 168f)]
    [InlineData(0xA9B40123u, 95f, 205.125f, 0xA9B50019u, 95f, 13.125f)]
    [InlineData(0xA9B40001u, -400f, 600f, 0xA6B7003Au, 176f, 24f)]
    [InlineData(0xA9B4FFFFu, 100f, 50f, 0xA9B40023u, 100f, 50f)]
    [InlineData(0x00000001u, -1f, 5f, 0u, -1f, 5f)]
    [InlineData(0xFEFE0040u, 192f, 5f, 0u, 192f, 5f)]
    [InlineData(0xA9B40055u, 5f, 5f, 0u, 5f, 5f)]
    public void A_point_belongs_to_the_land_cell_under_it(uint id, float x, float y, uint adjusted, float ax, float ay)
    {
        Vector3 point = new(x, y, 7);
        Assert.Equal(adjusted != 0, CellIds.AdjustToOutside(ref id, ref point));
        Assert.Equal(adjusted, id);
        Assert.Equal(new Vector3(ax, ay, 7), point);
    }

    [Theory]
    [Behaviour("world.ids.adjust-to-outside.far", "spec/05, 4.1")]
    [InlineData(1e30f)]
    [InlineData(-1e30f)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_point_far_off_the_map_has_no_cell(float x)
    {
        uint id = 0xA9B40001;
        Vector3 point = new(x, 5, 0);
        Assert.False(CellIds.AdjustToOutside(ref id, ref point));
        Assert.Equal(0u, id);
    }

    [Fact]
    [Behaviour("world.positions.offset", "spec/05, 6.2; @0x00509F60")]
    public void Positions_in_different_blocks_are_as_far_apart_as_they_look()
    {
        Position a = new(0xA9B40039, new Vector3(190, 10, 5)), b = new(0xAAB40001, new Vector3(2, 12, 6));
        Assert.Equal(new Vector3(4, 2, 1), a.OffsetTo(b));
    }

    [Theory]
    [Behaviour("world.positions.cylinder-distance", "spec/05, 6.2; @0x005A97F0")]
    [InlineData(1.8f, 3f, 0f, 2.4)]
    [InlineData(1.8f, 0.2f, 0f, -1.843909)]
    [InlineData(1.8f, 0f, 3f, 2.683282)]
    [InlineData(0.2f, 0f, 0.5f, 0.3)]
    public void Cylinders_are_apart_by_the_mixture_of_retail(float height, float x, float z, double distance)
    {
        Position a = new(0xA9B40001, new Vector3(10, 10, 0)), b = new(0xA9B40001, new Vector3(10 + x, 10, z));
        Assert.Equal(distance, a.CylinderDistance(0.3f, height, b, 0.3f, height), 5e-6);
    }

    [Theory]
    [Behaviour("world.positions.heading", "spec/05, 4.2; @0x005A9520")]
    [InlineData(0, 1, 0)]
    [InlineData(1, 0, 90)]
    [InlineData(0, -1, 180)]
    [InlineData(-1, 0, 270)]
    [InlineData(0, 0, 0)]
    public void Headings_count_clockwise_from_north(float x, float y, float degrees)
    {
        Position a = new(0xA9B40001, new Vector3(10, 10, 0)), b = new(0xA9B40001, new Vector3(10 + x, 10 + y, 4));
        Assert.Equal(degrees, a.HeadingTo(b), 1e-4f);
    }

    [Fact]
    [Behaviour("world.positions.quadrant", "spec/05, 4.2; @0x005A9580")]
    public void Quadrants_are_told_by_side_front_and_third()
    {
        Position a = new(0xA9B40001, new Vector3(10, 10, 0));
        Assert.Equal(16 | 32 | 4, a.QuadrantOf(new Position(0xA9B40001, new Vector3(11, 11, 0.5f)), 1.8f));
        Assert.Equal(8 | 64 | 2, a.QuadrantOf(new Position(0xA9B40001, new Vector3(9, 9, 1)), 1.8f));
        Assert.Equal(16 | 64 | 1, a.QuadrantOf(new Position(0xA9B40001, new Vector3(11, 9, 1.5f)), 1.8f));
    }

    [Fact]
    [Behaviour("world.ids.within-block", "spec/05, 4.1; @0x0050E800")]
    public void A_sphere_is_within_its_block_when_it_does_not_reach_over_the_border()
    {
        Assert.True(CellIds.IsWithinBlock(new Vector3(1, 1, 0), 1));
        Assert.False(CellIds.IsWithinBlock(new Vector3(0.99f, 1, 0), 1));
        Assert.False(CellIds.IsWithinBlock(new Vector3(191, 100, 0), 1));
        Assert.True(CellIds.IsWithinBlock(new Vector3(190.99f, 100, 0), 1));
    }
}
