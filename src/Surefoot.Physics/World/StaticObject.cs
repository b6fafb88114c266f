using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;

namespace Surefoot.Physics.World;

/// <summary>Something of the dat files that never moves: an object of a landblock or room, a piece of scenery, a building's shell.</summary>
public sealed class StaticObject : WorldObject
{
    internal StaticObject(SetupAsset setup, in Position position, ulong order, ObjCell cell, float scale)
        : base(0, setup, PhysicsState.Default | PhysicsState.Static)
    {
        Scale = scale;
        Order = order;
        SeatAt(position, cell);
    }

    /// <summary>It was strewn by the rules of the terrain, and stands in no record.</summary>
    public bool IsScenery { get; internal init; }

    /// <summary>Its first part is over land that is not loaded; the cells it reaches are known when that is.</summary>
    internal bool LacksGround { get; set; }

    /// <summary>
    /// Place in the order in which statics are tested: land objects and scenery of all landblocks, column by column, then those of rooms. It does not
    /// depend on the order of loading.
    /// </summary>
    internal ulong Order { get; }
}
