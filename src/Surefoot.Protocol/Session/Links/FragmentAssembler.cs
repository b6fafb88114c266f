using System.Buffers;

namespace Surefoot.Protocol.Session;

/// <summary>Puts messages together whose fragments arrive in any order (specification 08, 2.5). Its memory is bounded: the unfinished
/// message that was begun first goes when there are too many.</summary>
internal sealed class FragmentAssembler
{
    /// <summary>Longest message.</summary>
    public const int MostLength = 1 << 16;

    /// <summary>Most unfinished messages.</summary>
    public const int MostUnfinished = 256;

    /// <summary>Most bytes of all unfinished messages.</summary>
    public const int MostBytes = 1 << 22;

    private const int MostFragments = MostLength / FragmentHeader.MostData;

    private readonly Dictionary<ulong, Unfinished> unfinished = [];
    private byte[]? finished;
    private long begun;

    /// <summary>Messages of which fragments are still missing.</summary>
    public int Count => unfinished.Count;

    /// <summary>Bytes of memory that they hold.</summary>
    public int HeldBytes { get; private set; }

    /// <summary>Unfinished messages that had to go.</summary>
    public long Evicted { get; private set; }

    /// <summary>Takes a fragment.</summary>
    /// <param name="header">Its header, which is valid.</param>
    /// <param name="data">Its part of the message.</param>
    /// <param name="message">The whole message when it is complete, until the next call; else empty.</param>
    /// <returns>Why the fragment was not used.</returns>
    public DropReason Add(FragmentHeader header, ReadOnlySpan<byte> data, out ReadOnlySpan<byte> message)
    {
        Release();
        message = [];
        bool isLast = header.Index == header.Count - 1;
        if (header.Count > MostFragments || (isLast ? data.IsEmpty : data.Length != FragmentHeader.MostData))
            return DropReason.BadMessage;
        if (header.Count == 1)
        {
            message = data;
            return DropReason.None;
        }

        ulong id = ((ulong)header.Id << 32) | header.Sequence;
        if (!unfinished.TryGetValue(id, out Unfinished? parts))
        {
            parts = new Unfinished(header.Count, begun++);
            MakeRoom(parts.Buffer.Length);
            unfinished.Add(id, parts);
            HeldBytes += parts.Buffer.Length;
        }

        if (parts.Count != header.Count)
            return DropReason.BadMessage;
        if (!parts.TryAdd(header.Index, data, isLast))
            return DropReason.Duplicate;
        if (!parts.IsComplete)
            return DropReason.None;

        Forget(id, parts);
        finished = parts.Buffer;
        message = parts.Buffer.AsSpan(0, parts.Length);
        return DropReason.None;
    }

    private void MakeRoom(int bytes)
    {
        while (unfinished.Count > 0 && (unfinished.Count >= MostUnfinished || HeldBytes + bytes > MostBytes))
        {
            KeyValuePair<ulong, Unfinished> oldest = unfinished.MinBy(entry => entry.Value.Serial);
            Forget(oldest.Key, oldest.Value);
            ArrayPool<byte>.Shared.Return(oldest.Value.Buffer);
            Evicted++;
        }
    }

    private void Forget(ulong id, Unfinished parts)
    {
        unfinished.Remove(id);
        HeldBytes -= parts.Buffer.Length;
    }

    private void Release()
    {
        if (finished is not null)
            ArrayPool<byte>.Shared.Return(finished);
        finished = null;
    }

    private sealed class Unfinished(int count, long serial)
    {
        private readonly bool[] arrived = new bool[count];
        private int left = count;

        public int Count => arrived.Length;

        public long Serial => serial;

        public byte[] Buffer { get; } = ArrayPool<byte>.Shared.Rent(count * FragmentHeader.MostData);

        public int Length { get; private set; } = (count - 1) * FragmentHeader.MostData;

        public bool IsComplete => left == 0;

        public bool TryAdd(int index, ReadOnlySpan<byte> data, bool isLast)
        {
            if (arrived[index])
                return false;
            arrived[index] = true;
            left--;
            data.CopyTo(Buffer.AsSpan(index * FragmentHeader.MostData));
            if (isLast)
                Length += data.Length;
            return true;
        }
    }
}
