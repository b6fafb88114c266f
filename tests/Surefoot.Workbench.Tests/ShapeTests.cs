using System.Buffers;
using System.Collections.Immutable;
using System.Numerics;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Workbench.Simulation;
using StaticObject = Surefoot.Dats.Records.StaticObject;

namespace Surefoot.Workbench.Tests;

/// <summary>What is drawn is where it stops a body.</summary>
public sealed class ShapeTests
{
    private const uint Block = 0xA9B4FFFF, Thing = 0x02000001, Mesh = 0x01000001;

    [Fact]
    [Behaviour("workbench.shapes.resting-pose", "spec/06, 3: every object is made with placement 0x65")]
    public void An_object_is_drawn_as_it_rests()
    {
        PhysicsWorld world = new PhysicsEngine(new PhysicsDataCache(new Records(
            new Region { Id = 0x13000000, HeightTable = [.. Enumerable.Repeat(0f, 256)] },
            new LandBlock { Id = Block, InfoFlag = 1, Terrain = [.. new ushort[81]], Heights = [.. new byte[81]] },
            new LandBlockInfo { Id = Block - 1, Objects = [new StaticObject(Thing, At(100))] },
            new Setup
            {
                Id = Thing,
                PartIds = [Mesh],
                PlacementFrames = [new PlacementFrame(0, new AnimFrame([At(1)])), new PlacementFrame(0x65, new AnimFrame([At(3)]))],
            },
            Triangle))).World;
        Assert.True(world.LoadLandblock(Block));
        BlockShapes shapes = ShapeCollector.Collect(world.FindLandblock(Block)!);
        Assert.Equal([103f, 104f, 104f], shapes.Objects.Select(corner => corner.X));
        Assert.Empty(shapes.Moving);
    }

    [Fact]
    [Behaviour("workbench.shapes.moving-parts", "spec/02, 4.19")]
    public void Parts_that_an_animation_moves_are_drawn_where_the_physics_has_them()
    {
        using SimulatedWorld world = new("Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, []);
        WorkbenchPlace place = world.Places.Single(one => one.Name == "The windmill");
        ushort block = (ushort)(place.CellId >> 16);
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, place, 100);
        IReadOnlyList<MovingShape> shapes = world.ReadShapes(block)!.Moving;
        Assert.Equal([(0, 0), (0, 1)], shapes.Select(shape => ((int)shape.Object, (int)shape.Part)));

        List<MovingPart> parts = [];
        double now = 100;
        // Six frames of a thirtieth are six degrees about the mill's y; the time before the first tick is too long to count.
        for (int i = 0; i <= 6; i++, now += 1.001 / 30) Assert.True(world.Advance(now));
        world.LookAtParts(player, parts);
        Assert.Equal([(block, 0, 0), (block, 0, 1)], parts.Select(part => (part.Block, (int)part.Object, (int)part.Part)));
        Assert.Equal(Quaternion.Identity, parts[0].Rotation);
        Assert.Equal(parts[0].Position + new Vector3(0, -1.9f, 4.4f), parts[1].Position, (a, b) => (a - b).Length() < 1e-4f);
        Assert.Equal(Math.Sin(3 * Math.PI / 180), parts[1].Rotation.Y, 1e-5);
        Assert.Equal(1f, parts[1].Scale);

        // Far from it nothing is told.
        player.Goto(world.Places.Single(one => one.Name == "The runway"), now);
        world.LookAtParts(player, parts);
        Assert.Empty(parts);
    }

    private static DatFrame At(float x) => new(new Vector3(x, 0, 0), Quaternion.Identity);

    private static GfxObj Triangle => new()
    {
        Id = Mesh,
        Flags = GfxObjFlags.HasPhysics,
        Vertices = new DatVertexArray(
            [
                .. ImmutableArray.Create(Vector3.Zero, Vector3.UnitX, new Vector3(1, 1, 0))
                    .Select((p, i) => new DatVertex((ushort)i, p, Vector3.UnitZ))]),
        PhysicsPolygons = [new DatPolygon { Vertices = [0, 1, 2] }],
        PhysicsTree = BspTree.OfLeaf(new BspNode { Solid = 1, Sphere = new DatSphere(Vector3.Zero, 2), Polygons = [0] }),
    };

    private sealed class Records(params DatRecord[] records) : IDatSource
    {
        public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
        {
            DatRecord? found = Array.Find(records, record => record.Id == id);
            bytes = found is null ? default : new ReadOnlySequence<byte>(found.Encode());
            return found is not null;
        }
    }
}
