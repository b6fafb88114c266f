using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>Records that contradict themselves: an error that names the record, or nothing worse than retail.</summary>
public class HostileRecordTests
{
    private static void AssertRefused(GfxObj record, string complaint)
    {
        DatFormatException e = Assert.Throws<DatFormatException>(
            () => new PhysicsDataCache(new MemorySource().Add(record)).GetGfxObj(record.Id));
        Assert.Equal(record.Id, e.RecordId);
        Assert.Contains(complaint, e.Message);
    }

    private static void AssertRefused(Setup record, string complaint)
    {
        DatFormatException e = Assert.Throws<DatFormatException>(
            () => new PhysicsDataCache(new MemorySource().Add(record)).GetSetup(record.Id));
        Assert.Equal(record.Id, e.RecordId);
        Assert.Contains(complaint, e.Message);
    }

    [Fact, Behaviour("assets.hostile.missing-polygon", "design.md, decision 7")]
    public void A_leaf_that_names_a_missing_polygon_is_refused()
    {
        AssertRefused(Records.Slab(leaf: [0, 1]), "polygon 1 of 1");
        AssertRefused(Records.Slab(leaf: [-1]), "polygon -1 of 1");
    }

    [Fact, Behaviour("assets.hostile.missing-vertex", "design.md, decision 7")]
    public void A_polygon_that_names_a_missing_vertex_or_none_is_refused()
    {
        AssertRefused(Records.Slab(corners: [0, 1, 4]), "vertex 4 of 4");
        AssertRefused(Records.Slab(corners: []), "0 corners");
    }

    [Fact, Behaviour("assets.hostile.not-finite", "design, decision 7")]
    public void Numbers_that_are_not_finite_are_refused()
    {
        AssertRefused(Records.Slab(firstVertex: new(float.NaN, 0, 0)), "vertex 0");
        AssertRefused(Records.Slab(firstVertex: new(0, float.PositiveInfinity, 0)), "vertex 0");
        AssertRefused(new Setup { Id = 0x02000005, StepUpHeight = float.NaN }, "step-up height");
        AssertRefused(new Setup { Id = 0x02000005, Spheres = [new DatSphere(Vector3.Zero, float.PositiveInfinity)] }, "sphere");
        AssertRefused(new Setup { Id = 0x02000005, CylSpheres = [new DatCylSphere(new(float.NaN, 0, 0), 1, 1)] }, "cylinder");
    }

    [Fact, Behaviour("assets.hostile.missing-mesh", "spec/06, 2: a part whose mesh cannot be loaded is an error at load")]
    public void A_setup_without_one_of_its_meshes_is_refused()
    {
        DatRecordMissingException e = Assert.Throws<DatRecordMissingException>(
            () => new PhysicsDataCache(new MemorySource().Add(new Setup { Id = 0x02000005, PartIds = [0x01000099] })).GetSetup(0x02000005));
        Assert.Equal((0x01000099u, 0x02000005u), (e.Id, e.RequestedBy));
    }

    [Fact, Behaviour("assets.hostile.missing-portal-polygon", "spec/05, question 5")]
    public void A_portal_that_names_a_missing_polygon_is_refused()
    {
        CellEnvironment record = new()
        {
            Id = 0x0D000005,
            Cells =
            [
                new CellStruct
                {
                    CellTree = BspTree.OfLeaf(new BspNode()),
                    PhysicsTree = BspTree.OfLeaf(new BspNode()),
                    PortalPolygons = [0],
                },
            ],
        };
        DatFormatException e =
            Assert.Throws<DatFormatException>(() => new PhysicsDataCache(new MemorySource().Add(record)).GetEnvironment(record.Id));
        Assert.Equal(record.Id, e.RecordId);
        Assert.Contains("polygon 0 of 0", e.Message);
    }

    [Theory, Behaviour("assets.hostile.no-area", "spec/04, 4.4: a plane of NaN, never hit")]
    [InlineData(0, 1, 0, 1)]
    [InlineData(0, 0, 0, 0)]
    [InlineData(2)]
    [InlineData(0, 3)]
    public void A_polygon_without_area_is_loaded_and_stops_nothing(params int[] corners)
    {
        GfxObj record = Records.Slab(corners: [.. corners.Select(c => (ushort)c)]);
        PhysicsBsp tree = new PhysicsDataCache(new MemorySource().Add(record)).GetGfxObj(record.Id).Physics!;
        PolygonContact contact = default;
        Assert.False(tree.SphereIntersectsPoly(Records.Near(0.2f), new(0, 0, -1), ref contact));
        Assert.False(contact.IsSome);
        Assert.False(tree.SphereIntersectsSolid(Records.Near(0.2f), false));
        Assert.False(tree.HitsWalkable(Records.Near(0.2f), Vector3.UnitZ, 0));
    }

    [Theory, Behaviour("assets.hostile.deep-tree", "design.md, decision 7")]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    [InlineData(true, true)]
    public void A_line_of_ten_thousand_nodes_loads_and_answers(bool downFront, bool polygonsBeside)
    {
        PhysicsBsp tree = new PhysicsDataCache(new MemorySource().Add(Records.Line(10_000, downFront, polygonsBeside)))
            .GetGfxObj(0x01000020).Physics!;
        Assert.Equal(10_000, tree.NodeCount);
        // The widest sphere straddles every plane of the line.
        Sphere huge = new(Vector3.Zero, 500), small = Records.Near(0.2f);
        PolygonContact contact = default;
        Assert.True(tree.SphereIntersectsPoly(huge, new(0, 0, -1), ref contact));
        Assert.True(tree.SphereIntersectsSolid(huge, true));
        bool solid = false;
        contact = default;
        tree.SphereIntersectsSolidPoly(huge, 500, ref solid, ref contact, true);
        Assert.Equal(0, contact.Polygon);
        WalkableSearch search = new() { Sphere = small, Movement = new(0, 0, -1), Up = Vector3.UnitZ, WalkInterp = 1 };
        tree.FindWalkable(ref search);
        tree.PointIntersectsSolid(Vector3.Zero);
        Assert.True(RetailMath.IsFinite(search.Sphere.Center));
    }

    [Fact, Behaviour("assets.hostile.endless-branches", "design.md, decision 7")]
    public void A_tree_that_would_need_too_large_a_stack_is_refused() =>
        AssertRefused(Records.Line(PhysicsBsp.MaxPending + 1, downFront: true, polygonsBeside: true), "branches");

    [Fact, Behaviour("assets.hostile.cycle", "design.md, decision 7")]
    public void A_tree_whose_nodes_form_a_cycle_is_refused()
    {
        PhysicsBspBuilder builder = new(PolygonSet.Empty);
        int a = builder.AddNode(new Plane(0, 0, 1, 0), default), b = builder.AddNode(new Plane(0, 0, 1, 0), default);
        builder.SetPositive(a, b);
        builder.SetNegative(b, a);
        Assert.Throws<FormatException>(() => builder.Build(a, default));
    }
}
