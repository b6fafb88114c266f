using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>What the design asks of bodies that a server moves, as a player notices it.</summary>
public class RemoteAcceptanceTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint PlayerId = 0x50000001;

    // The two humans' spheres, and what a touch leaves between them.
    private const double Radii = 0.48 + 0.48, Slack = 0.02;

    [Fact]
    [Behaviour("acceptance.dead-reckoning", "design, acceptance: dead reckoning; spec/09, 4.3: grounded, queue empty, not stuck")]
    public void Between_two_messages_another_player_goes_on_at_its_speed_from_where_it_was_told_to_be()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        Vector3 told = Start + new Vector3(0, 1, 0);
        f.Say(PositionOf(told, 1));
        f.Frames(15);
        AssertAt(told, f);

        // Nothing more is heard for a second: 4 m/s times 1.5, a frame of the animation more or less (spec/01b, 4).
        f.Say(MotionOf(1, 0, Run(1.5f), autonomous: true));
        f.Frames(30);
        Assert.Equal(6, f.Origin.Y - told.Y, 2 * 4 / 30f);
        Assert.Equal(told.X, f.Origin.X);
        f.Say(MotionOf(2, 0, MovementData.Motion(NonCombat, new WireInterpretedMotion()), autonomous: true));
        f.Frames(1);
        Vector3 stopped = f.Origin;
        f.Frames(30);
        Assert.Equal(stopped, f.Origin);
    }

    [Theory]
    [Behaviour("acceptance.moving-creatures-block", "design, acceptance: NPCs block movement while they move")]
    [InlineData(0f, 7f, 180f)]
    [InlineData(-1.2f, 3f, 90f)]
    [InlineData(1.2f, 3f, 270f)]
    public void A_creature_that_walks_by_a_servers_message_and_a_player_who_runs_at_it_do_not_pass_through_each_other(
        float east, float north, float heading)
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(100, 100), heading: 0);
        RemoteWorld remote = new(
            walk.Engine, new DatObjectAssets(files.Cache, movesHands: false), new RemoteWorldOptions { Player = PlayerId });
        Position begin = walk.Start;
        begin.Frame.Origin += new Vector3(east, north, 0);
        begin.Frame.SetHeading(heading);
        ObjectDescription creature = new(
            One, new ModelData(),
            new PhysicsDescription
            {
                State = (uint)PhysicsState.Default,
                Setup = Human,
                MotionTable = HumanTable,
                Position = new WirePosition(begin.CellId, begin.Frame.Origin, begin.Frame.Rotation),
                Stamps = Stamps(),
            },
            new WeenieDescription { Name = "a creature", ItemType = Creature });
        Say(remote, new CreateObject(creature));
        PhysicsBody body = remote.Find(One)!.Body;
        walk.Hold(MovementKeys.None, 5);
        Say(remote, MotionOf(1, 1, MovementData.Motion(NonCombat, new WireInterpretedMotion(forwardCommand: WalkForward))));

        double nearest = double.MaxValue, walked = 0;
        Position creatureBegan = body.Position;
        walk.Hold(MovementKeys.Forward, 60, () =>
        {
            double distance = walk.Position.HorizontalDistanceTo(body.Position);
            if (distance < nearest) (nearest, walked) = (distance, creatureBegan.DistanceTo(body.Position));
            Assert.True(distance > Radii - Slack, $"{distance} m between their axes");
        });
        Assert.InRange(nearest, Radii - Slack, Radii + 0.1);
        Assert.InRange(walked, 0.5, 10);
        Assert.True(walk.Moved.Length() > 1);
    }

    [Theory]
    [Behaviour("remote.motion.bad-values", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.NegativeInfinity)]
    [InlineData(1e30f)]
    public void A_motion_at_no_speed_that_can_be_is_counted_and_changes_nothing_but_the_stamp(float speed)
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(MotionOf(1, 1, Run(speed)));
        f.Say(MotionOf(2, 2, MovementData.MoveToPosition(NonCombat, StubCell, Start, Way, speed)));
        f.Say(MotionOf(3, 3, MovementData.Motion(NonCombat, new WireInterpretedMotion(turnCommand: 0x0D, turnSpeed: speed))));
        Assert.Equal(3, f.Remote.Drops[RemoteDrop.BadValue]);
        f.Frames(30);
        Assert.Equal(MotionCommand.Ready, f.Motion.ForwardCommand);
        AssertAt(Start, f);
        f.Say(MotionOf(4, 4, Run(1)));
        f.Frames(30);
        Assert.True(f.Origin.Y > Start.Y + 3);
    }

    [Fact]
    [Behaviour("remote.stamps.far-ahead", "spec/09, 5.2 and 6.7: 32767 ahead is newer, 32768 is not")]
    public void A_stamp_half_the_numbers_ahead_is_old_and_counted()
    {
        const ushort newer = 7 + 32767, older = 7 + 32768;
        RemoteFixture f = new();
        f.CreateStanding(new ObjectStamps(7, 7, 7, 7, 0, 0, 0, 7, 1));
        uint state = Standing | (uint)PhysicsState.Inelastic;
        ModelData model = new() { Parts = [new PartChange(1, 0x01000005)] };
        f.Say(PositionOf(Start + new Vector3(0, 1, 0), older));
        f.Say(MotionOf(older, 0, Run(1)));
        f.Say(new SetState(One, state, 1, older));
        f.Say(new VectorUpdate(One, new Vector3(0, 0, 1), default, 1, older));
        f.Say(new ObjDescEvent(One, model, 1, older));
        Assert.Equal(5, f.Remote.Drops[RemoteDrop.Late]);
        f.Frames(10);
        Assert.Equal(PhysicsState.Default, f.Body.State);
        AssertAt(Start, f);

        f.Say(PositionOf(Start + new Vector3(0, 1, 0), newer));
        f.Say(new SetState(One, state, 1, newer));
        f.Say(new ObjDescEvent(One, model, 1, newer));
        f.Frames(10);
        Assert.Equal((PhysicsState)state, f.Body.State);
        AssertAt(Start + new Vector3(0, 1, 0), f);
        Assert.Equal((model, 5L), (f.Item.Model, f.Remote.Drops[RemoteDrop.Late]));
    }

    private const uint StubCell = Physics.Tests.Transitions.StubWorld.CellId;

    private static void AssertAt(Vector3 place, RemoteFixture f) => Assert.Equal(0, Vector3.Distance(place, f.Origin), 1e-5f);

    private static void Say<T>(RemoteWorld remote, in T message)
        where T : IMessage<T>
    {
        byte[] bytes = new byte[1024];
        Assert.True(WireMessage.TryWrite(message, bytes, out int length));
        Assert.True(WireMessage.TryParse(bytes.AsSpan(0, length), out WireMessage parsed));
        remote.OnMessage(parsed);
    }
}
