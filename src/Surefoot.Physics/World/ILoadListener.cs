namespace Surefoot.Physics.World;

/// <summary>Is told what a world loads and unloads.</summary>
internal interface ILoadListener
{
    /// <summary>A landblock was loaded, and what comes with it.</summary>
    /// <param name="block">The landblock.</param>
    void OnLandblockLoaded(Landblock block);

    /// <summary>A landblock is about to go away.</summary>
    /// <param name="blockId">The landblock, 0xXXYY0000.</param>
    void OnLandblockUnloading(uint blockId);
}
