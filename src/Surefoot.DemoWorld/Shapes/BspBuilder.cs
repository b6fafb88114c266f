using System.Collections.Immutable;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>Makes physics trees from the faces of closed solids.</summary>
/// <remarks>
/// Keeps the rules of spec 07, 7.3: both children everywhere, spheres around the polygons of the subtree, each polygon
/// in every leaf that it touches from behind. A leaf behind a portal is not solid: there another cell begins.
/// </remarks>
internal sealed class BspBuilder
{
    // Below the width of anything built here, above rounding.
    private const double Thickness = 1e-5;
    private const int Candidates = 24;

    private readonly IReadOnlyList<Face> faces;
    private readonly List<BspNode> nodes = [];
    private int leaves;

    private BspBuilder(IReadOnlyList<Face> faces) => this.faces = faces;

    /// <summary>The tree of faces. Polygons are counted without the portals, in order.</summary>
    public static BspTree Build(IReadOnlyList<Face> faces)
    {
        var builder = new BspBuilder(faces);
        List<Fragment> all = [.. faces.Select((face, index) => new Fragment(index, face.Points))];
        builder.Add(all, []);
        return new() { Nodes = [.. builder.nodes] };
    }

    // Open faces may still become planes of nodes; used ones have, and lie on the border of the region with the region behind them.
    private int Add(List<Fragment> open, List<Fragment> used)
    {
        int self = nodes.Count;
        nodes.Add(default);
        if (open.Count == 0)
        {
            nodes[self] = Leaf(used);
            return self;
        }

        Face splitter = faces[Choose(open).Face];
        List<Fragment> frontOpen = [], frontUsed = [], backOpen = [], backUsed = [];
        foreach (var fragment in open)
        {
            var (normal, coplanar) = (faces[fragment.Face].Normal.Dot(splitter.Normal), IsOn(splitter, fragment));
            if (coplanar && normal > 0)
                backUsed.Add(fragment);
            else if (coplanar)
                frontOpen.Add(fragment);
            else
                Share(splitter, fragment, frontOpen, backOpen);
        }

        foreach (var fragment in used)
            Share(splitter, fragment, frontUsed, backUsed);
        int positive = Add(frontOpen, frontUsed), negative = Add(backOpen, backUsed);
        nodes[self] = new()
        {
            Tag = BspTag.BPnN,
            Plane = new(splitter.Normal.ToVector(), (float)splitter.Offset),
            Positive = positive,
            Negative = negative,
            Sphere = SphereOf(open.Concat(used)),
        };
        return self;
    }

    private BspNode Leaf(List<Fragment> used)
    {
        bool opening = used.Any(fragment => faces[fragment.Face].IsPortal);
        ImmutableArray<short> polygons =
            [.. used.Where(fragment => !faces[fragment.Face].IsPortal).Select(fragment => PolygonOf(fragment.Face)).Distinct().Order()];
        return new()
        {
            LeafIndex = leaves++,
            Solid = polygons.Length > 0 && !opening ? 1 : 0,
            Sphere = SphereOf(used),
            Polygons = polygons,
        };
    }

    private short PolygonOf(int face) => (short)faces.Take(face).Count(other => !other.IsPortal);

    // Portals first, so that what lies beyond them is cut off at once; then, of a sample, the face that cuts the fewest others, and
    // the most even. A sample will do: the tree is right with any choice, only larger.
    private Fragment Choose(List<Fragment> open)
    {
        foreach (var fragment in open)
        {
            if (faces[fragment.Face].IsPortal)
                return fragment;
        }

        Fragment best = open[0];
        double bestScore = double.MaxValue;
        int stride = 1 + (open.Count / Candidates);
        for (int i = 0; i < open.Count; i += stride)
        {
            Face face = faces[open[i].Face];
            int front = 0, back = 0, cut = 0;
            foreach (var other in open)
            {
                var (low, high) = Extent(face, other);
                if (high > Thickness && low < -Thickness)
                    cut++;
                else if (high > Thickness)
                    front++;
                else
                    back++;
            }

            double score = (4.0 * cut) + Math.Abs(front - back);
            if (score < bestScore)
                (best, bestScore) = (open[i], score);
        }

        return best;
    }

    private static (double Low, double High) Extent(Face plane, Fragment fragment)
    {
        double low = double.MaxValue, high = double.MinValue;
        foreach (var point in fragment.Points)
        {
            double distance = plane.DistanceTo(point);
            low = Math.Min(low, distance);
            high = Math.Max(high, distance);
        }

        return (low, high);
    }

    private static bool IsOn(Face plane, Fragment fragment)
    {
        var (low, high) = Extent(plane, fragment);
        return low >= -Thickness && high <= Thickness;
    }

    private static void Share(Face plane, Fragment fragment, List<Fragment> front, List<Fragment> back)
    {
        var (low, high) = Extent(plane, fragment);
        if (high > Thickness)
            front.Add(low >= 0 ? fragment : Clip(fragment, plane, 1));
        if (low < -Thickness)
            back.Add(high <= 0 ? fragment : Clip(fragment, plane, -1));
    }

    // The part of a fragment in front of a plane (side 1) or behind it (side -1).
    private static Fragment Clip(Fragment fragment, Face plane, int side)
    {
        var points = ImmutableArray.CreateBuilder<Point3>();
        for (int i = 0; i < fragment.Points.Length; i++)
        {
            Point3 here = fragment.Points[i], next = fragment.Points[(i + 1) % fragment.Points.Length];
            double a = side * plane.DistanceTo(here), b = side * plane.DistanceTo(next);
            if (a >= 0)
                points.Add(here);
            if ((a < 0 && b > 0) || (a > 0 && b < 0))
                points.Add(here + ((next - here) * (a / (a - b))));
        }

        return fragment with { Points = points.ToImmutable() };
    }

    private DatSphere SphereOf(IEnumerable<Fragment> fragments)
    {
        List<Point3> points = [.. fragments.SelectMany(fragment => faces[fragment.Face].Points)];
        return points.Count == 0 ? default : Spheres.Around(points);
    }

    private readonly record struct Fragment(int Face, ImmutableArray<Point3> Points);
}
