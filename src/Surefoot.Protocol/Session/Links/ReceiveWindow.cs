using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace Surefoot.Protocol.Session;

/// <summary>Which packets have arrived, which are missing, and which words of the key stream their checksums may be made with
/// (specification 08, 2.6, 2.4 and 10). Nothing changes for a packet whose checksum is wrong.</summary>
/// <remarks>Retail: SharedNet::ProcessNewSeqNum @0x00544690. Retail ties a word to each missing number; here the words of missing packets
/// are a pool, since a server of the field gives numbers to packets for which it draws no word.</remarks>
internal sealed class ReceiveWindow
{
    // How far ahead a word is looked for when the one that is due does not fit (specification 08, 10).
    private const int SearchedAhead = 256;

    // Words are kept that were looked at: a stranger's numbers must not make them many.
    private const uint FarthestChecked = 4096;

    private readonly KeyWindow keys;
    private readonly uint farthest;
    private readonly int mostMissing;
    private readonly List<uint> missing = [];
    private readonly List<(uint Word, int Index)> pool = [];

    /// <summary>Starts before the first numbered packet, which is number 2.</summary>
    /// <param name="seed">Seed of the sender's key stream.</param>
    /// <param name="farthest">How far ahead of the newest a number may be.</param>
    /// <param name="mostMissing">How many packets may be outstanding.</param>
    public ReceiveWindow(uint seed, uint farthest, int mostMissing)
    {
        keys = new KeyWindow(seed);
        this.farthest = farthest;
        this.mostMissing = mostMissing;
    }

    /// <summary>Number of the newest packet.</summary>
    public uint Newest { get; private set; } = 1;

    /// <summary>Everything up to this number has arrived.</summary>
    public uint InOrder => missing.Count == 0 ? Newest : Before(missing[0]);

    /// <summary>Numbers of packets that have not arrived, oldest first.</summary>
    public ReadOnlySpan<uint> Missing => CollectionsMarshal.AsSpan(missing);

    /// <summary>Words kept for packets that have not arrived.</summary>
    public int KeptWords => pool.Count;

    /// <summary>A number is newer than another one, around the wrap.</summary>
    public static bool IsNewer(uint stored, uint incoming) => (int)(incoming - stored) > 0;

    /// <summary>The number after another one; 0 is nobody's.</summary>
    public static uint After(uint number) => number == uint.MaxValue ? 1 : number + 1;

    /// <summary>Decides about a packet with a number, and takes note of it when it is good.</summary>
    /// <param name="datagram">The packet.</param>
    /// <param name="keyIndex">Which word of the key stream its checksum was made with; −1 for none.</param>
    public DropReason Accept(in Datagram datagram, out int keyIndex)
    {
        keyIndex = -1;
        uint number = datagram.Header.Sequence;
        bool isNew = IsNewer(Newest, number);
        if (isNew)
        {
            if (number - Newest > farthest)
                return DropReason.TooFarAhead;
            if (missing.Count + (number - Newest) > mostMissing)
                return DropReason.TooManyMissing;
        }

        if (!datagram.Header.IsEncrypted)
            return AcceptCleartext(datagram, isNew);
        if (number == 0)
            return DropReason.Unexpected;
        return isNew ? AcceptNew(number, datagram.Key, out keyIndex) : AcceptMissing(number, datagram.Key, out keyIndex);
    }

    /// <summary>A packet that is too new to be accepted is the other side's all the same: its checksum is made with the word that is due
    /// for its number.</summary>
    public bool IsMadeWithDueWord(in Datagram datagram)
    {
        uint number = datagram.Header.Sequence;
        return datagram.Header.IsEncrypted && IsNewer(Newest, number) && Distance(Newest, number) <= FarthestChecked
            && keys.Peek((int)Distance(Newest, number) - 1) == datagram.Key;
    }

    /// <summary>The sender no longer has these packets: they are not waited for any more.</summary>
    /// <param name="numbers">Four bytes each.</param>
    public void Forget(ReadOnlySpan<byte> numbers)
    {
        for (; numbers.Length >= 4; numbers = numbers[4..])
        {
            int index = missing.BinarySearch(BinaryPrimitives.ReadUInt32LittleEndian(numbers), ByAge.Instance);
            if (index < 0)
                continue;

            // With a word for each number the number's own word is known and goes with it.
            if (pool.Count == missing.Count)
                pool.RemoveAt(index);
            missing.RemoveAt(index);
        }
    }

    private DropReason AcceptCleartext(in Datagram datagram, bool isNew)
    {
        if (!datagram.IsIntact)
            return DropReason.Checksum;

        // A packet that refuses to send again has a number of its own but no word; others carry the number of the newest packet
        // before them.
        uint number = datagram.Header.Sequence;
        bool isNumbered = datagram.Has(PacketFlags.RejectRetransmit);
        if (isNew)
        {
            uint last = isNumbered ? Before(number) : number;
            AddMissing(last);
            Newest = number;
        }
        else if (isNumbered && missing.BinarySearch(number, ByAge.Instance) is >= 0 and var index)
        {
            missing.RemoveAt(index);
        }

        return DropReason.None;
    }

    private DropReason AcceptNew(uint number, uint key, out int keyIndex)
    {
        keyIndex = -1;
        int gap = (int)Distance(Newest, number) - 1;
        if (keys.Peek(gap) == key)
        {
            keyIndex = keys.Head + gap;
        }
        else if (FindInPool(key) is >= 0 and var pooled)
        {
            keyIndex = pool[pooled].Index;
            TakeBack(pooled);
            AddNumbers(Before(number));
            Newest = number;
            return DropReason.None;
        }
        else
        {
            for (int offset = 0; offset <= gap + SearchedAhead && keyIndex < 0; offset++)
            {
                if (keys.Peek(offset) == key)
                    keyIndex = keys.Head + offset;
            }

            if (keyIndex < 0)
                return DropReason.Checksum;
        }

        AddNumbers(Before(number));
        Newest = number;
        while (keys.Head < keyIndex)
            AddWord();
        keys.Take();
        return DropReason.None;
    }

    private DropReason AcceptMissing(uint number, uint key, out int keyIndex)
    {
        keyIndex = -1;
        int index = missing.BinarySearch(number, ByAge.Instance);
        if (index < 0)
            return DropReason.Duplicate;
        int pooled = FindInPool(key);
        if (pooled < 0)
            return DropReason.Checksum;
        keyIndex = pool[pooled].Index;
        pool.RemoveAt(pooled);
        missing.RemoveAt(index);
        return DropReason.None;
    }

    /// <summary>A new packet was made with a word that a missing one was thought to have: there are numbers without a word among the
    /// missing ones. The words that were taken after it belong to packets to come.</summary>
    private void TakeBack(int pooled)
    {
        int after = pool.Count - pooled - 1;
        if (keys.Head - pool[pooled].Index - 1 == after)
        {
            Span<uint> words = after <= 256 ? stackalloc uint[after] : new uint[after];
            for (int i = 0; i < after; i++)
                words[i] = pool[pooled + 1 + i].Word;
            keys.GiveBack(words);
            pool.RemoveRange(pooled + 1, after);
        }

        pool.RemoveAt(pooled);
    }

    private void AddMissing(uint last)
    {
        int before = missing.Count;
        AddNumbers(last);
        for (int i = before; i < missing.Count; i++)
            AddWord();
    }

    private void AddNumbers(uint last)
    {
        for (uint number = After(Newest); !IsNewer(last, number); number = After(number))
            missing.Add(number);
    }

    private void AddWord()
    {
        int index = keys.Head;
        pool.Add((keys.Take(), index));
        if (pool.Count > mostMissing)
            pool.RemoveAt(0);
    }

    private int FindInPool(uint key)
    {
        ReadOnlySpan<(uint Word, int Index)> words = CollectionsMarshal.AsSpan(pool);
        for (int i = 0; i < words.Length; i++)
        {
            if (words[i].Word == key)
                return i;
        }

        return -1;
    }

    private static uint Before(uint number) => number == 1 ? uint.MaxValue : number - 1;

    /// <summary>How many numbers a newer one is ahead of another.</summary>
    private static uint Distance(uint from, uint to) => to < from ? to - from - 1 : to - from;

    /// <summary>Orders numbers that lie less than half the range apart.</summary>
    private sealed class ByAge : IComparer<uint>
    {
        public static ByAge Instance { get; } = new();

        public int Compare(uint x, uint y) => ((int)(x - y)).CompareTo(0);
    }
}
