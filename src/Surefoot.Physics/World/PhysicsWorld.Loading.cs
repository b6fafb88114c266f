using Surefoot.Dats;
using Surefoot.Physics.Assets;

namespace Surefoot.Physics.World;

/// <content>What is loaded.</content>
public sealed partial class PhysicsWorld
{
    private readonly LandblockBuilder? builder;
    private ILoadListener? listener;

    /// <summary>Blocks whose faults are in the list: they are counted once, however often a block is loaded.</summary>
    private readonly HashSet<uint> reported = [];

    /// <summary>A world of which nothing is loaded yet.</summary>
    /// <param name="cache">Shapes and records; may be shared with other worlds.</param>
    /// <param name="region">The region; read from the cache's source when not given. May be shared with other worlds.</param>
    /// <exception cref="DatRecordMissingException">There is no region.</exception>
    /// <exception cref="DatFormatException">The region is malformed.</exception>
    internal PhysicsWorld(PhysicsDataCache cache, RegionAsset? region = null)
    {
        Region = region ?? RegionAsset.Load(cache.Source);
        builder = new LandblockBuilder(cache, Region);
    }

    /// <summary>A world without files, for grounds that are made up.</summary>
    internal PhysicsWorld() => Region = new RegionAsset([]);

    /// <summary>What all landblocks share.</summary>
    public RegionAsset Region { get; }

    /// <summary>A landblock with a fault does not load, and loading it throws; see <c>PhysicsEngineOptions.StrictLoading</c>.</summary>
    public bool StrictLoading { get; internal init; }

    /// <summary>Loads a block with all its rooms, buildings, objects and scenery.</summary>
    /// <param name="blockId">Any id of the block.</param>
    /// <returns>
    /// False when the files have no such block, it is off the map, or it cannot be read; <see cref="LeftOut"/> then says why.
    /// </returns>
    /// <exception cref="DatRecordMissingException">
    /// <see cref="StrictLoading"/>: a record that another one promises is missing; nothing was loaded.
    /// </exception>
    /// <exception cref="DatFormatException"><see cref="StrictLoading"/>: a record is malformed; nothing was loaded.</exception>
    public bool LoadLandblock(uint blockId)
    {
        if (FindLandblock(blockId) is not null) return true;
        if (Build(CellIds.BlockOf(blockId)) is not { } block) return false;
        Add(block);
        listener?.OnLandblockLoaded(block);
        return true;
    }

    /// <summary>
    /// Loads the block of a position and those around it, as far as the files have them. A block that cannot be read keeps none of the
    /// others away.
    /// </summary>
    /// <param name="position">The place in the middle.</param>
    /// <param name="radius">How many blocks on each side; 1 is what retail keeps.</param>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative.</exception>
    /// <exception cref="DatRecordMissingException">
    /// <see cref="StrictLoading"/>: a record that another one promises is missing; blocks before it were loaded.
    /// </exception>
    /// <exception cref="DatFormatException"><see cref="StrictLoading"/>: a record is malformed; blocks before it were loaded.</exception>
    public void EnsureLoadedAround(in Position position, int radius)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(radius);
        radius = Math.Min(radius, MapBlocks);
        int x = (int)(position.CellId >> 24), y = (int)((position.CellId >> 16) & 0xFF);
        List<Landblock> added = [];
        try
        {
            for (int i = Math.Max(x - radius, 0); i <= Math.Min(x + radius, MapBlocks - 1); i++)
            {
                for (int j = Math.Max(y - radius, 0); j <= Math.Min(y + radius, MapBlocks - 1); j++)
                {
                    uint id = ((uint)i << 24) | ((uint)j << 16);
                    if (FindLandblock(id) is not null || Build(id) is not { } block) continue;
                    Add(block);
                    added.Add(block);
                }
            }
        }
        finally
        {
            // Bodies come back to land whose neighbours are there.
            foreach (Landblock block in added) listener?.OnLandblockLoaded(block);
        }
    }

    private Landblock? Build(uint blockId)
    {
        LandblockFaults faults = new(StrictLoading);
        Landblock? block = builder?.Build(blockId, faults);
        if (faults.Items.Count > 0 && reported.Add(blockId))
        {
            foreach (LeftOutItem item in faults.Items) LeftOut.Add(item);
        }

        return block;
    }

    /// <summary>Unloads a block. Bodies in it wait until it is loaded again; those near by are no longer listed in it.</summary>
    /// <param name="blockId">Any id of the block.</param>
    /// <returns>False when it was not loaded.</returns>
    public bool UnloadLandblock(uint blockId)
    {
        if (FindLandblock(blockId) is not { } block) return false;
        listener?.OnLandblockUnloading(block.Id);
        foreach (StaticObject item in block.StaticObjects) item.ClearShadows();
        HashSet<StaticObject> reachIn = [];
        foreach (ObjCell cell in block.Cells)
        {
            for (int i = 0; i < cell.ShadowCount; i++)
            {
                WorldObject item = cell.ShadowAt(i);
                if (item is StaticObject neighbour) reachIn.Add(neighbour);
                else waiting.Add(item);
            }

            cell.ReleaseShadows();
        }

        columns[block.Id >> 24]![(block.Id >> 16) & 0xFF] = null;
        blocks.Remove(block.Id);
        foreach (StaticObject item in reachIn) CalcCrossCellsStatic(item);
        return true;
    }

    /// <summary>Makes a finished block part of the world.</summary>
    internal void Add(Landblock block)
    {
        Landblock?[] column = columns[block.Id >> 24] ??= new Landblock?[MapBlocks];
        column[(block.Id >> 16) & 0xFF] = block;
        foreach (StaticObject item in block.StaticObjects) CalcCrossCellsStatic(item);
        foreach (Landblock other in blocks.Values)
        {
            foreach (StaticObject item in other.StaticObjects)
            {
                if (item.LacksGround || !item.IsCompletelyVisible) CalcCrossCellsStatic(item);
            }
        }

        blocks.Add(block.Id, block);
        FillWaitingShadows(block);
    }

    /// <summary>Who is told what is loaded and unloaded: the one engine that owns the world.</summary>
    /// <exception cref="InvalidOperationException">Another one owns it.</exception>
    internal void Attach(ILoadListener owner)
    {
        if (listener is not null) throw new InvalidOperationException("The world belongs to another engine.");
        listener = owner;
    }
}
