using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>A way into a building.</summary>
/// <remarks>Retail: CBldPortal::UnPack @0x0053BC40.</remarks>
/// <param name="Flags">Its flags; never <see cref="PortalFlags.Outside"/>.</param>
/// <param name="OtherCell">Low word of the cell behind it.</param>
/// <param name="OtherPortal">Index into that cell's portals.</param>
/// <param name="StabCells">Low words of the cells that may be seen through it.</param>
public sealed record BuildingPortal(PortalFlags Flags, ushort OtherCell, ushort OtherPortal, ImmutableArray<ushort> StabCells)
{
    internal const int LeastSize = 8;

    internal static BuildingPortal Read(ref DatReader reader)
    {
        var flags = (PortalFlags)reader.ReadUInt16();
        ushort cell = reader.ReadUInt16(), portal = reader.ReadUInt16(), stabs = reader.ReadUInt16();
        var result = new BuildingPortal(flags, cell, portal, reader.ReadUInt16Array(stabs));
        reader.SkipPadding((stabs & 1) * 2);
        return result;
    }

    internal static void Write(DatWriter writer, BuildingPortal portal)
    {
        int stabs = DatWriter.RequireCount(portal.StabCells.Length, ushort.MaxValue, "cells seen through a building's portal");
        writer.WriteUInt16((ushort)portal.Flags);
        writer.WriteUInt16(portal.OtherCell);
        writer.WriteUInt16(portal.OtherPortal);
        writer.WriteUInt16((ushort)stabs);
        writer.WriteUInt16Array(portal.StabCells);
        writer.WriteZeros((stabs & 1) * 2);
    }
}

/// <summary>A building.</summary>
/// <param name="ModelId">GfxObj or Setup of its outside.</param>
/// <param name="Frame">In landblock coordinates; metres.</param>
/// <param name="LeafCount">Leaves of the model's drawing tree; nothing in movement reads it.</param>
/// <param name="Portals">Its ways in.</param>
public sealed record Building(uint ModelId, DatFrame Frame, uint LeafCount, ImmutableArray<BuildingPortal> Portals)
{
    internal const int LeastSize = 40;

    internal static Building Read(ref DatReader reader) => new(
        reader.ReadUInt32(), reader.ReadFrame(), reader.ReadUInt32(), reader.ReadList(BuildingPortal.LeastSize, BuildingPortal.Read));

    internal static void Write(DatWriter writer, Building building)
    {
        writer.WriteUInt32(building.ModelId);
        writer.WriteFrame(building.Frame);
        writer.WriteUInt32(building.LeafCount);
        writer.WriteList(building.Portals, BuildingPortal.Write);
    }
}

/// <summary>Who may enter a cell.</summary>
/// <param name="CellId">Full cell id.</param>
/// <param name="ObjectId">The object that decides.</param>
public readonly record struct CellRestriction(uint CellId, uint ObjectId);

/// <summary>Bits of <see cref="LandBlockInfo.Flags"/>.</summary>
[Flags]
public enum LandBlockInfoFlags : ushort
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>A table of restrictions follows.</summary>
    HasRestrictions = 1,
}

/// <summary>XXYYFFFE: objects, buildings and number of cells of a block (spec 07, 7.13).</summary>
/// <remarks>Retail: CLandBlockInfo::UnPack @0x0052ECA0.</remarks>
public sealed class LandBlockInfo : DatRecord, IDatRecord<LandBlockInfo>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.LandBlockInfo;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>How many EnvCells the block has: 0x0100, 0x0101, … without gaps.</summary>
    public uint CellCount { get; init; }

    /// <summary>Things on the land, in landblock coordinates.</summary>
    public ImmutableArray<StaticObject> Objects { get; init; } = [];

    /// <summary>Buildings.</summary>
    public ImmutableArray<Building> Buildings { get; init; } = [];

    /// <summary>What else is stored.</summary>
    public LandBlockInfoFlags Flags { get; init; }

    /// <summary>Bucket count of the restriction table as stored.</summary>
    public ushort RestrictionBuckets { get; init; }

    /// <summary>Who may enter which cell.</summary>
    public ImmutableArray<CellRestriction> Restrictions { get; init; } = [];

    /// <inheritdoc/>
    public static LandBlockInfo Decode(ref DatReader reader)
    {
        uint id = reader.ReadId(), cells = reader.ReadUInt32();
        ImmutableArray<StaticObject> objects = reader.ReadList(StaticObject.Size, StaticObject.Read);
        ushort buildingCount = reader.ReadUInt16();
        var flags = (LandBlockInfoFlags)reader.ReadUInt16();
        ImmutableArray<Building> buildings = reader.ReadArray(buildingCount, Building.LeastSize, Building.Read);
        bool restricted = flags.HasFlag(LandBlockInfoFlags.HasRestrictions);
        ushort count = restricted ? reader.ReadUInt16() : (ushort)0, buckets = restricted ? reader.ReadUInt16() : (ushort)0;
        if (count > 0 && buckets == 0)
            throw reader.Error("a hash table with entries but no buckets", reader.Position - 2);
        return new()
        {
            Id = id,
            CellCount = cells,
            Objects = objects,
            Buildings = buildings,
            Flags = flags,
            RestrictionBuckets = buckets,
            Restrictions = reader.ReadArray(count, 8, static (ref r) => new CellRestriction(r.ReadUInt32(), r.ReadUInt32())),
        };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteUInt32(CellCount);
        writer.WriteList(Objects, StaticObject.Write);
        writer.WriteUInt16((ushort)DatWriter.RequireCount(Buildings.Length, ushort.MaxValue, "buildings of a block"));
        writer.WriteUInt16((ushort)Flags);
        writer.WriteArray(Buildings, Building.Write);
        if (!Flags.HasFlag(LandBlockInfoFlags.HasRestrictions))
        {
            DatWriter.Require(Restrictions.IsEmpty, $"LandBlockInfo 0x{Id:X8} has restrictions but not the flag for them.");
            return;
        }

        DatWriter.Require(Restrictions.IsEmpty || RestrictionBuckets > 0, $"LandBlockInfo 0x{Id:X8}: a table with entries needs buckets.");
        writer.WriteUInt16((ushort)DatWriter.RequireCount(Restrictions.Length, ushort.MaxValue, "restrictions of a block"));
        writer.WriteUInt16(RestrictionBuckets);
        writer.WriteArray(Restrictions, static (w, restriction) =>
        {
            w.WriteUInt32(restriction.CellId);
            w.WriteUInt32(restriction.ObjectId);
        });
    }
}
