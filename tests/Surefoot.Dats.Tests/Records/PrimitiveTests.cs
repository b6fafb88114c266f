using System.Buffers;
using System.Numerics;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Encodings of single values.</summary>
public sealed class PrimitiveTests
{
    [Theory]
    [InlineData(0x7Fu, "7F")]
    [InlineData(0x80u, "8080")]
    [InlineData(0x3FFFu, "BFFF")]
    [InlineData(0x4000u, "C0000040")]
    [InlineData(0x12345678u, "D2347856")]
    [InlineData(0u, "00")]
    [InlineData(0x3FFFFFFFu, "FFFFFFFF")]
    [Behaviour("dats.primitive.cuint", "spec/07, 10.1")]
    public void A_cuint_has_1_2_or_4_bytes(uint value, string bytes)
    {
        Assert.Equal(bytes, Write(w => w.WriteCompressedUInt32(value)));
        Assert.Equal(value, Reader(bytes).ReadCompressedUInt32());
    }

    [Fact]
    public void A_cuint_above_its_range_cannot_be_written()
        => Assert.Throws<ArgumentOutOfRangeException>(() => new DatWriter().WriteCompressedUInt32(0x40000000));

    [Theory]
    [InlineData(0x01000123u, "2301")]
    [InlineData(0x01003FFFu, "FF3F")]
    [InlineData(0x01004000u, "00800040")]
    [InlineData(0x01005678u, "00807856")]
    [InlineData(0x01000000u, "0000")]
    [Behaviour("dats.primitive.known-type-id", "spec/07, 10.1")]
    public void A_known_type_id_has_2_or_4_bytes(uint id, string bytes)
    {
        Assert.Equal(bytes, Write(w => w.WriteKnownTypeId(id, 0x01000000)));
        Assert.Equal(id, Reader(bytes).ReadKnownTypeId(0x01000000));
    }

    [Fact]
    [Behaviour("dats.primitive.known-type-id-none", "spec/07, section 2")]
    public void No_id_comes_back_as_the_base() => Assert.Equal("0000", Write(w => w.WriteKnownTypeId(0, 0x01000000)));

    [Theory]
    [InlineData("Dereth", "0600446572657468")]
    [InlineData("Sunny", "050053756E6E7900")]
    [InlineData("", "00000000")]
    [InlineData("€œ", "0200809C")]
    [Behaviour("dats.primitive.pstring", "spec/07, 10.1")]
    public void A_pstring_is_counted_and_aligned(string text, string bytes)
    {
        Assert.Equal(bytes, Write(w => w.WritePString(text)));
        var reader = Reader(bytes);
        Assert.Equal(text, reader.ReadPString());
        Assert.Equal(0, reader.Remaining);
    }

    [Theory]
    [InlineData(0xFFFE, 2)]
    [InlineData(0xFFFF, 6)]
    [InlineData(0x10001, 6)]
    [Behaviour("dats.primitive.pstring-long", "spec/07, section 2")]
    public void A_long_pstring_has_a_long_count(int length, int head)
    {
        string text = new('x', length);
        var writer = new DatWriter();
        writer.WritePString(text);
        Assert.Equal((head + length + 3) / 4 * 4, writer.Position);
        Assert.Equal(text, new DatReader(new ReadOnlySequence<byte>(writer.ToArray()), 0).ReadPString());
    }

    [Fact]
    [Behaviour("dats.primitive.pstring-keeps-any-byte", "spec/07, section 2 (Windows-1252)")]
    public void Every_byte_of_a_text_survives()
    {
        byte[] bytes = [0x00, 0x01, .. Enumerable.Range(0, 256).Select(i => (byte)i), 0, 0];
        string text = new DatReader(new ReadOnlySequence<byte>(bytes), 0).ReadPString();
        Assert.Equal(256, text.Distinct().Count());
        Assert.Equal(Convert.ToHexString(bytes), Write(w => w.WritePString(text)));
    }

    [Fact]
    public void A_text_outside_the_code_page_cannot_be_written()
        => Assert.Throws<ArgumentException>(() => new DatWriter().WritePString("日本"));

    [Fact]
    [Behaviour("dats.primitive.quaternion-order", "spec/07, section 2")]
    public void A_rotation_is_stored_w_first()
        => Assert.Equal("0000803F000000400000404000008040", Write(w => w.WriteQuaternion(new(2, 3, 4, 1))));

    [Fact]
    [Behaviour("dats.primitive.colour-order", "spec/07, section 2")]
    public void A_colour_is_stored_blue_first() => Assert.Equal("01020304", Write(w => w.WriteColor(new(3, 2, 1, 4))));

    [Theory]
    [InlineData(1f, 0f, 0)]
    [InlineData(1.0004f, 0f, 0)]
    [InlineData(1.001f, 0f, 1)]
    [InlineData(0.999f, 0f, 1)]
    [InlineData(0f, 0f, 1)]
    [Behaviour("dats.primitive.frame-norm", "spec/07, section 2 (Frame::IsValid @0x00534ED0)")]
    public void A_rotation_off_length_1_is_remarked_upon(float w, float x, int remarks)
    {
        var writer = new DatWriter();
        writer.WriteFrame(new(Vector3.One, new(x, 0, 0, w)));
        var found = new List<DatRemark>();
        var reader = new DatReader(new ReadOnlySequence<byte>(writer.ToArray()), 1, "", found);
        Assert.Equal(new DatFrame(Vector3.One, new(x, 0, 0, w)), reader.ReadFrame());
        Assert.Equal(remarks, found.Count);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [InlineData(6)]
    [Behaviour("dats.primitive.frame-nan", "spec/07, section 2")]
    public void A_frame_with_NaN_is_refused(int index)
    {
        var writer = new DatWriter();
        for (int i = 0; i < 7; i++)
            writer.WriteSingle(i == index ? float.NaN : 0.5f);
        var error = Assert.Throws<DatFormatException>(
            () => new DatReader(new ReadOnlySequence<byte>(writer.ToArray()), 0x02000001, "x.dat").ReadFrame());
        Assert.Equal(("x.dat", 0x02000001u, 0L), (error.File, error.RecordId, error.Offset));
    }

    [Fact]
    [Behaviour("dats.primitive.floats-keep-their-bits", "design.md")]
    public void Every_float_keeps_its_bits()
        => Gen.UInt.Sample(bits =>
        {
            var writer = new DatWriter();
            writer.WriteSingle(BitConverter.UInt32BitsToSingle(bits));
            writer.WriteSingle(new DatReader(new ReadOnlySequence<byte>(writer.ToArray()), 0).ReadSingle());
            Assert.Equal(writer.WrittenSpan[..4], writer.WrittenSpan[4..]);
        });

    [Fact]
    [Behaviour("dats.primitive.cuint-round-trip", "spec/07, section 2")]
    public void Every_cuint_round_trips()
        => Gen.UInt[0, 0x3FFFFFFF].Sample(value =>
        {
            var writer = new DatWriter();
            writer.WriteCompressedUInt32(value);
            return new DatReader(new ReadOnlySequence<byte>(writer.ToArray()), 0).ReadCompressedUInt32() == value;
        });

    [Fact]
    [Behaviour("dats.primitive.frame-is-normalised-in-double", "spec/07, section 2")]
    public void A_frame_for_writing_is_normalised_in_double()
    {
        DatFrame frame = DatFrame.Create(Vector3.One, new(0, 0, 3, 4));
        Assert.Equal(new DatFrame(Vector3.One, new(0, 0, 0.6f, 0.8f)), frame);
    }

    private static string Write(Action<DatWriter> write)
    {
        var writer = new DatWriter();
        write(writer);
        return Convert.ToHexString(writer.WrittenSpan);
    }

    private static DatReader Reader(string hex) => new(new ReadOnlySequence<byte>(Convert.FromHexString(hex)), 0);
}
