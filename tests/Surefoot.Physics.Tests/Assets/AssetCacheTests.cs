using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>From dat records to assets: specification 07, 7.1 to 7.10, and 06, sections 2 and 3.</summary>
public class AssetCacheTests
{
    private static PhysicsDataCache Samples() => new(DatSet.Open(Repository.PathOf("tests", "data", "dat-samples", "mini")));

    [Fact, Behaviour("assets.mesh.flattened", "dat-samples, gfxobj-01000001")]
    public void A_mesh_keeps_its_planes_polygons_and_bounds()
    {
        GfxObjAsset box = Samples().GetGfxObj(0x01000001);
        PhysicsBsp tree = Assert.IsType<PhysicsBsp>(box.Physics);
        Assert.Equal((6, 1, 6), (tree.NodeCount, tree.LeafCount, tree.Polygons.Count));
        Assert.Equal(new Sphere(new(0, 0, 1), 1.75f), tree.Bounds);
        Assert.Equal(new Sphere(new(0, 0, 1), 1.75f), box.DrawingSphere);
        Assert.Equal(new BoundingBox(new(-1, -1, 0), new(1, 1, 2)), box.BoundingBox);
        // In the order top, bottom, east, west, north, south, normals outwards.
        Vector3[] normals = [Vector3.UnitZ, -Vector3.UnitZ, Vector3.UnitX, -Vector3.UnitX, Vector3.UnitY, -Vector3.UnitY];
        for (int i = 0; i < 6; i++) Assert.Equal(normals[i], tree.Polygons.PlaneOf(i).Normal);
        Assert.True(tree.PointIntersectsSolid(new(0, 0, 1)));
        Assert.False(tree.PointIntersectsSolid(new(0, 0, 2.1f)));
        Assert.False(box.Always2D);
    }

    [Fact, Behaviour("assets.mesh.without-shape", "dat-samples, gfxobj-01000011")]
    public void A_mesh_without_a_tree_stops_nothing_and_has_an_empty_box()
    {
        GfxObjAsset empty = Samples().GetGfxObj(0x01000011);
        Assert.Null(empty.Physics);
        Assert.Null(empty.AnySphere);
        Assert.True(empty.BoundingBox.IsEmpty);
    }

    [Fact, Behaviour("assets.mesh.every-tag", "dat-samples, gfxobj-01000003, and spec/07, 7.2")]
    public void Every_tag_of_a_node_is_understood_and_a_missing_child_is_empty_space()
    {
        PhysicsBsp tree = Samples().GetGfxObj(0x01000003).Physics!;
        // Behind (1,0,0) 0 and in front of (0,1,0) −1 is a node with a child behind only, which has none at all.
        Assert.False(tree.PointIntersectsSolid(new(-1, 2, 3)));
        Assert.False(tree.SphereIntersectsSolid(new(new(-1, 2, 3), 0.5f), true));
        // In front of (1,0,0) 0, behind (0,1,0) 0 and behind (0,0,1) −1: the leaf with polygons.
        Assert.True(tree.PointIntersectsSolid(new(1, -1, 0.5f)));
    }

    [Fact, Behaviour("assets.room.flattened", "dat-samples, environment-0D000001")]
    public void A_room_keeps_its_walls_its_space_and_its_portals()
    {
        EnvironmentAsset environment = Samples().GetEnvironment(0x0D000001);
        Assert.Equal(2, environment.Structures.Length);
        Assert.Null(environment[2]);
        Assert.Null(environment[-1]);
        CellStructAsset room = environment[0]!;
        Assert.Equal(6, room.Cell.Planes.Length);
        Assert.True(room.Cell.PointInside(new(0, 0, 1)));
        Assert.False(room.Cell.PointInside(new(0, 2.1f, 1)));
        Assert.Equal(10, room.Physics.Polygons.Count);
        Assert.Equal(2, room.Portals.Count);
        Assert.True(room.TryFindPortal(11, out int north));
        Assert.Equal(new Vector3(0, 1, 0), room.Portals.PlaneOf(north).Normal);
        Assert.False(room.TryFindPortal(3, out _));
    }

    [Fact, Behaviour("assets.room.chain-ends-in-leaf", "dat-samples, environment-0D000010, and spec/07, 7.4")]
    public void A_containment_chain_may_end_in_a_leaf()
    {
        CellStructAsset room = Samples().GetEnvironment(0x0D000010)[0]!;
        Assert.Equal(2, room.Cell.Planes.Length);
        Assert.True(room.Cell.PointInside(new(0, 1, 1)));
        Assert.False(room.Cell.PointInside(new(0, 3, 1)));
    }

    [Fact, Behaviour("assets.setup.flattened", "dat-samples, setup-02000001")]
    public void A_setup_keeps_parts_shapes_heights_and_placements()
    {
        SetupAsset setup = Samples().GetSetup(0x02000001);
        Assert.Equal(2, setup.Parts.Length);
        Assert.Equal(new Vector3(0.5f, 0.5f, 2), setup.Parts[1].DefaultScale);
        Assert.Same(setup.Parts[0].Mesh, setup.Parts[1].Mesh);
        Assert.Equal([new CylSphere(new(0, 0, 0.25f), 0.35f, 1.5f)], setup.Cylinders.ToArray());
        Assert.Equal([new Sphere(new(0, 0, 0.475f), 0.48f), new Sphere(new(0, 0, 1.35f), 0.48f)], setup.Spheres.ToArray());
        Assert.Equal((1.835f, 0.6788225f, 0.6f, 1.5f), (setup.Height, setup.Radius, setup.StepUpHeight, setup.StepDownHeight));
        Assert.Equal(new Sphere(new(0, 0, 0.9f), 1.1f), setup.SortingSphere);
        Assert.Equal((true, 0x09000001u, false), (setup.AllowFreeHeading, setup.DefaultMotionTableId, setup.HasPhysicsBsp));
        Assert.Equal(1f, setup.Placement(0)[1].Origin.Z);
        Assert.Equal(0.5f, setup.Placement(0x65)[1].Origin.Z);
        Assert.Equal(1f, setup.Placement(0x33)[1].Origin.Z);
    }

    [Fact, Behaviour("assets.setup.has-physics-bsp", "spec/06, 2: from the parts, not from the flag")]
    public void A_setup_has_a_tree_when_a_part_has_one()
    {
        MemorySource source = new();
        source.Add(Records.Slab(), new GfxObj { Id = 0x01000011 });
        source.Add(
            new Setup { Id = 0x02000010, PartIds = [0x01000011, Records.SlabId] },
            new Setup { Id = 0x02000011, Flags = SetupFlags.HasPhysicsBsp, PartIds = [0x01000011] },
            new Setup { Id = 0x02000012 });
        PhysicsDataCache cache = new(source);
        Assert.True(cache.GetSetup(0x02000010).HasPhysicsBsp);
        Assert.False(cache.GetSetup(0x02000011).HasPhysicsBsp);
        SetupAsset bare = cache.GetSetup(0x02000012);
        Assert.True(bare.Parts.IsEmpty && bare.Placement(0).IsEmpty && !bare.HasPhysicsBsp);
    }

    [Fact, Behaviour("assets.setup.of-a-mesh", "spec/06, 2, CSetup::makeSimpleSetup")]
    public void A_mesh_id_stands_for_a_setup_of_one_part()
    {
        SetupAsset setup = Samples().GetSetup(0x01000001);
        Assert.Equal(0x01000001u, setup.Id);
        Assert.Equal(0x01000001u, Assert.Single(setup.Parts.ToArray()).Mesh.Id);
        Assert.Equal(Frame.Identity, Assert.Single(setup.Placement(0x65).ToArray()));
        Assert.Equal(new Sphere(new(0, 0, 1), 1.75f), setup.SortingSphere);
        Assert.Equal((0f, 0f, 0f), (setup.Height, setup.StepUpHeight, setup.StepDownHeight));
        Assert.True(setup.HasPhysicsBsp);
    }

    [Theory, Behaviour("assets.mesh.always-2d", "spec/05, 4.10: level 0 of the degrade record has a mode other than 1")]
    [InlineData(1, 1, false)]
    [InlineData(1, 2, true)]
    [InlineData(0, 2, false)]
    public void A_picture_is_known_by_its_degrade_record(byte levels, byte mode, bool picture)
    {
        byte[] degrade = new byte[28];
        (degrade[3], degrade[0], degrade[4], degrade[12]) = (0x11, 1, levels, mode);
        MemorySource source = new MemorySource().Add(Records.Slab(degrade: 0x11000001)).Add(0x11000001, degrade);
        Assert.Equal(picture, new PhysicsDataCache(source).GetGfxObj(Records.SlabId).Always2D);
    }

    [Fact, Behaviour("assets.cache.shared", "design.md, decision 3")]
    public void An_asset_is_read_once_and_shared()
    {
        MemorySource source = new MemorySource().Add(Records.Slab());
        PhysicsDataCache cache = new(source);
        GfxObjAsset first = cache.GetGfxObj(Records.SlabId);
        Assert.Same(first, cache.GetGfxObj(Records.SlabId));
        Assert.Same(first, cache.GetSetup(Records.SlabId).Parts[0].Mesh);
        Assert.Same(cache.GetSetup(Records.SlabId), cache.GetSetup(Records.SlabId));
        Assert.Equal(1, source.Reads);
    }

    [Fact, Behaviour("assets.cache.threads", "design, decision 2")]
    public void Threads_that_ask_at_once_get_the_same_assets()
    {
        MemorySource source = new();
        uint[] ids = [.. Enumerable.Range(0, 50).Select(i => 0x01000100u + (uint)i)];
        foreach (uint id in ids) source.Add(Records.Slab(id));
        PhysicsDataCache cache = new(source);
        GfxObjAsset[][] seen = new GfxObjAsset[8][];
        using Barrier start = new(seen.Length);
        Thread[] threads = [.. seen.Select((_, i) => new Thread(() =>
        {
            start.SignalAndWait();
            seen[i] = [.. ids.Select(id => cache.GetSetup(id).Parts[0].Mesh)];
        }))];
        foreach (Thread thread in threads) thread.Start();
        foreach (Thread thread in threads) thread.Join();
        foreach (GfxObjAsset[] other in seen)
        {
            for (int i = 0; i < ids.Length; i++) Assert.Same(seen[0][i], other[i]);
        }

        Assert.Equal(2 * ids.Length, cache.Count);
    }
}
