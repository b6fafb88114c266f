using System.Collections.Immutable;
using System.Numerics;

namespace Surefoot.Dats.Records;

/// <summary>A point on a texture, in texture widths and heights.</summary>
/// <param name="U">Along the width.</param>
/// <param name="V">Along the height.</param>
public readonly record struct DatUV(float U, float V);

/// <summary>A vertex (spec 07, 7.1).</summary>
/// <remarks>Retail: CSWVertex::UnPack @0x0053DE50.</remarks>
/// <param name="Key">Stored key; retail ignores it and counts positions.</param>
/// <param name="Position">Metres.</param>
/// <param name="Normal">Normal for lighting.</param>
/// <param name="UVs">Texture points.</param>
public sealed record DatVertex(ushort Key, Vector3 Position, Vector3 Normal, ImmutableArray<DatUV> UVs)
{
    /// <summary>A vertex without texture points.</summary>
    public DatVertex(ushort key, Vector3 position, Vector3 normal)
        : this(key, position, normal, [])
    {
    }

    internal const int LeastSize = 28;

    internal static DatVertex Read(ref DatReader reader)
    {
        ushort key = reader.ReadUInt16(), uvs = reader.ReadUInt16();
        Vector3 position = reader.ReadVector3(), normal = reader.ReadVector3();
        return new(key, position, normal, reader.ReadArray(uvs, 8, static (ref r) => new DatUV(r.ReadSingle(), r.ReadSingle())));
    }

    internal static void Write(DatWriter writer, DatVertex vertex)
    {
        writer.WriteUInt16(vertex.Key);
        writer.WriteUInt16((ushort)DatWriter.RequireCount(vertex.UVs.Length, ushort.MaxValue, "texture points of a vertex"));
        writer.WriteVector3(vertex.Position);
        writer.WriteVector3(vertex.Normal);
        writer.WriteArray(vertex.UVs, static (w, uv) =>
        {
            w.WriteSingle(uv.U);
            w.WriteSingle(uv.V);
        });
    }
}

/// <summary>The vertices of a shape (spec 07, 7.1). Polygons refer to positions in <see cref="Vertices"/>.</summary>
/// <remarks>Retail: CVertexArray::UnPack @0x0053C030.</remarks>
/// <param name="Vertices">The vertices in file order.</param>
public sealed record DatVertexArray(ImmutableArray<DatVertex> Vertices)
{
    private const uint OnlyType = 1;

    /// <summary>No vertices.</summary>
    public static DatVertexArray Empty { get; } = new([]);

    internal static DatVertexArray Read(ref DatReader reader)
    {
        long start = reader.Position;
        uint type = reader.ReadUInt32();
        if (type != OnlyType)
            throw reader.Error($"vertex type {type}; only 1 exists", start);
        ImmutableArray<DatVertex> vertices = reader.ReadList<DatVertex>(DatVertex.LeastSize, DatVertex.Read);
        for (int i = 0; i < vertices.Length; i++)
        {
            if (vertices[i].Key != i)
            {
                reader.Remark($"vertex {i} has key {vertices[i].Key}; positions count", start);
                break;
            }
        }

        return new(vertices);
    }

    internal void Write(DatWriter writer)
    {
        writer.WriteUInt32(OnlyType);
        writer.WriteList(Vertices, DatVertex.Write);
    }
}

/// <summary>Bits of <see cref="DatPolygon.Stippling"/>.</summary>
[Flags]
public enum DatStippling : byte
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>The positive side is stippled.</summary>
    Positive = 1,

    /// <summary>The negative side is stippled.</summary>
    Negative = 2,

    /// <summary>No texture points for the positive side.</summary>
    NoPositiveUVs = 4,

    /// <summary>No texture points for the negative side.</summary>
    NoNegativeUVs = 8,

    /// <summary>Usual, together with 4, for portals.</summary>
    Portal = 16,
}

/// <summary>A polygon (spec 07, 7.1). Its plane follows from its points (spec 04).</summary>
/// <remarks>Retail: CPolygon::UnPack @0x00538650.</remarks>
public sealed record DatPolygon
{
    /// <summary>Value of <see cref="Sides"/> for two different surfaces.</summary>
    public const int TwoSurfaces = 2;

    internal const int LeastSize = 12;

    /// <summary>Stored key; retail ignores it and counts positions, but for the portals of an EnvCell.</summary>
    public ushort Key { get; init; }

    /// <summary>Stippling and which texture points are stored.</summary>
    public DatStippling Stippling { get; init; } = DatStippling.NoPositiveUVs;

    /// <summary>0 one side; 1 both sides alike; 2 two surfaces.</summary>
    public int Sides { get; init; }

    /// <summary>Index into the surface list of the GfxObj or EnvCell; −1 none.</summary>
    public short PositiveSurface { get; init; } = -1;

    /// <summary>The same for the other side.</summary>
    public short NegativeSurface { get; init; } = -1;

    /// <summary>Positions in the vertex array, counter-clockwise seen from the positive side. At most 127.</summary>
    public ImmutableArray<ushort> Vertices { get; init; } = [];

    /// <summary>For each point the index of its texture point; empty when <see cref="Stippling"/> says there are none.</summary>
    public ImmutableArray<byte> PositiveUVs { get; init; } = [];

    /// <summary>The same for the negative side; only with <see cref="Sides"/> 2.</summary>
    public ImmutableArray<byte> NegativeUVs { get; init; } = [];

    private bool HasPositiveUVs => (Stippling & DatStippling.NoPositiveUVs) == 0;

    private bool HasNegativeUVs => Sides == TwoSurfaces && (Stippling & DatStippling.NoNegativeUVs) == 0;

    internal static DatPolygon Read(ref DatReader reader)
    {
        ushort key = reader.ReadUInt16();
        byte points = reader.ReadByte();
        if (points > sbyte.MaxValue)
            throw reader.Error($"a polygon of {points} points; at most 127 are possible", reader.Position - 1);
        var head = new DatPolygon
        {
            Key = key,
            Stippling = (DatStippling)reader.ReadByte(),
            Sides = reader.ReadInt32(),
            PositiveSurface = reader.ReadInt16(),
            NegativeSurface = reader.ReadInt16(),
            Vertices = reader.ReadUInt16Array(points),
        };
        bool positive = head.HasPositiveUVs, negative = head.HasNegativeUVs;
        return positive || negative
            ? head with
            {
                PositiveUVs = reader.ReadByteArray(positive ? points : 0),
                NegativeUVs = reader.ReadByteArray(negative ? points : 0),
            }
            : head;
    }

    internal static ImmutableArray<DatPolygon> ReadArray(ref DatReader reader, long count)
    {
        long start = reader.Position;
        ImmutableArray<DatPolygon> polygons = reader.ReadArray<DatPolygon>(count, LeastSize, Read);
        for (int i = 0; i < polygons.Length; i++)
        {
            if (polygons[i].Key != i)
            {
                reader.Remark($"polygon {i} has key {polygons[i].Key}; positions count", start);
                break;
            }
        }

        return polygons;
    }

    internal static void Write(DatWriter writer, DatPolygon polygon)
    {
        int points = DatWriter.RequireCount(polygon.Vertices.Length, sbyte.MaxValue, "points of a polygon");
        DatWriter.Require(
            polygon.PositiveUVs.Length == (polygon.HasPositiveUVs ? points : 0),
            "The positive texture points of a polygon do not fit its points and stippling.");
        DatWriter.Require(
            polygon.NegativeUVs.Length == (polygon.HasNegativeUVs ? points : 0),
            "The negative texture points of a polygon do not fit its points, sides and stippling.");
        writer.WriteUInt16(polygon.Key);
        writer.WriteByte((byte)points);
        writer.WriteByte((byte)polygon.Stippling);
        writer.WriteInt32(polygon.Sides);
        writer.WriteInt16(polygon.PositiveSurface);
        writer.WriteInt16(polygon.NegativeSurface);
        writer.WriteUInt16Array(polygon.Vertices);
        writer.WriteBytes(polygon.PositiveUVs.AsSpan());
        writer.WriteBytes(polygon.NegativeUVs.AsSpan());
    }
}
