using System.Buffers;

namespace Surefoot.Dats;

/// <summary>A folder of dat files as one source: portal and cell, local and high resolution where they are there.</summary>
/// <remarks>An id of the portal file may equal a cell id (0x01000100 is a GfxObj and a cell of block 0100). The typed
/// <see cref="DatSourceExtensions.Read{T}"/> tells them apart; by id alone the portal file comes first.</remarks>
public sealed class DatSet : IDatSource, ITypedDatSource, IDisposable
{
    /// <summary>Name of the portal file.</summary>
    public const string PortalName = "client_portal.dat";

    /// <summary>Name of the cell file of region 1.</summary>
    public const string CellName = "client_cell_1.dat";

    /// <summary>Name of the English local file.</summary>
    public const string LocalName = "client_local_English.dat";

    /// <summary>Name of the file of large textures.</summary>
    public const string HighResName = "client_highres.dat";

    private DatSet(string folder, DatFile portal, DatFile cell, DatFile? local, DatFile? highRes)
    {
        Folder = folder;
        Portal = portal;
        Cell = cell;
        Local = local;
        HighRes = highRes;
        Files = [.. new[] { portal, cell, local, highRes }.OfType<DatFile>()];
    }

    /// <summary>The folder.</summary>
    public string Folder { get; }

    /// <summary>Shared records.</summary>
    public DatFile Portal { get; }

    /// <summary>Land blocks and cells.</summary>
    public DatFile Cell { get; }

    /// <summary>Texts; null where the file is missing.</summary>
    public DatFile? Local { get; }

    /// <summary>Large textures; null where the file is missing.</summary>
    public DatFile? HighRes { get; }

    /// <summary>The files that are there.</summary>
    public IReadOnlyList<DatFile> Files { get; }

    /// <summary>Opens a folder. Names are matched without regard to case.</summary>
    /// <exception cref="DatFolderException">The folder or one of the two needed files is missing; the message says which.</exception>
    /// <exception cref="DatFormatException">A file is no dat file, or another kind than its name says.</exception>
    public static DatSet Open(string folder)
    {
        ArgumentException.ThrowIfNullOrEmpty(folder);
        if (!Directory.Exists(folder))
        {
            bool isFile = File.Exists(folder);
            throw new DatFolderException(folder, isFile ? $"'{folder}' is a file, not a folder" : $"There is no folder '{folder}'");
        }

        string? portalPath = Find(folder, PortalName), cellPath = Find(folder, CellName);
        if (portalPath is null || cellPath is null)
        {
            string missing = portalPath is not null ? CellName : cellPath is not null ? PortalName : $"{PortalName} and {CellName}";
            throw new DatFolderException(folder, $"'{folder}' has no {missing}");
        }

        var opened = new List<DatFile>();
        try
        {
            return new(
                folder,
                OpenAs(DatFileKind.Portal, portalPath, opened)!,
                OpenAs(DatFileKind.Cell, cellPath, opened)!,
                OpenAs(DatFileKind.Local, Find(folder, LocalName), opened),
                OpenAs(DatFileKind.HighRes, Find(folder, HighResName), opened));
        }
        catch
        {
            opened.ForEach(static file => file.Dispose());
            throw;
        }
    }

    /// <summary>The ids of one kind in all files, ascending.</summary>
    public IEnumerable<uint> IdsOf(DatRecordType type) => Files.SelectMany(file => file.IdsOf(type)).Distinct().Order();

    /// <inheritdoc/>
    public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
        => TryReadShared(id, out bytes, out _) || Cell.TryRead(id, out bytes) || (Local is not null && Local.TryRead(id, out bytes));

    /// <inheritdoc/>
    public void Dispose()
    {
        foreach (DatFile file in Files)
            file.Dispose();
    }

    bool ITypedDatSource.TryRead(uint id, DatRecordType type, out ReadOnlySequence<byte> bytes, out string file)
    {
        DatFile own = DatIds.IsCellType(type) ? Cell : Portal;
        file = own.Path;
        bytes = default;
        if (DatIds.RecordTypeOf(id, own.Kind) != type)
            return false;
        if (own == Cell)
            return Cell.TryRead(id, out bytes);
        if (TryReadShared(id, out bytes, out file))
            return true;
        file = Local?.Path ?? file;
        return Local is not null && Local.TryRead(id, out bytes);
    }

    // Large textures are searched in their own file first (spec 07, 1.2).
    private bool TryReadShared(uint id, out ReadOnlySequence<byte> bytes, out string file)
    {
        file = Portal.Path;
        bool texture = DatIds.RecordTypeOf(id, DatFileKind.Portal) is DatRecordType.SurfaceTexture or DatRecordType.RenderSurface;
        if (!texture || HighRes is null || !HighRes.TryRead(id, out bytes))
            return Portal.TryRead(id, out bytes);
        file = HighRes.Path;
        return true;
    }

    private static string? Find(string folder, string name)
        => Directory.EnumerateFiles(folder)
            .Where(path => string.Equals(Path.GetFileName(path), name, StringComparison.OrdinalIgnoreCase))
            .OrderByDescending(path => Path.GetFileName(path) == name)
            .ThenBy(path => path, StringComparer.Ordinal)
            .FirstOrDefault();

    private static DatFile? OpenAs(DatFileKind kind, string? path, List<DatFile> opened)
    {
        if (path is null)
            return null;
        var file = DatFile.Open(path);
        opened.Add(file);
        return file.Kind == kind
            ? file
            : throw new DatFormatException(path, null, 0x14C, $"the name says {kind}, but the header says {file.Kind}");
    }
}
