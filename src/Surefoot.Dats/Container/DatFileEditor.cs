using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Changes single records of a dat file as the retail client does (spec 07, 5.2 and 5.3), on a copy that replaces the file on
/// <see cref="Complete"/>. Without that the file stays as it was.</summary>
/// <remarks>Not for several threads. Retail: BTree::DescendToAdd @0x006733B0, BTree::Delete @0x006739B0.</remarks>
public sealed class DatFileEditor : IDisposable
{
    private readonly string path;
    private readonly string temporary;
    private readonly BlockStore store;
    private readonly DirectoryTree tree;
    private readonly DatFileKind kind;
    private bool done;

    private DatFileEditor(string path, string temporary, DatHeader header)
    {
        this.path = path;
        this.temporary = temporary;
        kind = header.Kind;
        store = new BlockStore(temporary, header, path);
        tree = new DirectoryTree(store);
    }

    /// <summary>Opens a copy of a file for changes.</summary>
    /// <exception cref="DatFormatException">It is no dat file, its directory is damaged, or a write to it was interrupted.</exception>
    public static DatFileEditor Open(string path)
    {
        DatHeader header;
        using (var file = DatFile.Open(path))
        {
            header = file.Header;
            if (header.Transaction != 0)
                throw new DatFormatException(path, null, 0x100, "the file was left in the middle of a write; it must not be changed");
            if (file.Damage.Count > 0)
            {
                DatRemark first = file.Damage[0];
                throw new DatFormatException(path, null, first.Offset, $"the damaged directory forbids changes: {first.Message}");
            }
        }

        string temporary = path + ".new";
        File.Copy(path, temporary, overwrite: true);
        try
        {
            File.SetAttributes(temporary, FileAttributes.Normal);
            return new(path, temporary, header);
        }
        catch
        {
            File.Delete(temporary);
            throw;
        }
    }

    /// <summary>Adds or replaces a record.</summary>
    /// <param name="record">The record.</param>
    /// <param name="iteration">Update in which it changes; 0 for none in particular.</param>
    /// <param name="date">Unix seconds.</param>
    /// <returns>False when the file has the record from a later update; it is kept then, as retail does.</returns>
    public bool Put(DatRecord record, uint iteration = 1, uint date = 0)
    {
        ArgumentNullException.ThrowIfNull(record);
        if (record is not RawRecord && DatIds.RecordTypeOf(record.Id, kind) != record.Type)
            throw new ArgumentException($"0x{record.Id:X8} is not the id of a {record.Type} in a {kind} file.", nameof(record));
        return Put(record.Id, record.Encode(), iteration, date);
    }

    /// <summary>Adds or replaces a record by its bytes.</summary>
    /// <inheritdoc cref="Put(DatRecord, uint, uint)"/>
    public bool Put(uint id, ReadOnlySpan<byte> bytes, uint iteration = 1, uint date = 0)
    {
        ObjectDisposedException.ThrowIf(done, this);
        if (id == 0 || bytes.IsEmpty)
            throw new ArgumentException(id == 0 ? "Id 0 means no record." : $"Record 0x{id:X8} is empty.", nameof(id));
        bool exists = tree.TryFind(id, out DatEntry old);
        if (exists && iteration != 0 && old.Iteration > iteration)
            return false;
        ushort version = id == DatIds.Iteration ? DatFileWriter.IterationEntryVersion : DatFileWriter.EntryVersion;
        var entry = new DatEntry(0, version, id, store.Store(bytes), (uint)bytes.Length, date, id == DatIds.Iteration ? 0 : iteration);
        if (exists)
        {
            tree.Replace(entry);
            store.Free(old.Offset);
        }
        else
        {
            tree.Insert(entry);
        }

        return true;
    }

    /// <summary>Removes a record.</summary>
    /// <returns>False when it is not there.</returns>
    public bool Delete(uint id)
    {
        ObjectDisposedException.ThrowIf(done, this);
        if (!tree.TryFind(id, out DatEntry entry))
            return false;
        tree.Delete(id);
        store.Free(entry.Offset);
        return true;
    }

    /// <summary>Puts the changed copy in the file's place.</summary>
    public void Complete()
    {
        ObjectDisposedException.ThrowIf(done, this);
        tree.Flush();
        store.Close();
        done = true;
        File.Move(temporary, path, overwrite: true);
    }

    /// <summary>Drops the changes unless they are complete.</summary>
    public void Dispose()
    {
        if (done)
            return;
        done = true;
        store.Dispose();
        File.Delete(temporary);
    }
}
