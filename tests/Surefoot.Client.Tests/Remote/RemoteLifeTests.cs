using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>How other bodies come, change and go: specification 09, 5.1, 5.6, 5.8, 5.9 and 6.9.</summary>
public class RemoteLifeTests
{
    private static readonly MovementData ToOther =
        MovementData.MoveToObject(NonCombat, Other, StubWorld.CellId, Start, Way with { DistanceToObject = 1 }, 1);

    [Fact]
    [Behaviour("remote.create.description", "spec/09, 5.8; spec/02, 4.18 set_description; CPhysicsObj::set_description @0x00514F40")]
    public void A_body_is_made_as_it_is_described()
    {
        RemoteFixture f = new();
        ObjectDescription described = Describe(One, Start + new Vector3(0, 0, 50), new ObjectStamps(1, 2, 3, 4, 5, 6, 7, 8, 9));
        f.Create(described with
        {
            Physics = described.Physics with
            {
                State = Standing | (uint)PhysicsState.Inelastic,
                Movement = Run(1.5f),
                Autonomous = 1,
                Scale = 2,
                Friction = 0.5f,
                Elasticity = 7,
                Velocity = new Vector3(3, 0, 0),
                Omega = new Vector3(0, 0, 1),
            },
        });
        Assert.Equal(PhysicsState.Default | PhysicsState.Inelastic, f.Body.State);
        Assert.Equal((2f, 0.5f, 0.1f), (f.Body.Scale, f.Body.Friction, f.Body.Elasticity));
        Assert.Equal((new Vector3(3, 0, 0), new Vector3(0, 0, 1)), (f.Body.Velocity, f.Body.Omega));
        Assert.Equal((MotionCommand.RunForward, 1.5f), (f.Motion.ForwardCommand, f.Motion.ForwardSpeed));
        Assert.True(f.Body.LastMoveWasAutonomous);
        Assert.Equal(new MessageStamps([1, 2, 3, 4, 5, 6, 7, 8, 9]), f.Item.Stamps);
        Assert.Equal((WeenieTraits.Present | WeenieTraits.Creature, true), (f.Body.Weenie, f.Body.IsActive));
        Assert.NotNull(f.Body.Cell);
        Assert.Equal(["created 80000001"], f.Told);
        Assert.Equal(0, f.Remote.Drops.Total);
    }

    [Fact]
    [Behaviour("remote.create.defaults", "spec/09, 5.8")]
    public void What_is_not_described_has_its_default()
    {
        RemoteFixture f = new();
        f.Create(DescribeThing(One));
        Assert.Equal((1f, 0.95f, 0.05f, Vector3.Zero), (f.Body.Scale, f.Body.Friction, f.Body.Elasticity, f.Body.Velocity));
        Assert.Equal((null, 0u, null), (f.Body.Cell, f.Body.Position.CellId, f.Item.Movement));
        Assert.Equal(WeenieTraits.Present, f.Body.Weenie);
        f.FramesUntil(60);
        Assert.NotNull(f.Remote.Find(One));
    }

    [Fact]
    [Behaviour("remote.create.first-report-is-lost", "spec/09, 5.8, step 4; spec/09b, 7.2 (ten seconds) and 7.3 (0.5 m)")]
    public void A_creature_that_is_created_on_its_way_to_an_object_hears_of_it_only_when_the_object_moves()
    {
        foreach (bool moves in (bool[])[true, false])
        {
            RemoteFixture f = new();
            f.Create(Describe(Other, Start + new Vector3(0, 20, 0)));
            ObjectDescription described = Describe(One, Start + new Vector3(0, 0, 5));
            // Without gravity it stays in the air: to hit the ground would end an order that waits.
            const uint State = (uint)PhysicsState.ReportCollisions;
            f.Create(described with { Physics = described.Physics with { Movement = ToOther, State = State } });
            f.FramesUntil(5);
            Assert.Equal((true, 0), (f.Body.IsMovingTo, f.Movement.MoveTo!.NodeCount));
            if (moves) f.Say(PositionOf(Start + new Vector3(0, 21, 0), 1, guid: Other));
            f.FramesUntil(10);
            Assert.Equal((true, moves ? 1 : 0), (f.Body.IsMovingTo, f.Movement.MoveTo.NodeCount));
            f.FramesUntil(11.1);
            Assert.Equal((moves, moves ? MotionError.None : MotionError.NoTarget), (f.Body.IsMovingTo, f.Movement.LastMoveToError));
        }
    }

    [Fact]
    [Behaviour("remote.create.order-ends-on-the-ground", "spec/09b, 6.6, HitGround; spec/02, 4.17: a body placed on ground gets HitGround")]
    public void A_creature_that_is_created_on_the_ground_on_its_way_to_an_object_forgets_the_order_and_obeys_the_next()
    {
        RemoteFixture f = new();
        f.Create(Describe(Other, Start + new Vector3(0, 20, 0)));
        ObjectDescription described = Describe(One, Start);
        f.Create(described with { Physics = described.Physics with { Movement = ToOther } });
        Assert.Equal((false, true), (f.Body.IsMovingTo, f.Body.OnWalkable));
        f.FramesUntil(3);
        Assert.Equal(Start.Y, f.Origin.Y);
        f.Say(MotionOf(1, 1, ToOther));
        f.FramesUntil(6);
        Assert.True(f.Origin.Y > Start.Y + 3);
    }

    [Fact]
    [Behaviour("remote.create.messages-before", "spec/09, 5.9 and 6.9; ProcessObjectNetBlobs @0x00454B20")]
    public void Messages_that_came_before_their_object_act_in_order_when_it_comes()
    {
        RemoteFixture f = new();
        f.Say(MotionOf(1, 1, Run(1.5f)));
        f.FramesUntil(10);
        f.Say(MotionOf(3, 1, Run(2.5f)));
        f.FramesUntil(24.9);
        f.Say(MotionOf(2, 1, Run(3.5f)));
        Assert.Equal((1, 3), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        f.FramesUntil(30);
        f.Create(Describe(One, Start));
        Assert.Equal((2.5f, 1L), (f.Motion.ForwardSpeed, f.Remote.Drops[RemoteDrop.Late]));
        Assert.Equal((0, 0), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        f.FramesUntil(80);
        Assert.NotNull(f.Remote.Find(One));
    }

    [Fact]
    [Behaviour("remote.placeholder.timer", "spec/09, 5.10 and 6.9; AddObjectToBeDestroyed @0x00508F70")]
    public void An_object_that_never_comes_is_given_up_25_seconds_after_its_last_message_and_asked_for_every_20()
    {
        RemoteFixture f = new();
        byte[] message = f.Say(MotionOf(1, 1, Run()));
        f.FramesUntil(10);
        f.SayBytes(message);
        f.FramesUntil(20);
        Assert.Empty(f.Told);
        f.Frames(1);
        double asked = f.Now;
        Assert.Equal(["missing 80000001"], f.Told);
        f.FramesUntil(24.9);
        double last = f.Now;
        f.SayBytes(message);
        f.FramesUntil(asked + 20);
        Assert.Single(f.Told);
        f.Frames(1);
        Assert.Equal(2, f.Told.Count);
        f.FramesUntil(last + 25);
        Assert.Equal((1, 3), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        f.Frames(1);
        Assert.Equal((0, 0, 3L), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount, f.Remote.Drops[RemoteDrop.NeverCame]));
        f.FramesUntil(80);
        Assert.Equal(2, f.Told.Count);
    }

    [Fact]
    [Behaviour("remote.instance.newer-on-a-known-object", "spec/09, 5.1, 5.9 and 6.9")]
    public void A_message_for_the_next_life_of_a_known_object_is_lost_with_it_and_an_old_one_dropped()
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps(instance: 4));
        const uint other = Standing | (uint)PhysicsState.Inelastic;
        f.Say(new SetState(One, other, 5, 1));
        f.Say(new SetState(One, other, 3, 1));
        Assert.Equal((1L, 1L), (f.Remote.Drops[RemoteDrop.LaterLife], f.Remote.Drops[RemoteDrop.EarlierLife]));
        PhysicsBody old = f.Body;
        f.Create(Describe(One, Start + new Vector3(0, 3, 0), Stamps(instance: 5)));
        Assert.NotSame(old, f.Body);
        Assert.Equal((PhysicsState.Default, null), (f.Body.State, old.Cell));
        Assert.Equal(["created 80000001", "deleting 80000001", "created 80000001"], f.Told);
        f.Say(new SetState(One, other, 5, 1));
        Assert.Equal((PhysicsState)other, f.Body.State);
    }

    [Fact]
    [Behaviour("remote.create.refresh", "spec/09, 5.8: known, equal instance; spec/08, 4.5")]
    public void A_known_object_that_is_described_again_takes_what_is_news()
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps() with { State = 5 });
        PhysicsBody body = f.Body;
        ObjectDescription again = Describe(One, Start + new Vector3(0, 5, 0), new ObjectStamps(1, 1, 5, 1, 0, 0, 0, 1, 1));
        f.Say(new CreateObject(again with
        {
            Model = new ModelData { Parts = [new PartChange(0, 0x01000007)] },
            Physics = again.Physics with { Movement = Run(2), State = 0, Scale = 3, Velocity = new Vector3(0, 0, 4) },
            Weenie = new WeenieDescription { Name = "another", ItemType = Creature, Description = 0x8 },
        }));
        Assert.Same(body, f.Body);
        Assert.Equal((2f, PhysicsState.Default, 1f), (f.Motion.ForwardSpeed, body.State, body.Scale));
        Assert.Equal((new Vector3(0, 0, 4), true, "another"), (body.Velocity, body.IsInterpolating, f.Item.Weenie.Name));
        Assert.Equal(WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player, body.Weenie);
        Assert.Equal(new PartChange(0, 0x01000007), Assert.Single(f.Item.Model.Parts));

        // Without a place and a holder it is in somebody's pack; an older life is no news.
        f.Say(new CreateObject(Describe(One, null, Stamps(2))));
        Assert.Equal((null, 0u), (body.Cell, body.Position.CellId));
        f.Say(new CreateObject(Describe(One, Start, Stamps(9, instance: 0))));
        Assert.Equal((null, 1L), (body.Cell, f.Remote.Drops[RemoteDrop.EarlierLife]));
        f.Say(new CreateObject(Describe(One, Start, Stamps(3))));
        Assert.NotNull(body.Cell);
    }

    [Fact]
    [Behaviour("remote.create.forced", "spec/08, 4.5, step 3; HandleUpdateObject @0x00455580")]
    public void An_object_that_is_told_anew_is_made_anew_whatever_its_life()
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps(instance: 7));
        PhysicsBody old = f.Body;
        f.Say(new UpdateObject(Describe(One, Start, Stamps(instance: 7))));
        Assert.NotSame(old, f.Body);
        Assert.Same(f.Body, f.Engine.Find(One));
    }

    [Fact]
    [Behaviour("remote.delete", "spec/09, 5.2 and 5.6; HandleDeleteObject @0x00451EA0")]
    public void A_deleted_object_is_gone_and_a_second_delete_waits_for_the_next_of_its_id()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(new DeleteObject(One, 0));
        Assert.NotNull(f.Remote.Find(One));
        f.Say(new DeleteObject(One, 1));
        Assert.Equal((null, null), (f.Remote.Find(One), f.Engine.Find(One)));
        f.Say(new DeleteObject(One, 1));
        Assert.Equal(1, f.Remote.AwaitedCount);
        f.Say(new CreateObject(Describe(One, Start)));
        Assert.Equal((null, 0), (f.Remote.Find(One), f.Remote.AwaitedCount));
        f.Create(Describe(One, Start));
        f.Say(new DeleteObject(PlayerId, 1));
        Assert.Equal(1, f.Remote.Drops[RemoteDrop.NotOurs]);
        Assert.NotNull(f.Engine.Find(PlayerId));
    }

    [Fact]
    [Behaviour("remote.delete.ends-ways-to-it", "spec/09, 5.6, exit_world; spec/09b, 7.3")]
    public void Who_was_on_the_way_to_a_deleted_object_stops()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Create(Describe(Other, Start + new Vector3(0, 20, 0)));
        f.Say(MotionOf(1, 1, ToOther));
        f.Frames(10);
        Assert.True(f.Body.IsMovingTo);
        f.Say(new DeleteObject(Other, 1));
        Assert.Equal((false, MotionError.TargetGone), (f.Body.IsMovingTo, f.Movement.LastMoveToError));
    }

    [Fact]
    [Behaviour("remote.player.messages-wait", "spec/09, 5.1; IsReadyToDispatchEvent @0x00559590")]
    public void Until_the_player_is_known_every_message_waits()
    {
        RemoteFixture f = new(new RemoteWorldOptions());
        f.Say(new CreateObject(Describe(One, Start)));
        f.Say(MotionOf(1, 1, Run(2)));
        Assert.Equal((null, 2, null), (f.Remote.Find(One), f.Remote.WaitingMessageCount, f.Remote.Player));
        f.Say(new PlayerCreate(PlayerId));
        Assert.Equal((2f, 0, PlayerId), (f.Motion.ForwardSpeed, f.Remote.WaitingMessageCount, f.Remote.Player));
        f.Say(new PlayerCreate(One));
        Assert.Equal(PlayerId, f.Remote.Player);
    }

    [Fact]
    [Behaviour("remote.player.is-left-alone", "spec/09, section 1: everything but the local player")]
    public void Messages_about_the_local_player_do_nothing_here()
    {
        RemoteFixture f = new();
        Position before = f.Engine.Player!.Position;
        f.Say(PositionOf(Start, 1, 1, guid: PlayerId));
        f.Say(MotionOf(1, 1, Run(), guid: PlayerId));
        f.Say(new CreateObject(Describe(PlayerId, Start)));
        f.Frames(3);
        Assert.Equal((before, 0L, 0), (f.Engine.Player.Position, f.Remote.Drops.Total, f.Remote.AwaitedCount));
        Assert.Empty(f.Remote.Objects);
    }

    [Fact]
    [Behaviour("remote.effects-wait", "spec/09, 5.1: sounds and scripts")]
    public void Sounds_and_scripts_wait_for_their_object_as_others_do()
    {
        RemoteFixture f = new();
        f.Say(new Sound(One, 1, 1));
        f.Say(new PlayScriptId(One, 1));
        f.Say(new PlayScriptType(Other, 1, 1));
        Assert.Equal((2, 3), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        f.Create(Describe(One, Start));
        f.Say(new Sound(One, 1, 1));
        Assert.Equal((1, 1), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
    }
}
