using System.Buffers;
using System.Diagnostics.CodeAnalysis;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Typed records from any source.</summary>
public static class DatSourceExtensions
{
    /// <summary>Reads and decodes a record, e.g. <c>source.Read&lt;Setup&gt;(0x02000001)</c>. Nothing is cached.</summary>
    /// <param name="source">Where from.</param>
    /// <param name="id">The record.</param>
    /// <param name="requestedBy">The record that names it, for the error.</param>
    /// <exception cref="DatRecordMissingException">There is no such record.</exception>
    /// <exception cref="DatFormatException">Its bytes are wrong.</exception>
    public static T Read<T>(this IDatSource source, uint id, uint? requestedBy = null)
        where T : DatRecord, IDatRecord<T>
        => source.TryRead(id, out T? record) ? record : throw new DatRecordMissingException(id, T.RecordType, requestedBy);

    /// <summary>Reads and decodes a record that may be missing.</summary>
    /// <exception cref="DatFormatException">Its bytes are wrong.</exception>
    public static bool TryRead<T>(this IDatSource source, uint id, [NotNullWhen(true)] out T? record)
        where T : DatRecord, IDatRecord<T>
    {
        string file = string.Empty;
        bool found = source is ITypedDatSource typed
            ? typed.TryRead(id, T.RecordType, out ReadOnlySequence<byte> bytes, out file)
            : source.TryRead(id, out bytes);
        record = found ? DatRecord.Decode<T>(id, bytes, file) : null;
        return found;
    }
}
