using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.Transitions.Obstacles;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>How an object is put down and which of its shapes count: specification 06, 2 and 3; 02, 2.2; 05, 4.8 f.</summary>
public class ObjectPoseTests
{
    private const uint Hook = 0x67;

    private static readonly GfxObjAsset Cube = new()
    {
        Id = 0x01000001,
        Physics = Trees.UnitCube(),
        BoundingBox = new BoundingBox(new Vector3(-0.5f), new Vector3(0.5f)),
    };

    private static readonly Vector3 Place = new(84, 84, 5);

    [Fact]
    [Behaviour("object.pose.resting",
        "spec/06, 3: every object is made with placement 0x65, so with placement 0 only if its setup has no 0x65")]
    public void Everything_lies_as_resting_things_do_where_its_setup_says_how()
    {
        SetupAsset both = Setup((0, 1), (SetupAsset.Resting, 3), (Hook, 5)), one = Setup((0, 1), (Hook, 5));
        Assert.Equal((3f, 1f), (PartAt(Static(both)), PartAt(Static(one))));
        Assert.Equal((3f, 1f), (PartAt(Body(both)), PartAt(Body(one))));
        Assert.True(Hits(Static(both), Place + new Vector3(3, 0, 0)));
        Assert.False(Hits(Static(both), Place + new Vector3(1, 0, 0)));

        // So does a building, of which the first part alone stops anybody.
        BuildingObject shell = new(Static(both), []);
        Assert.NotEqual(TransitionState.OK, shell.FindBuildingCollisions(MoverAt(Place + new Vector3(3, 0, 0)).Transition));
        Assert.Equal(TransitionState.OK, shell.FindBuildingCollisions(MoverAt(Place + new Vector3(1, 0, 0)).Transition));
    }

    [Fact]
    [Behaviour("object.pose.placement-of-a-body",
        "spec/06, 3: the placement of a server's description; absent is 0, absent too moves nothing")]
    public void A_body_takes_the_placement_it_is_given()
    {
        PhysicsBody body = Body(Setup((0, 1), (SetupAsset.Resting, 3), (Hook, 5)));
        body.SetPlacement(Hook);
        Assert.Equal(5f, PartAt(body));
        body.SetPlacement(0x33);
        Assert.Equal(1f, PartAt(body));
        body.SetPlacement(SetupAsset.Resting);
        Assert.Equal(3f, PartAt(body));
        body.SetPlacement(0);
        Assert.Equal(1f, PartAt(body));

        PhysicsBody held = Body(Setup((Hook, 5)));
        Assert.Equal(0, held.PlacedPartCount);
        held.SetPlacement(Hook);
        Assert.Equal(5f, PartAt(held));
        held.SetPlacement(0x33);
        Assert.Equal(5f, PartAt(held));
    }

    [Fact, Behaviour("object.pose.placement-of-a-body.absent-is-listed", "spec/06, 3; spec/07, 9.1")]
    public void A_placement_that_a_setup_lacks_is_named_in_the_list_of_what_is_left_out()
    {
        PhysicsBody body = Body(Setup((0, 1), (Hook, 5)));
        body.SetPlacement(Hook);
        body.SetPlacement(0);
        Assert.Empty(body.Population.Cells.LeftOut);
        body.SetPlacement(0x33);
        // Said again with each position of a server: the same thing still.
        body.SetPlacement(0x33);
        body.SetPlacement(0);
        body.SetPlacement(0x33);
        LeftOutItem item = Assert.Single(body.Population.Cells.LeftOut);
        Assert.Equal((LeftOutKind.Placement, 0x02000001u, 2L, 1u), (item.Kind, item.Id, item.Count, item.FirstIn));
        Assert.Equal("the setup has no placement 0x33", item.Reason);
    }

    [Theory, Behaviour("body.state.contradictions-are-listed", "spec/02, 2.2; spec/06, 2")]
    [InlineData(PhysicsState.HasPhysicsBsp, "HAS_PHYSICS_BSP, but no part has a collision tree")]
    [InlineData(PhysicsState.HasDefaultAnim, "HAS_DEFAULT_ANIM, but the setup names no animation")]
    [InlineData(PhysicsState.Static | PhysicsState.Missile, "STATIC, but MISSILE, ALIGNPATH or SLEDDING as well")]
    [InlineData(PhysicsState.Static | PhysicsState.Ethereal | PhysicsState.Gravity, null)]
    public void A_state_word_with_contradictory_bits_is_listed_and_leaves_the_body_as_it_lies(PhysicsState word, string? reason)
    {
        PhysicsBody body = Body(
            new SetupAsset { Id = 0x02000001, Parts = [new SetupPart(new GfxObjAsset(), Vector3.One)] }.With(
                SetupAsset.Resting, [Records.FrameAt(new(3, 0, 0))]));
        body.SetState(word);
        Assert.Equal((word, 3f), (body.State, PartAt(body)));
        Assert.Equal(reason is null ? [] : [reason], body.Population.Cells.LeftOut.Select(item => item.Reason));
        Assert.All(body.Population.Cells.LeftOut, item => Assert.Equal((LeftOutKind.StateBit, 0x02000001u), (item.Kind, item.Id)));
    }

    [Fact, Behaviour("object.pose.follows-the-body", "spec/06, 3; spec/02, 4.17 set_frame")]
    public void The_parts_of_a_body_go_where_it_goes_and_turn_with_it()
    {
        PhysicsBody body = Body(Setup((SetupAsset.Resting, 3)));
        body.SetHeading(90);
        // Facing east, its right side is in the south.
        Assert.Equal(0, (body.PartFrame(0).Origin - (Place + new Vector3(0, -3, 0))).Length(), 1e-5);
        body.Seat(
            new BodySeat(new Position(StubWorld.CellId, Place + new Vector3(0, 9, 0)), Vector3.Zero, TransientState.None, default, 0,
                Vector3.Zero));
        Assert.Equal(Place + new Vector3(3, 9, 0), body.PartFrame(0).Origin);
    }

    [Fact, Behaviour("object.pose.scaled-scenery", "spec/05, 4.8 f: the parts are scaled, their places are not; spec/06, 3")]
    public void Parts_of_scaled_scenery_stay_at_their_unscaled_places()
    {
        StaticObject tree = Static(Setup((0, 3)), scale: 2);
        Assert.Equal(3f, PartAt(tree));
        // A cube of one metre to each side, at x = 3 and not at x = 6.
        Assert.True(Hits(tree, Place + new Vector3(3.95f, 0, 0)));
        Assert.True(Hits(tree, Place + new Vector3(2.05f, 0, 0)));
        Assert.False(Hits(tree, Place + new Vector3(6, 0, 0)));
    }

    [Fact]
    [Behaviour("object.pose.scaled-scenery.cells",
        "spec/05, 4.8 f and 4.17: the cells work from the unscaled places, whatever is loaded later")]
    public void The_cells_of_scaled_scenery_are_those_of_its_unscaled_places()
    {
        PhysicsWorld world = CellListTests.Flat(0xA9B40000);
        CrossCells cells = new(world);
        // The square 1C ends at x = 96, twelve metres on: a part at 11 m stays in it, at 22 m it would not.
        cells.FindStatic(Static(Setup((0, 11)), scale: 2, world));
        Assert.Equal("A9B4001C", CellListTests.Ids(cells.Cells));
    }

    [Fact, Behaviour("body.state.shape-bit-of-the-parts", "spec/02, 2.2; spec/06, 2: computed from the parts when the object is made")]
    public void When_an_object_is_made_its_parts_say_whether_it_has_a_tree()
    {
        SetupAsset flagged = new SetupAsset { Parts = [new SetupPart(new GfxObjAsset(), Vector3.One)] }.With(0, [Frame.Identity]);
        Assert.True(Body(Setup((0, 0))).State.HasFlag(PhysicsState.HasPhysicsBsp));
        Assert.False(Body(flagged, PhysicsState.HasPhysicsBsp).State.HasFlag(PhysicsState.HasPhysicsBsp));
        Assert.True(Static(Setup((0, 0))).State.HasFlag(PhysicsState.HasPhysicsBsp));
    }

    [Fact]
    [Behaviour("body.state.shape-bit-of-the-server",
        "spec/02, 2.2 and 4.21 step 7: a server's word decides between parts and cylinders or spheres")]
    public void Afterwards_the_last_state_word_says_which_shapes_count()
    {
        Sphere ball = new(new Vector3(8, 0, 0), 0.5f);
        PhysicsBody body = Body(Setup([ball], (0, 1)));
        Assert.Equal((true, false), (Hits(body, Place + Vector3.UnitX), Hits(body, Place + ball.Center)));
        body.SetState(PhysicsState.Default);
        Assert.Equal(PhysicsState.Default, body.State);
        Assert.Equal((false, true), (Hits(body, Place + Vector3.UnitX), Hits(body, Place + ball.Center)));
        body.SetState(PhysicsState.Default | PhysicsState.HasPhysicsBsp);
        Assert.Equal((true, false), (Hits(body, Place + Vector3.UnitX), Hits(body, Place + ball.Center)));

        // With the bit and without a tree nothing is left to be hit.
        PhysicsBody bare =
            Body(new SetupAsset { Parts = [new SetupPart(new GfxObjAsset(), Vector3.One)], Spheres = [ball] }.With(0, [Frame.Identity]));
        Assert.True(Hits(bare, Place + ball.Center));
        bare.SetState(PhysicsState.Default | PhysicsState.HasPhysicsBsp);
        Assert.False(Hits(bare, Place + ball.Center));
    }

    [Fact, Behaviour("world.shadows.shape-bit", "spec/05, 4.17: cell lists ask the bit")]
    public void The_last_state_word_says_by_which_shapes_the_cells_are_found()
    {
        PhysicsWorld world = CellListTests.Flat(0xA9B40000);
        PhysicsEngine engine = new(world);
        SetupAsset setup = new SetupAsset
        {
            Parts = [new SetupPart(Cube, Vector3.One)],
            SortingSphere = new Sphere(new Vector3(0, 11.9f, 0), 1),
        }.With(0, [new Frame(new Vector3(11.9f, 0, 0), Quaternion.Identity)]);
        PhysicsBody body = engine.CreateBody(1, setup, PhysicsState.None);
        Assert.True(body.EnterWorld(new Position(0xA9B4001C, Place)));
        Assert.Equal("A9B4001C A9B40024", Listed(world, body));
        body.SetState(PhysicsState.None);
        Assert.Equal("A9B4001C A9B4001D", Listed(world, body));
        body.SetState(PhysicsState.HasPhysicsBsp);
        Assert.Equal("A9B4001C A9B40024", Listed(world, body));
    }

    private static SetupAsset Setup(params (uint Placement, float X)[] placements) => Setup([], placements);

    private static SetupAsset Setup(Sphere[] spheres, params (uint Placement, float X)[] placements)
    {
        SetupAsset setup = new() { Id = 0x02000001, Parts = [new SetupPart(Cube, Vector3.One)], Spheres = spheres };
        foreach ((uint placement, float x) in placements) setup.With(placement, [new Frame(new Vector3(x, 0, 0), Quaternion.Identity)]);
        return setup;
    }

    private static StaticObject Static(SetupAsset setup, float scale = 1, PhysicsWorld? world = null)
    {
        const uint id = StubWorld.CellId;
        return world is null
            ? new StaticObject(setup, new Position(id, Place), 1, new StubWorld(_ => null).Cell, scale)
            : new StaticObject(setup, new Position(0xA9B4001C, Place), 1, world.GetVisible(0xA9B4001C)!, scale);
    }

    private static PhysicsBody Body(SetupAsset setup, PhysicsState state = PhysicsState.ReportCollisions)
    {
        PhysicsBody body = new PhysicsEngine(new StubWorld(_ => null)).CreateBody(1, setup, state);
        body.Seat(new BodySeat(new Position(StubWorld.CellId, Place), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
        return body;
    }

    private static string Listed(PhysicsWorld world, WorldObject item)
    {
        world.CalcCrossCells(item);
        return string.Join(' ', Enumerable.Range(0, item.ShadowCount).Select(i => item.ShadowAt(i).CellId.ToString("X8")));
    }

    /// <summary>How far east of the object its part is.</summary>
    private static float PartAt(WorldObject item) => item.PartFrame(0).Origin.X - Place.X;

    private static Mover MoverAt(Vector3 center) =>
        new Mover(MoverFlags.None, center, center, 0.1f).With(p => p.InsertType = InsertType.Placement);

    private static bool Hits(WorldObject item, Vector3 center) => item.FindObjCollisions(MoverAt(center).Transition) != TransitionState.OK;
}
