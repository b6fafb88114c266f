using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using static Surefoot.Physics.Tests.World.HostileWorldTests;
using MeshRecords = Surefoot.Physics.Tests.Assets.Records;

namespace Surefoot.Physics.Tests.World;

/// <summary>Bodies among records that promise too much or too little: none of them hangs, breaks or is lost.</summary>
public sealed class HostileBodiesTests
{
    private const uint Cell = 0xA9B40001, Scene = 0x12000001;

    private static readonly SetupAsset Walker = StubWorld.Setup(
        new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f));

    [Theory]
    [Behaviour("world.strict.scenery-scale", "spec/07, 9.1; spec/05, 4.8")]
    [InlineData(0, 0)]
    [InlineData(-1, -1)]
    [InlineData(float.NaN, 1)]
    [InlineData(0, 1)]
    [InlineData(1, float.PositiveInfinity)]
    public void Strict_loading_names_the_scene_of_scenery_without_a_size(float least, float most)
    {
        SceneObject thing =
            new() { ObjectId = Thing, BaseFrame = DatFrame.Identity, Frequency = 2, MinScale = least, MaxScale = most, MaxSlope = 2 };
        PhysicsWorld world = new Records { [Scene] = new Scene { Id = Scene, Objects = [thing] } }.World(SceneryEverywhere, strict: true);
        DatFormatException error = Assert.Throws<DatFormatException>(() => world.LoadLandblock(Block));
        Assert.Equal(Scene, error.RecordId);
        Assert.Empty(world.Landblocks);
    }

    [Fact]
    [Behaviour("world.hostile.scenery-of-size-1", "spec/05, 4.8: the control of the test above")]
    public void Scenery_of_an_ordinary_size_loads()
    {
        SceneObject thing =
            new() { ObjectId = Thing, BaseFrame = DatFrame.Identity, Frequency = 2, MinScale = 1, MaxScale = 1, MaxSlope = 2 };
        PhysicsWorld world = new Records { [Scene] = new Scene { Id = Scene, Objects = [thing] } }.World(SceneryEverywhere);
        Assert.True(world.LoadLandblock(Block));
        Assert.NotEmpty(world.FindLandblock(Block)!.StaticObjects);
    }

    [Theory]
    [Behaviour("world.hostile.body-scale", "design.md, decision 7")]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void A_body_without_a_size_is_refused_at_the_door(float scale)
    {
        PhysicsEngine engine = new(new Records().World());
        Assert.Throws<ArgumentException>(() => engine.CreateBody(1, Walker, scale: scale));
        Assert.Empty(engine.Bodies);
        Assert.Null(engine.Find(1));
    }

    [Fact]
    [Behaviour("world.hostile.setup-without-parts",
        "design.md, decision 7; spec/06, 2; spec/02, 4.4 step 5: without spheres a body stays where it is")]
    public void A_setup_without_parts_stops_nobody_and_a_body_of_it_stays_where_it_was_put()
    {
        PhysicsWorld world = new Records
        {
            [Thing] = new Setup { Id = Thing },
            [Info] = new LandBlockInfo { Id = Info, CellCount = 1, Objects = [At(Thing, 12), At(Thing, 13)] },
        }.World();
        Assert.True(world.LoadLandblock(Block));
        PhysicsEngine engine = new(world);
        PhysicsBody bare = engine.CreateBody(2, world.FindLandblock(Block)!.StaticObjects[0].Setup),
            walker = Enter(engine, 1, new Vector3(10, 12, 0));
        Assert.True(bare.EnterWorld(new Position(Cell, new Vector3(11.5f, 12, 5))));
        Position put = bare.Position;
        for (int i = 0; i < 40; i++)
        {
            Strides.Walk(walker, new Vector3(0.1f, 0, 0));
            bare.AdvanceQuantum(1f / 30);
        }

        Assert.Equal(14, walker.Position.Frame.Origin.X, 1e-3f);
        Assert.Equal(put.Frame.Origin, bare.Position.Frame.Origin);
        Assert.NotNull(bare.Cell);
        engine.RemoveBody(bare);
        AssertNobodyIsListed(world, bare);
    }

    [Theory]
    [Behaviour("world.hostile.deep-tree-walked", "design.md, decision 7")]
    [InlineData(false, false)]
    [InlineData(true, true)]
    public void A_body_walks_against_a_mesh_of_ten_thousand_nodes_in_a_line(bool downFront, bool polygonsBeside)
    {
        GfxObj line = MeshRecords.Line(10_000, downFront, polygonsBeside);
        PhysicsWorld world =
            new Records { [line.Id] = line, [Info] = new LandBlockInfo { Id = Info, CellCount = 1, Objects = [At(line.Id, 12)] } }.World();
        Assert.True(world.LoadLandblock(Block));
        PhysicsEngine engine = new(world);
        // All of its box is solid, so nobody can be placed near it.
        PhysicsBody walker = engine.CreateBody(1, Walker, weenie: WeenieTraits.Present | WeenieTraits.Creature);
        Position begin = new(Cell, new Vector3(9, 12, 0));
        Assert.False(walker.EnterWorld(begin, slide: false));
        walker.Seat(
            new BodySeat(begin, Vector3.Zero, TransientState.Contact | TransientState.OnWalkable, new Plane(0, 0, 1, 0), Cell,
                Vector3.Zero));
        for (int i = 0; i < 20; i++) Strides.Walk(walker, new Vector3(0.2f, 0.01f, 0));
        Assert.NotNull(walker.Cell);
        Assert.True(RetailMath.IsFinite(walker.Position.Frame.Origin));
    }

    [Fact]
    [Behaviour("world.hostile.crowded-cell-walked", "design.md, decision 7; spec/05, 4.17")]
    public void A_body_is_stopped_among_ten_thousand_objects_of_one_cell()
    {
        PhysicsWorld world = new Records
        {
            [Info] = new LandBlockInfo
            {
                Id = Info,
                CellCount = 1,
                Objects = [.. Enumerable.Range(0, 10_000).Select(i => At(Thing, 8 + (i * 0.0001f)))],
            },
        }.World();
        Assert.True(world.LoadLandblock(Block));
        PhysicsEngine engine = new(world);
        PhysicsBody walker = Enter(engine, 1, new Vector3(6, 12, 0));
        for (int i = 0; i < 20; i++) Strides.Walk(walker, new Vector3(0.2f, 0, 0));

        // The first cylinder has a radius of 0.5 m.
        Assert.InRange(walker.Position.Frame.Origin.X, 6.5f, 8 - 0.97f);
        Assert.True(walker.OnWalkable);
    }

    [Fact]
    [Behaviour("world.hostile.crowded-cell-of-bodies", "design.md, decision 7; spec/05, 4.17")]
    public void Ten_thousand_bodies_live_in_one_cell_and_none_is_left_behind()
    {
        PhysicsWorld world = new Records().World();
        Assert.True(world.LoadLandblock(Block));
        PhysicsEngine engine = new(world);
        PhysicsBody[] bodies = new PhysicsBody[10_000];
        for (int i = 0; i < bodies.Length; i++)
        {
            // Hooks are put where they are told without a test (specification 02, 4.16, ForceIntoCell); every hundredth body is tested
            // against all before it.
            WeenieTraits weenie = i % 100 == 0 ? WeenieTraits.Present : WeenieTraits.Present | WeenieTraits.Hook;
            bodies[i] = engine.CreateBody((uint)i + 1, Walker, PhysicsState.Default | PhysicsState.Ethereal | PhysicsState.IgnoreCollisions,
                weenie);
            Assert.True(bodies[i].EnterWorld(new Position(Cell, new Vector3(12, 12, 0))));
        }

        ObjCell cell = world.GetVisible(Cell)!;
        Assert.Equal(bodies.Length, cell.ShadowCount);
        for (int i = 0; i < bodies.Length; i += 100) Strides.Walk(bodies[i], new Vector3(0, 0.1f, 0));
        Assert.Equal(bodies.Length, cell.ShadowCount);
        for (int i = 0; i < bodies.Length; i += 100) Assert.Equal(12.1f, bodies[i].Position.Frame.Origin.Y, 1e-3f);

        // Out in an order that is neither that of coming nor its reverse.
        for (int i = 0; i < bodies.Length; i++) engine.RemoveBody(bodies[i * 7919 % bodies.Length]);
        Assert.Equal(0, cell.ShadowCount);
        Assert.Empty(engine.Bodies);
    }

    [Fact]
    [Behaviour("world.hostile.portal-to-nowhere", "design.md, decision 7; spec/05, 4.14, 4.19; spec/03, 4.6 check_other_cells step 4")]
    public void Whoever_goes_through_a_portal_to_a_room_that_does_not_exist_waits_there_and_can_be_fetched()
    {
        (PhysicsWorld world, uint hall, Vector3 middle) = RoomTests.HallWithADoorToNowhere();
        PhysicsEngine engine = new(world);
        PhysicsBody body = engine.CreateBody(1, Walker, weenie: WeenieTraits.Present);
        Assert.True(body.EnterWorld(new Position(hall, middle)));
        for (int i = 0; i < 60 && !body.IsLost; i++) Strides.Walk(body, new Vector3(0.2f, 0, 0));
        Assert.True(body.IsLost);
        Assert.Null(body.Cell);
        AssertNobodyIsListed(world, body);
        Assert.True(RetailMath.IsFinite(body.Position.Frame.Origin));

        Assert.Equal(PlacementResult.OK, body.SetPositionSimple(new Position(hall, middle), sliding: true));
        Assert.False(body.IsLost);
        Assert.Equal(hall, body.Cell?.Id);
    }

    private static Region SceneryEverywhere { get; } = new()
    {
        Id = DatIds.Region,
        HeightTable = [.. new float[256]],
        SceneTypes = [new SceneType(0, [Scene])],
        TerrainTypes = [new TerrainType("Meadow", default, [0])],
    };

    private static PhysicsBody Enter(PhysicsEngine engine, uint id, Vector3 at)
    {
        PhysicsBody body = engine.CreateBody(id, Walker, weenie: WeenieTraits.Present | WeenieTraits.Creature);
        Assert.True(body.EnterWorld(new Position(Cell, at)));
        return body;
    }

    private static void AssertNobodyIsListed(PhysicsWorld world, PhysicsBody body) =>
        Assert.DoesNotContain(body, world.Landblocks.SelectMany(block => block.Cells).SelectMany(LoadingTests.Listed));
}
