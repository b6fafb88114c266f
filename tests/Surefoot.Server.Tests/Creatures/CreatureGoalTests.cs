using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Creatures;

/// <summary>What a driven creature does, on the level runway.</summary>
public sealed class CreatureGoalTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const string Meadow = "runway";

    [Fact, Behaviour("creature.move-to-object", "spec/09b, 6: 0.6 m from surface to surface; spec/08, 8.7")]
    public void A_creature_comes_to_an_object_and_stands_there()
    {
        CreatureFixture f = new(ground, Meadow);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, right: 6, ahead: 8));
        Assert.True(f.Driver!.MoveTo(CreatureFixture.TargetId));
        Assert.Equal(MovementType.MoveToObject, f.LastOrder);
        f.RunUntil(() => f.Told.Count > 0, limit: 10);
        Assert.Equal(["arrived"], f.Told);
        Assert.InRange(f.GapTo(target), 0, 0.6);
        Assert.Equal((CreatureGoal.None, CreatureProgress.Idle), (f.Driver.Goal, f.Driver.Progress));
        f.Run(1);
        Position before = f.Body.Position;
        f.Run(1);
        Assert.Equal(before, f.Body.Position);
    }

    [Fact, Behaviour("creature.move-to-place", "spec/09b, 6; spec/08, 6.4: type 7")]
    public void A_creature_comes_to_a_place_and_clients_are_told_its_way_five_times_a_second()
    {
        CreatureFixture f = new(ground, Meadow);
        Position place = DemoGround.At(Meadow, ahead: 9.5f);
        f.Driver!.MoveTo(place);
        UpdateMotion order = Assert.Single(f.Motions).Message;
        Assert.Equal((MovementType.MoveToPosition, place.CellId, place.Frame.Origin, 1f),
            (order.Movement.Type, order.Movement.Cell, order.Movement.Origin, order.Movement.RunRate));
        double seconds = f.RunUntil(() => f.Told.Contains("arrived"), limit: 10);
        Assert.InRange(f.Body.Position.DistanceTo(place), 0, 0.6 + f.Body.Radius);

        // One position in every fifth of a second, and one at the end.
        Assert.InRange(f.Positions.Count, (seconds / 0.24) - 2, (seconds / 0.2) + 2);
        Assert.Equal(f.Body.Position.Frame.Origin, f.Positions[^1].Message.Pack.Position.Origin);
    }

    [Fact, Behaviour("creature.stamps", "spec/08, 4.3 and 8.7: SERVER_CONTROLLED + 1 when a move begins")]
    public void Every_message_about_a_creature_has_the_next_stamp()
    {
        ObjectStamps stamps = new(
            Position: 65534, Movement: 7, 0, 0, Teleport: 3, ServerControlledMove: 65535, ForcePosition: 4, 0, Instance: 9);
        CreatureFixture f = new(ground, Meadow, options: new CreatureDriverOptions { Stamps = stamps });
        f.Driver!.MoveTo(DemoGround.At(Meadow, ahead: 9));
        f.Driver.TurnTo(90f);
        f.RunUntil(() => f.Told.Contains("arrived"), limit: 10);
        Assert.Equal([(8, 0), (9, 1)],
            f.Motions.Select(m => ((int)m.Message.MovementStamp, (int)m.Message.ServerControlledMove)));
        Assert.All(f.Motions, m => Assert.Equal((9, false), (m.Message.Instance, m.Message.Autonomous)));
        Assert.Equal(Enumerable.Range(0, f.Positions.Count).Select(i => (ushort)(65535 + i)),
            f.Positions.Select(p => p.Message.Pack.PositionStamp));
        Assert.All(f.Positions, p => Assert.Equal((9, 3, 4),
            ((int)p.Message.Pack.Instance, (int)p.Message.Pack.Teleport, (int)p.Message.Pack.ForcePosition)));
    }

    [Fact, Behaviour("creature.turn-to", "spec/09b, 6; spec/08, 6.4: types 8 and 9")]
    public void A_creature_turns_to_an_object_or_to_a_heading()
    {
        CreatureFixture f = new(ground, Meadow);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, right: 5, ahead: -5));
        Assert.True(f.Driver!.TurnTo(CreatureFixture.TargetId));
        Assert.Equal(MovementType.TurnToObject, f.LastOrder);
        f.RunUntil(() => f.Told.Count == 1, limit: 6);
        Assert.Equal(f.Body.Position.HeadingTo(target.Position), f.Body.Position.Frame.Heading, 0.1);
        f.Driver.TurnTo(10f);
        Assert.Equal(MovementType.TurnToHeading, f.LastOrder);
        f.RunUntil(() => f.Told.Count == 2, limit: 6);
        Assert.Equal(10, f.Body.Position.Frame.Heading, 0.1);
    }

    [Fact, Behaviour("creature.follow", "spec/09b, 6 and 7: a target that moves is followed")]
    public void A_creature_follows_an_object_that_goes_away_again_and_again()
    {
        CreatureFixture f = new(ground, Meadow);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, ahead: 5));
        Assert.True(f.Driver!.Follow(CreatureFixture.TargetId));
        f.RunUntil(() => f.Told.Count == 1, limit: 6);
        for (int leg = 2; leg <= 4; leg++)
        {
            target.SetPositionSimple(DemoGround.At(Meadow, right: leg % 2 == 0 ? 6 : 0, ahead: 5), sliding: true);
            f.RunUntil(() => f.Told.Count == leg, limit: 8);
            Assert.InRange(f.GapTo(target), 0, 0.6 + 0.1);
        }

        Assert.Equal(["arrived", "arrived", "arrived", "arrived"], f.Told);
        Assert.Equal((CreatureGoal.Follow, CreatureProgress.Watching), (f.Driver.Goal, f.Driver.Progress));
    }

    [Fact, Behaviour("creature.follow.runner", "spec/09b, 4.2: CanCharge runs whatever the distance; the key is chosen when a move begins")]
    public void A_creature_runs_after_one_who_runs_away_and_walks_to_one_who_stands()
    {
        CreatureFixture f = new(ground, Meadow, options: new CreatureDriverOptions { RunRate = 2 });
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, ahead: 3));
        Assert.True(f.Driver!.Follow(CreatureFixture.TargetId));
        f.RunUntil(() => f.Told.Count == 1, limit: 6);
        Assert.All(f.Motions, m => Assert.False(Charges(m.Message)));

        f.Engine.MovementOf(target)!.ApplyUpdate(
            new InterpretedMotionState { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = 1.5f }, autonomous: false);
        f.Run(6);
        Assert.Contains(f.Motions, m => Charges(m.Message));
        // Three quarters as fast as the creature can run: it is never left behind by more than it may be, and by what it took to notice.
        Assert.InRange(f.GapTo(target), 0, 0.6 + 1 + 1 + 2);
        Assert.InRange(f.Body.Position.DistanceTo(f.Driver.Home), 20, 60);

        f.Engine.MovementOf(target)!.ApplyUpdate(new InterpretedMotionState(), autonomous: false);
        f.Run(4);
        f.Motions.Clear();
        target.SetPositionSimple(DemoGround.At(Meadow, ahead: 3 + (float)f.Body.Position.DistanceTo(f.Driver.Home)), sliding: true);
        f.Run(0.2);
        Assert.DoesNotContain(f.Motions, m => Charges(m.Message));

        static bool Charges(in UpdateMotion order) => (order.Movement.Parameters.Bits & (uint)MovementFlags.CanCharge) != 0;
    }

    [Fact, Behaviour("creature.stick", "spec/09, 3.3: 0.3 m from surface to surface, for a second at a time")]
    public void A_creature_sticks_to_an_object_and_stays_with_it()
    {
        CreatureFixture f = new(ground, Meadow);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, ahead: 4));
        Assert.True(f.Driver!.StickTo(CreatureFixture.TargetId));
        Assert.Equal((uint)MovementFlags.Sticky, f.Motions[^1].Message.Movement.Parameters.Bits & (uint)MovementFlags.Sticky);
        f.RunUntil(() => f.Told.Count == 1, limit: 6);
        f.Run(3);
        Assert.Equal(0.3, f.GapTo(target), 0.05);

        // It took hold again each second: type 0, with the object to stick to.
        int holds = f.Motions.Count(
            m => m.Message.Movement is { Type: MovementType.InterpretedMotion, Target: CreatureFixture.TargetId });
        Assert.InRange(holds, 2, 4);
        target.SetPositionSimple(DemoGround.At(Meadow, right: 1, ahead: 4.5f), sliding: false);
        f.Run(1.5);
        Assert.Equal(0.3, f.GapTo(target), 0.05);
        Assert.Equal(f.Body.Position.HeadingTo(target.Position), f.Body.Position.Frame.Heading, 1);
        Assert.Equal(["arrived"], f.Told);
    }

    [Fact, Behaviour("creature.flee", "spec/09b, 4.2 and 6: moving away until the least distance")]
    public void A_creature_flees_from_an_object_and_flees_again_when_it_comes_near()
    {
        CreatureFixture f = new(ground, Meadow);
        PhysicsBody hunter = f.SpawnTarget(DemoGround.At(Meadow, ahead: -3));
        Assert.True(f.Driver!.FleeFrom(CreatureFixture.TargetId));
        f.RunUntil(() => f.Told.Count == 1, limit: 10);
        Assert.True(f.GapTo(hunter) >= 15 - 0.1);
        f.Run(2);
        Assert.Equal(CreatureProgress.Watching, f.Driver.Progress);
        Position near = f.Body.Position;
        near.Frame.Origin.Y -= 4;
        hunter.SetPositionSimple(near, sliding: true);
        f.RunUntil(() => f.Told.Count == 2, limit: 10);
        Assert.True(f.GapTo(hunter) >= 15 - 0.1);
    }

    [Fact, Behaviour("creature.home", "spec/09b, 6: with a heading at the end")]
    public void A_creature_goes_home_and_faces_as_it_did()
    {
        CreatureFixture f = new(ground, Meadow);
        double heading = f.Body.Position.Frame.Heading;
        f.Driver!.MoveTo(DemoGround.At(Meadow, right: 8, ahead: 3));
        f.RunUntil(() => f.Told.Count == 1, limit: 10);
        f.Driver.GoHome();
        f.RunUntil(() => f.Told.Count == 2, limit: 12);
        Assert.InRange(f.Body.Position.DistanceTo(f.Driver.Home), 0, 0.6 + f.Body.Radius);
        Assert.Equal(0, ((f.Body.Position.Frame.Heading - heading + 540) % 360) - 180, 0.1);
    }

    [Fact, Behaviour("creature.stop", "spec/08, 6.4: type 0, Ready")]
    public void A_creature_told_to_stop_stands_and_clients_are_told()
    {
        CreatureFixture f = new(ground, Meadow);
        f.Driver!.MoveTo(DemoGround.At(Meadow, ahead: 12));
        f.Run(2);
        f.Driver.Stop();
        Assert.Equal((MovementType.InterpretedMotion, unchecked((ushort)MotionCommand.Ready)),
            (f.LastOrder, f.Motions[^1].Message.Movement.State.ForwardCommand));
        f.Run(1);
        Position stood = f.Body.Position;
        f.Run(1);
        Assert.Equal(stood, f.Body.Position);
    }

    [Fact, Behaviour("creature.target-gone", "design, server operator: a target that vanished, or is the body itself, is refused")]
    public void A_target_that_is_not_there_is_refused_and_one_that_vanishes_ends_the_goal()
    {
        CreatureFixture f = new(ground, Meadow);
        Assert.False(f.Driver!.Follow(0x8000FFFF));
        Assert.False(f.Driver.Follow(CreatureFixture.CreatureId));
        Assert.Equal((CreatureGoal.None, 0), (f.Driver.Goal, f.Motions.Count));
        PhysicsBody target = f.SpawnTarget(DemoGround.At(Meadow, ahead: 9));
        f.Driver.Follow(CreatureFixture.TargetId);
        f.Run(1);
        f.Engine.RemoveBody(target);
        f.Run(0.1);
        Assert.Equal(["gave up: TargetGone"], f.Told);
        Assert.Equal((CreatureGoal.None, CreatureProgress.Idle), (f.Driver.Goal, f.Driver.Progress));
    }

    [Fact, Behaviour("creature.bad-input", "design, decision 7")]
    public void Bad_places_headings_and_options_are_refused_and_change_nothing()
    {
        CreatureFixture f = new(ground, Meadow);
        Assert.Throws<ArgumentException>(() => f.Driver!.MoveTo(new Position(0xA9B50001, new Vector3(float.NaN, 0, 0))));
        Assert.Throws<ArgumentException>(() => f.Driver!.MoveTo(new Position(0, Vector3.Zero)));
        Assert.Throws<ArgumentOutOfRangeException>(() => f.Driver!.TurnTo(float.PositiveInfinity));
        Assert.Throws<ArgumentException>(() =>
            new CreatureDriver(f.Engine, f.Body, f, new CreatureDriverOptions { StuckAfter = double.NaN }));
        PhysicsEngine other = ground.EngineAt(Meadow);
        Assert.Throws<ArgumentException>(() => new CreatureDriver(other, f.Body, f));
        PhysicsBody stone = f.Engine.CreateBody(CreatureFixture.ByStander, ground.Human);
        Assert.Throws<ArgumentException>(() => new CreatureDriver(f.Engine, stone, f));
        Assert.Equal((CreatureGoal.None, 0), (f.Driver!.Goal, f.Motions.Count));
    }
}
