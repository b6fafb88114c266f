using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Session;

public class SumAndKeyTests
{
    [Theory]
    [InlineData("", 0u)]
    [InlineData("01", 0x01010000u)]
    [InlineData("0102", 0x01040000u)]
    [InlineData("010203", 0x01050300u)]
    [InlineData("01020304", 0x04070201u)]
    [InlineData("0102030405", 0x09080201u)]
    [Behaviour("protocol.packets.sum", "08, 2.3 and 11")]
    public void The_sum_of_a_few_bytes_is_that_of_the_examples(string bytes, uint sum)
        => Assert.Equal(sum, Hash32.Of(Convert.FromHexString(bytes)));

    [Fact, Behaviour("protocol.packets.key-stream", "08, 2.4")]
    public void The_key_stream_begins_as_the_specification_prints_it()
    {
        uint[] expected =
        [
            0xFDD4AFEB, 0x398311D2, 0xC71829A4, 0xB19DF96A, 0x7ED4A1E7, 0xB718A446, 0x5FA77DF1, 0x5CB793D2,
            0x52C95BAC, 0xA8F8FD7E, 0x18582C04, 0xD257F506, 0x4D11A3F0, 0x919DE7A7, 0x1D809C6B, 0xE97F65F8,
        ];
        var keys = new KeyStream(0x12345678);
        Assert.Equal(expected, expected.Select(_ => keys.Next()));
    }

    [Fact, Behaviour("protocol.packets.key-stream-scrambles-again", "08, 2.4")]
    public void The_key_stream_goes_on_over_its_first_256_words()
    {
        uint[] expected = [0xD92733AF, 0xDF7CA7E9, 0xA608787A, 0x2271E865, 0xF43B889E, 0x28278E9B];
        var keys = new KeyStream(0x12345678);
        for (int i = 0; i < 254; i++)
            keys.Next();
        Assert.Equal(expected, expected.Select(_ => keys.Next()));
    }

    [Fact, Behaviour("protocol.packets.key-stream-of-seed-zero", "08, 2.4")]
    public void Seed_zero_is_a_seed_like_others()
    {
        uint[] expected = [0x182600F3, 0x300B4A8D, 0x301B6622, 0xB08ACD21];
        var keys = new KeyStream(0);
        Assert.Equal(expected, expected.Select(_ => keys.Next()));
    }
}
