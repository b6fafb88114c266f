using System.Collections.Immutable;
using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>Bits of <see cref="EnvCell.Flags"/>.</summary>
[Flags]
public enum EnvCellFlags : uint
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>The outdoors can be seen from it.</summary>
    SeenOutside = 1,

    /// <summary>Static objects follow.</summary>
    HasStaticObjects = 2,

    /// <summary>A restriction object follows.</summary>
    HasRestriction = 8,
}

/// <summary>Bits of a portal of a cell or a building.</summary>
[Flags]
public enum PortalFlags : ushort
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Both portals are the same polygon.</summary>
    ExactMatch = 1,

    /// <summary>Set: the polygon's normal points into the cell (retail: portal_side 0). Clear: out of it (portal_side 1).</summary>
    NormalPointsIn = 2,

    /// <summary>Opens to the outdoors.</summary>
    Outside = 4,
}

/// <summary>A portal of a cell.</summary>
/// <remarks>Retail: CCellPortal::UnPack @0x0053BAB0.</remarks>
/// <param name="Flags">Its flags.</param>
/// <param name="Polygon">Key of its polygon among the structure's portal polygons.</param>
/// <param name="OtherCell">Low word of the cell behind it; not looked at where it opens to the outdoors.</param>
/// <param name="OtherPortal">Index into the other cell's portals.</param>
public readonly record struct CellPortal(PortalFlags Flags, ushort Polygon, ushort OtherCell, ushort OtherPortal)
{
    /// <summary>
    /// True where it opens to the outdoors, which its flag alone says: behind 0xFFFF without it is a cell that never exists.
    /// </summary>
    [JsonIgnore]
    public bool IsOutside => (Flags & PortalFlags.Outside) != 0;

    /// <summary>Retail's portal_side: true when the polygon's normal points out of the cell.</summary>
    [JsonIgnore]
    public bool PortalSide => (Flags & PortalFlags.NormalPointsIn) == 0;
}

/// <summary>A thing that stands in the world.</summary>
/// <param name="ObjectId">GfxObj or Setup, by its top byte.</param>
/// <param name="Frame">In landblock coordinates; metres.</param>
public readonly record struct StaticObject(uint ObjectId, DatFrame Frame)
{
    internal const int Size = 32;

    internal static StaticObject Read(ref DatReader reader) => new(reader.ReadUInt32(), reader.ReadFrame());

    internal static void Write(DatWriter writer, StaticObject thing)
    {
        writer.WriteUInt32(thing.ObjectId);
        writer.WriteFrame(thing.Frame);
    }
}

/// <summary>XXYY0100 to XXYYFFFD: one indoor cell (spec 07, 7.11).</summary>
/// <remarks>Retail: CEnvCell::UnPack @0x0052D470.</remarks>
public sealed class EnvCell : DatRecord, IDatRecord<EnvCell>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.EnvCell;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>What is stored.</summary>
    public EnvCellFlags Flags { get; init; }

    /// <summary>The id again; its upper half completes the 16-bit cell numbers of this record.</summary>
    public required uint CellId { get; init; }

    /// <summary>Surfaces, full ids (0x0800xxxx).</summary>
    public ImmutableArray<uint> SurfaceIds { get; init; } = [];

    /// <summary>Environment, full id (0x0D00xxxx).</summary>
    public uint EnvironmentId { get; init; } = DatIds.EnvironmentBase;

    /// <summary>Position of its structure in the environment.</summary>
    public ushort Structure { get; init; }

    /// <summary>Where the structure stands, in landblock coordinates; metres.</summary>
    public DatFrame Position { get; init; } = DatFrame.Identity;

    /// <summary>Its portals.</summary>
    public ImmutableArray<CellPortal> Portals { get; init; } = [];

    /// <summary>Low words of the cells that may be seen from it, itself not among them.</summary>
    public ImmutableArray<ushort> VisibleCells { get; init; } = [];

    /// <summary>Things in it, in landblock coordinates.</summary>
    public ImmutableArray<StaticObject> StaticObjects { get; init; } = [];

    /// <summary>Who may enter; 0 without <see cref="EnvCellFlags.HasRestriction"/>.</summary>
    public uint RestrictionObjectId { get; init; }

    /// <inheritdoc/>
    public static EnvCell Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        var flags = (EnvCellFlags)reader.ReadUInt32();
        long again = reader.Position;
        uint cellId = reader.ReadUInt32();
        if (cellId != id)
            reader.Remark($"the second cell id is 0x{cellId:X8}; it decides", again);
        byte surfaces = reader.ReadByte(), portals = reader.ReadByte();
        ushort visible = reader.ReadUInt16();
        return new()
        {
            Id = id,
            Flags = flags,
            CellId = cellId,
            SurfaceIds = reader.ReadArray(surfaces, 2, static (ref r) => DatIds.SurfaceBase | r.ReadUInt16()),
            EnvironmentId = DatIds.EnvironmentBase | reader.ReadUInt16(),
            Structure = reader.ReadUInt16(),
            Position = reader.ReadFrame(),
            Portals = reader.ReadArray(
                portals, 8, static (ref r) => new CellPortal((PortalFlags)r.ReadUInt16(), r.ReadUInt16(), r.ReadUInt16(), r.ReadUInt16())),
            VisibleCells = reader.ReadUInt16Array(visible),
            StaticObjects = flags.HasFlag(EnvCellFlags.HasStaticObjects) ? reader.ReadList(StaticObject.Size, StaticObject.Read) : [],
            RestrictionObjectId = flags.HasFlag(EnvCellFlags.HasRestriction) ? reader.ReadUInt32() : 0,
        };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteUInt32((uint)Flags);
        writer.WriteUInt32(CellId);
        writer.WriteByte((byte)DatWriter.RequireCount(SurfaceIds.Length, byte.MaxValue, "surfaces of a cell"));
        writer.WriteByte((byte)DatWriter.RequireCount(Portals.Length, byte.MaxValue, "portals of a cell"));
        writer.WriteUInt16((ushort)DatWriter.RequireCount(VisibleCells.Length, ushort.MaxValue, "visible cells of a cell"));
        foreach (uint surface in SurfaceIds)
            writer.WriteUInt16(LowWord(surface, DatIds.SurfaceBase));
        writer.WriteUInt16(LowWord(EnvironmentId, DatIds.EnvironmentBase));
        writer.WriteUInt16(Structure);
        writer.WriteFrame(Position);
        writer.WriteArray(Portals, static (w, portal) =>
        {
            w.WriteUInt16((ushort)portal.Flags);
            w.WriteUInt16(portal.Polygon);
            w.WriteUInt16(portal.OtherCell);
            w.WriteUInt16(portal.OtherPortal);
        });
        writer.WriteUInt16Array(VisibleCells);
        if (Flags.HasFlag(EnvCellFlags.HasStaticObjects))
            writer.WriteList(StaticObjects, StaticObject.Write);
        else
            DatWriter.Require(StaticObjects.IsEmpty, $"EnvCell 0x{Id:X8} has static objects but not the flag for them.");
        if (Flags.HasFlag(EnvCellFlags.HasRestriction))
            writer.WriteUInt32(RestrictionObjectId);
        else
            DatWriter.Require(RestrictionObjectId == 0, $"EnvCell 0x{Id:X8} has a restriction but not the flag for it.");
    }

    private ushort LowWord(uint id, uint baseId)
    {
        DatWriter.Require(
            (id & 0xFFFF0000) == baseId, $"EnvCell 0x{Id:X8} can only refer to 0x{baseId:X8} … 0x{baseId | 0xFFFF:X8}, not 0x{id:X8}.");
        return (ushort)id;
    }
}
