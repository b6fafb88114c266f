using System.Diagnostics.CodeAnalysis;
using Surefoot.Physics.Assets;

namespace Surefoot.Physics.World;

/// <summary>
/// Finds the shapes that a world's landblocks name. A record with a fault is read once only, however many things name it.
/// </summary>
internal sealed class AssetFinder(PhysicsDataCache cache)
{
    private readonly Dictionary<uint, Exception> unusable = [];

    /// <summary>The shape of an object; null when it is left out.</summary>
    /// <param name="id">Its model: a setup or a mesh.</param>
    /// <param name="kind">What kind of object.</param>
    /// <param name="firstIn">The record that names it.</param>
    /// <param name="faults">Decides on faults.</param>
    internal SetupAsset? FindSetup(uint id, LeftOutKind kind, uint firstIn, LandblockFaults faults)
    {
        if (TryGet(id, cache.GetSetup, out SetupAsset? setup, out Exception? fault)) return setup;
        faults.LeaveOut(kind, id, firstIn, fault);
        return null;
    }

    /// <summary>
    /// What moves the parts of a static for ever; null for nothing, also when it is left out: the object then stays at its rest pose.
    /// </summary>
    /// <param name="setup">Its shape.</param>
    /// <param name="faults">Decides on faults.</param>
    internal AnimationAsset? FindAnimation(SetupAsset setup, LandblockFaults faults)
    {
        uint id = setup.DefaultAnimationId;
        if (id == 0) return null;
        if (TryGet(id, named => cache.GetDefaultAnimation(named, setup.Id), out AnimationAsset? animation, out Exception? fault))
            return animation;
        faults.LeaveOut(LeftOutKind.Animation, id, setup.Id, fault);
        return null;
    }

    /// <summary>The shapes of rooms, or why they cannot be had.</summary>
    internal bool TryGetEnvironment(
        uint id, [NotNullWhen(true)] out EnvironmentAsset? environment, [NotNullWhen(false)] out Exception? fault) =>
        TryGet(id, cache.GetEnvironment, out environment, out fault);

    private bool TryGet<T>(uint id, Func<uint, T> get, [NotNullWhen(true)] out T? asset, [NotNullWhen(false)] out Exception? fault)
        where T : class
    {
        asset = null;
        if (unusable.TryGetValue(id, out fault)) return false;
        try
        {
            asset = get(id);
            return true;
        }
        catch (Exception thrown) when (LandblockFaults.IsFault(thrown))
        {
            unusable.Add(id, fault = thrown);
            return false;
        }
    }
}
