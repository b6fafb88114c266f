using System.Buffers;

namespace Surefoot.Dats.Tests;

/// <summary>Bytes as a chain of short segments.</summary>
internal sealed class Pieces : ReadOnlySequenceSegment<byte>
{
    public static ReadOnlySequence<byte> Of(byte[] bytes, int length)
    {
        Pieces first = new() { Memory = bytes.AsMemory(0, Math.Min(length, bytes.Length)) }, last = first;
        for (int i = last.Memory.Length; i < bytes.Length; i += last.Memory.Length)
        {
            var next = new Pieces { Memory = bytes.AsMemory(i, Math.Min(length, bytes.Length - i)), RunningIndex = i };
            last.Next = next;
            last = next;
        }

        return new ReadOnlySequence<byte>(first, 0, last, last.Memory.Length);
    }
}
