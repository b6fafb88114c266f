using System.Buffers;
using System.Collections.Immutable;
using System.Runtime.InteropServices;

namespace Surefoot.Dats.Records;

/// <summary>A record of a kind that this library carries as bytes (textures, tables, texts).</summary>
public sealed class RawRecord : DatRecord
{
    private readonly DatRecordType type;

    /// <summary>Creates a record from its bytes.</summary>
    /// <param name="type">Its kind; <see cref="DatRecordType.Unknown"/> when nobody knows.</param>
    public RawRecord(DatRecordType type) => this.type = type;

    /// <inheritdoc/>
    public override DatRecordType Type => type;

    /// <summary>All bytes, the leading id (where the kind has one) included.</summary>
    public ImmutableArray<byte> Bytes { get; init; } = [];

    /// <summary>Copies the bytes of a record.</summary>
    public static RawRecord FromBytes(uint id, DatRecordType type, ReadOnlySequence<byte> bytes)
        => new(type) { Id = id, Bytes = ImmutableCollectionsMarshal.AsImmutableArray(bytes.ToArray()) };

    /// <inheritdoc/>
    public override void Encode(DatWriter writer) => writer.WriteBytes(Bytes.AsSpan());
}
