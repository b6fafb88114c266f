using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Shapes parse to the values that come with the samples.</summary>
public sealed class GeometrySampleTests
{
    [Fact]
    [Behaviour("dats.sample.gfxobj", "data/dat-samples/README.md; spec/07, section 7")]
    public void Square_gfxobj()
    {
        var shape = TestData.Sample<GfxObj>("gfxobj-01000010");

        Assert.Equal(0x01000010u, shape.Id);
        Assert.Equal(GfxObjFlags.HasPhysics, shape.Flags);
        Assert.Equal([0x08000001u], shape.SurfaceIds);
        Assert.Equal([new(-1, -1, 0), new(1, -1, 0), new(1, 1, 0), new(-1, 1, 0)], shape.Vertices.Vertices.Select(v => v.Position));
        Assert.All(shape.Vertices.Vertices, v => Assert.Equal(Vector3.UnitZ, v.Normal));
        Assert.All(shape.Vertices.Vertices, v => Assert.Empty(v.UVs));
        DatPolygon polygon = Assert.Single(shape.PhysicsPolygons);
        Assert.Equal([0, 1, 2, 3], polygon.Vertices.Select(v => (int)v));
        Assert.Equal((DatStippling)4, polygon.Stippling);
        Assert.Equal((0, -1, -1), (polygon.Sides, polygon.PositiveSurface, polygon.NegativeSurface));
        var nodes = shape.PhysicsTree!.Nodes;
        Assert.Equal(3, nodes.Length);
        AssertNode(nodes[0], BspTag.BPnN, new(0, 0, 1, 0), new(Vector3.Zero, 1.5f), 1, 2);
        AssertLeaf(nodes[1], 0, 0, default);
        AssertLeaf(nodes[2], 1, 1, new(Vector3.Zero, 1.5f), 0);
        Assert.Equal(Vector3.Zero, shape.SortCentre);
        Assert.Null(shape.DrawingTree);
    }

    [Fact]
    [Behaviour("dats.sample.gfxobj-smallest", "data/dat-samples/README.md; spec/07, section 7")]
    public void Smallest_gfxobj()
    {
        var shape = TestData.Sample<GfxObj>("gfxobj-01000011");

        Assert.Equal(GfxObjFlags.None, shape.Flags);
        Assert.Empty(shape.SurfaceIds);
        Assert.Empty(shape.Vertices.Vertices);
        Assert.Equal(Vector3.Zero, shape.SortCentre);
        Assert.Null(shape.PhysicsTree);
        Assert.Null(shape.DrawingTree);
        Assert.Equal(29, shape.Encode().Length);
    }

    [Fact]
    [Behaviour("dats.sample.gfxobj-box", "data/dat-samples/README.md; spec/07, section 7")]
    public void Box_gfxobj()
    {
        var shape = TestData.Sample<GfxObj>("gfxobj-01000001");

        Assert.Equal(GfxObjFlags.HasPhysics | GfxObjFlags.HasDrawing | GfxObjFlags.HasDegrade, shape.Flags);
        Assert.Equal([0x08000001u, 0x08000002u], shape.SurfaceIds);
        (float X, float Y)[] corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)];
        Assert.Equal(8, shape.Vertices.Vertices.Length);
        for (int i = 0; i < 8; i++)
        {
            DatVertex vertex = shape.Vertices.Vertices[i];
            var (x, y) = corners[i % 4];
            float z = i < 4 ? 0 : 2;
            Assert.Equal(i, vertex.Key);
            Assert.Equal(new Vector3(x, y, z), vertex.Position);
            Assert.Equal([new DatUV((x + 1) / 2, (y + 1) / 2)], vertex.UVs);
            AssertClose(new Vector3(x, y, z - 1) * 0.57735f, vertex.Normal, 1e-5f);
        }

        int[][] faces = [[4, 5, 6, 7], [0, 3, 2, 1], [1, 2, 6, 5], [0, 4, 7, 3], [2, 3, 7, 6], [0, 1, 5, 4]];
        Assert.Equal(faces, shape.PhysicsPolygons.Select(p => p.Vertices.Select(v => (int)v).ToArray()));
        Assert.Equal(faces, shape.DrawingPolygons.Select(p => p.Vertices.Select(v => (int)v).ToArray()));

        Plane[] planes = [new(0, 0, 1, -2), new(0, 0, -1, 0), new(1, 0, 0, -1), new(-1, 0, 0, -1), new(0, 1, 0, -1), new(0, -1, 0, -1)];
        var sphere = new DatSphere(Vector3.UnitZ, 1.75f);
        var nodes = shape.PhysicsTree!.Nodes;
        Assert.Equal(13, nodes.Length);
        for (int face = 0, node = 0; face < 6; face++, node = nodes[node].Negative)
        {
            AssertNode(nodes[node], BspTag.BPnN, planes[face], sphere, nodes[node].Positive, nodes[node].Negative);
            AssertLeaf(nodes[nodes[node].Positive], face, 0, default);
        }

        AssertLeaf(nodes[12], 6, 1, sphere, 0, 1, 2, 3, 4, 5);
        Assert.Equal(Vector3.UnitZ, shape.SortCentre);
        for (int i = 0; i < 6; i++)
        {
            DatPolygon polygon = shape.DrawingPolygons[i];
            Assert.Equal(DatStippling.None, polygon.Stippling);
            Assert.Equal((i == 0 ? 1 : 0, -1), (polygon.PositiveSurface, polygon.NegativeSurface));
            Assert.Equal([0, 0, 0, 0], polygon.PositiveUVs.Select(v => (int)v));
        }

        var drawing = shape.DrawingTree!.Nodes;
        AssertNode(drawing[0], BspTag.BPIN, new(0, 0, 1, -1), sphere, 1, 3, 2, 3, 4, 5);
        AssertNode(drawing[1], BspTag.BPIn, new(0, 0, 1, -2), new(new(0, 0, 2), 1.5f), 2, -1, 0);
        AssertLeaf(drawing[2], 0, 0, default);
        AssertNode(drawing[3], BspTag.BPIn, new(0, 0, -1, 0), new(Vector3.Zero, 1.5f), 4, -1, 1);
        AssertLeaf(drawing[4], 1, 0, default);
        Assert.Equal(0x11000001u, shape.DegradeId);
    }

    [Fact]
    [Behaviour("dats.sample.gfxobj-every-tag", "data/dat-samples/README.md; spec/07, section 7")]
    public void Gfxobj_with_every_inner_tag()
    {
        var shape = TestData.Sample<GfxObj>("gfxobj-01000003");
        var sphere = new DatSphere(new(0, 0, 2.5f), 4);

        Assert.Equal(GfxObjFlags.HasPhysics | GfxObjFlags.HasDrawing, shape.Flags);
        Assert.Equal([0x08000001u], shape.SurfaceIds);
        Assert.Equal(
            [new(-2, 0, 0), new(2, 0, 0), new(2, 0, 3), new(-2, 0, 3), new(0, 0, 5)], shape.Vertices.Vertices.Select(v => v.Position));
        Assert.Equal(
            [[new(0, 0)], [new(1, 0)], [new(1, 1)], [new(0, 1)], [new DatUV(0.5f, 2), new(0.5f, 3)]],
            shape.Vertices.Vertices.Select(v => v.UVs.ToArray()));
        Assert.Equal([[0, 1, 2, 3], [3, 2, 4]], shape.PhysicsPolygons.Select(p => p.Vertices.Select(v => (int)v).ToArray()));

        var nodes = shape.PhysicsTree!.Nodes;
        AssertNode(nodes[0], BspTag.BPIN, new(1, 0, 0, 0), sphere, 1, 6);
        AssertNode(nodes[1], BspTag.BPnN, new(0, 1, 0, 0), sphere, 2, 4);
        AssertNode(nodes[2], BspTag.BPnn, new(0, 0, 1, 0), sphere, 3, -1);
        AssertLeaf(nodes[3], 0, 0, nodes[3].Sphere);
        AssertNode(nodes[4], BspTag.BpnN, new(0, 0, 1, -1), sphere, -1, 5);
        AssertLeaf(nodes[5], 1, 1, sphere, 0, 1);
        AssertNode(nodes[6], BspTag.BPIn, new(0, 1, 0, -1), sphere, 7, -1);
        AssertNode(nodes[7], BspTag.BpIN, new(0, 0, 1, -2), sphere, -1, 8);
        AssertNode(nodes[8], BspTag.Bpnn, new(0, 0, 1, -3), sphere, -1, -1);
        Assert.Equal(9, nodes.Length);
        Assert.Equal(new Vector3(0, 0, 2.5f), shape.SortCentre);

        AssertPolygon(shape.DrawingPolygons[0], 0, 0, [0, 1, 2, 3], [0, 0, 0, 0], []);
        AssertPolygon(shape.DrawingPolygons[1], 0x14, 0, [0, 1, 2], [], []);
        AssertPolygon(shape.DrawingPolygons[2], 0, 2, [3, 2, 4], [0, 0, 0], [0, 0, 1]);
        AssertPolygon(shape.DrawingPolygons[3], 8, 2, [3, 2, 4], [0, 0, 1], []);
        AssertPolygon(shape.DrawingPolygons[4], 3, 1, [3, 2, 4], [0, 0, 0], []);
        Assert.Equal((0, 0), (shape.DrawingPolygons[2].PositiveSurface, shape.DrawingPolygons[2].NegativeSurface));

        var drawing = shape.DrawingTree!.Nodes;
        AssertNode(drawing[0], BspTag.Port, new(0, 1, 0, 0), sphere, 1, 3, 0);
        Assert.Equal([new BspPortal(1, 0)], drawing[0].Portals);
        AssertNode(drawing[1], BspTag.BpIN, new(0, 0, 1, 0), drawing[1].Sphere, -1, 2, 2);
        AssertLeaf(drawing[2], 0, 0, default);
        AssertLeaf(drawing[3], 1, 0, default);
    }

    [Fact]
    [Behaviour("dats.sample.environment", "data/dat-samples/README.md; spec/07, section 7")]
    public void Environment_of_a_floor_and_a_portal()
    {
        CellStruct cell = Assert.Single(TestData.Sample<CellEnvironment>("environment-0D000010").Cells);

        Assert.Equal(6, cell.Vertices.Vertices.Length);
        Assert.Equal(2, cell.Polygons.Length);
        AssertPolygon(cell.Polygons[0], 4, 0, [0, 1, 2, 3], [], []);
        AssertPolygon(cell.Polygons[1], 0x14, 0, [2, 3, 4, 5], [], []);
        Assert.Equal(-1, cell.Polygons[1].PositiveSurface);
        AssertPolygon(Assert.Single(cell.PhysicsPolygons), 4, 0, [0, 1, 2, 3], [], []);
        Assert.Equal([(ushort)1], cell.PortalPolygons);
        AssertNode(cell.CellTree.Nodes[0], BspTag.BPnn, new(0, 0, 1, 0), default, 1, -1);
        AssertNode(cell.CellTree.Nodes[1], BspTag.BPnn, new(0, -1, 0, 2), default, 2, -1);
        AssertLeaf(cell.CellTree.Nodes[2], 0, 0, default);
        AssertNode(cell.PhysicsTree.Nodes[0], BspTag.BPnN, new(0, 0, 1, 0), new(Vector3.Zero, 3), 1, 2);
        AssertLeaf(cell.PhysicsTree.Nodes[1], 0, 0, default);
        AssertLeaf(cell.PhysicsTree.Nodes[2], 1, 1, new(Vector3.Zero, 3), 0);
        Assert.Null(cell.DrawingTree);
    }

    [Theory]
    [InlineData(0, 20, 12, 10, 2f, 2f, 3.92f, 0f)]
    [InlineData(1, 14, 9, 8, -2f, 6f, 3.92f, 4f)]
    [Behaviour("dats.sample.environment-rooms", "data/dat-samples/README.md; spec/07, section 7")]
    public void Environment_of_two_rooms(
        int index, int vertices, int polygons, int walls, float south, float north, float radius, float centreY)
    {
        CellStruct cell = TestData.Sample<CellEnvironment>("environment-0D000001").Cells[index];

        Assert.Equal((uint)index, cell.Key);
        Assert.Equal(vertices, cell.Vertices.Vertices.Length);
        Assert.Equal(polygons, cell.Polygons.Length);
        Assert.Equal(walls, cell.PhysicsPolygons.Length);
        Assert.Equal(Enumerable.Range(walls, polygons - walls), cell.PortalPolygons.Select(p => (int)p));
        Assert.All(
            cell.PortalPolygons,
            p => Assert.Equal(((DatStippling)0x14, (short)-1), (cell.Polygons[p].Stippling, cell.Polygons[p].PositiveSurface)));

        Plane[] planes = [new(1, 0, 0, 3), new(-1, 0, 0, 3), new(0, 1, 0, south), new(0, -1, 0, north), new(0, 0, 1, 0), new(0, 0, -1, 3)];
        var cellNodes = cell.CellTree.Nodes;
        Assert.Equal(6, cellNodes.Length);
        for (int i = 0; i < 6; i++)
            AssertNode(cellNodes[i], i < 5 ? BspTag.BPnn : BspTag.Bpnn, planes[i], default, i < 5 ? i + 1 : -1, -1);

        var nodes = cell.PhysicsTree.Nodes;
        Assert.Equal(13, nodes.Length);
        for (int wall = 0, node = 0; wall < 6; wall++, node = nodes[node].Positive)
        {
            Assert.Equal((BspTag.BPnN, planes[wall]), (nodes[node].Tag, nodes[node].Plane));
            AssertClose(new Vector3(0, centreY, 1.5f), nodes[node].Sphere.Centre, 0);
            Assert.Equal(radius, nodes[node].Sphere.Radius, 0.005f);
            BspNode leaf = nodes[nodes[node].Negative];
            Assert.True(leaf.IsLeaf);
            Assert.Equal(wall, leaf.LeafIndex);
            Assert.NotEmpty(leaf.Polygons);
            bool open = wall == 2 || (wall == 3 && index == 0);
            Assert.Equal(open ? 0 : 1, leaf.Solid);
        }

        AssertLeaf(nodes.Single(n => n.IsLeaf && n.LeafIndex == 6), 6, 0, default);
        var drawing = cell.DrawingTree!.Nodes;
        AssertNode(
            drawing[0], BspTag.BPIn, new(0, 0, 1, 0), nodes[0].Sphere, 1, -1, [.. Enumerable.Range(0, walls).Select(i => (short)i)]);
        AssertLeaf(drawing[1], 0, 0, default);
    }

    private static void AssertNode(
        BspNode node, BspTag tag, Plane plane, DatSphere sphere, int positive, int negative, params short[] polygons)
    {
        Assert.Equal(tag, node.Tag);
        Assert.Equal(plane, node.Plane);
        Assert.Equal(sphere, node.Sphere);
        Assert.Equal((positive, negative), (node.Positive, node.Negative));
        Assert.Equal(polygons, node.Polygons);
    }

    private static void AssertLeaf(BspNode node, int index, int solid, DatSphere sphere, params short[] polygons)
    {
        Assert.True(node.IsLeaf);
        Assert.Equal((index, solid), (node.LeafIndex, node.Solid));
        Assert.Equal(sphere, node.Sphere);
        Assert.Equal((-1, -1), (node.Positive, node.Negative));
        Assert.Equal(polygons, node.Polygons);
    }

    private static void AssertPolygon(DatPolygon polygon, int stippling, int sides, int[] vertices, int[] positive, int[] negative)
    {
        Assert.Equal((DatStippling)stippling, polygon.Stippling);
        Assert.Equal(sides, polygon.Sides);
        Assert.Equal(vertices, polygon.Vertices.Select(v => (int)v));
        Assert.Equal(positive, polygon.PositiveUVs.Select(v => (int)v));
        Assert.Equal(negative, polygon.NegativeUVs.Select(v => (int)v));
    }

    private static void AssertClose(Vector3 expected, Vector3 actual, float tolerance)
        => Assert.True(Vector3.Distance(expected, actual) <= tolerance, $"{actual} is not {expected}");
}
