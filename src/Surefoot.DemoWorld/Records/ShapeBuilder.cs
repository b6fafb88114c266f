using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>Collects boxes and makes a shape of them that is drawn and does not collide.</summary>
internal sealed class ShapeBuilder
{
    private readonly List<uint> surfaces = [];
    private readonly List<DatVertex> vertices = [];
    private readonly List<DatPolygon> polygons = [];

    /// <summary>Adds an upright box.</summary>
    /// <param name="low">Least corner (m).</param>
    /// <param name="high">Greatest corner (m).</param>
    /// <param name="surface">Surface id of all faces.</param>
    public ShapeBuilder Box(Vector3 low, Vector3 high, uint surface)
    {
        int index = surfaces.IndexOf(surface);
        if (index < 0)
        {
            index = surfaces.Count;
            surfaces.Add(surface);
        }

        AddFace(index, Vector3.UnitZ, new(low.X, low.Y, high.Z), new(high.X, low.Y, high.Z), high, new(low.X, high.Y, high.Z));
        AddFace(index, -Vector3.UnitZ, low, new(low.X, high.Y, low.Z), new(high.X, high.Y, low.Z), new(high.X, low.Y, low.Z));
        AddFace(index, Vector3.UnitX, new(high.X, low.Y, low.Z), new(high.X, high.Y, low.Z), high, new(high.X, low.Y, high.Z));
        AddFace(index, -Vector3.UnitX, low, new(low.X, low.Y, high.Z), new(low.X, high.Y, high.Z), new(low.X, high.Y, low.Z));
        AddFace(index, Vector3.UnitY, new(low.X, high.Y, low.Z), new(low.X, high.Y, high.Z), high, new(high.X, high.Y, low.Z));
        AddFace(index, -Vector3.UnitY, low, new(high.X, low.Y, low.Z), new(high.X, low.Y, high.Z), new(low.X, low.Y, high.Z));
        return this;
    }

    /// <summary>The shape as a record.</summary>
    public GfxObj Build(uint id)
    {
        var sphere = EnclosingSphere();

        // One node over one leaf, as spec 07, 7.4 advises for shapes whose drawing order does not matter.
        var tree = new BspTree
        {
            Nodes =
            [
                new BspNode
                {
                    Tag = BspTag.BPIn,
                    Plane = new(Vector3.UnitZ, 0f),
                    Positive = 1,
                    Sphere = sphere,
                    Polygons = [.. Enumerable.Range(0, polygons.Count).Select(i => (short)i)],
                },
                new BspNode(),
            ],
        };
        return new()
        {
            Id = id,
            Flags = GfxObjFlags.HasDrawing,
            SurfaceIds = [.. surfaces],
            Vertices = new([.. vertices]),
            SortCentre = sphere.Centre,
            DrawingPolygons = [.. polygons],
            DrawingTree = tree,
        };
    }

    // Corners counter-clockwise seen from outside; each face has its own vertices, so that edges are drawn sharp.
    private void AddFace(int surface, Vector3 normal, params ReadOnlySpan<Vector3> corners)
    {
        var points = ImmutableArray.CreateBuilder<ushort>();
        foreach (var corner in corners)
        {
            points.Add((ushort)vertices.Count);
            vertices.Add(new((ushort)vertices.Count, corner, normal));
        }

        polygons.Add(new() { Key = (ushort)polygons.Count, PositiveSurface = (short)surface, Vertices = points.ToImmutable() });
    }

    private DatSphere EnclosingSphere()
    {
        Vector3 low = new(float.MaxValue), high = new(float.MinValue);
        foreach (var vertex in vertices)
            (low, high) = (Vector3.Min(low, vertex.Position), Vector3.Max(high, vertex.Position));
        double dx = (double)high.X - low.X, dy = (double)high.Y - low.Y, dz = (double)high.Z - low.Z;
        var centre = new Vector3((float)((low.X + (double)high.X) / 2), (float)((low.Y + (double)high.Y) / 2), (float)((low.Z + (double)high.Z) / 2));
        return new(centre, (float)((Math.Sqrt((dx * dx) + (dy * dy) + (dz * dz)) / 2) + 0.001));
    }
}
