using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Land, cells, scenery and region parse to the values that come with the samples.</summary>
public sealed class WorldSampleTests
{
    private const PortalFlags ExactOutside = PortalFlags.ExactMatch | PortalFlags.Outside;

    private static readonly Quaternion QuarterTurn = new(0, 0, 0.70710677f, 0.70710677f);

    [Fact]
    [Behaviour("dats.sample.landblock", "data/dat-samples/README.md; spec/07, section 7")]
    public void Land_blocks()
    {
        var block = TestData.Sample<LandBlock>("landblock-A9B4FFFF");
        var flat = TestData.Sample<LandBlock>("landblock-A8B4FFFF");

        Assert.True(block.HasInfo);
        Assert.Equal(Enumerable.Range(0, 81), block.Heights.Select(h => (int)h));
        Assert.Equal(Enumerable.Range(0, 81).Select(i => LandBlock.TerrainWord(i % 4, i % 32, i % 32)), block.Terrain);
        Assert.False(flat.HasInfo);
        Assert.All(flat.Terrain, word => Assert.Equal(0, word));
        Assert.All(flat.Heights, height => Assert.Equal(10, height));
        Assert.Equal((0, 8, 9, 80), (LandBlock.IndexOf(0, 0), LandBlock.IndexOf(0, 8), LandBlock.IndexOf(1, 0), LandBlock.IndexOf(8, 8)));
    }

    [Fact]
    [Behaviour("dats.sample.landblock-info", "data/dat-samples/README.md; spec/07, section 7")]
    public void Land_block_info()
    {
        var info = TestData.Sample<LandBlockInfo>("landblockinfo-A9B4FFFE");

        Assert.Equal(3u, info.CellCount);
        Assert.Equal([new StaticObject(0x02000010, new(new(10, 20, 30), Quaternion.Identity))], info.Objects);
        Building building = Assert.Single(info.Buildings);
        Assert.Equal((0x01000003u, 5u), (building.ModelId, building.LeafCount));
        Assert.Equal(new DatFrame(new(96, 96, 24), QuarterTurn), building.Frame);
        Assert.Equal((PortalFlags.ExactMatch, (ushort)0x100, (ushort)0),
            (building.Portals[0].Flags, building.Portals[0].OtherCell, building.Portals[0].OtherPortal));
        Assert.Equal([0x100, 0x101, 0x102], building.Portals[0].StabCells.Select(c => (int)c));
        Assert.Equal(PortalFlags.ExactMatch | PortalFlags.NormalPointsIn, building.Portals[1].Flags);
        Assert.Equal(((ushort)0x102, (ushort)0), (building.Portals[1].OtherCell, building.Portals[1].OtherPortal));
        Assert.Equal([0x102, 0x100], building.Portals[1].StabCells.Select(c => (int)c));
        Assert.Equal(8, info.RestrictionBuckets);
        Assert.Equal([new CellRestriction(0xA9B40100, 0x7A9B4001)], info.Restrictions);
    }

    [Fact]
    [Behaviour("dats.sample.envcell", "data/dat-samples/README.md; spec/07, section 7")]
    public void Cells()
    {
        var hall = TestData.Sample<EnvCell>("envcell-A9B40100");
        var room = TestData.Sample<EnvCell>("envcell-A9B40101");
        var hut = TestData.Sample<EnvCell>("envcell-A9B40102");

        Assert.Equal((EnvCellFlags)11, hall.Flags);
        Assert.Equal([0x08000001u, 0x08000002u, 0x08000003u], hall.SurfaceIds);
        Assert.Equal((0x0D000001u, (ushort)0), (hall.EnvironmentId, hall.Structure));
        Assert.Equal(new DatFrame(new(96, 96, 24), QuarterTurn), hall.Position);
        Assert.Equal([new CellPortal(ExactOutside, 10, 0xFFFF, 0), new CellPortal(PortalFlags.ExactMatch, 11, 0x101, 0)], hall.Portals);
        Assert.Equal([true, false], hall.Portals.Select(p => p.IsOutside));
        Assert.All(hall.Portals, p => Assert.True(p.PortalSide));
        Assert.Equal([(ushort)0x101], hall.VisibleCells);
        Assert.Equal([new StaticObject(0x02000010, new(new(96.5f, 97, 24), Quaternion.Identity))], hall.StaticObjects);
        Assert.Equal(0x7A9B4001u, hall.RestrictionObjectId);

        Assert.Equal(EnvCellFlags.SeenOutside, room.Flags);
        Assert.Equal([0x08000001u], room.SurfaceIds);
        Assert.Equal((0x0D000001u, (ushort)1), (room.EnvironmentId, room.Structure));
        Assert.Equal(hall.Position, room.Position);
        Assert.Equal([new CellPortal(PortalFlags.ExactMatch, 8, 0x100, 1)], room.Portals);
        Assert.Equal([(ushort)0x100], room.VisibleCells);

        Assert.Equal(EnvCellFlags.None, hut.Flags);
        Assert.Equal((0x0D000010u, (ushort)0), (hut.EnvironmentId, hut.Structure));
        Assert.Equal(new DatFrame(new(24, 24, 10), Quaternion.Identity), hut.Position);
        Assert.Equal([new CellPortal(ExactOutside, 1, 0xFFFF, 0)], hut.Portals);
        Assert.Empty(hut.VisibleCells);
        Assert.Empty(hut.StaticObjects);
    }

    [Theory]
    [InlineData(5, 0xFFFF, true)]
    [InlineData(4, 0x0101, true)]
    [InlineData(1, 0xFFFF, false)]
    [InlineData(1, 0x0101, false)]
    [Behaviour("dats.envcell.portal-to-the-outside", "spec/05, 2.5; spec/07, 7.11")]
    public void A_portal_opens_to_the_outside_by_its_flag_alone(int flags, int cell, bool outside)
        => Assert.Equal(outside, new CellPortal((PortalFlags)flags, 0, (ushort)cell, 0).IsOutside);

    [Fact]
    [Behaviour("dats.sample.scene", "data/dat-samples/README.md; spec/07, section 7")]
    public void Scene_of_one_object()
    {
        SceneObject thing = Assert.Single(TestData.Sample<Scene>("scene-12000001").Objects);

        Assert.Equal(0x02000010u, thing.ObjectId);
        Assert.Equal(new DatFrame(new(1, 2, 3), Quaternion.Identity), thing.BaseFrame);
        Assert.Equal((0.75f, 12f, 10f), (thing.Frequency, thing.DisplaceX, thing.DisplaceY));
        Assert.Equal((0.8f, 1.4f, 360f), (thing.MinScale, thing.MaxScale, thing.MaxRotation));
        Assert.Equal((0.5f, 1f), (thing.MinSlope, thing.MaxSlope));
        Assert.Equal((0u, 1u, 0u), (thing.Align, thing.Orient, thing.WeenieObject));
    }

    [Fact]
    [Behaviour("dats.sample.region", "data/dat-samples/README.md; spec/07, section 7")]
    public void Minimal_region()
    {
        var region = TestData.Sample<Region>("region-13000000");

        AssertCommon(region);
        Assert.Equal(RegionParts.Scenes, region.Parts);
        Assert.Null(region.Sky);
        Assert.Null(region.Misc);
        Assert.Empty(region.Sounds);
        Assert.Empty(region.Time.TimesOfDay);
        Assert.Empty(region.Time.WeekDays);
        Assert.Empty(region.Time.Seasons);
        SceneType type = Assert.Single(region.SceneTypes);
        Assert.Equal(SceneType.NoSound, type.SoundIndex);
        Assert.Equal([0x12000001u], type.SceneIds);
        TerrainType terrain = Assert.Single(region.TerrainTypes);
        Assert.Equal(("BarrenRock", new DatColor(7, 8, 9, 255)), (terrain.Name, terrain.Color));
        Assert.Equal([0u], terrain.SceneTypes);
        Assert.Equal(0u, region.Surface.BaseTextureSize);
        Assert.Empty(region.Surface.CornerMaps);
        Assert.Empty(region.Surface.SideMaps);
        Assert.Empty(region.Surface.RoadMaps);
        Assert.Empty(region.Surface.TerrainTextures);
    }

    [Fact]
    [Behaviour("dats.sample.region-full", "data/dat-samples/README.md; spec/07, section 7")]
    public void Region_with_every_part()
    {
        var region = TestData.Sample<Region>("region-full-13000000");

        AssertCommon(region);
        Assert.Equal((RegionParts)0x213, region.Parts);
        Assert.Equal([new TimeOfDay(0, 1, "Darktide"), new TimeOfDay(0.5f, 0, "Midsong")], region.Time.TimesOfDay);
        Assert.Equal(["Frostfell", "Snow"], region.Time.WeekDays);
        Assert.Equal([new Season(0, "Winter"), new Season(90, "Spring")], region.Time.Seasons);

        Assert.Equal((1d, 20d), (region.Sky!.TickSize, region.Sky.LightTickSize));
        DayGroup day = Assert.Single(region.Sky.DayGroups);
        Assert.Equal((1f, "Sunny"), (day.Chance, day.Name));
        Assert.Equal([new SkyObject(0, 1, 90, 180, 0.25f, 0, 0x01001348, 0, 0)], day.Objects);
        SkyTime time = Assert.Single(day.Times);
        Assert.Equal((0f, 0.5f, 0f, 90f), (time.Begin, time.DirectionalBrightness, time.Heading, time.Pitch));
        Assert.Equal((new DatColor(0x80, 0x80, 0x80, 0xFF), 0.25f, new DatColor(0x40, 0x40, 0x40, 0xFF)),
            (time.DirectionalColor, time.AmbientBrightness, time.AmbientColor));
        Assert.Equal((100f, 1000f, new DatColor(0xFF, 0xFF, 0xFF, 0xFF), 1u), (time.MinFog, time.MaxFog, time.FogColor, time.FogMode));
        Assert.Equal([new SkyObjectReplacement(0, 0x01001F6A, 45, 0, 1, 1)], time.Replacements);

        AmbientSounds sounds = Assert.Single(region.Sounds);
        Assert.Equal(0x20000001u, sounds.SoundTableId);
        Assert.Equal([new AmbientSound(0x64, 0.5f, 0.25f, 10, 60)], sounds.Sounds);
        Assert.Equal([0u, SceneType.NoSound], region.SceneTypes.Select(t => t.SoundIndex));
        Assert.Equal([[0x12000001u], [0x12000001u, 0x12000001u]], region.SceneTypes.Select(t => t.SceneIds.ToArray()));
        Assert.Equal(["BarrenRock", "Grassland"], region.TerrainTypes.Select(t => t.Name));
        Assert.Equal([[0u, 1u], [1u]], region.TerrainTypes.Select(t => t.SceneTypes.ToArray()));
        Assert.Equal(new DatColor(3, 2, 1, 255), region.TerrainTypes[1].Color);

        Assert.Equal(512u, region.Surface.BaseTextureSize);
        Assert.Equal([new TerrainMap(8, 0x05000001)], region.Surface.CornerMaps);
        Assert.Equal([new TerrainMap(9, 0x05000001)], region.Surface.SideMaps);
        Assert.Equal([new TerrainMap(9, 0x05000001)], region.Surface.RoadMaps);
        Assert.Equal([new TerrainTexture(0, 0x05000001, 4, 20, 0, 10, 0, 5, 0, 8, 0x05000001)], region.Surface.TerrainTextures);
        Assert.Equal(new RegionMisc(1, 2, 3, 4, 5, 6), region.Misc);
    }

    [Fact]
    [Behaviour("dats.sample.iteration", "data/dat-samples/README.md; spec/07, section 7")]
    public void Iteration_records()
    {
        var three = TestData.Sample<IterationRecord>("iteration-FFFF0001");

        Assert.Equal(3, three.Count);
        Assert.Equal([-3, 1], three.Words);
        Assert.Equal(Convert.FromHexString("18080000E8F7FFFF01000000"), IterationRecord.UpTo(2072).Encode());
        Assert.Equal(new byte[4], new IterationRecord { Id = DatIds.Iteration, Count = 0 }.Encode());
    }

    private static void AssertCommon(Region region)
    {
        Assert.Equal((1u, 3u, "Dereth"), (region.Number, region.Version, region.Name));
        Assert.Equal(new RegionLand(255, 255, 24, 8, 1, 200, 1000, 5), region.Land);
        Assert.Equal(Enumerable.Range(0, 256).Select(i => 2f * i), region.HeightTable);
        Assert.Equal((0d, 10u, 7620f, 360u, "P.Y."),
            (region.Time.ZeroTimeOfYear, region.Time.ZeroYear, region.Time.DayLength, region.Time.DaysPerYear, region.Time.YearName));
    }
}
