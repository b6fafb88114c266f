using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

public sealed class ShapesTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    [Fact, Behaviour("demo-world.shapes.trees-tell-solid-from-air", "spec/07, 7.3")]
    public void The_tree_of_every_solid_shape_tells_inside_from_outside()
    {
        int shapes = 0;
        foreach (var shape in Colliding())
        {
            Vector3[][] faces = [.. shape.PhysicsPolygons.Select(polygon => Solids.Points(shape.Vertices, polygon))];
            AssertTree(shape.PhysicsTree!, faces, $"0x{shape.Id:X8}");
            AssertTellsSolid(shape.PhysicsTree!, faces, (leaf, inside) => (leaf.Solid == 1) == inside, $"0x{shape.Id:X8}");
            shapes++;
        }

        Assert.True(shapes > 30);
    }

    [Fact, Behaviour("demo-world.shapes.rooms-are-hollow", "spec/07, 7.3")]
    public void The_tree_of_every_room_is_empty_where_the_room_is_air()
    {
        foreach (var (cell, name) in Rooms())
        {
            Vector3[][] faces = [.. cell.PhysicsPolygons.Select(polygon => Solids.Points(cell.Vertices, polygon))];
            Vector3[][] portals = [.. cell.PortalPolygons.Select(index => Solids.Points(cell.Vertices, cell.Polygons[index]))];
            AssertTree(cell.PhysicsTree, faces, name);
            AssertTellsSolid(
                cell.PhysicsTree, [.. faces, .. portals], (leaf, air) => !air || (leaf.Solid == 0 && leaf.Polygons.IsEmpty), name);
        }
    }

    [Fact, Behaviour("demo-world.shapes.cell-trees-hold-the-air", "spec/07, 7.4")]
    public void The_cell_tree_of_a_room_encloses_its_air_and_ends_at_its_portals()
    {
        foreach (var (cell, name) in Rooms())
        {
            foreach (var polygon in cell.Polygons)
            {
                foreach (var point in Solids.Points(cell.Vertices, polygon))
                    Assert.True(cell.CellTree.Nodes.All(node => Vector3.Dot(node.Plane.Normal, point) + node.Plane.D >= -1e-5), name);
            }

            foreach (var portal in cell.PortalPolygons.Select(index => Solids.Points(cell.Vertices, cell.Polygons[index])))
            {
                var outside = portal.Aggregate(Vector3.Zero, (sum, point) => sum + point) / portal.Length + (Solids.Normal(portal) * 0.05f);
                Assert.Contains(cell.CellTree.Nodes, node => Vector3.Dot(node.Plane.Normal, outside) + node.Plane.D < 0);
            }
        }
    }

    [Fact, Behaviour("demo-world.shapes.portals-match", "spec/07, 7.11")]
    public void Portals_of_joined_rooms_are_the_same_rectangle_and_name_each_other()
    {
        int joined = 0, outside = 0;
        foreach (uint id in world.Dats.IdsOf(DatRecordType.EnvCell))
        {
            var cell = world.Dats.Read<EnvCell>(id);
            for (int i = 0; i < cell.Portals.Length; i++)
            {
                var portal = cell.Portals[i];
                if (portal.IsOutside)
                {
                    outside++;
                    continue;
                }

                var other = world.Dats.Read<EnvCell>((id & 0xFFFF0000) | portal.OtherCell);
                var back = other.Portals[portal.OtherPortal];
                Assert.Equal(id & 0xFFFF, back.OtherCell);
                Assert.Equal(i, back.OtherPortal);
                Assert.Contains((ushort)(other.Id & 0xFFFF), cell.VisibleCells);
                var here = Corners(cell, portal.Polygon);
                var there = Corners(other, back.Polygon);
                Assert.Equal(here.Order(Comparer<Vector3>.Create(Compare)), there.Order(Comparer<Vector3>.Create(Compare)));
                Assert.True(Vector3.Dot(Solids.Normal(here), Solids.Normal(there)) < -0.999f);
                joined++;
            }
        }

        Assert.Equal((2 * ((3 * 3) + 6), 3), (joined, outside));
    }

    [Fact, Behaviour("demo-world.shapes.buildings-lead-in", "spec/07, 7.13")]
    public void Each_building_leads_to_the_portal_of_its_hall_and_counts_its_cells()
    {
        foreach (uint id in world.Dats.IdsOf(DatRecordType.LandBlockInfo))
        {
            var info = world.Dats.Read<LandBlockInfo>(id);
            uint block = id & 0xFFFF0000;
            Assert.True(world.Dats.Read<LandBlock>(block | 0xFFFF).HasInfo);
            for (uint cell = 0; cell < info.CellCount; cell++)
                Assert.True(world.Dats.Cell.TryGetEntry(block + 0x100 + cell, out _));
            Assert.False(world.Dats.Cell.TryGetEntry(block + 0x100 + info.CellCount, out _));
            foreach (var portal in info.Buildings.SelectMany(building => building.Portals))
                Assert.True(world.Dats.Read<EnvCell>(block | portal.OtherCell).Portals[portal.OtherPortal].IsOutside);
            Assert.Equal(
                info.Buildings.Length, info.Buildings.Select(
                    building => ((int)(building.Frame.Origin.X / 24), (int)(building.Frame.Origin.Y / 24))).Distinct().Count());
        }
    }

    [Fact, Behaviour("demo-world.places.leave-room-for-a-body", "design.md, Two commands")]
    public void No_place_is_inside_something_solid()
    {
        foreach (var place in DemoPlaces.All)
        {
            uint block = place.CellId & 0xFFFF0000;
            if (!world.Dats.TryRead<LandBlockInfo>(block | 0xFFFE, out var info))
                continue;
            var things = info.Objects.Select(thing => (thing.ObjectId, thing.Frame))
                .Concat(info.Buildings.Select(building => (ObjectId: building.ModelId, building.Frame)));
            foreach (var (shapeId, frame) in things.SelectMany(thing => PartsOf(thing.ObjectId).Select(part => (part, thing.Frame))))
            {
                var shape = world.Dats.Read<GfxObj>(shapeId);
                Vector3[][] faces = [.. shape.PhysicsPolygons.Select(polygon => Solids.Points(shape.Vertices, polygon))];
                foreach (var point in BodyPoints(place.Origin))
                    Assert.False(Solids.Contains(faces, Vector3.Transform(point - frame.Origin, Quaternion.Conjugate(frame.Rotation))),
                        $"{place.Name} is inside 0x{shapeId:X8}");
            }
        }
    }

    [Fact, Behaviour("demo-world.windmill.turns", "spec/02, 4.19; spec/06, 3")]
    public void The_windmills_sails_turn_a_degree_a_frame_in_one_plane_and_keep_off_its_tower()
    {
        var setup = world.Dats.Read<Setup>(DemoIds.WindmillSetup);
        var turning = world.Dats.Read<Animation>(setup.DefaultAnimationId);
        Assert.Equal((2u, 90), (turning.PartCount, turning.Frames.Length));
        Assert.Equal(setup.PlacementFrames[0].Frame.Parts, turning.Frames[0].Parts);
        var sails = world.Dats.Read<GfxObj>(setup.PartIds[1]);
        Assert.NotNull(sails.PhysicsTree);
        for (int i = 0; i < turning.Frames.Length; i++)
        {
            Assert.Equal(DatFrame.Identity, turning.Frames[i].Parts[0]);
            var frame = turning.Frames[i].Parts[1];
            var along = Vector3.Transform(Vector3.UnitX, frame.Rotation);
            Assert.Equal(Math.Cos(i * Math.PI / 180), along.X, 1e-6);
            Assert.Equal(0f, along.Y, 1e-6f);
            foreach (var vertex in sails.Vertices.Vertices)
            {
                // The tower's wall is at y = -1.6; the land's cell ends 12 m from the mill.
                var point = frame.Origin + Vector3.Transform(vertex.Position, frame.Rotation);
                Assert.InRange(point.Y, -2, -1.5999f);
                Assert.InRange(point.Z, 0.2, 9);
                Assert.InRange(point.X, -5, 5);
            }
        }
    }

    [Fact, Behaviour("demo-world.places.stand-on-floors", "design.md, Two commands")]
    public void Indoor_places_stand_on_a_floor_and_in_the_air_of_their_room()
    {
        int indoor = 0;
        foreach (var place in DemoPlaces.All.Where(place => (place.CellId & 0xFFFF) >= 0x100))
        {
            var cell = world.Dats.Read<EnvCell>(place.CellId);
            var room = world.Dats.Read<CellEnvironment>(cell.EnvironmentId).Cells[cell.Structure];
            var feet = Vector3.Transform(place.Origin - cell.Position.Origin, Quaternion.Conjugate(cell.Position.Rotation));
            Vector3[][] faces = [.. room.Polygons.Select(polygon => Solids.Points(room.Vertices, polygon))];
            foreach (var point in BodyPoints(feet))
                Assert.True(Solids.Contains(faces, point), $"{place.Name}: {point} is not in the air");
            Assert.False(Solids.Contains(faces, feet - new Vector3(0, 0, 0.02f)), $"{place.Name} has no floor");
            indoor++;
        }

        Assert.Equal(8, indoor);
    }

    [Fact, Behaviour("demo-world.spawns.are-there", "design.md, Two commands")]
    public void There_are_guards_wanderers_a_crowd_of_a_hundred_and_a_door()
    {
        var spawns = DemoSpawns.All;
        Assert.Equal(spawns.Length, spawns.Select(spawn => spawn.Name).Distinct().Count());
        Assert.Equal(100, spawns.Count(spawn => spawn.Kind == DemoSpawnKind.Crowd));
        Assert.True(spawns.Count(spawn => spawn.Kind == DemoSpawnKind.Guard) >= 2);
        Assert.All(spawns.Where(spawn => spawn.Kind == DemoSpawnKind.Wanderer), spawn => Assert.True(spawn.WanderRadius > 0));
        Assert.Single(spawns, spawn => spawn.Kind == DemoSpawnKind.Door);
        Assert.All(spawns, spawn => Assert.NotEmpty(world.Dats.Read<Setup>(spawn.SetupId).PartIds));
    }

    [Fact, Behaviour("demo-world.spawns.beside-edges", "spec/05, 4.18: on the line between two cells a body may be said to be in either")]
    public void Nobody_is_spawned_on_the_line_between_two_squares_of_land()
    {
        foreach (var origin in DemoSpawns.All.Select(spawn => spawn.Origin).Concat(DemoShooters.All.Select(shooter => shooter.Origin)))
        {
            Assert.True(MathF.Abs(origin.X - (24 * MathF.Round(origin.X / 24))) > 0.009f, $"{origin}");
            Assert.True(MathF.Abs(origin.Y - (24 * MathF.Round(origin.Y / 24))) > 0.009f, $"{origin}");
        }

        // The crowd's west side would be on a block's border.
        Assert.Equal(0.01f, DemoSpawns.All.Single(spawn => spawn.Name == "crowd-1").Origin.X, 1e-5f);
    }

    // Of a setup the parts that stand where it stands; those that an animation moves are nowhere for long.
    private IEnumerable<uint> PartsOf(uint id)
    {
        if (!world.Dats.Portal.TryGetEntry(id, out _) || DatIds.RecordTypeOf(id, DatFileKind.Portal) != DatRecordType.Setup)
            return [id];
        var setup = world.Dats.Read<Setup>(id);
        return setup.PartIds.Where((_, part) => setup.PlacementFrames[0].Frame.Parts[part] == DatFrame.Identity);
    }

    private static IEnumerable<Vector3> BodyPoints(Vector3 feet)
    {
        for (int height = 0; height < 3; height++)
        {
            yield return feet + new Vector3(0, 0, 0.2f + (0.8f * height));
            for (int turn = 0; turn < 8; turn++)
                yield return feet + new Vector3(0.46f * MathF.Cos(turn), 0.46f * MathF.Sin(turn), 0.3f + (0.6f * height));
        }
    }

    private IEnumerable<GfxObj> Colliding()
        => world.Dats.IdsOf(DatRecordType.GfxObj).Select(id => world.Dats.Read<GfxObj>(id)).Where(shape => shape.PhysicsTree is not null);

    private IEnumerable<(CellStruct Cell, string Name)> Rooms()
        => world.Dats.IdsOf(DatRecordType.Environment)
            .SelectMany(id => world.Dats.Read<CellEnvironment>(id).Cells.Select(cell => (cell, $"0x{id:X8} room {cell.Key}")));

    private Vector3[] Corners(EnvCell cell, ushort polygon)
    {
        var room = world.Dats.Read<CellEnvironment>(cell.EnvironmentId).Cells[cell.Structure];
        Assert.Contains(polygon, room.PortalPolygons);
        return Solids.Points(room.Vertices, room.Polygons[polygon]);
    }

    private static int Compare(Vector3 a, Vector3 b) => (a.X, a.Y, a.Z).CompareTo((b.X, b.Y, b.Z));

    // Spec 07, 7.3: both children, spheres around the subtree's polygons, polygons in the leaves behind them.
    private static void AssertTree(BspTree tree, Vector3[][] faces, string name)
    {
        foreach (var node in tree.Nodes)
        {
            Assert.True(node.IsLeaf || (node.Tag == BspTag.BPnN && node.Positive > 0 && node.Negative > 0), name);
            foreach (short polygon in PolygonsBelow(tree, node))
                Assert.All(faces[polygon], point => Assert.True(Vector3.Distance(point, node.Sphere.Centre) <= node.Sphere.Radius, name));
        }

        var random = new Random(1);
        for (int i = 0; i < faces.Length; i++)
        {
            var normal = Solids.Normal(faces[i]);
            for (int sample = 0; sample < 20; sample++)
            {
                var behind = Solids.PointOn(faces[i], random) - (normal * 0.001f);
                Assert.True(Solids.LeafAt(tree, behind).Polygons.Contains((short)i), $"{name}: polygon {i} is missing behind itself");
            }
        }
    }

    private static void AssertTellsSolid(BspTree tree, Vector3[][] faces, Func<BspNode, bool, bool> agrees, string name)
    {
        Vector3 low = new(float.MaxValue), high = new(float.MinValue);
        foreach (var point in faces.SelectMany(face => face))
            (low, high) = (Vector3.Min(low, point), Vector3.Max(high, point));
        low -= new Vector3(0.5f);
        high += new Vector3(0.5f);
        var random = new Random(2);
        for (int sample = 0; sample < 400; sample++)
        {
            var point = low + ((high - low) * new Vector3(random.NextSingle(), random.NextSingle(), random.NextSingle()));
            Assert.True(agrees(Solids.LeafAt(tree, point), Solids.Contains(faces, point)), $"{name} at {point}");
        }
    }

    private static HashSet<short> PolygonsBelow(BspTree tree, BspNode node)
    {
        var found = new HashSet<short>();
        var open = new Stack<BspNode>([node]);
        while (open.TryPop(out var next))
        {
            found.UnionWith(next.Polygons);
            if (next.IsLeaf)
                continue;
            open.Push(tree.Nodes[next.Positive]);
            open.Push(tree.Nodes[next.Negative]);
        }

        return found;
    }
}
