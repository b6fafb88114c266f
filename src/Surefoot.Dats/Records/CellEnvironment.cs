using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>The shape of an indoor cell (spec 07, 7.10).</summary>
/// <remarks>Retail: CCellStruct::UnPack @0x00533D00.</remarks>
public sealed record CellStruct
{
    internal const int LeastSize = 40;

    /// <summary>Stored key; retail counts positions instead.</summary>
    public uint Key { get; init; }

    /// <summary>Vertices of both polygon lists.</summary>
    public DatVertexArray Vertices { get; init; } = DatVertexArray.Empty;

    /// <summary>Polygons that are drawn, the portals' included.</summary>
    public ImmutableArray<DatPolygon> Polygons { get; init; } = [];

    /// <summary>Positions in <see cref="Polygons"/> of the portals' polygons.</summary>
    public ImmutableArray<ushort> PortalPolygons { get; init; } = [];

    /// <summary>The space of the cell.</summary>
    public required BspTree CellTree { get; init; }

    /// <summary>Polygons that collide.</summary>
    public ImmutableArray<DatPolygon> PhysicsPolygons { get; init; } = [];

    /// <summary>Their tree; always there.</summary>
    public required BspTree PhysicsTree { get; init; }

    /// <summary>Stored word that says whether a drawing tree follows: non-zero for yes.</summary>
    public uint DrawingTreeFlag { get; init; }

    /// <summary>The drawing tree; null when there is none.</summary>
    public BspTree? DrawingTree { get; init; }

    internal static CellStruct Read(ref DatReader reader)
    {
        uint key = reader.ReadUInt32();
        uint polygonCount = reader.ReadUInt32(), physicsCount = reader.ReadUInt32(), portalCount = reader.ReadUInt32();
        DatVertexArray vertices = DatVertexArray.Read(ref reader);
        ImmutableArray<DatPolygon> polygons = DatPolygon.ReadArray(ref reader, polygonCount);
        ImmutableArray<ushort> portals = reader.ReadUInt16Array(portalCount);
        reader.Align4();
        BspTree cellTree = BspTree.Read(ref reader, BspKind.Cell);
        ImmutableArray<DatPolygon> physicsPolygons = DatPolygon.ReadArray(ref reader, physicsCount);
        BspTree physicsTree = BspTree.Read(ref reader, BspKind.Physics);
        uint drawing = reader.ReadUInt32();
        BspTree? drawingTree = drawing != 0 ? BspTree.Read(ref reader, BspKind.Drawing) : null;
        reader.Align4();
        return new()
        {
            Key = key,
            Vertices = vertices,
            Polygons = polygons,
            PortalPolygons = portals,
            CellTree = cellTree,
            PhysicsPolygons = physicsPolygons,
            PhysicsTree = physicsTree,
            DrawingTreeFlag = drawing,
            DrawingTree = drawingTree,
        };
    }

    internal static void Write(DatWriter writer, CellStruct cell)
    {
        DatWriter.Require(
            cell.DrawingTreeFlag != 0 == cell.DrawingTree is not null, "The drawing tree of a cell and its flag contradict each other.");
        writer.WriteUInt32(cell.Key);
        writer.WriteUInt32((uint)cell.Polygons.Length);
        writer.WriteUInt32((uint)cell.PhysicsPolygons.Length);
        writer.WriteUInt32((uint)cell.PortalPolygons.Length);
        cell.Vertices.Write(writer);
        writer.WriteArray(cell.Polygons, DatPolygon.Write);
        writer.WriteUInt16Array(cell.PortalPolygons);
        writer.Align4();
        cell.CellTree.Write(writer, BspKind.Cell);
        writer.WriteArray(cell.PhysicsPolygons, DatPolygon.Write);
        cell.PhysicsTree.Write(writer, BspKind.Physics);
        writer.WriteUInt32(cell.DrawingTreeFlag);
        cell.DrawingTree?.Write(writer, BspKind.Drawing);
        writer.Align4();
    }
}

/// <summary>0x0D: the shapes of indoor cells (spec 07, 7.10). Retail calls it Environment; that name is .NET's.</summary>
/// <remarks>Retail: CEnvironment::UnPack @0x00530CF0.</remarks>
public sealed class CellEnvironment : DatRecord, IDatRecord<CellEnvironment>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Environment;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>The shapes; an EnvCell names one by its position.</summary>
    public ImmutableArray<CellStruct> Cells { get; init; } = [];

    /// <inheritdoc/>
    public static CellEnvironment Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        long start = reader.Position;
        ImmutableArray<CellStruct> cells = reader.ReadList(CellStruct.LeastSize, CellStruct.Read);
        for (int i = 0; i < cells.Length; i++)
        {
            if (cells[i].Key != i)
            {
                reader.Remark($"structure {i} has key {cells[i].Key}; positions count", start);
                break;
            }
        }

        return new() { Id = id, Cells = cells };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteList(Cells, CellStruct.Write);
    }
}
