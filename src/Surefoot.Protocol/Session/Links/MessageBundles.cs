using System.Buffers;
using System.Buffers.Binary;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>Messages that wait to be sent, a bundle for each group: groups leave in the order of their numbers, whatever was queued first
/// (specification 08, 8.4).</summary>
internal sealed class MessageBundles
{
    private const int Groups = 12, LengthSize = 4, MostBytes = 1 << 20;

    private readonly ArrayBufferWriter<byte>[] bundles = [.. Enumerable.Range(0, Groups).Select(_ => new ArrayBufferWriter<byte>())];
    private int bytes;

    /// <summary>Queues a message.</summary>
    /// <returns>False when there is no room for it.</returns>
    public bool Add(ReadOnlySpan<byte> message, MessageGroup group)
    {
        if ((int)group >= Groups || bytes + LengthSize + message.Length > MostBytes)
            return false;
        ArrayBufferWriter<byte> bundle = bundles[(int)group];
        BinaryPrimitives.WriteInt32LittleEndian(bundle.GetSpan(LengthSize), message.Length);
        bundle.Advance(LengthSize);
        bundle.Write(message);
        bytes += LengthSize + message.Length;
        return true;
    }

    /// <summary>Puts all messages into packets.</summary>
    /// <param name="channel">Where to.</param>
    /// <param name="sequence">Number of the next message.</param>
    /// <param name="id">High half of the messages' ids.</param>
    /// <param name="now">The time.</param>
    public void MoveTo(PacketChannel channel, ref uint sequence, uint id, double now)
    {
        for (int group = 0; group < Groups && bytes > 0; group++)
        {
            ReadOnlySpan<byte> rest = bundles[group].WrittenSpan;
            while (!rest.IsEmpty)
            {
                int length = BinaryPrimitives.ReadInt32LittleEndian(rest);
                channel.Append(rest.Slice(LengthSize, length), sequence++, id, (MessageGroup)group, now);
                rest = rest[(LengthSize + length)..];
                bytes -= LengthSize + length;
            }

            bundles[group].ResetWrittenCount();
        }
    }
}
