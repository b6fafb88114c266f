using System.Buffers;
using System.Buffers.Binary;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Regions before August 2012 store eight words a thing in the sky, later ones nine; nothing in them says which.</summary>
public sealed class RegionKindTests
{
    private const uint SkyMesh = 0x01001348;

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [Behaviour("dats.region.before-august-2012", "spec/07, 7.15")]
    public void A_region_whose_sky_has_no_scripts_is_read_and_written_back_identically(int trailingZeros)
    {
        byte[] later = TestData.SampleBytes("region-full-13000000");
        byte[] earlier = [.. WithoutScript(later), .. new byte[trailingZeros]];
        Region region = Decode(earlier);
        Assert.False(region.Sky!.HasScripts);
        Assert.Equal([new SkyObject(0, 1, 90, 180, 0.25f, 0, SkyMesh, 0, 0x77)], Assert.Single(region.Sky.DayGroups).Objects);
        Assert.Equal((RegionParts)0x213, region.Parts);
        Assert.Equal(["BarrenRock", "Grassland"], region.TerrainTypes.Select(t => t.Name));
        Assert.Equal(new RegionMisc(1, 2, 3, 4, 5, 6), region.Misc);
        Assert.Equal(earlier, region.Encode());
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [Behaviour("dats.region.since-august-2012", "spec/07, 7.15")]
    public void A_region_whose_sky_has_scripts_stays_what_it_is(int trailingZeros)
    {
        byte[] bytes = [.. TestData.SampleBytes("region-full-13000000"), .. new byte[trailingZeros]];
        Region region = Decode(bytes);
        Assert.True(region.Sky!.HasScripts);
        Assert.Equal(bytes, region.Encode());
    }

    [Fact]
    [Behaviour("dats.region.kind-is-found", "spec/07, 7.15")]
    public void Either_kind_of_any_sky_is_told_from_the_record_s_end()
    {
        int cases = Fuzz.Cases(300), ambiguous = 0;
        Gen.Select(RegionGen.Region(), Gen.Bool.SelectMany(RegionGen.Sky)).Sample(
            (region, sky) =>
            {
                byte[] bytes = WithSky(region, sky).Encode();
                Region back = Decode(bytes, region.Id);
                Assert.Equal(bytes, back.Encode());
                if (back.Sky!.HasScripts == sky.HasScripts) return;

                // Both readings explain every byte: the newer one holds.
                Assert.True(back.Sky.HasScripts);
                Interlocked.Increment(ref ambiguous);
            },
            iter: cases);
        Assert.InRange(ambiguous, 0, Math.Max(1, cases / 20));
    }

    [Fact]
    [Behaviour("dats.region.neither-kind", "spec/07, 7.15")]
    public void A_region_that_fits_neither_kind_is_an_error_at_the_place_where_the_newer_reading_ends()
    {
        byte[] bytes = TestData.SampleBytes("region-full-13000000");
        var error = Assert.Throws<DatFormatException>(() => Decode(bytes[..^4]));
        Assert.Equal(bytes.Length - 4, error.Offset);
        error = Assert.Throws<DatFormatException>(() => Decode([.. bytes, 1]));
        Assert.Equal(bytes.Length, error.Offset);
    }

    [Fact]
    [Behaviour("dats.region.no-script-to-write", "spec/07, 7.15")]
    public void A_script_is_not_written_into_a_sky_that_stores_none()
    {
        var thing = new SkyObject(0, 1, 0, 0, 0, 0, SkyMesh, 0x33000001, 0);
        var sky = new SkyDescription(1, 1, [new DayGroup(1, "Sunny", [thing], [])]);
        Region region = TestData.Sample<Region>("region-13000000");
        Assert.True(Decode(WithSky(region, sky).Encode()).Sky!.HasScripts);
        Assert.Throws<InvalidOperationException>(WithSky(region, sky with { HasScripts = false }).Encode);
    }

    /// <summary>
    /// The sample as an earlier writer would have made it; its last property word is set, so that nothing is 0 by chance.
    /// </summary>
    private static byte[] WithoutScript(byte[] bytes)
    {
        byte[] mesh = new byte[4];
        BinaryPrimitives.WriteUInt32LittleEndian(mesh, SkyMesh);
        int script = bytes.AsSpan().IndexOf(mesh) + 4;
        byte[] earlier = [.. bytes[..script], .. bytes[(script + 4)..]];
        earlier[script] = 0x77;
        return earlier;
    }

    private static Region WithSky(Region region, SkyDescription sky) => new()
    {
        Id = region.Id,
        HeightTable = region.HeightTable,
        Time = region.Time,
        Parts = region.Parts | RegionParts.Sky,
        Sky = sky,
        Sounds = region.Sounds,
        SceneTypes = region.SceneTypes,
        TerrainTypes = region.TerrainTypes,
        Surface = region.Surface,
        Misc = region.Misc,
    };

    private static Region Decode(byte[] bytes, uint id = 0x13000000) => DatRecord.Decode<Region>(id, new ReadOnlySequence<byte>(bytes));
}
