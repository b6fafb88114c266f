using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Motion;

/// <summary>
/// The statics that an engine animates: those of the landblocks that are loaded. The many that have no animation cost nothing.
/// </summary>
/// <remarks>Retail: the list of CPhysics::AddStaticAnimatingObject @0x00509AF0 and RemoveStaticAnimatingObject @0x00509760.</remarks>
internal sealed class StaticAnimations
{
    private readonly List<AnimatedStatic> all = [];

    /// <summary>A landblock was loaded.</summary>
    internal void Add(Landblock block, ICellWorld cells, double now)
    {
        foreach (StaticObject item in block.AnimatedStatics) all.Add(new AnimatedStatic(item, cells, now));
    }

    /// <summary>A landblock goes away.</summary>
    /// <param name="blockId">0xXXYY0000.</param>
    internal void Remove(uint blockId) => all.RemoveAll(one => one.BlockId == blockId);

    /// <summary>Brings all of them to a time, seconds.</summary>
    internal void Animate(double now)
    {
        foreach (AnimatedStatic one in all) one.Animate(now);
    }

    /// <summary>Adds what is state to a hash, in an order that does not depend on that of loading.</summary>
    internal void AddTo(ref StateHash hash)
    {
        foreach (AnimatedStatic one in all.OrderBy(one => one.Order)) one.AddTo(ref hash);
    }
}
