using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>The collision polygons of one mesh or room, flat: a plane and a run of corners for each. Immutable.</summary>
public sealed class PolygonSet
{
    private readonly Plane[] planes;
    private readonly int[] firstCorner;
    private readonly Vector3[] corners;

    /// <summary>Polygon i has the corners <c>firstCorner[i] .. firstCorner[i + 1]</c>.</summary>
    internal PolygonSet(Plane[] planes, int[] firstCorner, Vector3[] corners)
    {
        this.planes = planes;
        this.firstCorner = firstCorner;
        this.corners = corners;
    }

    /// <summary>A set without polygons.</summary>
    public static PolygonSet Empty { get; } = new([], [0], []);

    /// <summary>Number of polygons.</summary>
    public int Count => planes.Length;

    /// <summary>The corners of all polygons, one polygon after the other, metres.</summary>
    public ReadOnlySpan<Vector3> Corners => corners;

    /// <summary>Plane of a polygon: the side its normal points to is the front.</summary>
    public ref readonly Plane PlaneOf(int polygon) => ref planes[polygon];

    /// <summary>Corners of a polygon, in order, metres.</summary>
    public ReadOnlySpan<Vector3> CornersOf(int polygon) =>
        corners.AsSpan(firstCorner[polygon], firstCorner[polygon + 1] - firstCorner[polygon]);

    /// <summary>A polygon, to be asked questions of.</summary>
    internal ConvexPolygon this[int polygon] => new(planes[polygon], CornersOf(polygon));
}

/// <summary>Collects polygons into flat arrays.</summary>
internal sealed class PolygonSetBuilder(int expected)
{
    private readonly List<Plane> planes = new(expected);
    private readonly List<int> firstCorner = [0];
    private readonly List<Vector3> corners = new(expected * 4);

    public void Add(ReadOnlySpan<Vector3> polygon)
    {
        planes.Add(ConvexPolygon.MakePlane(polygon));
        corners.AddRange(polygon);
        firstCorner.Add(corners.Count);
    }

    public PolygonSet Build()
    {
        if (planes.Count == 0) return PolygonSet.Empty;
        return new PolygonSet([.. planes], [.. firstCorner], [.. corners]);
    }
}

/// <summary>One polygon of a set; the default value is no polygon.</summary>
/// <param name="Set">The set, null for no polygon.</param>
/// <param name="Index">Index inside the set.</param>
internal readonly record struct PolygonRef(PolygonSet? Set, int Index)
{
    /// <summary>True for no polygon.</summary>
    public bool IsNone => Set is null;

    /// <summary>The polygon; there must be one.</summary>
    public ConvexPolygon Polygon => Set![Index];

    /// <summary>
    /// Is a sphere carried along <paramref name="up"/> onto the plane supported by the polygon? All in the polygon's frame.
    /// </summary>
    /// <remarks>Retail: CPolygon::check_walkable @0x00538E60.</remarks>
    public bool CheckWalkable(in Sphere sphere, in Vector3 up) => Polygon.SupportsFoot(sphere, up);

    /// <summary>
    /// The first edge beyond which the sphere's centre, carried along <paramref name="up"/> onto the plane, lies;
    /// <paramref name="normal"/> is the edge's unit normal in the plane, pointing inside, or zero when there is none.
    /// </summary>
    /// <remarks>Retail: CPolygon::find_crossed_edge @0x00539300.</remarks>
    public bool FindCrossedEdge(in Sphere sphere, in Vector3 up, out Vector3 normal)
    {
        normal = default;
        return Polygon.FindCrossedEdge(sphere, up, ref normal);
    }
}
