using System.Numerics;
using Surefoot.Physics.Bodies;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>The nine stamps and what a position does: the worked examples of specification 09, 6.7.</summary>
public class StampTests
{
    [Theory]
    [Behaviour("stamps.newer-wraps-around", "spec/09, 6.7; CPhysicsObj::is_newer @0x00451AD0")]
    [InlineData(10, 11, true)]
    [InlineData(11, 10, false)]
    [InlineData(10, 10, false)]
    [InlineData(65535, 0, true)]
    [InlineData(0, 65535, false)]
    [InlineData(65530, 5, true)]
    [InlineData(5, 65530, false)]
    [InlineData(0, 32767, true)]
    [InlineData(0, 32768, false)]
    [InlineData(32768, 0, true)]
    [InlineData(1, 32769, false)]
    [InlineData(32769, 1, true)]
    [InlineData(40000, 7232, true)]
    [InlineData(40000, 7233, false)]
    [InlineData(32767, 65535, false)]
    public void Stamps_wrap_around(int stored, int incoming, bool newer) =>
        Assert.Equal(newer, MessageStamps.IsNewer((ushort)stored, (ushort)incoming));

    [Theory]
    [Behaviour("stamps.position", "spec/09, 6.7; CPhysicsObj::MoveOrTeleport @0x00516330")]
    [InlineData(0, 7, true, 30f, 5f, true, "interpolated", 0, 7)]
    [InlineData(65535, 7, true, 30f, 5f, true, "dropped", 65535, 7)]
    [InlineData(65535, 8, true, 30f, 5f, true, "dropped", 65535, 7)]
    [InlineData(0, 6, true, 30f, 5f, true, "dropped", 65535, 7)]
    [InlineData(0, 8, false, 30f, 5f, true, "teleported", 0, 8)]
    [InlineData(0, 7, false, 30f, 5f, true, "ignored", 0, 7)]
    [InlineData(0, 7, true, 96f, 5f, true, "placed", 0, 7)]
    [InlineData(0, 7, true, 95.99f, 150f, true, "blip", 0, 7)]
    [InlineData(0, 7, false, 30f, 5f, false, "teleported", 0, 7)]
    [InlineData(0, 7, true, float.MaxValue, 5f, true, "placed", 0, 7)]
    [InlineData(0, 32776, true, 30f, 5f, true, "dropped", 65535, 7)]
    [InlineData(0, 32775, true, 30f, 5f, true, "dropped", 65535, 7)]
    [InlineData(0, 32774, true, 30f, 5f, true, "teleported", 0, 32774)]
    public void A_position_of_a_server_is_followed_placed_ignored_or_dropped(
        int position, int teleport, bool contact, float playerDistance, float away, bool hasCell,
        string outcome, int positionAfter, int teleportAfter)
    {
        MessageStamps stamps = new([65535, 0, 0, 0, 7, 0, 0, 0, 0]);
        FakeSteeredBody body = new(new FakeSteeredWorld(), 1, Vector3.Zero) { DistanceFromPlayer = playerDistance, InWorld = hasCell };
        body.InterpolateTo(FakeSteeredBody.At(0, -1), keepHeading: false);
        string did = "dropped";
        if (stamps.TryAcceptPosition((ushort)position, (ushort)teleport, out bool teleported))
            did = body.MoveOrTeleport(FakeSteeredBody.At(0, away), teleported, contact).ToString().ToLowerInvariant();
        if (did == "interpolated" && body.Interpolation.FailCount > 3) did = "blip";
        Assert.Equal((outcome, positionAfter, teleportAfter), (did, stamps[ObjectStamp.Position], stamps[ObjectStamp.Teleport]));

        bool acted = did is not ("dropped" or "ignored");
        Assert.Equal(acted, body.PositionManager!.Constraint is { IsConstrained: true });
        if (acted) Assert.Equal(0f, body.Leash.PathLength);
        Assert.Equal(did switch { "placed" or "teleported" => 0, "dropped" or "ignored" => 1, _ => 2 }, body.Interpolation.QueueLength);
        Assert.Equal(did is "placed" or "teleported" ? away : 0f, body.Y);
    }

    [Theory]
    [Behaviour("stamps.motion", "spec/09, 6.7; CPhysics::SetObjectMovement @0x00509690")]
    [InlineData(10, 3, true, 10, 3)]
    [InlineData(10, 4, true, 10, 4)]
    [InlineData(9, 4, false, 9, 3)]
    [InlineData(10, 2, false, 10, 3)]
    public void A_motion_that_the_server_overtook_uses_up_its_stamp(
        int movement, int serverControl, bool accepted, int movementAfter, int serverControlAfter)
    {
        MessageStamps stamps = new([0, 9, 0, 0, 0, 3, 0, 0, 0]);
        Assert.Equal(accepted, stamps.TryAcceptMotion((ushort)movement, (ushort)serverControl));
        Assert.Equal((movementAfter, serverControlAfter), (stamps[ObjectStamp.Movement], stamps[ObjectStamp.ServerControlledMove]));
    }

    [Theory]
    [Behaviour("stamps.forced-position", "spec/08, 4.4 step 1")]
    [InlineData(5, true, 77)]
    [InlineData(7, true, 77)]
    [InlineData(3, false, 60)]
    public void A_correction_from_before_a_teleport_is_remembered_and_not_done(int teleport, bool forced, int position)
    {
        MessageStamps stamps = new([60, 0, 0, 0, 5, 0, 1, 0, 0]);
        Assert.Equal(forced, stamps.TryAcceptForcedPosition(77, (ushort)teleport, 2));
        Assert.Equal((position, 5, 2), (stamps[ObjectStamp.Position], stamps[ObjectStamp.Teleport], stamps[ObjectStamp.ForcePosition]));
        Assert.False(stamps.TryAcceptForcedPosition(78, 9, 2));
    }

    [Theory]
    [Behaviour("stamps.instance", "spec/09, 5.1")]
    [InlineData(4, InstanceAge.Current)]
    [InlineData(5, InstanceAge.Ahead)]
    [InlineData(3, InstanceAge.Stale)]
    [InlineData(4 + 32767, InstanceAge.Ahead)]
    [InlineData(4 + 32768, InstanceAge.Stale)]
    public void A_message_for_another_life_of_the_object_waits_or_is_dropped(int instance, object age) =>
        Assert.Equal(age, (object)new MessageStamps([0, 0, 0, 0, 0, 0, 0, 0, 4]).AgeOf((ushort)instance));

    [Fact]
    [Behaviour("stamps.repeated-messages-are-dropped", "spec/09, 5.2; CPhysicsObj::newer_event @0x00451B10")]
    public void A_message_that_comes_again_is_dropped()
    {
        MessageStamps stamps = default;
        foreach (ObjectStamp stamp in Enum.GetValues<ObjectStamp>())
        {
            Assert.True(stamps.TryAdvance(stamp, 1));
            Assert.False(stamps.TryAdvance(stamp, 1));
            Assert.False(stamps.TryAdvance(stamp, 0));
        }

        Assert.Equal(new MessageStamps([1, 1, 1, 1, 1, 1, 1, 1, 1]), stamps);
        Assert.NotEqual(default, stamps);
        Assert.Throws<ArgumentException>(() => new MessageStamps([1, 2]));
    }
}
