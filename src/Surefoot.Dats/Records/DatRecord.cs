using System.Buffers;
using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>One record of a dat file, decoded. Encoding it gives the bytes it was decoded from.</summary>
/// <remarks>Immutable; may be shared between threads.</remarks>
public abstract class DatRecord
{
    /// <summary>Id of the record in its file's directory.</summary>
    [JsonPropertyOrder(-2)]
    public required uint Id { get; init; }

    /// <summary>Its kind.</summary>
    [JsonPropertyOrder(-1)]
    public abstract DatRecordType Type { get; }

    /// <summary>Zeros (0 to 3) behind the record proper in the file it was read from; written back.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingDefault)]
    public int TrailingZeros { get; internal set; }

    /// <summary>Name or path of the file it was read from, for errors; empty when it was made in memory.</summary>
    [JsonIgnore]
    public string File { get; internal set; } = string.Empty;

    /// <summary>Decodes a whole record.</summary>
    /// <param name="id">Its id.</param>
    /// <param name="bytes">All its bytes.</param>
    /// <param name="file">Name of its file, for errors.</param>
    /// <param name="remarks">Receives what is odd but readable; null to drop it.</param>
    /// <exception cref="DatFormatException">The bytes are no such record: too few, too many, or wrong.</exception>
    public static T Decode<T>(uint id, ReadOnlySequence<byte> bytes, string file = "", ICollection<DatRemark>? remarks = null)
        where T : DatRecord, IDatRecord<T>
    {
        var reader = new DatReader(bytes, id, file, remarks);
        T record = T.Decode(ref reader);
        record.TrailingZeros = reader.ReadEnd();
        record.File = file;
        return record;
    }

    /// <summary>The bytes of the whole record.</summary>
    /// <exception cref="InvalidOperationException">The record contradicts itself, e.g. content whose flag is not set.</exception>
    /// <exception cref="ArgumentException">A number or text that the format cannot hold.</exception>
    public byte[] Encode()
    {
        var writer = new DatWriter();
        Encode(writer);
        writer.WriteZeros(TrailingZeros);
        return writer.ToArray();
    }

    /// <summary>Writes the record. Alignment counts from the writer's start, so give a fresh one.</summary>
    public abstract void Encode(DatWriter writer);
}

/// <summary>What each kind of record can do by its type: <c>source.Read&lt;Setup&gt;(id)</c> rests on it.</summary>
public interface IDatRecord<TSelf>
    where TSelf : DatRecord, IDatRecord<TSelf>
{
    /// <summary>The kind.</summary>
    static abstract DatRecordType RecordType { get; }

    /// <summary>Reads the record from its first byte.</summary>
    static abstract TSelf Decode(ref DatReader reader);
}
