using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Queries;

/// <summary>A sphere in a world.</summary>
/// <param name="CellId">
/// A cell of its landblock, in whose coordinates the sphere is; for a sphere in a room, that room or one near by.
/// </param>
/// <param name="Sphere">The sphere, metres, block coordinates.</param>
public readonly record struct SphereInput(uint CellId, Sphere Sphere)
{
    /// <summary>A body that does not count: the one that asks.</summary>
    public PhysicsBody? Except { get; init; }
}

/// <summary>What a sphere in a world reaches into.</summary>
/// <param name="Overlaps">It reaches into something solid.</param>
/// <param name="IsLoaded">False when it reaches into a cell that is not loaded: nothing is known of what is there.</param>
/// <param name="CellId">The cell that its centre is in; 0 when that is not known.</param>
/// <param name="Subject">What it reaches into, the first thing that is found.</param>
public readonly record struct SphereOverlap(bool Overlaps, bool IsLoaded, uint CellId, TraceSubject Subject);

/// <summary>A point in a world.</summary>
/// <param name="CellId">
/// A cell of its landblock, in whose coordinates the point is; for a point in a room, that room or one near by.
/// </param>
/// <param name="Point">The point, metres, block coordinates.</param>
public readonly record struct PointInput(uint CellId, Vector3 Point)
{
    /// <summary>A body that does not count: the one that asks.</summary>
    public PhysicsBody? Except { get; init; }
}

/// <summary>What is at a point of a world.</summary>
/// <param name="IsSolid">The point is in the ground, in the walls of a building or room, or in an object.</param>
/// <param name="IsLoaded">False when its cell is not loaded: nothing is known of what is there.</param>
/// <param name="CellId">The cell that it is in; 0 when that is not known.</param>
/// <param name="Subject">What it is in.</param>
public readonly record struct PointOverlap(bool IsSolid, bool IsLoaded, uint CellId, TraceSubject Subject);
