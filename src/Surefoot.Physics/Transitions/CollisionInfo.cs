using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>What a transition met: contact plane, sliding normal, collision normal, objects.</summary>
/// <remarks>Retail: COLLISIONINFO.</remarks>
internal sealed class CollisionInfo
{
    private WorldObject[] objects = new WorldObject[8];

    /// <summary>True when the body rests on <see cref="ContactPlane"/> in this sub-step.</summary>
    public bool ContactPlaneValid { get; set; }

    /// <summary>The plane rested on, in the block frame of <see cref="ContactPlaneCellId"/>.</summary>
    public Plane ContactPlane { get; set; }

    /// <summary>The contact plane is water, or another body.</summary>
    public bool ContactPlaneIsWater { get; set; }

    /// <summary>Cell whose block frame the contact plane is in.</summary>
    public uint ContactPlaneCellId { get; set; }

    /// <summary>True when the last accepted sub-step rested on something.</summary>
    public bool LastKnownContactPlaneValid { get; set; }

    /// <summary>Contact plane of the last accepted sub-step.</summary>
    public Plane LastKnownContactPlane { get; set; }

    /// <summary>Water flag of the last accepted sub-step.</summary>
    public bool LastKnownContactPlaneIsWater { get; set; }

    /// <summary>Cell of the last accepted sub-step's contact plane.</summary>
    public uint LastKnownContactPlaneCellId { get; set; }

    /// <summary>True while a wall is slid along; the normal may still be zero.</summary>
    public bool SlidingNormalValid { get; set; }

    /// <summary>Horizontal unit normal of the wall slid along, or zero.</summary>
    public Vector3 SlidingNormal { get; private set; }

    /// <summary>True once anything was hit in this transition.</summary>
    public bool CollisionNormalValid { get; set; }

    /// <summary>Unit normal of the last hit of the whole transition.</summary>
    public Vector3 CollisionNormal { get; private set; }

    /// <summary>Terrain, a building, a room or a static object was hit by a mover without contact.</summary>
    public bool CollidedWithEnvironment { get; set; }

    /// <summary>
    /// The mover loses its velocity, wherever it ends and even if it stays where it began: a sub-step was taken back while it rested on
    /// something, or a landing was refused. Whoever ran the transition for a live body stops that body before anything else.
    /// </summary>
    /// <remarks>
    /// Retail: OBJECTINFO::kill_velocity @0x0050CFE0, which stops the body at once. Nothing in a transition reads the body's velocity, so
    /// it makes no difference to wait for the end; and a sweep that only asks changes nobody.
    /// </remarks>
    public bool StopsMover { get; internal set; }

    /// <summary>How many quanta in a row the body failed to move, 0 to 3.</summary>
    public int FramesStationaryFall { get; set; }

    /// <summary>Number of distinct objects met.</summary>
    public int ObjectCount { get; private set; }

    /// <summary>The distinct objects met, in order.</summary>
    public ReadOnlySpan<WorldObject> Objects => objects.AsSpan(0, ObjectCount);

    /// <summary>Forgets a transition; planes and normals become zero, as in a client that has just started.</summary>
    internal void Reset()
    {
        Clear();
        ContactPlane = LastKnownContactPlane = default;
        SlidingNormal = CollisionNormal = default;
        ContactPlaneIsWater = LastKnownContactPlaneIsWater = false;
        LastKnownContactPlaneCellId = 0;
        StopsMover = false;
    }

    /// <summary>Clears the record between two attempts to place a body; what was decided about its velocity stays.</summary>
    /// <remarks>Retail: COLLISIONINFO::init @0x00509D60.</remarks>
    internal void Clear()
    {
        ContactPlaneValid = LastKnownContactPlaneValid = SlidingNormalValid = CollisionNormalValid = false;
        Array.Clear(objects, 0, ObjectCount);
        ObjectCount = 0;
        CollidedWithEnvironment = false;
        ContactPlaneCellId = 0;
        FramesStationaryFall = 0;
    }

    /// <summary>Takes a contact plane; the caller says right after whose block frame it is in.</summary>
    /// <remarks>Retail: COLLISIONINFO::set_contact_plane @0x00509D80.</remarks>
    public void SetContactPlane(in Plane plane, bool isWater)
    {
        ContactPlaneValid = true;
        ContactPlane = plane;
        ContactPlaneIsWater = isWater;
    }

    /// <summary>Takes a contact plane in the block frame of a cell.</summary>
    public void SetContactPlane(in Plane plane, bool isWater, uint cellId)
    {
        SetContactPlane(plane, isWater);
        ContactPlaneCellId = cellId;
    }

    /// <summary>The contact plane no longer holds.</summary>
    public void VoidContactPlane()
    {
        ContactPlaneValid = false;
        ContactPlaneIsWater = false;
    }

    /// <summary>Takes the unit vector of <paramref name="normal"/>, or zero when it is too small to have a direction.</summary>
    /// <remarks>Retail: COLLISIONINFO::set_collision_normal @0x0050A000.</remarks>
    public void SetCollisionNormal(Vector3 normal)
    {
        CollisionNormalValid = true;
        CollisionNormal = RetailMath.NormalizeCheckSmall(ref normal) ? Vector3.Zero : normal;
    }

    /// <summary>
    /// Takes the horizontal part of <paramref name="normal"/> made unit; a vertical one becomes zero, which blocks nothing.
    /// </summary>
    /// <remarks>Retail: COLLISIONINFO::set_sliding_normal @0x0050A060.</remarks>
    public void SetSlidingNormal(Vector3 normal)
    {
        SlidingNormalValid = true;
        normal.Z = 0;
        SlidingNormal = RetailMath.NormalizeCheckSmall(ref normal) ? Vector3.Zero : normal;
    }

    /// <summary>Lists an object once.</summary>
    /// <remarks>Retail: COLLISIONINFO::add_object @0x006B4E20.</remarks>
    internal void AddObject(WorldObject item)
    {
        for (int i = 0; i < ObjectCount; i++)
            if (ReferenceEquals(objects[i], item)) return;
        if (ObjectCount == objects.Length) Array.Resize(ref objects, ObjectCount * 2);
        objects[ObjectCount++] = item;
    }
}
