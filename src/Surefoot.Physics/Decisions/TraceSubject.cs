namespace Surefoot.Physics.Decisions;

/// <summary>What kind of thing a decision was about.</summary>
public enum TraceSubjectKind : byte
{
    /// <summary>Nothing in particular.</summary>
    None,

    /// <summary>What it was before the sweep, of which the sweep knows only the plane.</summary>
    AsBefore,

    /// <summary>The ground of a land cell.</summary>
    Ground,

    /// <summary>A room.</summary>
    Room,

    /// <summary>The shell of a building.</summary>
    Building,

    /// <summary>A piece of scenery.</summary>
    Scenery,

    /// <summary>A static object.</summary>
    Object,

    /// <summary>A body.</summary>
    Body,
}

/// <summary>What a decision was about.</summary>
/// <param name="Kind">What kind of thing.</param>
/// <param name="CellId">The cell that was asked: the ground's or the room itself, or the one that lists the object.</param>
/// <param name="ObjectId">Id of a body; 0 for everything else.</param>
/// <param name="SetupId">Setup or mesh of a building, an object or a body; 0 for none.</param>
/// <param name="Part">Index of a part of it; −1 for none.</param>
/// <param name="Polygon">Index of a polygon of its tree, or of a triangle of the landblock; −1 for none.</param>
/// <param name="Sphere">Which sphere of the mover: 0 the foot, 1 the head; −1 for none.</param>
public readonly record struct TraceSubject(
    TraceSubjectKind Kind, uint CellId, uint ObjectId, uint SetupId, short Part, int Polygon, sbyte Sphere)
{
    /// <summary>Nothing in particular.</summary>
    public static TraceSubject None { get; } = new(TraceSubjectKind.None, 0, 0, 0, -1, -1, -1);

    /// <summary>What it was before the sweep.</summary>
    public static TraceSubject AsBefore { get; } = None with { Kind = TraceSubjectKind.AsBefore };
}
