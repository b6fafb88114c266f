using System.Numerics;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.World;

/// <summary>A cell of the world that bodies can be in: a square of land or a room.</summary>
/// <remarks>Retail: CObjCell.</remarks>
public abstract class ObjCell
{
    /// <summary>A cell with this id.</summary>
    protected ObjCell(uint id) => Id = id;

    /// <summary>Cell id.</summary>
    public uint Id { get; }

    /// <summary>Tests the spheres of the transition's check position against everything in this cell.</summary>
    internal abstract TransitionState FindCollisions(Transition transition);

    /// <summary>True when a point, in this cell's block frame, belongs to the cell.</summary>
    internal abstract bool PointInCell(in Vector3 point);
}
