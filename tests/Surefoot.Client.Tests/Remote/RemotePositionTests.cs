using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Positions of other bodies: specification 09, 5.2, 5.3 and 6.7.</summary>
public class RemotePositionTests
{
    private static readonly Vector3 Near = Start + new Vector3(0, 5, 0), Far = Start + new Vector3(0, 150, 0);

    /// <summary>What the body did about a position.</summary>
    public enum Outcome
    {
        Dropped,
        Ignored,
        Follows,
        Placed,
        Teleported,
    }

    [Theory]
    [Behaviour("remote.position.stamps", "spec/09, 6.7; HandleReceivedPosition @0x00453FD0, CPhysicsObj::MoveOrTeleport @0x00516330")]
    [InlineData(0, 7, true, 30f, Outcome.Follows, 0, 7)]
    [InlineData(65535, 7, true, 30f, Outcome.Dropped, 65535, 7)]
    [InlineData(65535, 8, true, 30f, Outcome.Dropped, 65535, 7)]
    [InlineData(0, 6, true, 30f, Outcome.Dropped, 65535, 7)]
    [InlineData(0, 8, false, 30f, Outcome.Teleported, 0, 8)]
    [InlineData(0, 7, false, 30f, Outcome.Ignored, 0, 7)]
    [InlineData(0, 7, true, 96f, Outcome.Placed, 0, 7)]
    [InlineData(0, 32776, true, 30f, Outcome.Dropped, 65535, 7)]
    [InlineData(0, 32775, true, 30f, Outcome.Dropped, 65535, 7)]
    [InlineData(0, 32774, true, 30f, Outcome.Teleported, 0, 32774)]
    public void A_position_acts_by_its_stamps_and_by_where_the_player_is(
        ushort position, ushort teleport, bool contact, float playerDistance, Outcome outcome, ushort storedPosition, ushort storedTeleport)
    {
        RemoteFixture f = new(playerDistance: playerDistance);
        f.CreateStanding(Stamps(65535, 7));
        Assert.Equal(playerDistance, f.Body.PlayerDistance);
        BeginAWay(f);
        Assert.Equal(outcome, Hear(f, PositionOf(Near, position, teleport, contact)));
        Assert.Equal(
            (storedPosition, storedTeleport),
            (f.Item.Stamps[ObjectStamp.Position], f.Item.Stamps[ObjectStamp.Teleport]));
        Assert.Equal(outcome == Outcome.Dropped ? 1 : 0, f.Remote.Drops[RemoteDrop.Late]);
    }

    [Fact]
    [Behaviour("remote.position.before-the-first-tick", "spec/09, 5.3 and 6.7")]
    public void A_body_that_had_no_tick_yet_is_put_there()
    {
        RemoteFixture f = new();
        f.Create(Describe(One, Start, Stamps(65535, 7)));
        BeginAWay(f);
        Assert.Equal(Outcome.Placed, Hear(f, PositionOf(Near, 0, 7)));
    }

    [Fact]
    [Behaviour("remote.position.without-a-cell", "spec/09, 5.3, 5.6 and 6.7")]
    public void A_body_that_was_picked_up_is_teleported_whatever_the_stamp_says()
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps(65534, 7));
        BeginAWay(f);
        f.Say(new PickupEvent(One, 1, 65535));
        Assert.Equal((null, 0u), (f.Body.Cell, f.Body.Position.CellId));
        Assert.Equal(Outcome.Teleported, Hear(f, PositionOf(Near, 0, 7, contact: false)));
    }

    [Fact]
    [Behaviour("remote.position.blip", "spec/09, 6.4 f and 6.7; InterpolationManager::UseTime @0x00555F20")]
    public void A_position_too_far_away_is_jumped_to_in_the_next_quantum()
    {
        RemoteFixture f = new(playerDistance: 95.99f);
        f.CreateStanding(Stamps(65535, 7));
        Assert.Equal(Outcome.Follows, Hear(f, PositionOf(Far, 0, 7)));
        f.Frames(1);
        Assert.Equal(Far.Y, f.Origin.Y);
        Assert.False(f.Body.IsInterpolating);
    }

    [Fact]
    [Behaviour("remote.position.followed", "spec/09, 4.3 and 6.1")]
    public void A_position_is_followed_at_twice_the_running_speed_and_its_heading_taken_at_once()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        // 8 m/s for a creature that never ran: four quanta and a bit for a metre.
        Frame(f, heading: 90);
        f.Frames(1);
        Assert.Equal(90, f.Body.Position.Frame.Heading, 1e-4);
        Assert.Equal(Start.Y + 0.266667f, f.Origin.Y, 1e-4f);
        f.Frames(5);
        Assert.Equal(Start.Y + 1, f.Origin.Y, 1e-4f);
        Assert.False(f.Body.IsInterpolating);

        static void Frame(RemoteFixture f, float heading)
        {
            WirePosition place = At(Start + new Vector3(0, 1, 0)) with
            {
                Orientation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, -heading * MathF.PI / 180),
            };
            f.Say(new UpdatePosition(One, new PositionPack(place, true, 1, 1, 0, 0)));
        }
    }

    [Fact]
    [Behaviour("remote.position.order-and-loss", "spec/09, 5.2")]
    public void Positions_that_come_late_or_twice_do_nothing()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(PositionOf(Near, 3));
        f.Say(PositionOf(Start - new Vector3(0, 5, 0), 2));
        f.Say(PositionOf(Start - new Vector3(0, 5, 0), 3));
        f.Frames(60);
        Assert.Equal((Near.Y, 2L), (MathF.Round(f.Origin.Y, 3), f.Remote.Drops[RemoteDrop.Late]));
    }

    [Fact]
    [Behaviour("remote.position.keeps-heading-on-a-way", "spec/09, 5.3: keep = is moving to")]
    public void On_a_way_that_a_server_ordered_a_position_does_not_turn_the_body()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        BeginAWay(f);
        f.Frames(40);
        double heading = f.Body.Position.Frame.Heading;
        Assert.InRange(heading, 85, 95);
        f.Say(PositionOf(f.Origin + new Vector3(0, 1, 0), 1));
        f.Frames(2);
        Assert.Equal(heading, f.Body.Position.Frame.Heading, 5.0);
        Assert.True(f.Movement.IsMovingTo);
    }

    [Fact]
    [Behaviour("remote.position-and-movement", "spec/08, 6.1; spec/09, 5.1")]
    public void A_message_of_both_moves_the_body_also_when_its_position_comes_late()
    {
        RemoteFixture f = new();
        f.CreateStanding(Stamps(5));
        f.Say(new PositionAndMovement(PositionOf(Near, 4), MotionOf(1, 0, Run(1.5f))));
        Assert.Equal((1.5f, false, 1L), (f.Motion.ForwardSpeed, f.Body.IsInterpolating, f.Remote.Drops[RemoteDrop.Late]));
        f.Say(new PositionAndMovement(PositionOf(Near, 6, instance: 0), MotionOf(2, 0, Run(2))));
        Assert.Equal((1.5f, 1L), (f.Motion.ForwardSpeed, f.Remote.Drops[RemoteDrop.EarlierLife]));
    }

    /// <summary>Has the body begin a long way to the east, which a teleport ends and a correction does not.</summary>
    private static void BeginAWay(RemoteFixture f)
    {
        f.Say(MotionOf(1, 0, MovementData.MoveToPosition(NonCombat, StubWorld.CellId, Start + new Vector3(60, 0, 0), Way, 1)));
        Assert.True(f.Body.IsMovingTo);
    }

    private static Outcome Hear(RemoteFixture f, in UpdatePosition message)
    {
        Vector3 before = f.Origin;
        bool wasOnAWay = f.Body.IsMovingTo;
        ushort stamp = f.Item.Stamps[ObjectStamp.Position];
        Assert.Null(f.Leash);
        f.Say(message);
        if (f.Item.Stamps[ObjectStamp.Position] == stamp || f.Leash is null)
        {
            Assert.Equal((before, wasOnAWay, false, true), (f.Origin, f.Body.IsMovingTo, f.Body.IsInterpolating, f.Leash is null));
            return f.Item.Stamps[ObjectStamp.Position] == stamp ? Outcome.Dropped : Outcome.Ignored;
        }

        // The leash is tied where the body is now.
        Assert.Equal((true, 0f), (f.Leash.IsConstrained, f.Leash.PathLength));
        if (f.Body.IsInterpolating)
        {
            Assert.Equal((before, wasOnAWay), (f.Origin, f.Body.IsMovingTo));
            return Outcome.Follows;
        }

        Assert.Equal(message.Pack.Position.Origin.Y, f.Origin.Y);
        return wasOnAWay && !f.Body.IsMovingTo ? Outcome.Teleported : Outcome.Placed;
    }
}
