using System.Collections.Immutable;
using System.Numerics;

namespace Surefoot.Dats.Records;

/// <summary>Bits of <see cref="GfxObj.Flags"/>.</summary>
[Flags]
public enum GfxObjFlags : uint
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Physics polygons and tree follow.</summary>
    HasPhysics = 1,

    /// <summary>Drawing polygons and tree follow.</summary>
    HasDrawing = 2,

    /// <summary>The id of a degrade record follows.</summary>
    HasDegrade = 8,
}

/// <summary>0x01: a shape (spec 07, 7.5).</summary>
/// <remarks>Retail: CGfxObj::Serialize @0x00534970.</remarks>
public sealed class GfxObj : DatRecord, IDatRecord<GfxObj>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.GfxObj;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Which parts are stored.</summary>
    public GfxObjFlags Flags { get; init; }

    /// <summary>Surface ids.</summary>
    public ImmutableArray<uint> SurfaceIds { get; init; } = [];

    /// <summary>Vertices of both polygon lists.</summary>
    public DatVertexArray Vertices { get; init; } = DatVertexArray.Empty;

    /// <summary>Polygons that collide.</summary>
    public ImmutableArray<DatPolygon> PhysicsPolygons { get; init; } = [];

    /// <summary>Their tree; null without <see cref="GfxObjFlags.HasPhysics"/>.</summary>
    public BspTree? PhysicsTree { get; init; }

    /// <summary>Point by which transparent parts are sorted; metres.</summary>
    public Vector3 SortCentre { get; init; }

    /// <summary>Polygons that are drawn.</summary>
    public ImmutableArray<DatPolygon> DrawingPolygons { get; init; } = [];

    /// <summary>Their tree; null without <see cref="GfxObjFlags.HasDrawing"/>.</summary>
    public BspTree? DrawingTree { get; init; }

    /// <summary>Degrade record; 0 without <see cref="GfxObjFlags.HasDegrade"/>.</summary>
    public uint DegradeId { get; init; }

    /// <inheritdoc/>
    public static GfxObj Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        var flags = (GfxObjFlags)reader.ReadUInt32();
        ImmutableArray<uint> surfaces = reader.ReadUInt32Array(reader.ReadCompressedUInt32());
        DatVertexArray vertices = DatVertexArray.Read(ref reader);
        var (physicsPolygons, physicsTree) = ReadShape(ref reader, BspKind.Physics, flags.HasFlag(GfxObjFlags.HasPhysics));
        Vector3 sortCentre = reader.ReadVector3();
        var (drawingPolygons, drawingTree) = ReadShape(ref reader, BspKind.Drawing, flags.HasFlag(GfxObjFlags.HasDrawing));
        return new()
        {
            Id = id,
            Flags = flags,
            SurfaceIds = surfaces,
            Vertices = vertices,
            PhysicsPolygons = physicsPolygons,
            PhysicsTree = physicsTree,
            SortCentre = sortCentre,
            DrawingPolygons = drawingPolygons,
            DrawingTree = drawingTree,
            DegradeId = flags.HasFlag(GfxObjFlags.HasDegrade) ? reader.ReadUInt32() : 0,
        };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteUInt32((uint)Flags);
        writer.WriteCompressedUInt32((uint)SurfaceIds.Length);
        writer.WriteUInt32Array(SurfaceIds);
        Vertices.Write(writer);
        WriteShape(writer, BspKind.Physics, GfxObjFlags.HasPhysics, PhysicsPolygons, PhysicsTree);
        writer.WriteVector3(SortCentre);
        WriteShape(writer, BspKind.Drawing, GfxObjFlags.HasDrawing, DrawingPolygons, DrawingTree);
        if (Flags.HasFlag(GfxObjFlags.HasDegrade))
            writer.WriteUInt32(DegradeId);
        else
            DatWriter.Require(DegradeId == 0, $"GfxObj 0x{Id:X8} has a degrade record but not the flag for it.");
    }

    private static (ImmutableArray<DatPolygon> Polygons, BspTree? Tree) ReadShape(ref DatReader reader, BspKind kind, bool present)
    {
        if (!present)
            return ([], null);
        ImmutableArray<DatPolygon> polygons = DatPolygon.ReadArray(ref reader, reader.ReadCompressedUInt32());
        return (polygons, BspTree.Read(ref reader, kind));
    }

    private void WriteShape(DatWriter writer, BspKind kind, GfxObjFlags flag, ImmutableArray<DatPolygon> polygons, BspTree? tree)
    {
        bool present = Flags.HasFlag(flag);
        DatWriter.Require(present == tree is not null, $"GfxObj 0x{Id:X8}: the flag {flag} and the presence of the {kind} tree differ.");
        DatWriter.Require(present || polygons.IsEmpty, $"GfxObj 0x{Id:X8} has {kind} polygons but not the flag {flag}.");
        if (tree is null)
            return;
        writer.WriteCompressedUInt32((uint)polygons.Length);
        writer.WriteArray(polygons, DatPolygon.Write);
        tree.Write(writer, kind);
    }
}
