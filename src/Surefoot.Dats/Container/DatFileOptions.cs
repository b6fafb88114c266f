namespace Surefoot.Dats;

/// <summary>What a written file says besides its records. The defaults are those of the shipped files (spec 07, 4.1).</summary>
public sealed record DatFileOptions
{
    /// <summary>Block size in bytes, the link included; 0 for the kind's own (256 for cells, 1024 otherwise).</summary>
    public int BlockSize { get; init; }

    /// <summary>Subset; null for the kind's own (a cell file's is its region number, 1).</summary>
    public uint? Subset { get; init; }

    /// <summary>Engine pack version; null for the kind's own (22 for cells, 110 otherwise).</summary>
    public uint? EngineVersion { get; init; }

    /// <summary>Minor version.</summary>
    public uint MinorVersion { get; init; } = 1;

    /// <summary>Identifies the version of the files.</summary>
    public Guid VersionGuid { get; init; }

    /// <summary>Date of every entry; Unix seconds.</summary>
    public uint Date { get; init; }

    /// <summary>Number of updates that the file claims to contain, at least 1.</summary>
    public int Iterations { get; init; } = 1;

    /// <summary>Free blocks at the end, at least 52, so that the retail client can go on writing.</summary>
    public int FreeBlocks { get; init; } = 60;

    internal DatHeader HeaderFor(DatFileKind kind) => new()
    {
        BlockSize = BlockSize != 0 ? (uint)BlockSize : kind == DatFileKind.Cell ? 256u : 1024u,
        FileType = kind switch { DatFileKind.Cell => 2u, DatFileKind.Local => 3u, _ => 1u },
        Subset = Subset ?? kind switch { DatFileKind.Portal => 0u, DatFileKind.HighRes => DatHeader.HighResSubset, _ => 1u },
        EngineVersion = EngineVersion ?? (kind == DatFileKind.Cell ? 22u : 110u),
        MinorVersion = MinorVersion,
        VersionGuid = VersionGuid,
    };
}
