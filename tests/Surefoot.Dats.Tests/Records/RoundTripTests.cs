using System.Buffers;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Properties of every record that can be written.</summary>
public sealed class RoundTripTests
{
    [Fact]
    [Behaviour("dats.record.round-trip", "design.md")]
    public void Any_record_comes_back_from_its_bytes()
        => RecordGen.Any.Sample(
            record =>
            {
                byte[] bytes = record.Encode();
                DatRecord back = Decode(record, new ReadOnlySequence<byte>(bytes));
                Assert.Equal(bytes, back.Encode());
                Assert.Equal(RecordText.ToJson(record), RecordText.ToJson(back));
            },
            iter: Fuzz.Cases(1000));

    [Fact]
    [Behaviour("dats.record.chain-of-segments", "design.md")]
    public void A_record_in_pieces_decodes_as_in_one()
        => Gen.Select(RecordGen.Any, Gen.Int[1, 9]).Sample(
            (record, piece) =>
            {
                byte[] bytes = record.Encode();
                Assert.Equal(bytes, Decode(record, Pieces.Of(bytes, piece)).Encode());
            },
            iter: Fuzz.Cases(500));

    [Fact]
    [Behaviour("dats.record.trailing-zeros", "spec/07, section 7")]
    public void Zeros_that_align_the_end_are_kept_and_more_is_an_error()
    {
        byte[] bytes = TestData.SampleBytes("gfxobj-01000011");
        var aligned = DatRecord.Decode<GfxObj>(0x01000011, new ReadOnlySequence<byte>([.. bytes, 0, 0, 0]));
        Assert.Equal(32, aligned.Encode().Length);
        foreach (byte[] rest in new byte[][] { [0, 0, 0, 0], [1], [0, 0, 5] })
        {
            var error = Assert.Throws<DatFormatException>(
                () => DatRecord.Decode<GfxObj>(0x01000011, new ReadOnlySequence<byte>([.. bytes, .. rest])));
            Assert.Equal(29, error.Offset);
        }
    }

    [Fact]
    [Behaviour("dats.record.id-is-checked", "spec/07, section 7")]
    public void A_record_under_another_id_is_an_error()
    {
        var bytes = new ReadOnlySequence<byte>(TestData.SampleBytes("scene-12000001"));
        var error = Assert.Throws<DatFormatException>(() => DatRecord.Decode<Scene>(0x12000002, bytes, "portal"));
        Assert.Equal(("portal", 0x12000002u, 0L), (error.File, error.RecordId, error.Offset));
        Assert.Contains("0x12000001", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("dats.record.keys-out-of-order", "spec/07, 7.1")]
    public void Keys_out_of_order_are_remarked_upon_and_kept()
    {
        byte[] bytes = TestData.SampleBytes("gfxobj-01000010");
        bytes[0x15] = 9;
        var remarks = new List<DatRemark>();
        var shape = DatRecord.Decode<GfxObj>(0x01000010, new ReadOnlySequence<byte>(bytes), "", remarks);
        Assert.Equal(9, shape.Vertices.Vertices[0].Key);
        Assert.Contains("key 9", Assert.Single(remarks).Message, StringComparison.Ordinal);
        Assert.Equal(bytes, shape.Encode());
    }

    [Fact]
    [Behaviour("dats.record.padding-is-skipped", "spec/07, section 2 (align 4)")]
    public void Padding_is_skipped_without_looking_and_written_as_zero()
    {
        byte[] bytes = TestData.SampleBytes("landblock-A9B4FFFF");
        bytes[251] = 0xCC;
        var remarks = new List<DatRemark>();
        byte[] encoded = DatRecord.Decode<LandBlock>(0xA9B4FFFF, new ReadOnlySequence<byte>(bytes), "", remarks).Encode();
        Assert.Equal(251, Assert.Single(remarks).Offset);
        Assert.Equal(TestData.SampleBytes("landblock-A9B4FFFF"), encoded);
    }

    [Fact]
    [Behaviour("dats.animation.unknown-hook", "spec/07, 7.8")]
    public void An_unknown_hook_is_an_error_that_names_record_and_type()
    {
        byte[] bytes = TestData.SampleBytes("animation-03000003");
        bytes[0x30] = 0x1B;
        var error =
            Assert.Throws<DatFormatException>(() => DatRecord.Decode<Animation>(0x03000003, new ReadOnlySequence<byte>(bytes), "x"));
        Assert.Equal((0x03000003u, 0x30L), (error.RecordId, error.Offset));
        Assert.Contains("0x1B", error.Message, StringComparison.Ordinal);
    }

    public static TheoryData<DatRecord> Contradictions { get; } =
    [
        new GfxObj { Id = 0x01000001, DegradeId = 1 },
        new GfxObj { Id = 0x01000001, Flags = GfxObjFlags.HasPhysics },
        new GfxObj { Id = 0x01000001, PhysicsPolygons = [new DatPolygon()] },
        new GfxObj { Id = 0x01000001, Flags = GfxObjFlags.HasPhysics, PhysicsTree = new() { Nodes = [] } },
        new GfxObj
        {
            Id = 0x01000001,
            Flags = GfxObjFlags.HasPhysics,
            PhysicsTree = new() { Nodes = [new() { Tag = BspTag.BPnn, Positive = 0 }] },
        },
        new GfxObj { Id = 0x01000001, Flags = GfxObjFlags.HasPhysics, PhysicsTree = new() { Nodes = [new() { Tag = BspTag.BPnn }] } },
        new Setup { Id = 0x02000001, ParentParts = [1] },
        new Setup { Id = 0x02000001, PlacementFrames = [new(0, new([DatFrame.Identity]))] },
        new Animation { Id = 0x03000001, RootMotion = [DatFrame.Identity] },
        new MotionTable { Id = 0x09000001, Cycles = [new(0, new() { Velocity = System.Numerics.Vector3.UnitY })] },
        new EnvCell { Id = 0xA9B40100, CellId = 0xA9B40100, StaticObjects = [new(1, DatFrame.Identity)] },
        new EnvCell { Id = 0xA9B40100, CellId = 0xA9B40100, SurfaceIds = [0x08010000] },
        new LandBlock { Id = 0xA9B4FFFF, Terrain = [], Heights = [] },
        new LandBlockInfo { Id = 0xA9B4FFFE, Restrictions = [new(1, 2)] },
        new Region { Id = 0x13000000, HeightTable = [1] },
    ];

    [Theory]
    [MemberData(nameof(Contradictions))]
    [Behaviour("dats.record.contradictions-are-not-written", "spec/07, section 7")]
    public void A_record_that_contradicts_itself_is_not_written(DatRecord record)
        => Assert.Throws<InvalidOperationException>(record.Encode);

    private static DatRecord Decode(DatRecord record, ReadOnlySequence<byte> bytes) => DatRecords.Decode(record.Type, record.Id, bytes);
}
