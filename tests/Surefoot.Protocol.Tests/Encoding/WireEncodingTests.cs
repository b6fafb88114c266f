using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Encoding;

public class WireEncodingTests
{
    [Theory]
    [InlineData(0x1234u, "3412")]
    [InlineData(0x7FFFu, "FF7F")]
    [InlineData(0x8000u, "00800080")]
    [InlineData(0x12345u, "01804523")]
    [Behaviour("protocol.encoding.packed-number", "08, 3 and 11")]
    public void Packed_numbers_take_two_or_four_bytes(uint value, string bytes)
    {
        var writer = new WireWriter(new byte[8]);
        writer.WritePackedUInt32(value);
        Assert.Equal(bytes, Hex.Of(writer.Written));
        var reader = new WireReader(Convert.FromHexString(bytes));
        Assert.Equal(value, reader.ReadPackedUInt32());
    }

    [Theory]
    [InlineData("", "00000000")]
    [InlineData("ab", "02006162")]
    [InlineData("abc", "0300616263000000")]
    [Behaviour("protocol.encoding.text", "08, 3 and 11")]
    public void Texts_are_counted_and_padded(string text, string bytes)
    {
        var writer = new WireWriter(new byte[8]);
        writer.WriteString16(text);
        Assert.Equal(bytes, Hex.Of(writer.Written));
        var reader = new WireReader(Convert.FromHexString(bytes));
        Assert.Equal(text, reader.ReadString16());
        Assert.Equal(0, reader.Remaining);
    }

    [Fact, Behaviour("protocol.encoding.text-is-windows-1252", "08, 3")]
    public void Every_byte_of_a_text_survives()
    {
        byte[] bytes = [.. Enumerable.Range(0, 256).Select(i => (byte)i)];
        string text = WireText.CodePage.GetString(bytes);
        Assert.Equal("€‚„", $"{text[0x80]}{text[0x82]}{text[0x84]}");
        Assert.Equal(Hex.Of(bytes), Hex.Of(WireText.CodePage.GetBytes(text)));
    }

    [Fact, Behaviour("protocol.encoding.text-unknown-character", "08, 3")]
    public void A_character_that_the_code_page_lacks_becomes_a_question_mark()
    {
        var writer = new WireWriter(new byte[8]);
        writer.WriteString16("aЖ");
        Assert.Equal("0200613F", Hex.Of(writer.Written));
    }

    [Fact, Behaviour("protocol.encoding.reader-never-throws", "design.md, 7")]
    public void After_the_end_everything_reads_as_zero_and_the_first_fault_stays()
    {
        var reader = new WireReader([1, 2, 3]);
        Assert.Equal(0u, reader.ReadUInt32());
        Assert.Equal(WireFault.Truncated, reader.Fault);
        reader.Fail(WireFault.BadValue);
        Assert.Equal(0, reader.ReadByte());
        Assert.Equal("", reader.ReadString16());
        Assert.Equal(WireFault.Truncated, reader.Fault);
    }

    [Fact, Behaviour("protocol.encoding.counts-are-checked", "design.md, 7")]
    public void A_count_that_the_bytes_cannot_hold_allocates_nothing()
    {
        var reader = new WireReader([0xFF, 0xFF, 0xFF, 0x7F, 0, 0, 0, 0]);
        long before = GC.GetAllocatedBytesForCurrentThread();
        ValueList<uint> list = reader.ReadList(4, static (ref r) => r.ReadUInt32());
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        Assert.Empty(list);
        Assert.Equal(WireFault.CountTooLarge, reader.Fault);
        Assert.True(allocated < 1024, $"{allocated} bytes");
    }

    [Fact, Behaviour("protocol.encoding.writer-never-throws", "design.md, 7")]
    public void What_does_not_fit_fails_and_writes_nothing_more()
    {
        var writer = new WireWriter(new byte[6]);
        writer.WriteUInt32(1);
        writer.WriteUInt32(2);
        writer.WriteByte(3);
        Assert.True(writer.Failed);
        Assert.Equal("01000000", Hex.Of(writer.Written));
    }
}
