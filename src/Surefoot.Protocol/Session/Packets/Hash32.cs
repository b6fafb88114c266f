using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace Surefoot.Protocol.Session;

/// <summary>The sum that packets are protected with (specification 08, 2.3).</summary>
internal static class Hash32
{
    /// <summary>Length × 65536, plus every whole little-endian number, plus the up to three bytes behind them as highest bytes.</summary>
    public static uint Of(ReadOnlySpan<byte> bytes)
    {
        uint sum = (uint)bytes.Length << 16;
        int whole = bytes.Length & ~3;
        if (BitConverter.IsLittleEndian)
        {
            foreach (uint word in MemoryMarshal.Cast<byte, uint>(bytes[..whole]))
                sum += word;
        }
        else
        {
            for (int i = 0; i < whole; i += 4)
                sum += BinaryPrimitives.ReadUInt32LittleEndian(bytes[i..]);
        }

        for (int i = whole, shift = 24; i < bytes.Length; i++, shift -= 8)
            sum += (uint)bytes[i] << shift;
        return sum;
    }
}
