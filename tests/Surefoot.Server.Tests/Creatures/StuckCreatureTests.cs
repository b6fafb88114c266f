using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Creatures;

/// <summary>Creatures against walls: 4 m north of the place "house-door" is the house's wall, whose doorway is 1.2 m wide.</summary>
public sealed class StuckCreatureTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const string House = "house-door";
    private const float BesideTheDoor = 3, InTheHouse = 8;

    [Fact, Behaviour("creature.stuck.noticed", "design, server operator: a stuck creature is noticed within 2 s and reported")]
    public void A_creature_pressed_against_a_wall_is_noticed_within_two_seconds()
    {
        CreatureFixture f = AtTheWall();
        double standing = f.Now;
        for (Position last = f.Body.Position; ; last = f.Body.Position)
        {
            f.Run(0.01);
            if (f.Told.Count > 0) break;
            if (last.DistanceTo(f.Body.Position) > 1e-3) standing = f.Now;
        }

        Assert.Equal(["stuck"], f.Told);
        Assert.InRange(f.Now - standing, 1, 2);
        Assert.Equal((CreatureGoal.Place, CreatureProgress.Stuck, 1L), (f.Driver!.Goal, f.Driver.Progress, f.Driver.StuckCount));

        // Clients see it stand, where it stands.
        Assert.Equal((MovementType.InterpretedMotion, unchecked((ushort)MotionCommand.Ready)),
            (f.LastOrder, f.Motions[^1].Message.Movement.State.ForwardCommand));
        Assert.Equal(f.Body.Position.Frame.Origin, f.Positions[^1].Message.Pack.Position.Origin);
    }

    [Fact, Behaviour("creature.stuck.costs-no-sweep", "design, server operator: costs no sweep while nothing near it changes")]
    public void A_stuck_creature_costs_no_sweep_while_nothing_near_it_changes()
    {
        CreatureFixture f = AtTheWall();
        Assert.NotEqual(0, f.CountDecisions(0.5));
        f.RunUntil(() => f.Told.Count > 0, limit: 3);
        f.Run(0.5);
        Assert.Equal(0, f.CountDecisions(20));
        Assert.Equal(["stuck"], f.Told);

        // Far away somebody may do what he likes.
        PhysicsBody other = f.SpawnTarget(DemoGround.At(House, right: 10, ahead: -6));
        f.Run(0.5);
        other.SetPositionSimple(DemoGround.At(House, right: 12, ahead: -6), sliding: true);
        Assert.Equal(0, f.CountDecisions(3));
    }

    // Who pushed exactly head-on keeps the door's normal and would stay blocked: obstacles.exactly-head-on-stays-blocked.
    [Fact, Behaviour("creature.stuck.door", "design, server operator: wakes when something near it changes")]
    public void A_creature_stuck_at_a_shut_door_goes_in_when_it_opens()
    {
        CreatureFixture f = new(ground, "door");
        PhysicsBody door = f.SpawnDoor();
        f.Driver!.MoveTo(DemoGround.At("door", ahead: 8));
        f.RunUntil(() => f.Told.Contains("stuck"), limit: 8);
        f.Run(2);
        Assert.Equal(["stuck"], f.Told);
        Assert.True(door.SetEthereal(true));
        f.RunUntil(() => f.Told.Contains("arrived"), limit: 6);
        Assert.Equal(["stuck", "tries again", "arrived"], f.Told);
        Assert.False(CellIds.IsOutdoor(f.Body.Position.CellId));
    }

    [Fact, Behaviour("creature.stuck.target-moves", "design, server operator: wakes when something changes")]
    public void A_stuck_creature_tries_again_when_its_target_is_elsewhere()
    {
        CreatureFixture f = new(ground, House, BesideTheDoor);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(House, BesideTheDoor, InTheHouse));
        Assert.True(f.Driver!.Follow(CreatureFixture.TargetId));
        f.RunUntil(() => f.Told.Contains("stuck"), limit: 6);
        f.Run(1);
        target.SetPositionSimple(DemoGround.At(House, right: BesideTheDoor, ahead: -4), sliding: true);
        f.RunUntil(() => f.Told.Contains("arrived"), limit: 6);
        Assert.Equal(["stuck", "tries again", "arrived"], f.Told);
    }

    [Fact, Behaviour("creature.stuck.target-beside-it", "design, server operator: wakes when something changes")]
    public void A_creature_that_was_stuck_takes_hold_of_a_target_that_comes_right_beside_it()
    {
        CreatureFixture f = new(ground, House, BesideTheDoor);
        PhysicsBody target = f.SpawnTarget(DemoGround.At(House, BesideTheDoor, InTheHouse));
        Assert.True(f.Driver!.StickTo(CreatureFixture.TargetId));
        f.RunUntil(() => f.Told.Contains("stuck"), limit: 6);
        f.Run(1);
        Position here = f.Body.Position;
        here.Frame.Origin.Y -= 1.5f;
        target.SetPositionSimple(here, sliding: true);
        f.RunUntil(() => f.Told.Contains("arrived"), limit: 6);
        Assert.Equal(["stuck", "tries again", "arrived"], f.Told);
        Assert.Equal(CreatureFixture.TargetId, f.Body.StickyObjectId);
    }

    [Fact, Behaviour("creature.stuck.waits-longer", "design, server operator: servers burn their time on creatures pressed against walls")]
    public void A_creature_that_is_stuck_again_and_again_tries_less_and_less_often()
    {
        CreatureFixture f = AtTheWall();
        PhysicsBody stander = f.Spawn(CreatureFixture.ByStander, DemoGround.At(House, BesideTheDoor + 1.5f, 3));
        List<double> tries = [];
        for (int i = 0; i < 1200; i++)
        {
            // Somebody beside it never stands still.
            stander.SetPositionSimple(DemoGround.At(House, BesideTheDoor + (i % 2 == 0 ? 1.5f : 2), 3), sliding: false);
            f.Run(0.03);
            while (tries.Count < f.Told.Count(told => told == "tries again")) tries.Add(f.Now);
        }

        double[] pauses = [.. tries.Zip(tries.Skip(1), (a, b) => b - a)];
        Assert.True(pauses.Length >= 2);
        Assert.All(pauses.Zip(pauses.Skip(1)), pair => Assert.True(pair.Second > pair.First || pair.First > 8));
        Assert.InRange(tries.Count, 3, 8);
    }

    [Fact, Behaviour("creature.stuck.new-goal", "design, server operator: driving of creatures for whoever has the artificial mind")]
    public void A_stuck_creature_obeys_another_order_at_once()
    {
        CreatureFixture f = AtTheWall();
        f.RunUntil(() => f.Told.Contains("stuck"), limit: 6);
        f.Driver!.GoHome();
        f.RunUntil(() => f.Told.Contains("arrived"), limit: 6);
        Assert.InRange(f.Body.Position.DistanceTo(f.Driver.Home), 0, 0.6 + f.Body.Radius);
    }

    [Fact, Behaviour("creature.stuck.fair", "design, server operator: noticed, and nobody else is taken for one")]
    public void A_creature_that_turns_or_is_outrun_is_not_stuck()
    {
        CreatureFixture f = new(ground, "runway", options: new CreatureDriverOptions { WalkWithin = 100 });
        PhysicsBody target = f.SpawnTarget(DemoGround.At("runway", ahead: -6));
        Assert.True(f.Driver!.Follow(CreatureFixture.TargetId));
        for (int i = 0; i < 60; i++)
        {
            // Twice as fast as it walks.
            target.SetPositionSimple(DemoGround.At("runway", ahead: -6 - (0.6f * i)), sliding: false);
            f.Run(0.1);
        }

        Assert.Empty(f.Told);
    }

    /// <summary>A creature that has run into the wall on its way straight into the house, and presses against it.</summary>
    private CreatureFixture AtTheWall()
    {
        CreatureFixture f = new(ground, House, BesideTheDoor);
        f.Driver!.MoveTo(DemoGround.At(House, BesideTheDoor, InTheHouse));
        f.Run(1.2);
        return f;
    }
}
