using System.Collections.Immutable;
using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>XXYYFFFF: terrain and heights of a block of 192 m by 192 m (spec 07, 7.12).</summary>
/// <remarks>Retail: CLandBlock::UnPack @0x0052F310, CLandBlockStruct::UnPack @0x00531FD0.</remarks>
public sealed class LandBlock : DatRecord, IDatRecord<LandBlock>
{
    /// <summary>Vertices of a side.</summary>
    public const int Side = 9;

    /// <summary>Vertices of a block.</summary>
    public const int VertexCount = Side * Side;

    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.LandBlock;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Stored word: non-zero when the record XXYYFFFE exists. Write 0 or 1.</summary>
    public uint InfoFlag { get; init; }

    /// <summary>Whether the record XXYYFFFE exists.</summary>
    [JsonIgnore]
    public bool HasInfo => InfoFlag != 0;

    /// <summary>81 terrain words at <see cref="IndexOf"/>: bits 0–1 road, 2–6 terrain type, 11–15 scenery type.</summary>
    public required ImmutableArray<ushort> Terrain { get; init; }

    /// <summary>81 indices into the region's height table.</summary>
    public required ImmutableArray<byte> Heights { get; init; }

    /// <summary>Index of vertex (x east, y north), each 0 to 8.</summary>
    public static int IndexOf(int x, int y) => (Side * x) + y;

    /// <summary>Makes a terrain word.</summary>
    /// <param name="road">0 to 3.</param>
    /// <param name="type">Terrain type, 0 to 31.</param>
    /// <param name="scenery">Scenery type, 0 to 31.</param>
    public static ushort TerrainWord(int road, int type, int scenery)
        => (ushort)((road & 3) | ((type & 31) << 2) | ((scenery & 31) << 11));

    /// <inheritdoc/>
    public static LandBlock Decode(ref DatReader reader)
    {
        var block = new LandBlock
        {
            Id = reader.ReadId(),
            InfoFlag = reader.ReadUInt32(),
            Terrain = reader.ReadUInt16Array(VertexCount),
            Heights = reader.ReadByteArray(VertexCount),
        };
        reader.Align4();
        return block;
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        DatWriter.Require(
            Terrain.Length == VertexCount && Heights.Length == VertexCount, $"LandBlock 0x{Id:X8} needs 81 terrain words and 81 heights.");
        writer.WriteUInt32(Id);
        writer.WriteUInt32(InfoFlag);
        writer.WriteUInt16Array(Terrain);
        writer.WriteBytes(Heights.AsSpan());
        writer.Align4();
    }
}
