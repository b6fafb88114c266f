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
