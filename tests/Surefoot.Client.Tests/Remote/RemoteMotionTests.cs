using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Motions, velocities, states and looks of other bodies: specification 09, 5.4 and 5.5.</summary>
public class RemoteMotionTests
{
    [Theory]
    [Behaviour("remote.motion.stamps", "spec/09, 6.7; CPhysics::SetObjectMovement @0x00509690")]
    [InlineData(10, 3, true, 10, 3)]
    [InlineData(10, 4, true, 10, 4)]
    [InlineData(9, 4, false, 9, 3)]
    [InlineData(10, 2, false, 10, 3)]
    public void A_motion_acts_when_nothing_newer_came_before_and_uses_its_stamp_up(
        ushort movement, ushort serverControl, bool acts, ushort storedMovement, ushort storedControl)
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps() with { Movement = 9, ServerControlledMove = 3 });
        f.Say(MotionOf(movement, serverControl, Run(1.5f)));
        Assert.Equal(acts, f.Motion.ForwardCommand == MotionCommand.RunForward);
        Assert.Equal(
            (storedMovement, storedControl),
            (f.Item.Stamps[ObjectStamp.Movement], f.Item.Stamps[ObjectStamp.ServerControlledMove]));
        Assert.Equal(acts ? 0 : 1, f.Remote.Drops[RemoteDrop.Late]);
    }

    [Theory]
    [Behaviour("remote.motion.own-speed", "spec/09, 5.4; design, acceptance: other players use their own forward speed")]
    [InlineData(true)]
    [InlineData(false)]
    public void Another_player_runs_at_the_speed_in_the_message_whoever_asked_for_it(bool autonomous)
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(MotionOf(1, 0, Run(2.5f), autonomous));
        Assert.Equal(autonomous, f.Body.LastMoveWasAutonomous);
        f.Frames(1);
        float y = f.Origin.Y;
        f.Frames(30);
        Assert.Equal(10, f.Origin.Y - y, 1e-2f);
    }

    [Fact]
    [Behaviour("remote.motion.types", "spec/09, 5.4; MovementManager::unpack_movement @0x00524440")]
    public void A_body_goes_and_turns_as_each_type_of_order_says()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Create(Describe(Other, Start + new Vector3(6, 0, 0)));
        f.Say(MotionOf(1, 1, MovementData.TurnToHeading(NonCombat, (uint)MovementFlags.Default, 1, 180)));
        f.Frames(90);
        Assert.Equal(180, f.Body.Position.Frame.Heading, 1e-3);
        f.Say(MotionOf(2, 2, MovementData.TurnToObject(NonCombat, Other, 0, (uint)MovementFlags.Default, 1, 0)));
        f.Frames(90);
        Assert.Equal(90, f.Body.Position.Frame.Heading, 1e-3);
        f.Say(MotionOf(3, 3, MovementData.MoveToPosition(NonCombat, StubWorld.CellId, Start + new Vector3(0, 4, 0), Way, 1)));
        f.Frames(120);
        Assert.InRange(Start.Y + 4 - f.Origin.Y, 0.48f, 0.6f + 0.48f);
        f.Say(MotionOf(4, 4, MovementData.MoveToObject(NonCombat, Other, StubWorld.CellId, Start, Way, 1)));
        f.Frames(240);
        Assert.InRange(Vector3.Distance(f.Origin, f.Remote.Find(Other)!.Body.Position.Frame.Origin), 0.96f, 0.6f + 0.96f);
        f.Say(MotionOf(5, 5, MovementData.Motion(NonCombat, new WireInterpretedMotion(), stickTo: Other)));
        Assert.Equal(Other, f.Body.StickyObjectId);
        Assert.Equal(0, f.Remote.Drops.Total);
    }

    [Fact]
    [Behaviour("remote.motion.without-a-table", "spec/09, 5.4; CPhysicsObj::unpack_movement @0x00512040")]
    public void A_body_without_a_motion_table_ignores_motions_until_something_else_made_its_interpreter()
    {
        RemoteFixture f = new();
        f.Create(DescribeThing(One, Start));
        f.Frames(5);
        f.Say(MotionOf(1, 0, Run()));
        Assert.False(f.Movement.HasInterpreter);
        f.Say(PositionOf(Start + new Vector3(0, 5, 0), 1));
        f.Frames(1);
        Assert.True(f.Movement.HasInterpreter);
        f.Say(MotionOf(2, 0, Run()));
        Assert.Equal(MotionCommand.RunForward, f.Motion.ForwardCommand);
    }

    [Fact]
    [Behaviour("remote.motion.stop-keeps-the-queue", "spec/09, 5.4, last paragraph")]
    public void A_stopped_body_still_goes_to_its_last_position()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(MotionOf(1, 0, Run()));
        f.Say(PositionOf(Start + new Vector3(0, 4, 0), 1));
        f.Frames(2);
        f.Say(MotionOf(2, 0, MovementData.Motion(NonCombat, new WireInterpretedMotion())));
        f.Frames(60);
        Assert.Equal(Start.Y + 4, f.Origin.Y, 0.05f);
        Assert.Equal(MotionCommand.Ready, f.Motion.ForwardCommand);
    }

    [Fact]
    [Behaviour("remote.velocity.take-off", "spec/09, 4.4 and 6.8")]
    public void A_standing_body_jumps_with_a_servers_velocity_and_a_running_one_only_hops()
    {
        RemoteFixture standing = new(), running = new();
        standing.CreateStanding();
        running.CreateStanding();
        running.Say(MotionOf(1, 0, Run(2.65f)));
        foreach (RemoteFixture f in (RemoteFixture[])[standing, running])
        {
            f.Say(new VectorUpdate(One, new Vector3(0, 3, 6), default, 1, 1));
            f.Frames(1);
            Assert.False(f.Body.HasContact);
        }

        Assert.Equal(new Vector3(0, 3, 6), standing.Body.Velocity);
        Assert.Equal(10.6f, running.Body.Velocity.Y, 1e-5f);
        Assert.Equal(0, running.Body.Velocity.Z);
    }

    [Fact]
    [Behaviour("remote.velocity.stamps", "spec/09, 5.2 and 5.5; CPhysicsObj::set_velocity @0x005113F0")]
    public void A_velocity_acts_once_and_is_held_to_fifty_metres_a_second()
    {
        RemoteFixture f = new();
        f.Create(Describe(One, Start + new Vector3(0, 0, 20), Stamps() with { Vector = 65535 }));
        f.Say(new VectorUpdate(One, new Vector3(0, 300, 400), new Vector3(0, 0, 1), 1, 0));
        Assert.True(Vector3.Distance(new Vector3(0, 30, 40), f.Body.Velocity) < 1e-4f);
        Assert.Equal(new Vector3(0, 0, 1), f.Body.Omega);
        f.Say(new VectorUpdate(One, new Vector3(1, 0, 0), default, 1, 65535));
        f.Say(new VectorUpdate(One, new Vector3(1, 0, 0), default, 1, 0));
        Assert.Equal((0f, 2L), (f.Body.Velocity.X, f.Remote.Drops[RemoteDrop.Late]));
    }

    [Fact]
    [Behaviour("remote.state.stamps", "spec/09, 5.2 and 5.5; DoSetState @0x004520D0")]
    public void A_state_word_acts_once_and_a_hidden_body_keeps_its_cell()
    {
        const uint hidden = Standing | (uint)PhysicsState.Hidden;
        RemoteFixture f = new();
        f.CreateStanding(Stamps() with { State = 32767 });
        f.Say(new SetState(One, hidden, 1, 32767));
        f.Say(new SetState(One, hidden, 1, 65535));
        Assert.False(f.Body.State.HasFlag(PhysicsState.Hidden), "half way round, the smaller number is the newer one");
        f.Say(new SetState(One, hidden, 1, 65534));
        Assert.True(f.Body.State.HasFlag(PhysicsState.Hidden));
        Assert.NotNull(f.Body.Cell);
        f.Say(PositionOf(Start + new Vector3(0, 4, 0), 1));
        f.Frames(30);
        Assert.Equal(Start.Y + 4, f.Origin.Y, 0.06f);
        f.Say(new SetState(One, Standing, 1, 1));
        Assert.False(f.Body.State.HasFlag(PhysicsState.Hidden));
    }

    [Fact]
    [Behaviour("remote.look.stamps", "spec/09, 5.5; UpdateVisualDesc @0x00451F40")]
    public void A_new_look_is_kept_and_moves_nothing()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        ulong before = f.Engine.HashState();
        ModelData look = new() { Parts = [new PartChange(1, 0x01000005)] };
        f.Say(new ObjDescEvent(One, look, 1, 1));
        f.Say(new ObjDescEvent(One, new ModelData(), 1, 1));
        Assert.Equal((look, before), (f.Item.Model, f.Engine.HashState()));
    }

    [Fact]
    [Behaviour("remote.killers", "spec/08, 6.7: PK status; spec/02, 4.21, step 4")]
    public void Whether_a_player_is_a_killer_is_told_at_the_beginning_and_later()
    {
        RemoteFixture f = new();
        ObjectDescription player = Describe(One, Start);
        f.Create(player with { Weenie = player.Weenie with { Description = 0x8 | 0x20 } });
        const WeenieTraits plain = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;
        Assert.Equal(plain | WeenieTraits.PK, f.Body.Weenie);
        f.Say(new PublicUpdatePropertyInt(0, One, 134, 0x40));
        Assert.Equal(plain | WeenieTraits.PKLite, f.Body.Weenie);
        f.Say(new PublicUpdatePropertyInt(0, One, 134, 2));
        Assert.Equal(plain, f.Body.Weenie);
    }
}
