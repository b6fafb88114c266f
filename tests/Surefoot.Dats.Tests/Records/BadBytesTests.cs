using System.Buffers;
using System.Buffers.Binary;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>
/// Whatever the bytes: a value or a <see cref="DatFormatException"/> that names file, record and offset; in bounded memory.
/// </summary>
public sealed class BadBytesTests
{
    private const string FileName = "some.dat";

    // Records are at most a few kilobytes here; decoded ones may be some tens of times larger.
    private const long MostBytes = 2_000_000;

    public static TheoryData<string> Samples { get; } =
    [
        .. Directory.GetFiles(TestData.Samples, "*.bin")
            .Select(path => Path.GetFileNameWithoutExtension(path)!)
            .Where(name => TypeOf(name) is not null)
            .Order(StringComparer.Ordinal),
    ];

    [Theory]
    [MemberData(nameof(Samples))]
    [Behaviour("dats.bad-bytes.truncated", "design.md")]
    public void A_truncated_record_is_a_format_error(string name)
    {
        DatRecordType type = TypeOf(name)!.Value;
        uint id = TestData.SampleId(name);
        byte[] bytes = TestData.SampleBytes(name);
        for (int length = 0; length < bytes.Length; length++)
        {
            byte[] part = bytes[..length];
            Assert.True(Try(type, id, part), $"{name} cut to {length} bytes was accepted");
        }

        Assert.False(Try(type, id, bytes));
    }

    [Theory]
    [MemberData(nameof(Samples))]
    [Behaviour("dats.bad-bytes.one-byte", "design.md")]
    public void A_record_with_one_wrong_byte_is_a_value_or_a_format_error(string name)
    {
        DatRecordType type = TypeOf(name)!.Value;
        uint id = TestData.SampleId(name);
        byte[] bytes = TestData.SampleBytes(name);
        byte[] values = [0x00, 0x80, 0xFF];
        for (int i = 0; i < bytes.Length; i++)
        {
            byte original = bytes[i];
            foreach (byte value in values)
            {
                bytes[i] = value;
                Try(type, id, bytes);
            }

            bytes[i] = (byte)(original ^ (1 << (i % 8)));
            Try(type, id, bytes);
            bytes[i] = original;
        }
    }

    [Theory]
    [MemberData(nameof(Samples))]
    [Behaviour("dats.bad-bytes.hostile-count", "design.md")]
    public void A_count_of_FFFFFFFF_allocates_nothing(string name)
    {
        DatRecordType type = TypeOf(name)!.Value;
        uint id = TestData.SampleId(name);
        byte[] bytes = TestData.SampleBytes(name);
        foreach (uint count in new[] { 0xFFFFFFFFu, 0x7FFFFFFFu, 0x10000000u })
        {
            for (int i = 0; i + 4 <= bytes.Length; i++)
            {
                uint original = BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(i));
                BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(i), count);
                Try(type, id, bytes);
                BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(i), original);
            }
        }
    }

    [Fact]
    [Behaviour("dats.bad-bytes.any", "design.md")]
    public void Any_record_with_some_wrong_bytes_is_a_value_or_a_format_error()
        => Gen.Select(RecordGen.Any, Gen.Int[0, int.MaxValue].Array[1, 4], Gen.Byte.Array[4], Gen.Int[0, 3]).Sample(
            (record, places, values, cut) =>
            {
                byte[] bytes = record.Encode();
                for (int i = 0; i < places.Length; i++)
                    bytes[places[i] % bytes.Length] = values[i];
                bytes = cut == 0 ? bytes[..(places[0] % bytes.Length)] : bytes;
                Try(record.Type, record.Id, bytes);
            },
            iter: Fuzz.Cases(3000));

    [Fact]
    [Behaviour("dats.bad-bytes.noise", "design.md")]
    public void Noise_is_a_value_or_a_format_error()
        => Gen.Select(RecordGen.Among(Enum.GetValues<DatRecordType>()), Gen.Byte.Array[0, 300]).Sample(
            (type, bytes) =>
            {
                uint id = bytes.Length >= 4 ? BinaryPrimitives.ReadUInt32LittleEndian(bytes) : 1;
                Try(type, id, bytes);
            },
            iter: Fuzz.Cases(3000));

    [Fact]
    [Behaviour("dats.bsp.deep-chain", "spec/07, 7.2 (iterate or limit depth)")]
    public void A_tree_of_a_hundred_thousand_levels_reads_and_writes()
    {
        const int depth = 100_000;
        var nodes = new BspNode[depth + 1];
        for (int i = 0; i < depth; i++)
            nodes[i] = new BspNode
            {
                Tag = i % 2 == 0 ? BspTag.BPnn : BspTag.BpnN,
                Positive = i % 2 == 0 ? i + 1 : -1,
                Negative = i % 2 == 0 ? -1 : i + 1,
            };
        nodes[depth] = new BspNode();
        var shape = new GfxObj { Id = 0x01000001, Flags = GfxObjFlags.HasDrawing, DrawingTree = new() { Nodes = [.. nodes] } };

        byte[] bytes = shape.Encode();
        var back = DatRecord.Decode<GfxObj>(shape.Id, new ReadOnlySequence<byte>(bytes));

        Assert.Equal(nodes.Length, back.DrawingTree!.Nodes.Length);
        Assert.Equal(bytes, back.Encode());
        Assert.Throws<DatFormatException>(
            () => DatRecord.Decode<GfxObj>(shape.Id, new ReadOnlySequence<byte>(bytes.AsMemory(0, bytes.Length / 2))));
    }

    private static DatRecordType? TypeOf(string sample)
    {
        uint id = TestData.SampleId(sample);
        DatRecordType type = DatIds.RecordTypeOf(id, id >= 0x80000000 ? DatFileKind.Cell : DatFileKind.Portal);
        return DatRecords.Decode(type, id, new ReadOnlySequence<byte>(TestData.SampleBytes(sample))) is RawRecord ? null : type;
    }

    // True for a format error; any other exception fails the test.
    private static bool Try(DatRecordType type, uint id, byte[] bytes)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        try
        {
            DatRecords.Decode(type, id, new ReadOnlySequence<byte>(bytes), FileName);
            return false;
        }
        catch (DatFormatException e)
        {
            Assert.Equal((FileName, id), (e.File, e.RecordId));
            Assert.InRange(e.Offset, 0, bytes.Length);
            return true;
        }
        finally
        {
            Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, MostBytes);
        }
    }
}
