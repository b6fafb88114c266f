using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>Turns faces into the records that hold shapes.</summary>
internal static class Meshes
{
    /// <summary>A shape that is drawn and collides.</summary>
    public static GfxObj Solid(uint id, IReadOnlyList<Face> faces) => Shape(id, faces, collides: true);

    /// <summary>A shape that is drawn only.</summary>
    public static GfxObj Drawn(uint id, IReadOnlyList<Face> faces) => Shape(id, faces, collides: false);

    /// <summary>The shape of a box-shaped room. The portals among the faces become its portals, in order.</summary>
    /// <param name="space">The space that the cell claims.</param>
    /// <param name="faces">Faces of its air, inwards; portals outwards.</param>
    public static CellStruct Room(Box space, IReadOnlyList<Face> faces)
    {
        List<Face> walls = [.. faces.Where(face => !face.IsPortal)], portals = [.. faces.Where(face => face.IsPortal)];
        var mesh = new Mesh([.. walls, .. portals]);

        // The tree closes openings with the portal faces turned inwards, like the walls around them.
        var tree = BspBuilder.Build([.. walls, .. portals.Select(portal => portal.Flipped())]);
        return new()
        {
            Vertices = mesh.Vertices,
            Polygons = mesh.Polygons,
            PortalPolygons = [.. portals.Select((_, index) => (ushort)(walls.Count + index))],
            CellTree = CellTree(space),
            PhysicsPolygons = [.. mesh.Polygons.Take(walls.Count).Select(polygon => polygon with { PositiveSurface = -1 })],
            PhysicsTree = tree,
        };
    }

    /// <summary>The surface ids that the surface numbers of the faces' polygons select, for the record that names them.</summary>
    public static ImmutableArray<uint> SurfacesOf(IEnumerable<Face> faces)
        => [.. faces.Where(face => !face.IsPortal).Select(face => face.Surface).Distinct()];

    private static GfxObj Shape(uint id, IReadOnlyList<Face> faces, bool collides)
    {
        var mesh = new Mesh(faces);
        var sphere = Spheres.Around([.. faces.SelectMany(face => face.Points)]);
        return new()
        {
            Id = id,
            Flags = GfxObjFlags.HasDrawing | (collides ? GfxObjFlags.HasPhysics : GfxObjFlags.None),
            SurfaceIds = mesh.Surfaces,
            Vertices = mesh.Vertices,
            SortCentre = sphere.Centre,
            PhysicsPolygons = collides ? [.. mesh.Polygons.Select(polygon => polygon with { PositiveSurface = -1 })] : [],
            PhysicsTree = collides ? BspBuilder.Build(faces) : null,
            DrawingPolygons = mesh.Polygons,
            DrawingTree = DrawingTree(faces.Count, sphere),
        };
    }

    // One node over one leaf, as spec 07, 7.4 advises for shapes whose drawing order does not matter.
    private static BspTree DrawingTree(int polygons, DatSphere sphere) => new()
    {
        Nodes =
        [
            new BspNode
            {
                Tag = BspTag.BPIn,
                Plane = new(Vector3.UnitZ, 0f),
                Positive = 1,
                Sphere = sphere,
                Polygons = [.. Enumerable.Range(0, polygons).Select(i => (short)i)],
            },
            new BspNode(),
        ],
    };

    // A chain of the six walls, normals inwards; the last without a child, which every reader takes for the end (spec 07, 7.4).
    private static BspTree CellTree(Box space)
    {
        Plane[] planes =
        [
            new(1, 0, 0, (float)-space.Low.X), new(-1, 0, 0, (float)space.High.X), new(0, 1, 0, (float)-space.Low.Y),
            new(0, -1, 0, (float)space.High.Y), new(0, 0, 1, (float)-space.Low.Z), new(0, 0, -1, (float)space.High.Z),
        ];
        return new()
        {
            Nodes =
            [
                .. planes.Select((plane, index) => index + 1 < planes.Length
                    ? new BspNode { Tag = BspTag.BPnn, Plane = plane, Positive = index + 1 }
                    : new BspNode { Tag = BspTag.Bpnn, Plane = plane }),
            ],
        };
    }

    // Vertices are shared by position, so that faces which meet use the same numbers.
    private sealed class Mesh
    {
        private readonly List<DatVertex> vertices = [];
        private readonly Dictionary<(Vector3 Position, Vector3 Normal), ushort> known = [];

        public Mesh(IReadOnlyList<Face> faces)
        {
            Surfaces = SurfacesOf(faces);
            Polygons = [.. faces.Select(Polygon)];
        }

        public ImmutableArray<DatPolygon> Polygons { get; }

        public DatVertexArray Vertices => new([.. vertices]);

        public ImmutableArray<uint> Surfaces { get; }

        private DatPolygon Polygon(Face face, int key)
        {
            return new()
            {
                Key = (ushort)key,
                Stippling = face.IsPortal ? DatStippling.Portal | DatStippling.NoPositiveUVs : DatStippling.NoPositiveUVs,
                PositiveSurface = (short)(face.IsPortal ? -1 : Surfaces.IndexOf(face.Surface)),
                Vertices = [.. face.Points.Select(point => VertexOf(point.ToVector(), face.Normal.ToVector()))],
            };
        }

        private ushort VertexOf(Vector3 position, Vector3 normal)
        {
            if (!known.TryGetValue((position, normal), out ushort index))
            {
                known[(position, normal)] = index = (ushort)vertices.Count;
                vertices.Add(new(index, position, normal));
            }

            return index;
        }
    }
}
