using Surefoot.Physics.World;

namespace Surefoot.Client;

/// <summary>
/// Keeps the land around the local player loaded, a landblock ahead of where it can go, and forgets what it has left behind. Objects wait
/// on land that is not loaded.
/// </summary>
/// <param name="world">The world.</param>
/// <param name="ahead">Landblocks loaded around the player's in each direction.</param>
/// <param name="kept">Landblocks that stay loaded around it.</param>
internal sealed class LoadedLand(PhysicsWorld world, int ahead, int kept)
{
    private readonly List<uint> leaving = [];
    private uint? centre;

    /// <summary>Loads what is around a place; looks only when that is in another landblock than the last one.</summary>
    public void Follow(in Position place)
    {
        uint block = CellIds.BlockOf(place.CellId);
        if (place.CellId == 0 || block == centre) return;
        centre = block;
        world.EnsureLoadedAround(place, ahead);
        leaving.Clear();
        foreach (Landblock loaded in world.Landblocks)
            if (!IsKept(loaded.Id, block)) leaving.Add(loaded.Id);
        foreach (uint id in leaving) world.UnloadLandblock(id);
    }

    private bool IsKept(uint block, uint middle) =>
        Math.Abs((int)(block >> 24) - (int)(middle >> 24)) <= kept &&
        Math.Abs((int)((block >> 16) & 0xFF) - (int)((middle >> 16) & 0xFF)) <= kept;
}
