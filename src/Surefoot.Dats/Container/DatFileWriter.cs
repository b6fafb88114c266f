using System.Buffers.Binary;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Writes a whole dat file that the retail client and other readers accept (spec 07, 5.1).
/// The same records give the same bytes.
/// <code>new DatFileWriter(path, DatFileKind.Cell).Add(block).Add(info).Complete();</code></summary>
/// <remarks>Records are kept in memory until <see cref="Complete"/>, which writes beside the path and then renames.</remarks>
public sealed class DatFileWriter
{
    internal const int FirstBlock = 1024;
    internal const int LeastFreeBlocks = 52;
    internal const ushort EntryVersion = 2;
    internal const ushort IterationEntryVersion = 1;
    private const int LinkSize = 4;
    private const int Fanout = DirectoryNode.MaxEntries + 1;

    private readonly string path;
    private readonly DatFileKind kind;
    private readonly DatFileOptions options;
    private readonly SortedDictionary<uint, (byte[] Bytes, ushort Flags)> records = [];

    /// <summary>Prepares a file.</summary>
    /// <param name="path">Where it will be; an existing file is replaced. The client looks for the names in <see cref="DatSet"/>.</param>
    /// <param name="kind">Which of the four files.</param>
    /// <param name="options">What else it says; null for the defaults.</param>
    public DatFileWriter(string path, DatFileKind kind, DatFileOptions? options = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        this.path = path;
        this.kind = kind;
        this.options = options ?? new();
        uint blockSize = this.options.HeaderFor(kind).BlockSize;
        if (blockSize is < BlockReader.LeastBlockSize or > BlockReader.GreatestBlockSize)
            throw new ArgumentException($"A block size of {blockSize} bytes is impossible.", nameof(options));
        if (this.options.FreeBlocks < LeastFreeBlocks)
            throw new ArgumentException($"At least {LeastFreeBlocks} free blocks are needed.", nameof(options));
        if (this.options.Iterations < 1)
            throw new ArgumentException("At least 1 iteration is needed.", nameof(options));
        records.Add(DatIds.Iteration, (IterationRecord.UpTo(this.options.Iterations).Encode(), 0));
    }

    /// <summary>Adds a record.</summary>
    /// <exception cref="ArgumentException">Its id is taken, or belongs to another kind or another file.</exception>
    public DatFileWriter Add(DatRecord record)
    {
        ArgumentNullException.ThrowIfNull(record);
        if (record is not RawRecord && DatIds.RecordTypeOf(record.Id, kind) != record.Type)
            throw new ArgumentException($"0x{record.Id:X8} is not the id of a {record.Type} in a {kind} file.", nameof(record));
        return Add(record.Id, record.Encode());
    }

    /// <summary>Adds a record by its bytes.</summary>
    /// <param name="id">Its id.</param>
    /// <param name="bytes">All its bytes, at least 1.</param>
    /// <param name="compress">Store it as a zlib stream where that is smaller; some readers cannot take that.</param>
    /// <exception cref="ArgumentException">The id is taken, 0 or the iteration record's, or there are no bytes.</exception>
    public DatFileWriter Add(uint id, ReadOnlySpan<byte> bytes, bool compress = false)
    {
        byte[]? packed = compress ? Compression.Pack(bytes) : null;
        return AddStored(id, packed ?? bytes.ToArray(), packed is null ? (ushort)0 : DatEntry.CompressedFlag);
    }

    /// <summary>Adds bytes as they are to be stored, with the flags of their entry.</summary>
    internal DatFileWriter AddStored(uint id, byte[] bytes, ushort flags)
    {
        if (id is 0 or DatIds.Iteration)
            throw new ArgumentException(id == 0 ? "Id 0 means no record." : "The iteration record is written by the writer.", nameof(id));
        if (bytes.Length == 0)
            throw new ArgumentException($"Record 0x{id:X8} is empty; the retail client cannot load that.", nameof(bytes));
        if (!records.TryAdd(id, (bytes, flags)))
            throw new ArgumentException($"Record 0x{id:X8} was added before.", nameof(id));
        return this;
    }

    /// <summary>Writes the file.</summary>
    /// <exception cref="IOException">It cannot be written, or would be larger than 2 GB.</exception>
    public void Complete()
    {
        string temporary = path + ".new";
        try
        {
            using (var stream = new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None, 1 << 16))
                Write(stream);
            File.Move(temporary, path, overwrite: true);
        }
        catch
        {
            File.Delete(temporary);
            throw;
        }
    }

    private void Write(FileStream stream)
    {
        DatHeader header = options.HeaderFor(kind);
        stream.Write(new byte[FirstBlock]);
        var entries = new List<DatEntry>(records.Count);
        foreach (var (id, (bytes, flags)) in records)
        {
            uint offset = WriteChain(stream, bytes, (int)header.BlockSize);
            bool iteration = id == DatIds.Iteration;
            entries.Add(new(
                flags,
                iteration ? IterationEntryVersion : EntryVersion,
                id,
                offset,
                (uint)bytes.Length,
                options.Date,
                iteration ? 0 : (uint)options.Iterations));
        }

        uint root = WriteTree(stream, entries, 0, entries.Count, (int)header.BlockSize);
        uint firstFree = WriteFreeBlocks(stream, header.BlockSize);
        var head = new byte[DatHeader.ByteSize];
        (header with
        {
            FileSize = checked((uint)stream.Position),
            FirstFreeBlock = firstFree,
            LastFreeBlock = (uint)(stream.Position - header.BlockSize),
            FreeBlockCount = (uint)options.FreeBlocks,
            RootNode = root,
        }).Write(head);
        stream.Position = 0;
        stream.Write(head);
    }

    private uint WriteChain(FileStream stream, ReadOnlySpan<byte> bytes, int blockSize)
    {
        uint start = Here(stream, bytes.Length + blockSize);
        Span<byte> link = stackalloc byte[LinkSize];
        int payload = blockSize - LinkSize;
        while (true)
        {
            bool last = bytes.Length <= payload;
            BinaryPrimitives.WriteUInt32LittleEndian(link, last ? 0 : (uint)(stream.Position + blockSize));
            stream.Write(link);
            stream.Write(last ? bytes : bytes[..payload]);
            if (last)
            {
                stream.Write(new byte[payload - bytes.Length]);
                return start;
            }

            bytes = bytes[payload..];
        }
    }

    // Shares entries out evenly so that every node but the root has at least 30 (spec 07, 5.1); children come before their parent.
    private uint WriteTree(FileStream stream, List<DatEntry> entries, int from, int count, int blockSize)
    {
        var node = new DirectoryNode(0);
        long reach = 1;
        while (count > (reach * Fanout) - 1)
            reach *= Fanout;
        if (reach == 1)
        {
            node.Entries.AddRange(entries.GetRange(from, count));
        }
        else
        {
            int children = (int)((count + reach) / reach);
            int share = (count - children + 1) / children, larger = (count - children + 1) % children;
            for (int i = 0; i < children; i++)
            {
                int size = share + (i < larger ? 1 : 0);
                node.Children.Add(WriteTree(stream, entries, from, size, blockSize));
                from += size;
                if (i < children - 1)
                    node.Entries.Add(entries[from++]);
            }
        }

        return WriteChain(stream, node.ToBytes(), blockSize);
    }

    private uint WriteFreeBlocks(FileStream stream, uint blockSize)
    {
        uint first = Here(stream, options.FreeBlocks * (long)blockSize);
        var block = new byte[blockSize];
        for (int i = 0; i < options.FreeBlocks; i++)
        {
            uint next = i == options.FreeBlocks - 1 ? 0 : (uint)(stream.Position + blockSize);
            BinaryPrimitives.WriteUInt32LittleEndian(block, BlockReader.FreeBit | next);
            stream.Write(block);
        }

        return first;
    }

    // Offsets of free blocks share their word with a flag, so blocks have to stay below 2 GB.
    private uint Here(FileStream stream, long wanted)
        => stream.Position + wanted < BlockReader.FreeBit
            ? (uint)stream.Position
            : throw new IOException($"'{path}' would be larger than 2 GB, which links between blocks cannot express.");
}
