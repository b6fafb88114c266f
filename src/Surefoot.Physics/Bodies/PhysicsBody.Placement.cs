using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>How a body is to be put somewhere.</summary>
[Flags]
public enum PlacementFlags
{
    /// <summary>Exactly there, or not at all.</summary>
    None = 0,

    /// <summary>Informational.</summary>
    Placement = 0x1,

    /// <summary>Informational.</summary>
    Teleport = 0x2,

    /// <summary>The search may move the body to a free place near by.</summary>
    Slide = 0x10,

    /// <summary>Cells that are not resident are not created.</summary>
    DoNotCreateCells = 0x20,

    /// <summary>On failure try scattered positions.</summary>
    Scatter = 0x100,

    /// <summary>Only scattered positions.</summary>
    RandomScatter = 0x200,

    /// <summary>A server would be told.</summary>
    SendPositionEvent = 0x1000,
}

/// <summary>Outcome of a placement.</summary>
public enum PlacementResult
{
    /// <summary>Placed, or parked because the cell is not loaded.</summary>
    OK = 0,

    /// <summary>Could not be tried.</summary>
    GeneralFailure = 1,

    /// <summary>No free place.</summary>
    NoValidPosition = 2,

    /// <summary>No cell.</summary>
    NoCell = 3,

    /// <summary>No free place, and a collision was reported.</summary>
    Collided = 4,
}

/// <summary>A request to put a body somewhere.</summary>
/// <param name="Position">Where.</param>
/// <param name="Flags">How.</param>
/// <param name="RadiusX">Reach of scattered positions east and west, metres.</param>
/// <param name="RadiusY">Reach of scattered positions north and south, metres.</param>
/// <param name="Tries">How many scattered positions are tried.</param>
public readonly record struct PlacementRequest(
    Position Position, PlacementFlags Flags = PlacementFlags.None, float RadiusX = 0, float RadiusY = 0, int Tries = 0);

/// <content>Putting a body somewhere.</content>
public sealed partial class PhysicsBody
{
    /// <summary>Puts the body somewhere. No contact and no wall of where it was is taken along.</summary>
    /// <exception cref="ArgumentException">
    /// The position or a radius is not finite, or the id cannot name a cell; nothing has changed.
    /// </exception>
    /// <exception cref="InvalidOperationException">The body was removed from its engine.</exception>
    /// <remarks>Retail: CPhysicsObj::SetPosition @0x005160C0.</remarks>
    public PlacementResult SetPosition(in PlacementRequest request)
    {
        ThrowIfBad(request.Position);
        ThrowIfRemoved();
        if (!float.IsFinite(request.RadiusX) || !float.IsFinite(request.RadiusY)) throw new ArgumentException("A scatter radius is not finite.", nameof(request));
        return Place(request);
    }

    private PlacementResult Place(in PlacementRequest request)
    {
        if (!engine.Transitions.TryRent(out Transition? transition, Trace)) return PlacementResult.GeneralFailure;
        transition.SeedMover(this, MoverFlags.None);
        PlacementResult result;
        if ((request.Flags & PlacementFlags.RandomScatter) != 0)
        {
            result = Scatter(request, transition);
        }
        else
        {
            result = PlaceAt(request.Position, request.Flags, transition);
            if (result != PlacementResult.OK && (request.Flags & PlacementFlags.Scatter) != 0) result = Scatter(request, transition);
        }

        engine.Transitions.Return();
        return result;
    }

    /// <summary>Puts the body somewhere as a server's correction does.</summary>
    /// <param name="position">Where.</param>
    /// <param name="sliding">The body may be moved to a free place near by.</param>
    /// <remarks>Retail: CPhysicsObj::SetPositionSimple @0x005162B0.</remarks>
    public PlacementResult SetPositionSimple(in Position position, bool sliding) => SetPosition(new PlacementRequest(
        position, PlacementFlags.Teleport | PlacementFlags.SendPositionEvent | (sliding ? PlacementFlags.Slide : PlacementFlags.None)));

    /// <remarks>Retail: CPhysicsObj::SetScatterPositionInternal @0x00515F00. The transition is not reset between tries.</remarks>
    private PlacementResult Scatter(in PlacementRequest request, Transition transition)
    {
        PlacementResult result = PlacementResult.GeneralFailure;
        for (int i = 0; i < request.Tries && result != PlacementResult.OK; i++)
        {
            Position place = request.Position;
            double rollX = engine.NextRoll(), rollY = engine.NextRoll();
            place.Frame.Origin.X = (float)((float)(rollX * request.RadiusX) + (double)place.Frame.Origin.X);
            place.Frame.Origin.Y = (float)((rollY * request.RadiusY) + place.Frame.Origin.Y);
            result = PlaceAt(place, request.Flags, transition);
        }

        return result;
    }

    /// <remarks>Retail: CPhysicsObj::SetPositionInternal(pos, sps, transit) @0x00515BD0.</remarks>
    private PlacementResult PlaceAt(Position place, PlacementFlags flags, Transition transition)
    {
        if (Cell is null) PrepareToEnterWorld();
        engine.Cells.AdjustPosition(ref place, TransitionSeeds.FootOf(this), out ObjCell? cell);
        if (cell is null)
        {
            GoToLostCell(place);
            return PlacementResult.OK;
        }

        if (HangsWhereItIsPut(Weenie)) return ForceIntoCell(cell, place);
        if ((flags & PlacementFlags.DoNotCreateCells) != 0) transition.Cells.DoNotLoadCells = true;
        bool free = transition.Place(cell, ref place, (flags & PlacementFlags.Slide) != 0);
        TakeStop(transition);
        if (!free)
            return HandleAllCollisions(transition.Collision, false, false, updateTime) ? PlacementResult.Collided : PlacementResult.NoValidPosition;
        if (transition.Path.CurrCell is null) return PlacementResult.NoCell;
        Commit(transition, updateTime);
        return PlacementResult.OK;
    }

    /// <summary>Puts hooks, chests and corpses where they are told, without contact: they hang there.</summary>
    /// <remarks>Retail: CPhysicsObj::ForceIntoCell @0x00515660.</remarks>
    private PlacementResult ForceIntoCell(ObjCell cell, in Position place)
    {
        SetFrame(place.Frame);
        if (ReferenceEquals(cell, Cell)) return PlacementResult.OK;
        ChangeCell(cell);
        engine.Cells.CalcCrossCells(this);
        return PlacementResult.OK;
    }

    /// <summary>Hooks, chests and corpses are put where they are told without any test.</summary>
    internal static bool HangsWhereItIsPut(WeenieTraits weenie) => (weenie & (WeenieTraits.Hook | WeenieTraits.Storage | WeenieTraits.Corpse)) != 0;

    internal static void ThrowIfBad(in Position position, string name = "position")
    {
        ThrowIfNotFinite(position.Frame.Origin, name);
        if (!position.Frame.IsValid) throw new ArgumentException("The orientation is not a unit quaternion.", name);
        if (!CellIds.HasValidIndex(position.CellId)) throw new ArgumentException($"0x{position.CellId:X8} cannot name a cell.", name);
    }
}
