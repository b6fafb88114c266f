using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Objects that another one holds: specification 09, 5.11.</summary>
public class HeldObjectTests
{
    private const uint Hand = 1, Head = 6, Belt = 4, NoSuchLocation = 9;

    private static readonly GfxObjAsset Mesh = new() { Id = 0x01000001 };

    /// <summary>
    /// Two parts, of which the second is the hand: half a metre to the right, a metre up. The hand holds things 0.25 m ahead of it, the
    /// belt holds them at a part that there is not.
    /// </summary>
    private static readonly SetupAsset Shape = new SetupAsset
    {
        Id = 0x02000001,
        Parts = [new SetupPart(Mesh, Vector3.One), new SetupPart(Mesh, Vector3.One)],
        Spheres = [new Sphere(new Vector3(0, 0, 0.5f), 0.5f)],
        HoldingLocations =
        [
            new HoldingLocation(Hand, 1, At(0, 0.25f, 0)), new HoldingLocation(Head, 0, At(0, 0, 1.5f)),
            new HoldingLocation(Belt, uint.MaxValue, At(0, -0.125f, 0.5f)),
        ],
    }.With(0, [Frame.Identity, At(0.5f, 0, 1)]);

    private readonly PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
    private readonly PhysicsBody holder;
    private readonly PhysicsBody item;

    public HeldObjectTests()
    {
        holder = Spawn(1, Shape, new Vector3(12, 12, 0));
        item = Spawn(2, Shape, new Vector3(5, 5, 0));
    }

    [Theory]
    [Behaviour("body.held.where-the-holder-has-it", "spec/09, 5.11; CPhysicsObj::UpdateChild @0x00512D50")]
    [InlineData(Hand, 1f, 12.25f, 11.5f, 1f)]
    [InlineData(Hand, 2f, 12.25f, 11f, 2f)]
    [InlineData(Belt, 2f, 11.875f, 12f, 0.5f)]
    public void It_is_where_the_holders_part_is_or_the_holder_itself(uint location, float scale, float x, float y, float z)
    {
        holder.SetScale(scale);
        holder.SetHeading(90);
        Assert.True(item.SetParent(holder, location));
        AssertNear(new Vector3(x, y, z), item);
        Assert.Equal(90, item.Position.Frame.Heading, 1e-4);
        Assert.Equal((StubWorld.CellId, true), (item.Position.CellId, ReferenceEquals(holder.Cell, item.Cell)));
        Assert.Equal((1, holder), (holder.HeldCount, item.Parent));

        holder.SetHeading(0);
        holder.SetPositionSimple(new Position(StubWorld.CellId, new Vector3(20, 20, 0)), sliding: true);
        AssertNear(location == Hand ? new Vector3(20 + (0.5f * scale), 20.25f, scale) : new Vector3(20, 19.875f, 0.5f), item);
    }

    [Fact]
    [Behaviour("body.held.follows-the-animation", "spec/09, 5.11; CPhysicsObj::UpdateChildrenInternal @0x00513DA0")]
    public void It_follows_the_hand_as_the_animation_moves_it_and_what_it_holds_follows_it()
    {
        AnimationAsset wave = new(0x03000001, 3, default,
            [Frame.Identity, At(1, 0, 1), Frame.Identity, At(2, 0, 1), Frame.Identity, At(3, 0, 1)]);
        MotionTableAsset table = new MotionTableBuilder(0x09000001).Style(MotionCommand.NonCombat, MotionCommand.Ready)
            .Cycle(MotionCommand.NonCombat, MotionCommand.Ready, new MotionAsset([new AnimationSpan(wave, 0, -1, 30f)])).Build();
        SteeredPhysicsBody.Of(holder).Attach(new MovementManager(holder, table, weenie: null));
        PhysicsBody gem = Spawn(3, Shape, new Vector3(1, 1, 0));
        Assert.True(item.SetParent(holder, Hand));
        Assert.True(gem.SetParent(item, Head));
        List<float> seen = [];
        for (int i = 0; i < 6; i++)
        {
            holder.AdvanceQuantum(BodyFixture.Tick);
            float hand = holder.PartFrame(1).Origin.X;
            AssertNear(new Vector3(hand, 12.25f, 1), item);
            AssertNear(new Vector3(hand, 12.25f, 2.5f), gem);
            seen.Add(hand);
        }

        Assert.Equal([13f, 14f, 15f], seen.Distinct().Order());
    }

    [Fact]
    [Behaviour("body.held.no-quanta", "spec/09, 5.11; spec/02, 4.3, step 1")]
    public void It_has_no_quanta_of_its_own_and_keeps_its_velocity()
    {
        engine.Player = holder;
        Assert.True(item.SetParent(holder, Hand));
        item.SetVelocity(new Vector3(3, 0, 0));
        item.SetOmega(new Vector3(0, 0, 1));
        Position place = item.Position;
        for (int i = 1; i <= 5; i++)
        {
            Assert.True(engine.Tick(i * 0.05));
            Assert.Equal((place, false, new Vector3(3, 0, 0)), (item.Position, item.IsActive, item.Velocity));
        }
    }

    [Fact]
    [Behaviour("body.held.leaves-the-world-first", "spec/09, 5.11, steps 1 to 3; CPhysicsObj::set_parent @0x00515A90")]
    public void What_is_taken_leaves_the_ground_and_then_belongs_to_the_cell_of_its_holder()
    {
        QuantumCounter movement = new();
        SteeredPhysicsBody.Of(item).Attach(movement);
        Assert.True(item.OnWalkable);
        Assert.True(item.SetParent(holder, Hand));
        Assert.Equal((1, TransientState.None), (movement.Leaves, item.Transient));
        Assert.Same(holder.Cell, item.Cell);
        Assert.False(item.EnterWorld(new Position(StubWorld.CellId, new Vector3(1, 1, 0))));

        // A holder in no cell takes it out of the world, and brings it back when it comes in.
        PhysicsBody nowhere = engine.CreateBody(4, Shape);
        Assert.True(item.SetParent(nowhere, Hand));
        Assert.Equal((0u, null), (item.Position.CellId, item.Cell));
        Assert.Equal((0, 1), (holder.HeldCount, nowhere.HeldCount));
        Assert.True(nowhere.EnterWorld(new Position(StubWorld.CellId, new Vector3(30, 30, 0))));
        Assert.Same(nowhere.Cell, item.Cell);
        AssertNear(new Vector3(30.5f, 30.25f, 1), item);
        nowhere.LeaveWorld();
        Assert.Equal((StubWorld.CellId, null), (item.Position.CellId, item.Cell));
    }

    [Fact]
    [Behaviour("body.held.without-parts", "spec/09, 5.11, step 3")]
    public void A_body_without_parts_is_held_but_enters_no_cell()
    {
        PhysicsBody bare = engine.CreateBody(3, setup: null);
        Assert.True(bare.SetParent(holder, Hand));
        Assert.Equal((0u, null), (bare.Position.CellId, bare.Cell));
        AssertNear(new Vector3(12.5f, 12.25f, 1), bare);
        Assert.False(item.SetParent(bare, Hand));
    }

    [Fact]
    [Behaviour("body.held.refused", "spec/09, 5.11; design, decision 7")]
    public void A_location_that_there_is_not_and_a_ring_of_holders_are_refused_and_nothing_changes()
    {
        PhysicsBody third = Spawn(3, Shape, new Vector3(1, 1, 0));
        Assert.True(item.SetParent(holder, Hand));
        Assert.True(third.SetParent(item, Hand));
        ulong before = engine.HashState();
        Assert.False(holder.SetParent(holder, Hand));
        Assert.False(holder.SetParent(item, Hand));
        Assert.False(holder.SetParent(third, Hand));
        Assert.False(third.SetParent(holder, NoSuchLocation));
        Assert.Equal(before, engine.HashState());
        Assert.Same(item, third.Parent);
        Assert.Throws<ArgumentException>(() => third.SetParent(new PhysicsEngine(new StubWorld(_ => null)).CreateBody(9, Shape), Hand));
    }

    [Fact]
    [Behaviour("body.held.same-holder-again", "spec/09, 5.11, step 1")]
    public void Given_to_the_same_holder_again_it_is_held_once_at_the_new_location()
    {
        Assert.True(item.SetParent(holder, Hand));
        PhysicsBody other = Spawn(3, Shape, new Vector3(1, 1, 0));
        Assert.True(other.SetParent(holder, Hand));
        Assert.True(item.SetParent(holder, Head));
        Assert.Equal([other, item], Enumerable.Range(0, holder.HeldCount).Select(holder.HeldAt));
        AssertNear(new Vector3(12, 12, 1.5f), item);
    }

    [Fact]
    [Behaviour("body.held.let-go", "spec/09, 5.11; CPhysicsObj::unset_parent @0x00513470")]
    public void Let_go_it_stays_where_the_hand_was_and_falls_when_it_is_woken()
    {
        Assert.True(item.SetParent(holder, Hand));
        PhysicsBody other = Spawn(3, Shape, new Vector3(1, 1, 0));
        Assert.True(other.SetParent(holder, Head));
        item.UnsetParent();
        Assert.Equal((null, 1, other), (item.Parent, holder.HeldCount, holder.HeldAt(0)));
        holder.SetPositionSimple(new Position(StubWorld.CellId, new Vector3(20, 20, 0)), sliding: true);
        AssertNear(new Vector3(12.5f, 12.25f, 1), item);
        Assert.Same(holder.Cell, item.Cell);

        engine.Player = holder;
        for (int i = 1; i <= 60; i++) engine.Tick(i * 0.05);
        AssertNear(new Vector3(12.5f, 12.25f, 0), item);
        Assert.True(item.OnWalkable);
        item.UnsetParent();
        holder.UnparentChildren();
        Assert.Equal((0, null), (holder.HeldCount, other.Parent));
    }

    [Fact]
    [Behaviour("body.held.hidden-with-the-holder", "spec/09, 5.11, step 4; spec/02, 4.18, set_hidden")]
    public void What_a_hidden_body_holds_is_not_drawn()
    {
        bool IsDrawn() => !item.State.HasFlag(PhysicsState.NoDraw);

        holder.SetHidden(true);
        Assert.True(item.SetParent(holder, Hand));
        Assert.False(IsDrawn());
        item.UnsetParent();
        Assert.True(IsDrawn());
        Assert.True(item.SetParent(holder, Hand));
        holder.SetHidden(false);
        Assert.True(IsDrawn());
        holder.SetState(holder.State | PhysicsState.Hidden);
        Assert.False(IsDrawn());
    }

    [Fact]
    [Behaviour("body.held.removal", "spec/09, 5.6 and 5.11")]
    public void What_a_deleted_body_held_stays_known_in_no_cell()
    {
        Assert.True(item.SetParent(holder, Hand));
        engine.RemoveBody(holder);
        Assert.Equal((item, null, null), (engine.Find(2), item.Parent, item.Cell));
        Assert.Equal(StubWorld.CellId, item.Position.CellId);
        Assert.True(item.EnterWorld(new Position(StubWorld.CellId, new Vector3(3, 3, 0))));

        PhysicsBody second = Spawn(3, Shape, new Vector3(9, 9, 0));
        Assert.True(second.SetParent(item, Hand));
        engine.RemoveBody(second);
        Assert.Equal(0, item.HeldCount);
    }

    [Fact]
    [Behaviour("body.held.allocates-nothing", "design, decision 4")]
    public void A_holder_that_moves_allocates_nothing()
    {
        Assert.True(item.SetParent(holder, Hand));
        PhysicsBody gem = Spawn(3, Shape, new Vector3(1, 1, 0));
        Assert.True(gem.SetParent(item, Head));
        void Advance(int count)
        {
            for (int i = 0; i < count; i++)
            {
                holder.SetVelocity(new Vector3(1, 1, 0));
                holder.AdvanceQuantum(BodyFixture.Tick);
            }
        }

        Advance(100);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Advance(100);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.True(gem.Position.Frame.Origin.X > 16);
    }

    private static Frame At(float x, float y, float z) => new(new Vector3(x, y, z), Quaternion.Identity);

    private static void AssertNear(Vector3 expected, PhysicsBody body) =>
        Assert.True(Vector3.Distance(expected, body.Position.Frame.Origin) < 1e-5f, $"expected {expected}, is at {body.Position}");

    private PhysicsBody Spawn(uint id, SetupAsset shape, Vector3 place)
    {
        PhysicsBody body = engine.CreateBody(id, shape);
        Assert.True(body.EnterWorld(new Position(StubWorld.CellId, place)));
        return body;
    }
}
