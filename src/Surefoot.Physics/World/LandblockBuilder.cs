using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using EnvCellRecord = Surefoot.Dats.Records.EnvCell;

namespace Surefoot.Physics.World;

/// <summary>Makes a landblock from its records. Nothing is changed anywhere until it is complete.</summary>
/// <remarks>
/// Retail spreads this over CLandBlock::UnPack @0x0052F310, init_buildings @0x0052FD80 and init_static_objs @0x00530A40; specification 05,
/// 4.7.
/// </remarks>
internal sealed class LandblockBuilder(PhysicsDataCache cache, RegionAsset region)
{
    private const int MaxRooms = 0xFFFE - (int)CellIds.FirstIndoor;

    private readonly AssetFinder assets = new(cache);

    /// <summary>The block of an id; null when the files have none, or when it is left out as a whole.</summary>
    /// <param name="blockId">Any id of the block.</param>
    /// <param name="faults">Decides on what is missing or wrong.</param>
    internal Landblock? Build(uint blockId, LandblockFaults faults)
    {
        if (!CellIds.TryBlockCorner(blockId | 1, out _, out _)) return null;
        uint recordId = CellIds.LandblockRecord(blockId);
        try
        {
            return cache.Source.TryRead(recordId, out LandBlock? record) ? Build(blockId, record, faults) : null;
        }
        catch (Exception fault) when (LandblockFaults.IsFault(fault))
        {
            faults.LeaveOutAll(recordId, fault);
            return null;
        }
    }

    private Landblock Build(uint blockId, LandBlock record, LandblockFaults faults)
    {
        float[] heights = new float[TerrainSurface.VertexCount];
        for (int i = 0; i < heights.Length; i++) heights[i] = region.HeightTable[record.Heights[i]];
        Landblock block = new(new TerrainSurface(blockId, heights, record.Terrain.AsSpan()));
        LandBlockInfo? info = record.HasInfo ? cache.Source.Read<LandBlockInfo>(CellIds.LandblockInfoRecord(blockId), record.Id) : null;
        if (info?.CellCount > MaxRooms)
            throw new DatFormatException(info.File, info.Id, 4, $"{info.CellCount} rooms; a block has at most {MaxRooms}");
        StaticOrder order = new(block.Id);
        if (info is not null) AddContents(block, info, order, faults);
        foreach (SceneryItem item in Scenery.Of(block, region, assets, faults))
        {
            block.AddStatic(new StaticObject(
                item.Setup, new Position(item.Cell.Id, item.Frame), order.NextOnLand(), item.Cell, item.Scale,
                assets.FindAnimation(item.Setup, faults))
            {
                IsScenery = true,
            });
        }

        if (info is not null) AddRooms(block, info, order, faults);
        return block;
    }

    private void AddContents(Landblock block, LandBlockInfo info, StaticOrder order, LandblockFaults faults)
    {
        foreach (Building building in info.Buildings)
        {
            if (Place(block, LeftOutKind.Building, building.ModelId, building.Frame, info, faults) is not var (setup, place, cell))
                continue;
            StaticObject shell = new(setup, place, order.NextOnLand(), cell, 1f, assets.FindAnimation(setup, faults));
            BuildingPortal[] portals = [.. building.Portals.Select(p => new BuildingPortal(block.Id | p.OtherCell, (short)p.OtherPortal))];
            block.AddBuilding(cell, new BuildingObject(shell, portals));
        }

        foreach (Dats.Records.StaticObject thing in info.Objects)
        {
            if (Place(block, LeftOutKind.Object, thing.ObjectId, thing.Frame, info, faults) is var (setup, place, cell))
                block.AddStatic(new StaticObject(setup, place, order.NextOnLand(), cell, 1f, assets.FindAnimation(setup, faults)));
        }

        foreach (CellRestriction restriction in info.Restrictions)
        {
            if (restriction.ObjectId != 0 && CellIds.BlockOf(restriction.CellId) == block.Id &&
                block.Find(restriction.CellId) is LandCell cell)
                cell.RestrictionObject = restriction.ObjectId;
        }
    }

    /// <summary>
    /// Shape, place and square of land of a thing outdoors; null when it is left out or not over this block, where retail discards it.
    /// </summary>
    private (SetupAsset Setup, Position Place, LandCell Cell)? Place(
        Landblock block, LeftOutKind kind, uint modelId, in DatFrame frame, LandBlockInfo info, LandblockFaults faults)
    {
        if (assets.FindSetup(modelId, kind, info.Id, faults) is not { } setup) return null;
        if (Seat(kind, modelId, block.Id, frame, info, faults) is not { } place) return null;
        if (block.LandCellUnder(place) is not { } cell) return null;
        place.CellId = cell.Id;
        return (setup, place, cell);
    }

    /// <summary>The place that a record gives to a thing; null when a number of it is not finite and it is left out.</summary>
    private static Position? Seat(LeftOutKind kind, uint modelId, uint cellId, in DatFrame frame, DatRecord record, LandblockFaults faults)
    {
        try
        {
            return new Position(cellId, new RecordFlattener(record).Frame(frame, $"{kind} 0x{modelId:X8}"));
        }
        catch (DatFormatException fault)
        {
            faults.LeaveOut(kind, modelId, record.Id, fault);
            return null;
        }
    }

    private void AddRooms(Landblock block, LandBlockInfo info, StaticOrder order, LandblockFaults faults)
    {
        List<EnvCell> rooms = [];
        uint first = block.Id | CellIds.FirstIndoor, end = first + info.CellCount, missing = 0;
        for (uint id = first; id <= end; id++)
        {
            if (id < end && !TryAddRoom(rooms, block, id, info, order, faults))
            {
                missing++;
            }
            else if (missing > 0)
            {
                faults.LeaveOutMissingRooms(id - missing, missing, info.Id);
                missing = 0;
            }
        }

        block.SetRooms([.. rooms]);
    }

    /// <summary>Adds a room with what stands in it, or leaves it out.</summary>
    /// <returns>False when there is no such record.</returns>
    private bool TryAddRoom(List<EnvCell> rooms, Landblock block, uint id, LandBlockInfo info, StaticOrder order, LandblockFaults faults)
    {
        EnvCellRecord? record;
        EnvCell room;
        try
        {
            if (!cache.Source.TryRead(id, out record)) return false;
            if (!assets.TryGetEnvironment(record.EnvironmentId, out EnvironmentAsset? environment, out Exception? fault))
            {
                faults.LeaveOut(LeftOutKind.Room, id, info.Id, fault);
                return true;
            }

            room = new EnvCell(RoomOf(record, environment));
        }
        catch (DatFormatException fault)
        {
            faults.LeaveOut(LeftOutKind.Room, id, info.Id, fault);
            return true;
        }

        rooms.Add(room);
        foreach (Dats.Records.StaticObject thing in record.StaticObjects)
        {
            if (thing.ObjectId == 0 || assets.FindSetup(thing.ObjectId, LeftOutKind.Object, id, faults) is not { } setup) continue;
            if (Seat(LeftOutKind.Object, thing.ObjectId, id, thing.Frame, record, faults) is { } place)
                block.AddStatic(new StaticObject(setup, place, order.NextInRoom(), room, 1f, assets.FindAnimation(setup, faults)));
        }

        return true;
    }

    private static EnvCellContent RoomOf(EnvCellRecord record, EnvironmentAsset environment)
    {
        RecordFlattener check = new(record);
        uint blockId = CellIds.BlockOf(record.CellId);
        if (environment[record.Structure] is not { } structure)
            throw check.Error($"structure {record.Structure} of environment 0x{environment.Id:X8} does not exist");
        PortalPlane[] portals = new PortalPlane[record.Portals.Length];
        for (int i = 0; i < portals.Length; i++)
        {
            CellPortal portal = record.Portals[i];
            if (!structure.TryFindPortal(portal.Polygon, out int polygon))
                throw check.Error($"portal {i} names polygon {portal.Polygon}, which is no portal of its structure");
            portals[i] = new PortalPlane(
                structure.Portals.PlaneOf(polygon),
                portal.PortalSide,
                portal.IsOutside ? PortalPlane.Outdoors : blockId | portal.OtherCell,
                (short)portal.OtherPortal);
        }

        return new EnvCellContent
        {
            Id = record.Id,
            Frame = check.Frame(record.Position, "the room"),
            Shape = structure,
            Portals = portals,
            StabList = [.. record.VisibleCells.Select(index => blockId | index)],
            SeenOutside = record.Flags.HasFlag(EnvCellFlags.SeenOutside),
            RestrictionObject = record.RestrictionObjectId,
        };
    }

    /// <summary>Numbers statics: those of the land of all blocks, column by column, before those of rooms.</summary>
    private sealed class StaticOrder(uint blockId)
    {
        private const ulong Indoors = 1UL << 63;

        private readonly ulong block = (ulong)(blockId >> 16) << 32;
        private uint next;

        internal ulong NextOnLand() => block | next++;

        internal ulong NextInRoom() => Indoors | block | next++;
    }
}
