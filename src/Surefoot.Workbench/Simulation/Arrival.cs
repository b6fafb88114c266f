using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>Why a player cannot be put at a place.</summary>
internal enum PlaceRefusal : byte
{
    None = 0,

    /// <summary>The files have no such cell.</summary>
    NoSuchCell = 1,

    /// <summary>Outside the map.</summary>
    OutsideMap = 2,

    /// <summary>In none of the rooms around the one named.</summary>
    OutsideRooms = 3,

    /// <summary>Under the ground, where one would fall for ever.</summary>
    UnderGround = 4,

    /// <summary>Farther up than anything in the world.</summary>
    TooHigh = 5,

    /// <summary>Something is in the way.</summary>
    NoRoom = 6,
}

/// <summary>
/// Finds where a player is put who asks for a place: in the right cell, on the ground when no height is given, beside other players.
/// </summary>
/// <param name="engine">The world.</param>
/// <param name="land">Its landblocks.</param>
/// <param name="shape">A player's shape.</param>
/// <param name="load">Loads what a player in a cell may reach.</param>
internal sealed class Arrival(PhysicsEngine engine, PhysicsWorld land, SetupAsset shape, Action<uint> load)
{
    // The lowest one stands below terrain: knee-deep to the waist in water.
    private const float DeepestFeet = 1.5f;
    private const float Highest = 2000f;

    // Two bodies side by side, and a little air.
    private const float Apart = 1.2f, Touching = 1f, Story = 2f;
    private const int Rings = 3;

    private static readonly WeenieTraits Player = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;

    /// <summary>The position that a place stands for; loads what is around it.</summary>
    /// <param name="place">What was asked for.</param>
    /// <param name="position">Where that is.</param>
    /// <returns><see cref="PlaceRefusal.None"/>, or why nobody can be there.</returns>
    public PlaceRefusal Find(WorkbenchPlace place, out Position position)
    {
        position = SimulatedPlayer.PositionOf(place);
        bool onGround = float.IsNaN(position.Frame.Origin.Z);
        if (onGround) position.Frame.Origin.Z = 0;
        if (!CellIds.HasValidIndex(position.CellId)) return PlaceRefusal.NoSuchCell;
        if (Math.Abs(position.Frame.Origin.Z) > Highest) return PlaceRefusal.TooHigh;
        return CellIds.IsOutdoor(position.CellId) ? FindOutdoors(ref position, onGround) : FindRoom(ref position, onGround);
    }

    /// <summary>
    /// The nearest place around one that none of these players takes and that can be walked to from there; that one itself when there is
    /// none.
    /// </summary>
    /// <param name="wanted">Where a player wants to be.</param>
    /// <param name="others">The other players.</param>
    public Position Beside(in Position wanted, IReadOnlyList<PhysicsBody> others)
    {
        if (IsFree(wanted, others)) return wanted;
        for (int ring = 1; ring <= Rings; ring++)
        {
            int spots = 8 * ring;
            for (int i = 0; i < spots; i++)
            {
                (double sin, double cos) = Math.SinCos(Math.Tau * i / spots);
                Position aside = wanted;
                // To the right of the one who is there at first: nobody is hidden behind another.
                aside.Frame.Origin += aside.Frame.LocalToGlobalVector(new Vector3((float)cos, (float)sin, 0)) * (Apart * ring);
                if (WalkTo(wanted, aside) is { } there && IsFree(there, others)) return there;
            }
        }

        return wanted;
    }

    private static bool IsFree(Position position, IReadOnlyList<PhysicsBody> others)
    {
        foreach (PhysicsBody other in others)
        {
            Vector3 offset = position.OffsetTo(other.Position);
            if (other.HasCell && Math.Abs(offset.Z) < Story && new Vector2(offset.X, offset.Y).Length() < Touching) return false;
        }

        return true;
    }

    private Position? WalkTo(in Position from, in Position to)
    {
        SweepResult walk = engine.Resolve(shape, from, to, weenie: Player);
        if (!walk.Found || walk.Position.HorizontalDistanceTo(to) > 0.1) return null;
        return new Position(walk.Position.CellId, new Frame(walk.Position.Frame.Origin, from.Frame.Rotation));
    }

    private PlaceRefusal FindOutdoors(ref Position position, bool onGround)
    {
        if (!position.AdjustToOutside()) return PlaceRefusal.OutsideMap;
        load(position.CellId);
        if (land.GetVisible(position.CellId) is null || land.FindLandblock(position.CellId) is not { } block)
            return PlaceRefusal.NoSuchCell;
        Vector3 origin = position.Frame.Origin;
        if (!block.Terrain.TryGetHeight(origin.X, origin.Y, out float ground)) return PlaceRefusal.None;
        if (onGround) position.Frame.Origin.Z = ground;
        else if (origin.Z < ground - DeepestFeet) return PlaceRefusal.UnderGround;
        return PlaceRefusal.None;
    }

    private PlaceRefusal FindRoom(ref Position position, bool onGround)
    {
        if (onGround || !CellIds.IsValid(position.CellId)) return PlaceRefusal.NoSuchCell;
        load(position.CellId);
        if (land.GetVisible(position.CellId) is null) return PlaceRefusal.NoSuchCell;
        Vector3 foot = shape.Spheres.Length > 0 ? shape.Spheres[0].Center : Vector3.Zero;
        bool found = land.AdjustPosition(ref position, foot, out ObjCell? cell) && cell is not null;
        if (!found) return PlaceRefusal.OutsideRooms;
        return CellIds.IsOutdoor(position.CellId) ? FindOutdoors(ref position, onGround: false) : PlaceRefusal.None;
    }
}
