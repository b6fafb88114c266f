using System.Collections.Immutable;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Buildings;

/// <summary>One room: a box of air with solid boxes in it and openings in its walls.</summary>
/// <param name="space">The space that the room's cell claims (m, in the building's coordinates).</param>
/// <param name="floor">Surface of the floor.</param>
/// <param name="wall">Surface of the walls.</param>
/// <param name="ceiling">Surface of the ceiling.</param>
internal sealed class RoomPlan(Box space, uint floor, uint wall, uint ceiling)
{
    // Stands for air in the grid; no surface has this id.
    private const uint AirMark = 1;

    private readonly BoxGrid grid = new BoxGrid().Fill(space, AirMark);
    private readonly List<Opening> openings = [];

    public Box Space => space;

    public IReadOnlyList<Opening> Openings => openings;

    /// <summary>Puts a solid box into the room.</summary>
    public RoomPlan Solid(Box box, uint surface)
    {
        grid.Fill(box, surface);
        return this;
    }

    /// <summary>Takes away from what was put in.</summary>
    public RoomPlan Air(Box box)
    {
        grid.Fill(box, AirMark);
        return this;
    }

    /// <summary>Opens a rectangle (a box without thickness) in a wall of the space.</summary>
    /// <param name="rectangle">Where.</param>
    /// <param name="otherRoom">Index of the room behind it, or <see cref="Opening.Outside"/>.</param>
    /// <param name="otherOpening">Index of the opening there.</param>
    public void Open(Box rectangle, int otherRoom, int otherOpening) => openings.Add(new(rectangle, otherRoom, otherOpening));

    /// <summary>The walls, facing inwards, then the openings in order, facing outwards.</summary>
    public ImmutableArray<Face> Faces()
    {
        var faces = grid.Faces(Rule, [.. openings.Select(opening => opening.Rectangle)]);
        List<Face> portals = [.. faces.Where(face => face.IsPortal).Select(face => face.Flipped())];
        var ordered = openings.Select(opening => portals.Single(portal => opening.Holds(Middle(portal))));
        return [.. faces.Where(face => !face.IsPortal), .. ordered];
    }

    private uint? Rule(uint behind, uint front, BoxGrid.Direction direction, Point3 middle)
    {
        if (front != AirMark || behind == AirMark)
            return null;
        if (openings.Any(opening => opening.Holds(middle)))
            return 0;
        if (behind != 0)
            return behind;
        return direction switch { { Axis: 2, Sign: > 0 } => floor, { Axis: 2 } => ceiling, _ => wall };
    }

    private static Point3 Middle(Face face) => (face.Points[0] + face.Points[2]) * 0.5;
}

/// <summary>An opening of a room.</summary>
/// <param name="Rectangle">A box without thickness.</param>
/// <param name="OtherRoom">Index of the room behind it.</param>
/// <param name="OtherOpening">Index of the opening there.</param>
internal sealed record Opening(Box Rectangle, int OtherRoom, int OtherOpening)
{
    /// <summary>Instead of a room: the open air.</summary>
    public const int Outside = -1;

    /// <summary>Whether a point lies on the rectangle.</summary>
    public bool Holds(Point3 point)
        => Enumerable.Range(0, 3).All(axis => point[axis] >= Rectangle.Low[axis] - 1e-9 && point[axis] <= Rectangle.High[axis] + 1e-9);
}
