using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>Entering and leaving the world and its cells.</content>
public sealed partial class PhysicsBody
{
    /// <summary>The body waits for its cell to be loaded.</summary>
    public bool IsLost { get; private set; }

    /// <summary>Comes into the world at a position, moved to a free place near by when it is taken.</summary>
    /// <returns>True when it is in the world, or waits for its cell to be loaded.</returns>
    /// <remarks>Retail: CPhysicsObj::enter_world(pos) @0x00516310.</remarks>
    /// <exception cref="ArgumentException">The position is not finite, or its id cannot name a cell; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The body was removed from its engine.</exception>
    public bool EnterWorld(in Position position, bool slide = true)
    {
        ThrowIfBad(position);
        ThrowIfRemoved();
        if (Parent is not null) return false;
        StorePosition(position);
        updateTime = engine.Now;
        PlacementFlags flags = PlacementFlags.Placement | (slide ? PlacementFlags.Slide : PlacementFlags.None);
        if (SetPosition(new PlacementRequest(PositionField, flags)) != PlacementResult.OK) return false;
        // Also when it waits for its cell: the next tick puts such a body to sleep again.
        SetActive(true);
        Movement?.HandleEnterWorld();
        return true;
    }

    /// <summary>Leaves the world; every touch ends.</summary>
    /// <remarks>Retail: CPhysicsObj::leave_world @0x005155A0.</remarks>
    public void LeaveWorld()
    {
        ReportCollisionEnd(updateTime, force: true);
        IsLost = false;
        Transient &= ~TransientState.Active;
        engine.Cells.RemoveShadows(this);
        LeaveCell();
        PositionField.CellId = 0;
        ClearTransientStates();
    }

    /// <summary>Leaves the world for good: what is pending fails, whoever tracks the body is told, every touch ends.</summary>
    /// <remarks>Retail: CPhysicsObj::exit_world @0x00514E60.</remarks>
    internal void ExitWorld()
    {
        Movement?.HandleExitWorld();
        Steering?.HandleExitWorld();
        ReportCollisionEnd(updateTime, force: true);
    }

    /// <summary>What a teleport ends: a move-to, corrections under way, sticking, tracking, touches.</summary>
    /// <remarks>Retail: CPhysicsObj::teleport_hook @0x00514ED0.</remarks>
    internal void TeleportHook()
    {
        Steering?.HandleTeleport();
        ReportCollisionEnd(updateTime, force: true);
    }

    /// <summary>The landblock that holds the body's cell goes away; the body waits for it.</summary>
    /// <remarks>Retail: CPhysicsObj::leave_visibility @0x00514220.</remarks>
    internal void LeaveVisibility() => GoToLostCell(PositionField);

    /// <summary>The cell the body waited for is there again.</summary>
    /// <remarks>Retail: CPhysicsObj::reenter_visibility @0x00516250.</remarks>
    /// <returns>False when nothing was free there.</returns>
    internal bool ReenterVisibility() =>
        Place(new PlacementRequest(PositionField, PlacementFlags.Placement | PlacementFlags.Slide)) == PlacementResult.OK;

    private void ThrowIfRemoved()
    {
        if (!ReferenceEquals(engine.Find(Id), this))
            throw new InvalidOperationException($"The body 0x{Id:X8} was removed from its engine; make a new one.");
    }

    private void PrepareToEnterWorld()
    {
        updateTime = engine.Now;
        IsLost = false;
        SetActive(true);
    }

    /// <summary>Parks the body at a place whose cell is not loaded.</summary>
    private void GoToLostCell(in Position place)
    {
        engine.Cells.RemoveShadows(this);
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
        if (stood) Movement?.LeaveGround();
        CalcAcceleration();
        Transient &= ~(TransientState.Sliding | TransientState.StationaryMask | TransientState.Active | TransientState.CheckEthereal);
    }
}
