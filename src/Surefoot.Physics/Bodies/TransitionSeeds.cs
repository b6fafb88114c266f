using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>
/// What goes from a mover into a transition before it runs, and its two kinds of runs. Nothing here writes to the mover or to the world.
/// </summary>
internal static class TransitionSeeds
{
    private const float PlacementTolerance = 0.05f;

    private static readonly Sphere[] DummySphere = [new(new Vector3(0, 0, 0.1f), 0.1f)];

    /// <summary>Centre of the mover's first sphere in its own frame, by which its cell is found.</summary>
    internal static Vector3 FootOf(WorldObject mover) =>
        mover.Setup is { Spheres.Length: > 0 } setup ? RetailMath.Scale(setup.Spheres[0].Center, mover.Scale) : DummySphere[0].Center;

    /// <summary>Radius of the mover's first sphere, metres.</summary>
    internal static float RadiusOf(WorldObject mover) =>
        mover.Setup is { Spheres.Length: > 0 } setup ? (float)((double)setup.Spheres[0].Radius * mover.Scale) : DummySphere[0].Radius;

    /// <summary>Runs a sweep of a mover from a state to a place; false when no valid position was found.</summary>
    /// <remarks>Retail: CPhysicsObj::transition @0x00512DC0.</remarks>
    internal static bool Sweep(this Transition transition, WorldObject mover, in BodySeat from, ObjCell? cell, in Position to)
    {
        transition.SeedMover(mover, transition.SeedContact(mover, from));
        transition.Path.InitPath(cell, hasBegin: true, from.Position, to);
        transition.Collision.FramesStationaryFall = (from.Transient & TransientState.StationaryStuck) != 0 ? 3
            : (from.Transient & TransientState.StationaryStop) != 0 ? 2
            : (from.Transient & TransientState.StationaryFall) != 0 ? 1 : 0;
        return transition.FindValidPosition();
    }

    /// <summary>
    /// Tries a place for a mover that is seeded. Without sliding the found place must be in the same cell and less than 5 cm east or north
    /// of the one asked for; the test is signed, so any move west or south passes.
    /// </summary>
    /// <remarks>Retail: CPhysicsObj::CheckPositionInternal @0x00511E90.</remarks>
    internal static bool Place(this Transition transition, ObjCell cell, ref Position place, bool slide)
    {
        transition.Path.InitPath(cell, hasBegin: false, default, place);
        if (!slide) transition.Path.PlacementAllowsSliding = false;
        if (!transition.FindValidPosition()) return false;
        if (slide) return true;
        Position found = transition.Path.CurrPos;
        bool near = (double)found.Frame.Origin.X - place.Frame.Origin.X < PlacementTolerance &&
                    (double)found.Frame.Origin.Y - place.Frame.Origin.Y < PlacementTolerance;
        if (!near || transition.Path.CurrCell?.Id != cell.Id) return false;
        place.Frame.Origin = found.Frame.Origin;
        return true;
    }

    internal static void SeedMover(this Transition transition, WorldObject mover, MoverFlags flags)
    {
        transition.Object.Init(mover, flags);
        if (mover.Setup is { Spheres.Length: > 0 } setup) transition.Path.InitSpheres(setup.Spheres, mover.Scale);
        else transition.Path.InitSpheres(DummySphere, 1f);
    }

    /// <summary>
    /// What the mover stands on and slides along goes into the transition; a plane that its velocity leads away from is left behind.
    /// </summary>
    /// <remarks>Retail: CPhysicsObj::get_object_info @0x00511CC0, check_contact @0x0050F5B0.</remarks>
    internal static MoverFlags SeedContact(this Transition transition, WorldObject mover, in BodySeat from)
    {
        MoverFlags flags = MoverFlags.None;
        if (mover.State.Has(PhysicsState.EdgeSlide)) flags |= MoverFlags.EdgeSlide;
        if ((from.Transient & TransientState.Contact) != 0)
        {
            bool water = (from.Transient & TransientState.WaterContact) != 0;
            if (RetailMath.Dot(from.Velocity, from.ContactPlane.Normal) > RetailMath.Epsilon)
            {
                transition.InitLastKnownContactPlane(from.ContactPlaneCellId, from.ContactPlane, water);
            }
            else
            {
                transition.InitContactPlane(from.ContactPlaneCellId, from.ContactPlane, water);
                flags |= MoverFlags.Contact;
                if ((from.Transient & TransientState.OnWalkable) != 0) flags |= MoverFlags.OnWalkable;
            }
        }

        if ((from.Transient & TransientState.Sliding) != 0) transition.Collision.SetSlidingNormal(from.SlidingNormal);
        if (mover.Setup is { AllowFreeHeading: true }) flags |= MoverFlags.FreeRotate;
        if (mover.State.Has(PhysicsState.Missile)) flags |= MoverFlags.PathClipped;
        return flags;
    }
}
