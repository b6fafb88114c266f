using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Entering and leaving the world and its cells, and being put somewhere.</content>
public sealed partial class PhysicsBody
{
    /// <summary>The body waits for its cell to be loaded.</summary>
    public bool IsLost { get; private set; }

    /// <summary>The engine has forgotten it for good.</summary>
    internal bool IsRemoved { get; set; }

    /// <summary>Comes into the world at a position, moved to a free place near by when it is taken.</summary>
    /// <returns>True when it is in the world, or waits for its cell to be loaded.</returns>
    /// <remarks>Retail: CPhysicsObj::enter_world(pos) @0x00516310.</remarks>
    /// <exception cref="ArgumentException">The position is not finite, or its id cannot name a cell; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The body was removed from its population.</exception>
    public bool EnterWorld(in Position position, bool slide = true)
    {
        ThrowIfBad(position);
        ThrowIfRemoved();
        if (Parent is not null) return false;
        StorePosition(position);
        updateTime = population.Now;
        PlacementFlags flags = PlacementFlags.Placement | (slide ? PlacementFlags.Slide : PlacementFlags.None);
        // Not asked again whether the id names a cell: off the map it is none now, and the body is lost there.
        if (Place(new PlacementRequest(PositionField, flags)) != PlacementResult.OK) return false;
        // Also when it waits for its cell: the next tick puts such a body to sleep again.
        SetActive(true);
        driver.HandleEnterWorld();
        return true;
    }

    /// <summary>Leaves the world; every touch ends.</summary>
    /// <remarks>Retail: CPhysicsObj::leave_world @0x005155A0.</remarks>
    public void LeaveWorld()
    {
        collisions.ReportEnd(updateTime, force: true);
        IsLost = false;
        Transient &= ~TransientState.Active;
        population.Cells.RemoveShadows(this);
        LeaveCell();
        PositionField.CellId = 0;
        ClearTransientStates();
    }

    /// <summary>Leaves the world for good: what is pending fails, whoever tracks the body is told, every touch ends.</summary>
    /// <remarks>Retail: CPhysicsObj::exit_world @0x00514E60.</remarks>
    internal void ExitWorld()
    {
        driver.HandleExitWorld();
        collisions.ReportEnd(updateTime, force: true);
    }

    /// <summary>What a teleport ends: a move-to, corrections under way, sticking, tracking, touches.</summary>
    /// <remarks>Retail: CPhysicsObj::teleport_hook @0x00514ED0.</remarks>
    internal void TeleportHook()
    {
        driver.HandleTeleport();
        collisions.ReportEnd(updateTime, force: true);
    }

    /// <summary>The landblock that holds the body's cell goes away; the body waits for it.</summary>
    /// <remarks>Retail: CPhysicsObj::leave_visibility @0x00514220.</remarks>
    internal void LeaveVisibility() => GoToLostCell(PositionField);

    /// <summary>The cell the body waited for is there again.</summary>
    /// <remarks>Retail: CPhysicsObj::reenter_visibility @0x00516250.</remarks>
    /// <returns>False when nothing was free there.</returns>
    internal bool ReenterVisibility() =>
        Place(new PlacementRequest(PositionField, PlacementFlags.Placement | PlacementFlags.Slide)) == PlacementResult.OK;

    internal void ThrowIfRemoved()
    {
        if (IsRemoved)
            throw new InvalidOperationException($"The body 0x{Id:X8} was removed from its engine; make a new one.");
    }

    private void PrepareToEnterWorld()
    {
        updateTime = population.Now;
        IsLost = false;
        SetActive(true);
    }

    /// <summary>Parks the body at a place whose cell is not loaded.</summary>
    private void GoToLostCell(in Position place)
    {
        population.Cells.RemoveShadows(this);
        LeaveCell();
        StorePosition(place);
        IsLost = true;
        Transient &= ~TransientState.Active;
    }

    /// <remarks>Retail: CPhysicsObj::store_position @0x005141A0.</remarks>
    private void StorePosition(Position place)
    {
        if (CellIds.IsOutdoor(place.CellId)) place.AdjustToOutside();
        PositionField.CellId = place.CellId;
        SetFrame(place.Frame);
    }

    /// <remarks>Retail: CPhysicsObj::change_cell @0x00513390.</remarks>
    private void ChangeCell(ObjCell cell)
    {
        LeaveCell();
        EnterCell(cell);
    }

    /// <summary>Goes into a cell, with all that the body holds; one without parts is in none.</summary>
    /// <remarks>Retail: CPhysicsObj::enter_cell @0x00510ED0.</remarks>
    private void EnterCell(ObjCell cell)
    {
        if (Setup is null) return;
        for (int i = 0; i < HeldCount; i++) HeldBody(i).EnterCell(cell);
        Cell = cell;
        PositionField.CellId = cell.Id;
    }

    /// <summary>Leaves the cell with all that the body holds; its id stays.</summary>
    private void LeaveCell()
    {
        if (Cell is null) return;
        for (int i = 0; i < HeldCount; i++) HeldBody(i).LeaveCell();
        Cell = null;
    }

    /// <summary>The id of the cell the body is in, for it and for what it holds itself.</summary>
    private void SetCellId(uint id)
    {
        PositionField.CellId = id;
        for (int i = 0; i < HeldCount; i++) HeldBody(i).PositionField.CellId = id;
    }

    /// <remarks>Retail: CPhysicsObj::clear_transient_states @0x00511BF0.</remarks>
    private void ClearTransientStates()
    {
        Transient &= ~TransientState.Contact;
        CalcAcceleration();
        bool stood = OnWalkable;
        Transient &= ~(TransientState.OnWalkable | TransientState.WaterContact);
        if (stood) driver.LeaveGround();
        CalcAcceleration();
        Transient &= ~(TransientState.Sliding | TransientState.StationaryMask | TransientState.Active | TransientState.CheckEthereal);
    }

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
        if (!float.IsFinite(request.RadiusX) || !float.IsFinite(request.RadiusY))
            throw new ArgumentException("A scatter radius is not finite.", nameof(request));
        return Place(request);
    }

    private PlacementResult Place(in PlacementRequest request)
    {
        if (!population.Transitions.TryRent(out Transition? transition, Trace)) return PlacementResult.GeneralFailure;
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

        population.Transitions.Return();
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
            double rollX = population.NextRoll(), rollY = population.NextRoll();
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
        population.Cells.AdjustPosition(ref place, TransitionSeeds.FootOf(this), out ObjCell? cell);
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
            return HandleAllCollisions(transition.Collision, false, false, updateTime)
                ? PlacementResult.Collided
                : PlacementResult.NoValidPosition;
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
        population.Cells.CalcCrossCells(this);
        return PlacementResult.OK;
    }

    /// <summary>Hooks, chests and corpses are put where they are told without any test.</summary>
    internal static bool HangsWhereItIsPut(WeenieTraits weenie) =>
        (weenie & (WeenieTraits.Hook | WeenieTraits.Storage | WeenieTraits.Corpse)) != 0;

    internal static void ThrowIfBad(in Position position, string name = "position")
    {
        ThrowIfNotFinite(position.Frame.Origin, name);
        if (!position.Frame.IsValid) throw new ArgumentException("The orientation is not a unit quaternion.", name);
        if (!CellIds.HasValidIndex(position.CellId)) throw new ArgumentException($"0x{position.CellId:X8} cannot name a cell.", name);
    }
}
