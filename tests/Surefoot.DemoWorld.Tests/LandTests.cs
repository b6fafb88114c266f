using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Tests;

public sealed class LandTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    private const float WalkableNormalZ = 0.66417414f;

    private readonly DemoTerrain terrain = DemoTerrain.Create();

    public static TheoryData<string, double> PromisedSlopes()
        => [.. SlopeYard.Slopes.Select(slope => (slope.Name, slope.Degrees))];

    [Fact, Behaviour("demo-world.land.borders-agree", "spec/07, 7.12")]
    public void Neighbouring_blocks_agree_on_the_vertices_they_share()
    {
        int borders = 0;
        foreach (var (x, y) in DemoTerrain.Blocks)
        {
            var block = world.Block(x, y);
            for (int k = 0; k < LandBlock.Side; k++)
            {
                if (DemoTerrain.HasBlock(x + 1, y))
                    borders += AssertSame(block, LandBlock.IndexOf(8, k), world.Block(x + 1, y), LandBlock.IndexOf(0, k));
                if (DemoTerrain.HasBlock(x, y + 1))
                    borders += AssertSame(block, LandBlock.IndexOf(k, 8), world.Block(x, y + 1), LandBlock.IndexOf(k, 0));
            }
        }

        Assert.Equal(2 * 10 * 9 * 9, borders);
    }

    [Fact, Behaviour("demo-world.land.has-six-by-six-blocks", "design.md, Two commands")]
    public void The_land_has_at_least_six_by_six_blocks_and_the_open_sea_around_it()
    {
        Assert.True(DemoTerrain.LandBlocks >= 6);
        foreach (var (x, y) in DemoTerrain.Blocks)
        {
            // A block that is water at every vertex is impassable (spec 05, 4.16), so the land must have none and the sea nothing else.
            bool land = x is >= DemoTerrain.FirstBlockX and < DemoTerrain.FirstBlockX + DemoTerrain.LandBlocks
                && y is >= DemoTerrain.FirstBlockY and < DemoTerrain.FirstBlockY + DemoTerrain.LandBlocks;
            bool water = world.Block(x, y).Terrain.All(word => ((word >> 2) & 31) is >= 16 and <= 20);
            Assert.Equal(!land, water);
        }
    }

    [Fact, Behaviour("demo-world.land.split-follows-the-hash", "spec/05, 4.3 and 6.4")]
    public void Cells_are_cut_as_the_hash_says()
    {
        byte[] expected = [0xFF, 0xFC, 0xE0, 0xC3, 0xC7, 0xCC, 0xC9, 0xDB];
        for (uint i = 0; i < 8; i++)
        {
            int column = 0;
            for (uint j = 0; j < 8; j++)
                column |= TerrainTriangle.CutsSouthWestToNorthEast((0xA9 * 8) + i, (0xB4 * 8) + j) ? 1 << (int)j : 0;
            Assert.Equal(expected[i], column);
        }
    }

    [Fact, Behaviour("demo-world.land.height-table-rises", "spec/07, 7.15")]
    public void The_height_table_has_256_rising_heights_from_0_to_800()
    {
        var heights = world.Region.HeightTable;
        Assert.Equal(256, heights.Length);
        Assert.Equal(0f, heights[0]);
        Assert.Equal(800f, heights[^1]);
        for (int i = 1; i < heights.Length; i++)
            Assert.True(heights[i] > heights[i - 1]);
    }

    [Fact, Behaviour("demo-world.land.runway-is-flat", "design.md, Two commands")]
    public void The_runway_is_flat_for_more_than_five_blocks()
    {
        Assert.True(DemoPlaces.TryFind("runway", out var start));
        var (column, row) = DemoTerrain.OriginOf((int)(start.CellId >> 24), (int)((start.CellId >> 16) & 0xFF));
        double x = (column * 24.0) + start.Origin.X, y = (row * 24.0) + start.Origin.Y;
        Assert.Equal(90f, start.Heading);
        for (double ahead = -10; ahead <= 5 * 192 + 100; ahead += 2.5)
        {
            for (double aside = -24; aside <= 24; aside += 4)
            {
                var ground = terrain.GroundAt(x + ahead, y + aside);
                Assert.Equal(20f, ground.Position.Z);
                Assert.Equal(1f, ground.Normal.Z);
                Assert.Equal(0f, ground.WaterDepth);
            }
        }
    }

    [Theory, MemberData(nameof(PromisedSlopes)), Behaviour("demo-world.land.slopes-keep-their-promise", "spec/03, floor_z")]
    public void A_named_slope_has_the_promised_angle(string name, double degrees)
    {
        Assert.True(DemoPlaces.TryFind(name, out var place));
        for (float aside = -20; aside <= 20; aside += 5)
        {
            for (float ahead = 8.5f; ahead <= 31.5f; ahead += 2.3f)
            {
                var normal = terrain.GroundAt(place.CellId, place.Origin.X + aside, place.Origin.Y + ahead).Normal;
                Assert.Equal(Math.Cos(degrees * Math.PI / 180), normal.Z, 6);
                Assert.Equal(-Math.Sin(degrees * Math.PI / 180), normal.Y, 6);
                Assert.Equal(degrees < 48.38, normal.Z >= WalkableNormalZ);
            }

            Assert.Equal(1f, terrain.GroundAt(place.CellId, place.Origin.X + aside, place.Origin.Y).Normal.Z);
        }
    }

    [Fact, Behaviour("demo-world.land.mountains-are-too-steep", "spec/03, floor_z")]
    public void The_mountain_has_slopes_beyond_the_walkable_limit_between_its_foot_and_its_summit()
    {
        var summit = Place("mountain-top");
        var foot = Place("foot-of-the-mountain");
        Assert.True(summit.Z > foot.Z + 100);
        int steep = 0;
        for (int step = 1; step < 100; step++)
        {
            double share = step / 100.0;
            var ground = terrain.GroundAt(foot.X + (share * (summit.X - foot.X)), foot.Y + (share * (summit.Y - foot.Y)));
            steep += ground.Normal.Z < WalkableNormalZ ? 1 : 0;
        }

        Assert.True(steep > 30, $"only {steep} of 99 points are steep");
    }

    [Fact, Behaviour("demo-world.land.cliff-falls-off", "design.md, Two commands")]
    public void The_cliff_drops_more_than_30_metres_at_more_than_the_walkable_slope()
    {
        var brink = Place("cliff-edge");
        var foot = Place("cliff-foot");
        Assert.InRange(brink.Z - foot.Z, 30, 50);
        int steep = 0;
        for (double x = foot.X; x < brink.X; x++)
            steep += terrain.GroundAt(x, brink.Y).Normal.Z < WalkableNormalZ ? 1 : 0;
        Assert.InRange(steep, 22, 26);
    }

    [Fact, Behaviour("demo-world.land.shore-is-shallow", "spec/05, 4.5")]
    public void The_lake_is_entered_over_a_gentle_shore_and_is_never_deeper_than_retail_water()
    {
        var shore = Place("lake-shore");
        var middle = Place("lake-middle");
        Assert.Equal(0f, terrain.GroundAt(shore.X + 24, shore.Y).WaterDepth);
        var depths = new HashSet<float>();
        for (double share = 0; share <= 1; share += 0.005)
        {
            var ground = terrain.GroundAt(shore.X + (share * (middle.X - shore.X)), shore.Y + (share * (middle.Y - shore.Y)));
            Assert.True(ground.Normal.Z > Math.Cos(10 * Math.PI / 180));
            depths.Add(ground.WaterDepth);
        }

        Assert.Subset(new HashSet<float> { 0f, 0.1f, 0.45f, 0.9f }, depths);
        Assert.Contains(0.9f, depths);
        Assert.Contains(0.45f, depths);
    }

    [Fact, Behaviour("demo-world.land.roads-connect", "spec/05, 4.6")]
    public void Roads_cross_the_meadow_and_hang_together()
    {
        var roads = new HashSet<(int, int)>();
        for (int column = 0; column <= 64; column++)
        {
            for (int row = 0; row <= 64; row++)
            {
                if (terrain.IsRoad(column, row))
                    roads.Add((column, row));
            }
        }

        Assert.True(roads.Count > 80);
        var crossing = (Roads.CrossingColumn, Roads.CrossingRow);
        Assert.Contains(crossing, roads);
        var reached = new HashSet<(int, int)> { crossing };
        var open = new Queue<(int Column, int Row)>([crossing]);
        while (open.TryDequeue(out var at))
        {
            for (int turn = 0; turn < 9; turn++)
            {
                var next = (at.Column + (turn % 3) - 1, at.Row + (turn / 3) - 1);
                if (roads.Contains(next) && reached.Add(next))
                    open.Enqueue(next);
            }
        }

        Assert.Equal(roads.Count, reached.Count);
    }

    [Fact, Behaviour("demo-world.land.ground-is-continuous", "spec/05, 4.3")]
    public void The_ground_has_no_gaps_between_triangles_cells_and_blocks()
    {
        // Both triangles at a cell's border and diagonal give one height; so heights a millimetre apart differ by little.
        for (int column = 1; column < 64; column += 3)
        {
            for (int row = 1; row < 64; row += 3)
            {
                for (double along = 0.5; along < 24; along += 4.7)
                {
                    double x = column * 24.0, y = row * 24.0;
                    AssertClose(terrain.GroundAt(x - 0.001, y + along), terrain.GroundAt(x + 0.001, y + along));
                    AssertClose(terrain.GroundAt(x + along, y - 0.001), terrain.GroundAt(x + along, y + 0.001));
                    AssertClose(terrain.GroundAt(x + along, y + along - 0.001), terrain.GroundAt(x + along, y + along + 0.001));
                    AssertClose(terrain.GroundAt(x + along, y + 24 - along - 0.001), terrain.GroundAt(x + along, y + 24 - along + 0.001));
                }
            }
        }
    }

    [Fact, Behaviour("demo-world.land.matches-its-records", "spec/07, 7.12")]
    public void The_terrain_in_memory_is_the_one_in_the_files()
    {
        var heights = world.Region.HeightTable;
        foreach (var (x, y) in DemoTerrain.Blocks)
        {
            var block = world.Block(x, y);
            var (column, row) = DemoTerrain.OriginOf(x, y);
            for (int i = 0; i < LandBlock.Side; i++)
            {
                for (int j = 0; j < LandBlock.Side; j++)
                {
                    Assert.Equal(heights[block.Heights[LandBlock.IndexOf(i, j)]], terrain.Height(column + i, row + j));
                    Assert.Equal(block.Terrain[LandBlock.IndexOf(i, j)], terrain.Word(column + i, row + j));
                    int kind = (block.Terrain[LandBlock.IndexOf(i, j)] >> 2) & 31;
                    int scenery = block.Terrain[LandBlock.IndexOf(i, j)] >> 11;
                    Assert.True(scenery < world.Region.TerrainTypes[kind].SceneTypes.Length);
                }
            }
        }
    }

    private static int AssertSame(LandBlock a, int i, LandBlock b, int j)
    {
        Assert.Equal(a.Heights[i], b.Heights[j]);
        Assert.Equal(a.Terrain[i], b.Terrain[j]);
        return 1;
    }

    // A slope of 85 degrees rises 23 mm over 2 mm.
    private static void AssertClose(GroundPoint a, GroundPoint b) => Assert.InRange(a.Position.Z - b.Position.Z, -0.03f, 0.03f);

    // In metres from the land's south-west corner.
    private static (double X, double Y, double Z) Place(string name)
    {
        Assert.True(DemoPlaces.TryFind(name, out var place));
        var (column, row) = DemoTerrain.OriginOf((int)(place.CellId >> 24), (int)((place.CellId >> 16) & 0xFF));
        return ((column * 24.0) + place.Origin.X, (row * 24.0) + place.Origin.Y, place.Origin.Z);
    }
}
