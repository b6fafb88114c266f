using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

public sealed class TerrainTests
{
    [Theory]
    [Behaviour("world.terrain.split", "spec/05, 6.4; @0x00531D10")]
    [InlineData(0, 0, 0xAE6470DBu)]
    [InlineData(0, 1, 0x1A7F3662u)]
    [InlineData(1, 0, 0x6C488D1Eu)]
    [InlineData(7, 7, 0x472B6724u)]
    [InlineData(1352, 1440, 0xC15BD913u)]
    [InlineData(1352, 1441, 0xBC3DABF2u)]
    [InlineData(1352, 1442, 0xB71F7ED1u)]
    [InlineData(1353, 1440, 0x73B91436u)]
    [InlineData(1355, 1444, 0x5D7BD85Cu)]
    [InlineData(1359, 1447, 0xF0E404E4u)]
    [InlineData(1360, 1440, 0x5445B22Bu)]
    [InlineData(1352, 1448, 0x986A700Bu)]
    [InlineData(10, 13, 0x159F2D3Au)]
    [InlineData(1020, 412, 0x1E6DF8C3u)]
    [InlineData(1021, 412, 0x729F671Au)]
    [InlineData(134, 257, 0x6D66D526u)]
    [InlineData(1586, 1354, 0xF09A6713u)]
    [InlineData(1747, 683, 0xB2FD9944u)]
    [InlineData(1024, 1024, 0xAD1B98DBu)]
    [InlineData(1024, 1025, 0x44372A62u)]
    [InlineData(1025, 1025, 0x39E6D2D8u)]
    [InlineData(2032, 7, 0xA7173D0Cu)]
    [InlineData(7, 2032, 0xB57827F0u)]
    [InlineData(2039, 2039, 0x3846F0E4u)]
    public void The_hash_of_a_cell_decides_its_cut(uint x, uint y, uint hash)
    {
        Assert.Equal(hash, TerrainSurface.SplitHash(x, y));
        Assert.Equal(hash >= 0x80000000, TerrainSurface.IsCutSouthWestToNorthEast(x, y));
    }

    [Theory]
    [Behaviour("world.terrain.split.blocks", "spec/05, 6.4")]
    [InlineData(0xA9B40000u, "FFFCE0C3C7CCC9DB")]
    [InlineData(0x00000000u, "ADAAAAA92D242673")]
    [InlineData(0x7F330000u, "38CC26926BA555A9")]
    [InlineData(0xFEFE0000u, "F8003FC11CE7996C")]
    public void Whole_blocks_are_cut_as_retail_cuts_them(uint block, string columns)
    {
        TerrainSurface terrain = Ground.Flat(block);
        byte[] bytes = Convert.FromHexString(columns);
        for (int cell = 0; cell < 64; cell++)
            Assert.Equal((bytes[cell >> 3] >> (cell & 7) & 1) != 0, terrain.IsCutSouthWestToNorthEast(cell));
    }

    [Fact]
    [Behaviour("world.terrain.split.map", "spec/05, 6.4")]
    public void The_whole_map_is_cut_as_retail_cuts_it()
    {
        byte[] map = new byte[CellIds.MapCells * CellIds.MapCells];
        int ones = 0, at = 0;
        for (uint x = 0; x < CellIds.MapCells; x++)
        {
            for (uint y = 0; y < CellIds.MapCells; y++) ones += map[at++] = (byte)(TerrainSurface.IsCutSouthWestToNorthEast(x, y) ? 1 : 0);
        }

        Assert.Equal(2081396, ones);
        Assert.Equal(0x0CE83726u, Crc32(map));
    }

    [Theory]
    [Behaviour("world.terrain.planes", "spec/05, 6.5; @0x005383D0")]
    [InlineData(0xA9B40000u, 0, 0, "10,16,10,16", "-0.242535621,0,0.970142543,-9.70142555", "-0.242535621,0,0.970142543,-9.70142555")]
    [InlineData(0xA9B40000u, 1, 0, "10,16,10,16", "-0.242535621,0,0.970142543,-3.88057065", "-0.242535621,0,0.970142543,-3.88057089")]
    [InlineData(0xA9B40000u, 0, 0, "10,14,12,30", "-0.137360558,-0.549442232,0.824163377,-8.24163437",
        "-0.598671079,-0.0665190145,0.798228145,-7.98228168")]
    [InlineData(0xA9B40000u, 1, 0, "10,14,12,30", "-0.163846388,-0.0819231868,0.983078301,-5.89846992",
        "-0.529411793,-0.470588267,0.70588237,15.5294132")]
    [InlineData(0xA9B40000u, 7, 7, "20,22,28,24", "-0.0827605873,-0.0827605873,0.993127048,7.94501638",
        "0.156173766,-0.312347531,0.937042594,7.49634075")]
    [InlineData(0xA9B40000u, 3, 4, "4,40,8,2", "-0.828517139,-0.0920574591,0.552344739,66.2813721",
        "0.132324323,0.838054061,0.529297292,-114.328217")]
    [InlineData(0x00000000u, 7, 7, "100,50,60,110", "0.731194198,0.584955335,0.350973219,-256.210449",
        "-0.611944199,-0.734333098,0.293733239,226.174591")]
    [InlineData(0xC6A90000u, 2, 2, "0,2,2,44", "-0.0413096175,-0.867502034,0.495715439,43.6229591",
        "-0.867502034,-0.0413096212,0.495715439,43.6229591")]
    public void Both_triangles_of_a_cell_have_the_planes_of_retail(uint block, int i, int j, string corners, string first, string second)
    {
        TerrainSurface terrain = Ground.WithCell(block, i, j, Ground.Numbers(corners));
        int triangle = 2 * ((8 * i) + j);
        Assert.Equal(Ground.Numbers(first), Coefficients(terrain.PlaneOf(triangle)));
        Assert.Equal(Ground.Numbers(second), Coefficients(terrain.PlaneOf(triangle + 1)));
    }

    [Fact]
    [Behaviour("world.terrain.planes.flat", "spec/05, 4.3")]
    public void Ground_at_height_zero_has_a_negative_zero_constant()
    {
        Plane plane = Ground.Flat(0xA9B40000).PlaneOf(0);
        Assert.Equal(Vector3.UnitZ, plane.Normal);
        Assert.Equal(BitConverter.SingleToUInt32Bits(-0f), BitConverter.SingleToUInt32Bits(plane.D));
    }

    [Theory]
    [Behaviour("world.terrain.height", "spec/05, 6.5; @0x00532CF0")]
    [InlineData(0xA9B40000u, 0, 0, "10,16,10,16", "0:13 1:11.5 0:14.5 0:10 1:15.875 0:16")]
    [InlineData(0xA9B40000u, 0, 0, "10,14,12,30", "0:20 1:15.75 0:19 0:10.000001 1:29.604166 0:22")]
    [InlineData(0xA9B40000u, 1, 0, "10,14,12,30", "0:13 0:12.25 1:15.5 0:10 1:29.458334 1:22")]
    [InlineData(0xA9B40000u, 7, 7, "20,22,28,24", "0:22 1:24 0:22.25 0:20 1:24 0:23")]
    [InlineData(0xA9B40000u, 3, 4, "4,40,8,2", "0:23.9999981 0:15.499999 1:27.25 0:3.99999833 1:2.52083278 1:21")]
    [InlineData(0x00000000u, 7, 7, "100,50,60,110", "0:55.0000191 0:62.5000191 1:59.9999809 0:100.000015 1:108.333313 1:79.9999771")]
    [InlineData(0xC6A90000u, 2, 2, "0,2,2,44", "0:22 1:11.750001 0:17.25 0:2.40479267e-07 1:43.1041679 0:23")]
    public void A_point_is_over_one_triangle_and_has_its_height(uint block, int i, int j, string corners, string answers)
    {
        TerrainSurface terrain = Ground.WithCell(block, i, j, Ground.Numbers(corners));
        Vector2[] offsets = [new(12, 12), new(6, 15), new(18, 9), new(0, 0), new(23.5f, 23.75f), new(24, 12)];
        string[] expected = answers.Split(' ');
        for (int k = 0; k < offsets.Length; k++)
        {
            Vector3 point = new(offsets[k] + new Vector2(24 * i, 24 * j), 0);
            int cell = (8 * i) + j, triangle = terrain.FindTriangle(cell, point);
            string[] parts = expected[k].Split(':');
            Assert.Equal((2 * cell) + int.Parse(parts[0]), triangle);
            Assert.True(PlaneQueries.SetHeight(terrain.PlaneOf(triangle), ref point));
            Assert.Equal(Ground.Numbers(parts[1])[0], point.Z);
        }
    }

    [Theory]
    [Behaviour("world.terrain.water", "spec/05, 6.8; @0x00531550, @0x005327E0")]
    [InlineData(0, 0, WaterType.Entirely)]
    [InlineData(0, 1, WaterType.Partly)]
    [InlineData(1, 0, WaterType.Partly)]
    [InlineData(1, 1, WaterType.Partly)]
    [InlineData(1, 2, WaterType.Partly)]
    [InlineData(2, 1, WaterType.Partly)]
    [InlineData(2, 2, WaterType.Partly)]
    [InlineData(5, 5, WaterType.None)]
    [InlineData(3, 2, WaterType.None)]
    public void Water_at_the_corners_makes_a_cell_water(int i, int j, WaterType water)
    {
        TerrainSurface terrain = Ground.Pond();
        Assert.Equal(WaterType.Partly, terrain.BlockWaterType);
        Assert.Equal(water, terrain.WaterTypeOf((8 * i) + j));
    }

    [Theory]
    [Behaviour("world.terrain.water.depth", "spec/05, 6.8; @0x0052B8A0, @0x005315F0")]
    [InlineData(0, 0, 12, 12, 0.899999976f)]
    [InlineData(2, 2, 50, 50, 0.449999988f)]
    [InlineData(2, 2, 60, 60, 0.449999988f)]
    [InlineData(2, 2, 60.001f, 60, 0.100000001f)]
    [InlineData(2, 2, 60, 60.001f, 0.100000001f)]
    [InlineData(2, 2, 70, 70, 0.100000001f)]
    [InlineData(1, 1, 36, 36, 0.449999988f)]
    [InlineData(1, 1, 30, 30, 0.449999988f)]
    [InlineData(1, 1, 47.9f, 47.9f, 0.449999988f)]
    [InlineData(1, 0, 25, 23, 0.449999988f)]
    [InlineData(0, 1, 0, 36, 0.449999988f)]
    [InlineData(0, 1, 3, 36.5f, 0.100000001f)]
    [InlineData(1, 2, 48, 48, 0.449999988f)]
    [InlineData(5, 5, 130, 130, 0f)]
    public void Water_is_as_deep_as_the_corner_says(int i, int j, float x, float y, float depth) =>
        Assert.Equal(depth, Ground.Pond().WaterDepth((8 * i) + j, new Vector3(x, y, 0)));

    [Fact]
    [Behaviour("world.terrain.water.open", "spec/05, 6.8")]
    public void A_block_is_open_water_only_when_every_cell_is()
    {
        Assert.Equal(WaterType.Entirely, Ground.Of(0xA9B40000, (_, _) => 0, (_, _) => 17 << 2).BlockWaterType);
        TerrainSurface terrain = Ground.Of(0xA9B40000, (_, _) => 0, (i, j) => i == 4 && j == 4 ? 0 : 17 << 2);
        Assert.Equal(WaterType.Partly, terrain.BlockWaterType);
        for (int cell = 0; cell < 64; cell++)
        {
            bool island = (cell >> 3) is 3 or 4 && (cell & 7) is 3 or 4;
            Assert.Equal(island ? WaterType.Partly : WaterType.Entirely, terrain.WaterTypeOf(cell));
        }
    }

    [Theory]
    [Behaviour("world.terrain.words", "spec/05, 6.8")]
    [InlineData(0x0042, 2, 16, 0)]
    [InlineData(0x0054, 0, 21, 0)]
    [InlineData(0x07FF, 3, 31, 0)]
    [InlineData(0xF8D1, 1, 20, 31)]
    [InlineData(0xA850, 0, 20, 21)]
    public void A_terrain_word_says_road_type_and_scenery(int word, int road, int type, int scenery)
    {
        Assert.Equal(road, TerrainSurface.RoadOf((ushort)word));
        Assert.Equal(type, TerrainSurface.TypeOf((ushort)word));
        Assert.Equal(scenery, TerrainSurface.SceneryOf((ushort)word));
    }

    [Theory]
    [Behaviour("world.terrain.roads", "spec/05, 6.9; @0x0052FFF0")]
    [InlineData("1100", 4.99f, 12, true)]
    [InlineData("1100", 5, 12, false)]
    [InlineData("1010", 12, 4.99f, true)]
    [InlineData("0101", 12, 19, false)]
    [InlineData("0101", 12, 19.01f, true)]
    [InlineData("0011", 19.5f, 3, true)]
    [InlineData("1001", 12, 16.9f, true)]
    [InlineData("1001", 12, 17, false)]
    [InlineData("0110", 10, 10, true)]
    [InlineData("0110", 9, 9.9f, false)]
    [InlineData("1000", 2, 2.9f, true)]
    [InlineData("1000", 2, 3, false)]
    [InlineData("0001", 21.6f, 21.5f, true)]
    [InlineData("1110", 10, 10, false)]
    [InlineData("1011", 12, 4.99f, true)]
    [InlineData("1011", 19.5f, 12, true)]
    [InlineData("1011", 4, 12, false)]
    [InlineData("1101", 4, 12, true)]
    [InlineData("1101", 12, 4, false)]
    [InlineData("0111", 12, 19.5f, true)]
    [InlineData("0111", 12, 4, false)]
    [InlineData("0100", 2, 22, true)]
    [InlineData("0100", 22, 2, false)]
    [InlineData("0010", 22, 2, true)]
    [InlineData("0010", 2, 22, false)]
    [InlineData("1111", 12, 12, true)]
    public void Roads_are_five_metres_on_each_side(string corners, float x, float y, bool road)
    {
        TerrainSurface terrain = Ground.Of(
            0xA9B40000, (_, _) => 0, (i, j) => i < 2 && j < 2 && corners[(2 * i) + j] == '1' ? 1 : 0);
        Assert.Equal(road, terrain.IsOnRoad(new Vector3(x, y, 0)));
    }

    private static uint Crc32(ReadOnlySpan<byte> bytes)
    {
        uint crc = 0xFFFFFFFF;
        foreach (byte b in bytes)
        {
            crc ^= b;
            for (int bit = 0; bit < 8; bit++) crc = (crc >> 1) ^ (0xEDB88320 & (0 - (crc & 1)));
        }

        return ~crc;
    }

    private static float[] Coefficients(Plane plane) => [plane.Normal.X, plane.Normal.Y, plane.Normal.Z, plane.D];
}
