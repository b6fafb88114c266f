using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// What pages draw of the land. Terrain and shapes may be read on any thread: landblocks are built anew in worlds of their own, as the
/// players' world belongs to its thread; only the assets are shared.
/// </summary>
/// <param name="dats">The files.</param>
/// <param name="cache">Their shapes.</param>
/// <param name="region">Their region.</param>
internal sealed class LandView(DatSet dats, PhysicsDataCache cache, RegionAsset region)
{
    /// <summary>Those places that can be gone to, on the ground where they name no height; somewhere else where there is none.</summary>
    /// <exception cref="DatFolderException">There is no landblock that can be read.</exception>
    public IReadOnlyList<WorkbenchPlace> PlacesOf(IEnumerable<WorkbenchPlace> places)
    {
        PhysicsWorld world = NewWorld();
        WorkbenchPlace[] found =
            [.. places.Where(place => world.LoadLandblock(place.CellId) && world.GetVisible(place.CellId) is not null).Select(OnGround)];
        return found.Length > 0 ? found : [OnGround(KnownPlaces.Somewhere(dats, world.LoadLandblock))];
    }

    /// <summary>The terrain of a landblock as the physics built it, or null where there is none.</summary>
    /// <param name="block">0xXXYY.</param>
    public TerrainBlock? ReadTerrain(ushort block)
    {
        uint blockId = (uint)block << 16;
        LandBlock? record;
        try
        {
            if (!dats.TryRead(blockId | 0xFFFF, out record)) return null;
        }
        catch (DatFormatException)
        {
            return null;
        }

        float[] heights = new float[TerrainSurface.VertexCount];
        for (int i = 0; i < heights.Length; i++) heights[i] = region.HeightTable[record.Heights[i]];
        TerrainSurface surface = new(blockId, heights, record.Terrain.AsSpan());
        bool[] cuts = new bool[TerrainSurface.CellCount];
        for (int cell = 0; cell < cuts.Length; cell++) cuts[cell] = surface.IsCutSouthWestToNorthEast(cell);
        return new TerrainBlock(heights, [.. record.Terrain], cuts);
    }

    /// <summary>What stands on a landblock and under it, or null where there is nothing.</summary>
    /// <param name="block">0xXXYY.</param>
    public BlockShapes? ReadShapes(ushort block)
    {
        uint blockId = (uint)block << 16;
        PhysicsWorld world = NewWorld();
        return world.LoadLandblock(blockId) ? ShapeCollector.Collect(world.FindLandblock(blockId)!) : null;
    }

    /// <summary>Lists the parts near a place that animations move, in the order of their landblocks, objects and parts.</summary>
    /// <param name="land">The players' world.</param>
    /// <param name="from">Where one looks from.</param>
    /// <param name="near">Is filled anew.</param>
    public static void LookAtParts(PhysicsWorld land, in Position from, List<MovingPart> near)
    {
        near.Clear();
        foreach (Landblock block in land.Landblocks)
        {
            for (int i = 0; i < block.AnimatedStatics.Count; i++)
            {
                Physics.World.StaticObject item = block.AnimatedStatics[i];
                if (!ShapeCollector.MovesSolidParts(item) || item.Position.DistanceTo(from) > Sight.ShownWithin) continue;
                foreach (SolidPart part in SolidParts.Of(item))
                    near.Add(new MovingPart((ushort)(block.Id >> 16), (ushort)i, (ushort)part.Index, part.Frame.Origin, part.Frame.Rotation,
                        part.Scale));
            }
        }
    }

    /// <summary>Is a cell a room from which the land is not seen?</summary>
    public static bool IsEnclosed(PhysicsWorld land, uint cellId) =>
        land.GetVisible(cellId) is Physics.World.EnvCell { SeenOutside: false };

    private PhysicsWorld NewWorld() => new PhysicsEngine(cache, new PhysicsEngineOptions { Region = region }).World;

    /// <summary>An outdoor place without a height is put on the ground.</summary>
    private WorkbenchPlace OnGround(WorkbenchPlace place)
    {
        if (!float.IsNaN(place.Position.Z)) return place;
        float z = 0;
        if (ReadTerrain((ushort)(place.CellId >> 16)) is { } terrain)
            new TerrainSurface(place.CellId, terrain.Heights, terrain.Terrain).TryGetHeight(place.Position.X, place.Position.Y, out z);
        return place with { Position = place.Position with { Z = z } };
    }
}
