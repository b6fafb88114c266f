using System.Buffers.Binary;

namespace Surefoot.Dats;

/// <summary>The first 400 bytes of a dat file (spec 07, 4.1).</summary>
public sealed record DatHeader
{
    internal const int ByteSize = 0x190;
    internal const uint HighResSubset = 0x69466948;
    private const uint Magic = 0x5442;
    private const int TransactionOffset = 0x100;
    private const int MagicOffset = 0x140;
    private const int GuidOffset = 0x17C;

    /// <summary>Block size in bytes, the 4-byte link included.</summary>
    public required uint BlockSize { get; init; }

    /// <summary>File size in bytes, as stored.</summary>
    public uint FileSize { get; init; }

    /// <summary>1 portal and high resolution, 2 cell, 3 local.</summary>
    public required uint FileType { get; init; }

    /// <summary>Tells files of one type apart; the region number of a cell file.</summary>
    public uint Subset { get; init; }

    /// <summary>Offset of the first free block.</summary>
    public uint FirstFreeBlock { get; init; }

    /// <summary>Offset of the last free block.</summary>
    public uint LastFreeBlock { get; init; }

    /// <summary>Number of free blocks.</summary>
    public uint FreeBlockCount { get; init; }

    /// <summary>Offset of the directory's root node; 0 for an empty directory in files that retail refuses.</summary>
    public uint RootNode { get; init; }

    /// <summary>Unused by this client.</summary>
    public uint MasterMapId { get; init; }

    /// <summary>110 in portal files, 22 in cell files.</summary>
    public uint EngineVersion { get; init; }

    /// <summary>0; the client refuses others.</summary>
    public uint GameVersion { get; init; }

    /// <summary>Identifies the version of the files.</summary>
    public Guid VersionGuid { get; init; }

    /// <summary>Counts versions.</summary>
    public uint MinorVersion { get; init; }

    /// <summary>Type byte of the transaction record: non-zero when a write was interrupted (spec 07, 4.6).</summary>
    public byte Transaction { get; init; }

    /// <summary>Which of the four files this is.</summary>
    public DatFileKind Kind => FileType switch
    {
        2 => DatFileKind.Cell,
        3 => DatFileKind.Local,
        _ => Subset == HighResSubset ? DatFileKind.HighRes : DatFileKind.Portal,
    };

    internal static DatHeader Read(ReadOnlySpan<byte> bytes, long fileLength, string file)
    {
        if (bytes.Length < ByteSize)
            throw new DatFormatException(file, null, 0, $"the header of a dat file has {ByteSize} bytes, this file {fileLength}");
        uint magic = At(bytes, MagicOffset), blockSize = At(bytes, 0x144), type = At(bytes, 0x14C), root = At(bytes, 0x160);
        if (magic != Magic)
            throw new DatFormatException(file, null, MagicOffset, $"this is no dat file: the magic is 0x{magic:X} instead of 0x{Magic:X}");
        if (blockSize is < BlockReader.LeastBlockSize or > BlockReader.GreatestBlockSize)
            throw new DatFormatException(file, null, 0x144, $"a block size of {blockSize} bytes is impossible");
        if (type is < 1 or > 3)
            throw new DatFormatException(file, null, 0x14C, $"file type {type}; 1, 2 and 3 are known");
        if (root != 0 && (root < ByteSize || root >= fileLength))
            throw new DatFormatException(file, null, 0x160, $"the root of the directory, 0x{root:X}, lies outside the file");
        return new()
        {
            BlockSize = blockSize,
            FileSize = At(bytes, 0x148),
            FileType = type,
            Subset = At(bytes, 0x150),
            FirstFreeBlock = At(bytes, 0x154),
            LastFreeBlock = At(bytes, 0x158),
            FreeBlockCount = At(bytes, 0x15C),
            RootNode = root,
            MasterMapId = At(bytes, 0x170),
            EngineVersion = At(bytes, 0x174),
            GameVersion = At(bytes, 0x178),
            VersionGuid = new Guid(bytes.Slice(GuidOffset, 16)),
            MinorVersion = At(bytes, 0x18C),
            Transaction = bytes[TransactionOffset],
        };
    }

    /// <summary>The whole header of a file at rest: no version text, idle transaction record, no LRU list.</summary>
    internal void Write(Span<byte> bytes)
    {
        bytes[..ByteSize].Clear();
        bytes[0x101] = 0x50;
        bytes[0x102] = 0x4C;
        Put(bytes, MagicOffset, Magic);
        Put(bytes, 0x144, BlockSize);
        Put(bytes, 0x148, FileSize);
        Put(bytes, 0x14C, FileType);
        Put(bytes, 0x150, Subset);
        Put(bytes, 0x154, FirstFreeBlock);
        Put(bytes, 0x158, LastFreeBlock);
        Put(bytes, 0x15C, FreeBlockCount);
        Put(bytes, 0x160, RootNode);
        Put(bytes, 0x170, MasterMapId);
        Put(bytes, 0x174, EngineVersion);
        Put(bytes, 0x178, GameVersion);
        VersionGuid.TryWriteBytes(bytes[GuidOffset..]);
        Put(bytes, 0x18C, MinorVersion);
    }

    private static uint At(ReadOnlySpan<byte> bytes, int offset) => BinaryPrimitives.ReadUInt32LittleEndian(bytes[offset..]);

    private static void Put(Span<byte> bytes, int offset, uint value) => BinaryPrimitives.WriteUInt32LittleEndian(bytes[offset..], value);
}
