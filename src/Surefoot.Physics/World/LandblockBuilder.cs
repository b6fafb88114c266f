using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using EnvCellRecord = Surefoot.Dats.Records.EnvCell;

namespace Surefoot.Physics.World;

/// <summary>Makes a landblock from its records. Nothing is changed anywhere until it is complete.</summary>
/// <remarks>Retail spreads this over CLandBlock::UnPack @0x0052F310, init_buildings @0x0052FD80 and init_static_objs @0x00530A40; specification 05, 4.7.</remarks>
internal sealed class LandblockBuilder(PhysicsDataCache cache, RegionAsset region)
{
    private const int MaxRooms = 0xFFFE - (int)CellIds.FirstIndoor;

    /// <summary>The block of an id; null when the files have none.</summary>
    /// <exception cref="DatRecordMissingException">A record that another one promises is missing.</exception>
    /// <exception cref="DatFormatException">A record is malformed, or names something that does not exist.</exception>
    internal Landblock? Build(uint blockId)
    {
        if (!CellIds.TryBlockCorner(blockId | 1, out _, out _)) return null;
        uint recordId = CellIds.LandblockRecord(blockId), infoId = CellIds.LandblockInfoRecord(blockId);
        if (!cache.Source.TryRead(recordId, out LandBlock? record)) return null;

        float[] heights = new float[TerrainSurface.VertexCount];
        for (int i = 0; i < heights.Length; i++) heights[i] = region.HeightTable[record.Heights[i]];
        Landblock block = new(new TerrainSurface(blockId, heights, record.Terrain.AsSpan()));
        LandBlockInfo? info = record.HasInfo ? cache.Source.Read<LandBlockInfo>(infoId, recordId) : null;
        StaticOrder order = new(block.Id);
        if (info is not null) AddContents(block, info, order);
        foreach (SceneryItem item in Scenery.Of(block, region, cache))
            block.AddStatic(new StaticObject(item.Setup, new Position(item.Cell.Id, item.Frame), order.NextOnLand(), item.Cell, item.Scale) { IsScenery = true });
        if (info is not null) AddRooms(block, info, order);
        return block;
    }

    private void AddContents(Landblock block, LandBlockInfo info, StaticOrder order)
    {
        RecordFlattener check = new(info.Id);
        foreach (Building building in info.Buildings)
        {
            if (FindSetup(building.ModelId) is not { } setup) continue;
            Position place = new(block.Id, check.Frame(building.Frame, $"the frame of building 0x{building.ModelId:X8}"));
            if (block.LandCellUnder(place) is not { } cell) continue;
            place.CellId = cell.Id;
            StaticObject shell = new(setup, place, order.NextOnLand(), cell, 1f);
            BuildingPortal[] portals = [.. building.Portals.Select(p => new BuildingPortal(block.Id | p.OtherCell, (short)p.OtherPortal))];
            block.AddBuilding(cell, new BuildingObject(shell, portals));
        }

        foreach (Dats.Records.StaticObject thing in info.Objects)
        {
            if (FindSetup(thing.ObjectId) is not { } setup) continue;
            Position place = new(block.Id, check.Frame(thing.Frame, $"the frame of object 0x{thing.ObjectId:X8}"));
            if (block.LandCellUnder(place) is not { } cell) continue;
            place.CellId = cell.Id;
            block.AddStatic(new StaticObject(setup, place, order.NextOnLand(), cell, 1f));
        }

        foreach (CellRestriction restriction in info.Restrictions)
        {
            if (restriction.ObjectId != 0 && CellIds.BlockOf(restriction.CellId) == block.Id && block.Find(restriction.CellId) is LandCell cell)
                cell.RestrictionObject = restriction.ObjectId;
        }
    }

    private void AddRooms(Landblock block, LandBlockInfo info, StaticOrder order)
    {
        if (info.CellCount > MaxRooms) throw new DatFormatException("", info.Id, 4, $"{info.CellCount} rooms; a block has at most {MaxRooms}");
        List<EnvCell> rooms = [];
        for (uint i = 0; i < info.CellCount; i++)
        {
            EnvCellRecord record = cache.Source.Read<EnvCellRecord>(block.Id | (CellIds.FirstIndoor + i), info.Id);
            EnvCell room = new(RoomOf(record));
            rooms.Add(room);
            RecordFlattener check = new(record.Id);
            foreach (Dats.Records.StaticObject thing in record.StaticObjects)
            {
                if (thing.ObjectId == 0 || FindSetup(thing.ObjectId) is not { } setup) continue;
                Position place = new(room.Id, check.Frame(thing.Frame, $"the frame of object 0x{thing.ObjectId:X8}"));
                block.AddStatic(new StaticObject(setup, place, order.NextInRoom(), room, 1f));
            }
        }

        block.SetRooms([.. rooms]);
    }

    private EnvCellContent RoomOf(EnvCellRecord record)
    {
        uint blockId = CellIds.BlockOf(record.CellId);
        EnvironmentAsset environment = cache.GetEnvironment(record.EnvironmentId);
        if (environment[record.Structure] is not { } structure)
            throw new DatFormatException("", record.Id, 0, $"structure {record.Structure} of environment 0x{environment.Id:X8} does not exist");
        PortalPlane[] portals = new PortalPlane[record.Portals.Length];
        for (int i = 0; i < portals.Length; i++)
        {
            CellPortal portal = record.Portals[i];
            if (!structure.TryFindPortal(portal.Polygon, out int polygon))
                throw new DatFormatException("", record.Id, 0, $"portal {i} names polygon {portal.Polygon}, which is no portal of its structure");
            portals[i] = new PortalPlane(
                structure.Portals.PlaneOf(polygon),
                portal.PortalSide,
                portal.IsOutside ? PortalPlane.Outdoors : blockId | portal.OtherCell,
                (short)portal.OtherPortal);
        }

        return new EnvCellContent
        {
            Id = record.Id,
            Frame = new RecordFlattener(record.Id).Frame(record.Position, "the position"),
            Shape = structure,
            Portals = portals,
            StabList = [.. record.VisibleCells.Select(index => blockId | index)],
            SeenOutside = record.Flags.HasFlag(EnvCellFlags.SeenOutside),
            RestrictionObject = record.RestrictionObjectId,
        };
    }

    /// <summary>The shape of an object; null when there is no record with its id, which leaves the object out.</summary>
    private SetupAsset? FindSetup(uint id)
    {
        try
        {
            return cache.GetSetup(id);
        }
        catch (DatRecordMissingException missing) when (missing.Id == id)
        {
            return null;
        }
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
