using System.Buffers;

namespace Surefoot.Dats;

/// <summary>One dat file, opened for reading. Opening maps the file and reads its directory; records are read when asked for.</summary>
/// <remarks>Safe to use from several threads. Bytes that were handed out die with <see cref="Dispose"/>: dispose only when nothing reads.
/// Retail: DiskController::InitFile @0x00671430, BTree::LoadTree @0x00672150.</remarks>
public sealed class DatFile : IDatSource, ITypedDatSource, IDisposable
{
    private readonly MappedFile map;
    private readonly BlockReader blocks;
    private readonly DatEntry[] entries;
    private readonly uint[] ids;

    private DatFile(string path, MappedFile map)
    {
        Path = path;
        this.map = map;
        Header = DatHeader.Read(map.Slice(0, (int)Math.Min(map.Length, DatHeader.ByteSize)).Span, map.Length, path);
        blocks = new BlockReader(map, (int)Header.BlockSize, path);
        (entries, Damage) = new DirectoryReader(blocks, map.Length).ReadAll(Header.RootNode);
        ids = Array.ConvertAll(entries, static entry => entry.Id);
        Remarks = FindRemarks();
    }

    /// <summary>The path it was opened with.</summary>
    public string Path { get; }

    /// <summary>Its header.</summary>
    public DatHeader Header { get; }

    /// <summary>Which of the four files it is.</summary>
    public DatFileKind Kind => Header.Kind;

    /// <summary>Its directory, ascending by id.</summary>
    public IReadOnlyList<DatEntry> Entries => entries;

    /// <summary>The ids of its records, ascending.</summary>
    public IReadOnlyList<uint> Ids => ids;

    /// <summary>Subtrees of the directory that could not be read or are out of order, with the offset of the node. Their records are
    /// missing from <see cref="Entries"/>. Empty in a sound file (spec 07, 5.4).</summary>
    public IReadOnlyList<DatRemark> Damage { get; }

    /// <summary>What is odd but harmless: an interrupted write, a wrong file size, no iteration record.</summary>
    public IReadOnlyList<DatRemark> Remarks { get; }

    /// <summary>Blocks looked at since opening.</summary>
    internal long BlocksRead => blocks.BlocksRead;

    /// <summary>Opens a file.</summary>
    /// <exception cref="DatFormatException">It is no dat file.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static DatFile Open(string path)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        var map = new MappedFile(path);
        try
        {
            return new DatFile(path, map);
        }
        catch
        {
            map.Dispose();
            throw;
        }
    }

    /// <summary>The ids of one kind, ascending.</summary>
    public IEnumerable<uint> IdsOf(DatRecordType type) => ids.Where(id => DatIds.RecordTypeOf(id, Kind) == type);

    /// <summary>Finds a line of the directory.</summary>
    public bool TryGetEntry(uint id, out DatEntry entry)
    {
        int index = Array.BinarySearch(ids, id);

        // Id 0 is never found (spec 07, 5.3).
        bool found = index >= 0 && id != 0;
        entry = found ? entries[index] : default;
        return found;
    }

    /// <inheritdoc/>
    public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
    {
        if (!TryGetEntry(id, out DatEntry entry))
        {
            bytes = default;
            return false;
        }

        bytes = ReadStored(entry);
        if (entry.IsCompressed)
            bytes = Compression.Unpack(bytes, id, Path);
        return true;
    }

    /// <summary>The bytes as they are stored: those of a compressed record stay packed.</summary>
    /// <exception cref="DatFormatException">The blocks cannot be followed.</exception>
    public ReadOnlySequence<byte> ReadStored(in DatEntry entry) => blocks.Read(entry.Offset, entry.Size, entry.Id);

    /// <inheritdoc/>
    public void Dispose() => map.Dispose();

    bool ITypedDatSource.TryRead(uint id, DatRecordType type, out ReadOnlySequence<byte> bytes, out string file)
    {
        file = Path;
        if (DatIds.RecordTypeOf(id, Kind) == type)
            return TryRead(id, out bytes);
        bytes = default;
        return false;
    }

    /// <summary>A node of the directory, for tests of its shape.</summary>
    internal DirectoryNode ReadNode(uint offset)
        => new DirectoryReader(blocks, map.Length).ReadNode(offset, out string problem)
            ?? throw new DatFormatException(Path, null, offset, problem);

    private List<DatRemark> FindRemarks()
    {
        var remarks = new List<DatRemark>();
        if (Header.Transaction != 0)
            remarks.Add(new(null, 0x100, $"the file was left in the middle of a write (transaction type {Header.Transaction})"));
        if (Header.FileSize != map.Length)
            remarks.Add(new(null, 0x148, $"the header says {Header.FileSize} bytes, the file has {map.Length}"));
        if (!TryGetEntry(DatIds.Iteration, out DatEntry iteration))
            remarks.Add(new(DatIds.Iteration, 0, "there is no iteration record; the retail client cannot log in with this file"));
        else if (iteration.Version != DatFileWriter.IterationEntryVersion)
            remarks.Add(new(DatIds.Iteration, 0, $"the iteration record has entry version {iteration.Version}; the retail client needs 1"));
        return remarks;
    }
}
