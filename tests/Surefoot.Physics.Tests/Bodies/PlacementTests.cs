using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Where a placement is accepted, and who is updated at all: specification 02, 4.3, 4.16, 4.17 and 6.15.</summary>
public class PlacementTests
{
    [Theory, Behaviour("placement.accepts.signed-distance", "spec/02, 6.15; CPhysicsObj::CheckPositionInternal @0x00511E90")]
    [InlineData(10.04f, 10f, true)]
    [InlineData(10.05f, 10f, false)]
    [InlineData(7f, 10f, true)]
    [InlineData(10f, 9f, true)]
    [InlineData(10.2f, 10f, false)]
    public void Without_sliding_a_place_five_centimetres_east_or_north_is_refused(float x, float y, bool accepted)
    {
        foreach (PlacementFlags flags in (PlacementFlags[])[PlacementFlags.Placement, PlacementFlags.Placement | PlacementFlags.Slide])
        {
            BodyFixture f = new();
            f.World.Cell.Obstacle = PushOnce(new Vector3(x, y, 0));
            bool slides = (flags & PlacementFlags.Slide) != 0;
            PlacementResult result =
                f.Body.SetPosition(new PlacementRequest(new Position(StubWorld.CellId, new Vector3(10, 10, 0)), flags));
            Assert.Equal(accepted || slides ? PlacementResult.OK : PlacementResult.NoValidPosition, result);
            if (result == PlacementResult.OK) Assert.Equal(new Vector3(x, y, 0), f.Body.Position.Frame.Origin);
        }
    }

    [Fact, Behaviour("placement.scatter", "spec/02, 4.16 SetScatterPositionInternal")]
    public void Scattered_places_are_tried_within_the_radii_until_one_is_free()
    {
        BodyFixture f = new();
        int asked = 0;
        f.World.Blocks = t => t.Path.InsertType == InsertType.InitialPlacement && ++asked < 4;
        Position middle = new(StubWorld.CellId, new Vector3(50, 60, 0));
        PlacementRequest request = new(middle, PlacementFlags.Scatter, 3, 5, 10);
        Assert.Equal(PlacementResult.OK, f.Body.SetPosition(request));
        Assert.Equal(4, asked);
        Vector3 off = f.Body.Position.Frame.Origin - middle.Frame.Origin;
        Assert.NotEqual(Vector3.Zero, off);
        Assert.InRange(off.X, -3f, 3f);
        Assert.InRange(off.Y, -5f, 5f);

        // Only scattered places, and none to be tried: a failure of its own.
        Assert.Equal(PlacementResult.GeneralFailure, f.Body.SetPosition(request with { Flags = PlacementFlags.RandomScatter, Tries = 0 }));
        f.World.Blocks = _ => true;
        Assert.Equal(PlacementResult.NoValidPosition, f.Body.SetPosition(request));
    }

    [Theory, Behaviour("placement.forced", "spec/02, 4.16 ForceIntoCell")]
    [InlineData(WeenieTraits.Hook)]
    [InlineData(WeenieTraits.Storage)]
    [InlineData(WeenieTraits.Corpse)]
    public void Hooks_chests_and_corpses_hang_where_they_are_put(WeenieTraits kind)
    {
        BodyFixture f = new();
        f.World.Blocks = _ => true;
        f.Body.SetWeenie(WeenieTraits.Present | kind);
        Assert.Equal(PlacementResult.OK, f.Body.SetPositionSimple(new Position(StubWorld.CellId, new Vector3(10, 10, -3)), sliding: false));
        Assert.Equal(new Vector3(10, 10, -3), f.Body.Position.Frame.Origin);
        Assert.False(f.Body.HasContact);
    }

    [Fact, Behaviour("body.active.within-96-metres", "spec/02, 4.3, steps 1 and 2")]
    public void A_body_sleeps_when_the_player_is_farther_than_96_metres_and_wakes_without_catching_up()
    {
        BodyFixture f = new();
        f.Seat(new Vector3(100, 12, 50), Vector3.Zero, TransientState.None);
        PhysicsBody player = f.Engine.CreateBody(2, f.Body.Setup, PhysicsState.None);
        f.Engine.Player = player;
        SeatPlayer(3.9f);
        f.Engine.Tick(1);
        f.Engine.Tick(1.1);
        Assert.False(f.Body.IsActive);
        Assert.Equal((50f, 1.1), (f.Z, f.Body.SimulatedTime));

        SeatPlayer(4f);
        f.Engine.Tick(2);
        Assert.True(f.Body.IsActive);
        Assert.Equal((50f, Vector3.Zero, 2.0), (f.Z, f.Body.Velocity, f.Body.SimulatedTime));
        f.Engine.Tick(2.1);
        Assert.True(f.Body.Velocity.Z < 0);

        void SeatPlayer(float x) => player.Seat(new BodySeat(
            new Position(StubWorld.CellId, new Vector3(x, 12, 50)), Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
    }

    [Theory, Behaviour("body.active.never-updated", "spec/02, 2.2, 4.3 and 4.5")]
    [InlineData(PhysicsState.Frozen, false)]
    [InlineData(PhysicsState.Static, true)]
    [InlineData(PhysicsState.Hidden, true)]
    public void Frozen_static_and_hidden_bodies_do_not_fall(PhysicsState state, bool timeGoesOn)
    {
        BodyFixture f = new();
        f.Seat(new Vector3(12, 12, 50), new Vector3(0, 0, -5), TransientState.None);
        if (state != PhysicsState.Hidden) f.Body.SetActive(false);
        f.Body.SetState(f.Body.State | state);
        f.Body.SetActive(true);
        f.Engine.Tick(1);
        f.Engine.Tick(1.1);
        Assert.Equal((50f, -5f), (f.Z, f.Body.Velocity.Z));
        Assert.Equal(timeGoesOn ? 1.1 : 0.0, f.Body.SimulatedTime, 9);
        Assert.Equal(state == PhysicsState.Hidden, f.Body.IsActive);
    }

    [Fact, Behaviour("body.enter.leaves-pending-motions-alone-on-return", "spec/02, 4.16 flag sets and 4.17 reenter_visibility")]
    public void Coming_back_with_its_landblock_does_not_end_a_body_s_motions()
    {
        BodyFixture f = new();
        MovementManager movement = new(f.Body, HumanoidTable.Create(links: true), weenie: null);
        SteeredPhysicsBody.Of(f.Body).Attach(movement);
        Assert.True(f.Body.EnterWorld(new Position(StubWorld.CellId, new Vector3(12, 12, 0))));
        movement.Interpreter.DoInterpretedMotion(MotionCommand.WalkForward, new MovementParameters());
        int links = movement.Animation!.Sequence.LinkCount, pending = movement.Interpreter.PendingCount;
        Assert.True(links > 0 && pending > 0);
        f.Body.LeaveVisibility();
        Assert.True(f.Body.IsLost);
        Assert.True(f.Body.ReenterVisibility());
        Assert.Equal((false, true, links), (f.Body.IsLost, f.Body.HasCell, movement.Animation.Sequence.LinkCount));
        Assert.Equal(pending, movement.Interpreter.PendingCount);
    }

    [Fact, Behaviour("body.parts.without-parts-in-no-cell", "spec/02, 4.17 enter_cell and 4.20")]
    public void A_body_without_parts_steps_nowhere_and_is_in_no_cell()
    {
        PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
        PhysicsBody body = engine.CreateBody(1, null);
        Assert.Equal((0f, 0f, 0f, 0f), (body.StepUpHeight, body.StepDownHeight, body.Height, body.Radius));
        Assert.True(body.EnterWorld(new Position(StubWorld.CellId, new Vector3(12, 12, 0))));
        Assert.Null(body.Cell);
    }

    [Fact, Behaviour("body.setters.ranges", "spec/02, 4.18 set_elasticity; 2.1 friction")]
    public void Elasticity_is_clamped_and_a_friction_out_of_range_ignored()
    {
        PhysicsBody body = new BodyFixture().Body;
        Assert.Equal((0.05f, 0.95f), (body.Elasticity, body.Friction));
        (float Given, float Kept)[] elasticities = [(-1f, 0f), (0.07f, 0.07f), (0.1f, 0.1f), (0.2f, 0.1f)];
        foreach ((float given, float kept) in elasticities)
        {
            body.SetElasticity(given);
            Assert.Equal(kept, body.Elasticity);
        }

        (float Given, float Kept)[] frictions = [(0.5f, 0.5f), (1.01f, 0.5f), (-0.01f, 0.5f), (0f, 0f), (1f, 1f)];
        foreach ((float given, float kept) in frictions)
        {
            body.SetFriction(given);
            Assert.Equal(kept, body.Friction);
        }
    }

    /// <summary>Pushes the first attempt to a place; the others are left alone.</summary>
    private static Func<Transition, TransitionState> PushOnce(Vector3 to)
    {
        bool pushed = false;
        return t =>
        {
            if (pushed || t.Path.InsertType != InsertType.InitialPlacement) return TransitionState.OK;
            pushed = true;
            t.Path.AddOffsetToCheckPos(to - t.Path.CheckPos.Frame.Origin);
            return TransitionState.Adjusted;
        };
    }
}
