namespace Surefoot.Physics.World;

/// <content>What is loaded.</content>
public sealed partial class PhysicsWorld
{
    /// <summary>Unloads a block. Bodies in it are told by <see cref="LandblockUnloading"/> before; those near by are no longer listed in it.</summary>
    /// <param name="blockId">Any id of the block.</param>
    /// <returns>False when it was not loaded.</returns>
    public bool UnloadLandblock(uint blockId)
    {
        if (FindLandblock(blockId) is not { } block) return false;
        LandblockUnloading?.Invoke(block.Id);
        foreach (StaticObject item in block.StaticObjects) RemoveShadows(item);
        foreach (ObjCell cell in block.Cells)
        {
            for (int i = 0; i < cell.ShadowCount; i++)
            {
                if (cell.ShadowAt(i) is not StaticObject) waiting.Add(cell.ShadowAt(i));
            }

            cell.ReleaseShadows();
        }

        columns[block.Id >> 24]![(block.Id >> 16) & 0xFF] = null;
        blocks.Remove(block.Id);
        return true;
    }

    /// <summary>Makes a finished block part of the world.</summary>
    internal void Add(Landblock block)
    {
        Landblock?[] column = columns[block.Id >> 24] ??= new Landblock?[MapBlocks];
        column[(block.Id >> 16) & 0xFF] = block;
        blocks.Add(block.Id, block);
        FillWaitingShadows(block);
        LandblockLoaded?.Invoke(block.Id);
    }
}
