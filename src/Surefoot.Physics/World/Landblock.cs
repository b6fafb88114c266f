namespace Surefoot.Physics.World;

/// <summary>
/// One loaded landblock: its ground, all its rooms, its buildings and its static objects. Loaded and unloaded as a whole.
/// </summary>
/// <remarks>Retail: CLandBlock.</remarks>
public sealed class Landblock
{
    private readonly LandCell[] land = new LandCell[TerrainSurface.CellCount];
    private readonly List<StaticObject> statics = [];
    private readonly List<StaticObject> animated = [];
    private readonly List<BuildingObject> buildings = [];
    private EnvCell[] rooms = [];

    /// <summary>Rooms by their index; null where one is left out.</summary>
    private EnvCell?[] roomsByIndex = [];

    internal Landblock(TerrainSurface terrain)
    {
        Terrain = terrain;
        for (int i = 0; i < land.Length; i++) land[i] = new LandCell(this, i);
    }

    /// <summary>The block, 0xXXYY0000.</summary>
    public uint Id => Terrain.BlockId;

    /// <summary>The ground.</summary>
    public TerrainSurface Terrain { get; }

    /// <summary>The 64 squares of land, index 8·column + row.</summary>
    internal ReadOnlySpan<LandCell> LandCells => land;

    /// <summary>The rooms, ascending by id; those that are left out are not among them.</summary>
    public ReadOnlySpan<EnvCell> Rooms => rooms;

    /// <summary>Objects of the block, then its scenery, then the objects of its rooms.</summary>
    public IReadOnlyList<StaticObject> StaticObjects => statics;

    /// <summary>Those of the block's statics, shells of buildings among them, whose parts an animation moves.</summary>
    public IReadOnlyList<StaticObject> AnimatedStatics => animated;

    /// <summary>Buildings, also those that share a cell with an earlier one and are never asked.</summary>
    public IReadOnlyList<BuildingObject> Buildings => buildings;

    /// <summary>A cell of the block, null when it has none with this index.</summary>
    internal ObjCell? Find(uint cellId)
    {
        uint index = cellId & 0xFFFF;
        if (index >= CellIds.FirstIndoor)
            return index - CellIds.FirstIndoor < (uint)roomsByIndex.Length ? roomsByIndex[index - CellIds.FirstIndoor] : null;
        return index - 1 < TerrainSurface.CellCount ? land[index - 1] : null;
    }

    /// <summary>
    /// The square of land of this block under a place given in its coordinates, null when the place is over another block.
    /// </summary>
    internal LandCell? LandCellUnder(in Position place)
    {
        uint id = CellIds.LandblockRecord(Id);
        var point = place.Frame.Origin;
        return CellIds.AdjustToOutside(ref id, ref point) && CellIds.BlockOf(id) == Id ? land[CellIds.LandIndex(id)] : null;
    }

    /// <summary>Makes these the rooms.</summary>
    /// <param name="cells">Ascending by id; there may be gaps.</param>
    internal void SetRooms(EnvCell[] cells)
    {
        rooms = cells;
        roomsByIndex = new EnvCell?[cells.Length == 0 ? 0 : IndexOf(cells[^1].Id) + 1];
        foreach (EnvCell room in cells) roomsByIndex[IndexOf(room.Id)] = room;

        static int IndexOf(uint roomId) => (int)((roomId & 0xFFFF) - CellIds.FirstIndoor);
    }

    /// <summary>Adds a building to the cell under its origin; the first building of a cell wins.</summary>
    /// <remarks>Retail: CLandBlock::init_buildings @0x0052FD80, CSortCell::add_building @0x00534030.</remarks>
    internal void AddBuilding(LandCell cell, BuildingObject building)
    {
        buildings.Add(building);
        if (building.Shell.Animation is not null) animated.Add(building.Shell);
        cell.Building ??= building;
    }

    internal void AddStatic(StaticObject item)
    {
        statics.Add(item);
        if (item.Animation is not null) animated.Add(item);
    }

    /// <summary>Every cell of the block: land by index, then rooms by id.</summary>
    internal IEnumerable<ObjCell> Cells => land.Concat<ObjCell>(rooms);
}
