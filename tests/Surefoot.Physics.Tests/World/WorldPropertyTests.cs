using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

public sealed class WorldPropertyTests(FirstWorld files) : IClassFixture<FirstWorld>
{
    private static readonly Gen<float> Height = Gen.Int[0, 200].Select(h => 2f * h);

    [Fact]
    [Behaviour("world.terrain.height.interpolates", "spec/05, 4.3, 4.4")]
    public void The_plane_under_a_point_passes_through_the_triangles_corners()
    {
        Gen.Select(Height.Array[TerrainSurface.VertexCount], Gen.UInt[0, 254], Gen.UInt[0, 254], Gen.Float[0, 192],
            Gen.Float[0, 192]).Sample(
            (heights, column, row, x, y) =>
            {
                TerrainSurface terrain = new((column << 24) | (row << 16), heights, new ushort[TerrainSurface.VertexCount]);
                int triangle = terrain.FindTriangle(TerrainSurface.CellUnder(x, y), new Vector3(x, y, 0));
                Assert.True(triangle >= 0);
                Vector3[] corners = new Vector3[3];
                terrain.CopyCorners(triangle, corners);
                foreach (Vector3 corner in corners) Assert.Equal(0, RetailMath.Distance(terrain.PlaneOf(triangle), corner), 1e-4);
                Assert.True(terrain.PlaneOf(triangle).Normal.Z > 0);
                Assert.True(terrain.TryGetHeight(x, y, out float z));
                Assert.InRange(z, corners.Min(c => c.Z) - 0.01f, corners.Max(c => c.Z) + 0.01f);
            },
            iter: Fuzz.Cases(2000));
    }

    [Fact]
    [Behaviour("world.borders.invisible", "spec/05, 4.15, 4.19")]
    public void A_walk_over_a_border_is_the_walk_over_the_same_ground_away_from_one()
    {
        Gen.Select(Gen.Float[-0.25f, 0.25f], Gen.Float[-0.25f, 0.25f], Gen.Int[-3, 3], Gen.Int[-3, 3], Gen.Float[-6, 6],
            Gen.Float[-6, 6]).Sample(
            (east, north, slopeX, slopeY, x, y) =>
            {
                Vector3[] away = Walk(Slope(slopeX, slopeY), new Vector3(96 + x, 96 + y, 0), new Vector3(east, north, 0));
                Vector3[] border = Walk(Slope(slopeX, slopeY), new Vector3(192 + x, 192 + y, 0), new Vector3(east, north, 0));
                for (int i = 0; i < away.Length; i++) Assert.Equal(0, (away[i] - border[i]).Length(), 2e-3f);
            },
            iter: Fuzz.Cases(40));
    }

    [Fact]
    [Behaviour("world.shadows.history", "spec/05, 4.17; @0x00514AE0, @0x00511230")]
    public void Shadows_after_any_history_are_those_computed_afresh()
    {
        uint[] blocks = [0xA9B40000, 0xA9B50000, 0xA8B40000, FirstWorld.DungeonBlock];
        Gen<Deed> deed = Gen.Select(Gen.Int[0, 7], Gen.Int[0, 5], Gen.Float[-8, 8],
            Gen.Float[-8, 8]).Select((what, who, x, y) => new Deed(what, who, x, y));
        deed.List[1, 40].Sample(
            deeds =>
            {
                PhysicsWorld world = files.Load(blocks);
                PhysicsEngine engine = new(world);
                foreach (Deed d in deeds) Do(d, world, engine, blocks);
                CheckShadows(world, engine);
            },
            iter: Fuzz.Cases(25));
    }

    [Fact]
    [Behaviour("world.quanta.allocate-nothing", "design, decision 4")]
    public void A_quantum_among_trees_and_rooms_allocates_nothing()
    {
        PhysicsWorld world = files.Load(FirstWorld.Blocks);
        PhysicsEngine engine = new(world);
        PhysicsBody body = Add(engine, files, 1, new Position(0xA9B40001, new Vector3(96, 70, 60)));
        // Code that is not yet optimised boxes flags; what counts is what remains.
        long allocated = long.MaxValue;
        for (int round = 0; round < 400 && allocated > 0; round++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 314; i++)
            {
                double angle = i * 0.02;
                Strides.Walk(body, new Vector3((float)Math.Cos(angle) * 0.2f, (float)Math.Sin(angle) * 0.2f, 0));
            }

            allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, allocated);
        Assert.False(body.IsLost);
    }

    private void Do(Deed deed, PhysicsWorld world, PhysicsEngine engine, uint[] blocks)
    {
        uint id = (uint)deed.Who + 1;
        PhysicsBody? body = engine.Find(id);
        Vector3 around = new(96 + deed.X, 96 + deed.Y, 60);
        switch (deed.What)
        {
            case 0 when body is not null:
                engine.RemoveBody(body);
                break;
            case 1 when body is not null:
                body.SetPositionSimple(new Position(0xA9B40001, new Vector3(96 + (12 * deed.X), 96 + (12 * deed.Y), 60)), true);
                break;
            case 2:
                if (!world.UnloadLandblock(blocks[deed.Who % blocks.Length])) world.LoadLandblock(blocks[deed.Who % blocks.Length]);
                break;
            case 3 when body is not null:
                body.SetPositionSimple(new Position(0x01050102, new Vector3(60 + (deed.X / 8), 80 + deed.Y, -19.5f)), true);
                break;
            case 4 when body is not null:
                body.SetPositionSimple(new Position(0xA9B40102, new Vector3(96 + (deed.X / 4), 96 + (deed.Y / 4), 27)), true);
                break;
            default:
                body ??= Add(engine, files, id, new Position(0xA9B40001, around));
                for (int i = 0; i < 10; i++) Strides.Walk(body, new Vector3(deed.X / 16, deed.Y / 16, 0));
                break;
        }
    }

    private static void CheckShadows(PhysicsWorld world, PhysicsEngine engine)
    {
        foreach (PhysicsBody body in engine.Bodies)
        {
            HashSet<uint> ids = [];
            for (int i = 0; i < body.ShadowCount; i++)
            {
                ShadowObject shadow = body.ShadowAt(i);
                Assert.True(ids.Add(shadow.CellId));
                Assert.Same(world.GetVisible(shadow.CellId), shadow.Cell);
                if (shadow.Cell is not null) Assert.Single(LoadingTests.Listed(shadow.Cell), o => ReferenceEquals(o, body));
            }

            if (body.Cell is null)
            {
                Assert.Empty(ids);
                continue;
            }

            Assert.Same(world.GetVisible(body.Position.CellId), body.Cell);
            // A body put into the air keeps the list of the probe that found no footing (specification 03, 4.9, step 5) until it moves.
            if (!body.HasContact) continue;
            Transition fresh = new(world);
            fresh.Reset();
            fresh.Path.InitSpheres(body.Setup!.Spheres, body.Scale);
            fresh.Path.SetCheckPos(body.Position, body.Cell);
            ObjCell? home = null;
            world.FindCellList(fresh.Cells, fresh.Path.CheckPos, fresh.Path.CheckSpheres, false, ref home);
            Assert.Equal(Enumerable.Range(0, fresh.Cells.Count).Select(i => fresh.Cells[i].Id).Order(), ids.Order());
        }

        // No cell lists anybody who does not know of it.
        foreach (ObjCell cell in world.Landblocks.SelectMany(block => block.Cells))
        {
            foreach (WorldObject item in LoadingTests.Listed(cell))
                Assert.Contains(Enumerable.Range(0, item.ShadowCount), i => ReferenceEquals(item.ShadowAt(i).Cell, cell));
        }
    }

    private static PhysicsBody Add(PhysicsEngine engine, FirstWorld files, uint id, in Position place)
    {
        PhysicsBody body = engine.CreateBody(id, files.Cache.GetSetup(0x02000001), weenie: WeenieTraits.Present | WeenieTraits.Creature);
        SteeredPhysicsBody.Of(body).Attach(new Strides());
        body.EnterWorld(place);
        return body;
    }

    /// <summary>An inclined plane over four blocks, heights in whole metres.</summary>
    private static PhysicsWorld Slope(int slopeX, int slopeY)
    {
        PhysicsWorld world = new();
        for (int bx = 0; bx < 2; bx++)
        {
            for (int by = 0; by < 2; by++)
            {
                int ox = 8 * bx, oy = 8 * by;
                world.Add(new Landblock(Ground.Of(
                    0xA9B40000 + ((uint)bx << 24) + ((uint)by << 16), (i, j) => 100 + (slopeX * (i + ox)) + (slopeY * (j + oy)))));
            }
        }

        return world;
    }

    /// <summary>Positions along a walk, relative to where it was asked to begin and to the ground there.</summary>
    private static Vector3[] Walk(PhysicsWorld world, Vector3 start, Vector3 stride)
    {
        Position place = new(0xA9B40001, start with { Z = 200 });
        Assert.True(place.AdjustToOutside());
        LandCell cell = (LandCell)world.GetVisible(place.CellId)!;
        Assert.True(cell.Landblock.Terrain.TryGetHeight(place.Frame.Origin.X, place.Frame.Origin.Y, out float ground));
        place.Frame.Origin.Z = ground;
        PhysicsBody body = CellListTests.Enter(world, place);
        Vector3[] way = new Vector3[40];
        for (int i = 0; i < way.Length; i++)
        {
            Strides.Walk(body, stride);
            Assert.False(body.IsLost);
            way[i] = place.OffsetTo(body.Position);
            Assert.True(body.OnWalkable);
        }

        return way;
    }

    /// <summary>One random deed of one body, or of whoever loads the world.</summary>
    private sealed record Deed(int What, int Who, float X, float Y);
}
