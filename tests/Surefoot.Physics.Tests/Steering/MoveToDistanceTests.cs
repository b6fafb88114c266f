using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Distance and arrival: the table of specification 09b, 14.4. The body has radius 0.3 m and height 1.8 m.</summary>
public class MoveToDistanceTests
{
    private const uint TargetId = 2;

    private readonly FakeSteeredWorld world = new();
    private readonly FakeSteeredBody body;

    public MoveToDistanceTests() => body = new FakeSteeredBody(world, 1, Vector3.Zero) { OwnRadius = 0.3f, OwnHeight = 1.8f };

    [Theory]
    [Behaviour("steering.move-to.distance", "spec/09b, 14.4; MoveToManager::GetCurrentDistance @0x005291B0")]
    [InlineData(0.5f, 2f, 1.4f, 0f, 0f, 0.599999964f, true)]
    [InlineData(0.5f, 2f, 1.5f, 0f, 0f, 0.699999988f, false)]
    [InlineData(0.5f, 2f, 0.7f, 0f, 0f, -1.80277562f, true)]
    [InlineData(0.5f, 2f, 1.4f, 0f, 1f, 0.920464993f, false)]
    [InlineData(0.5f, 2f, 1f, 0f, 3f, 2.6495955f, false)]
    public void An_object_is_reached_when_the_gap_to_it_is_small_enough(
        float radius, float height, float x, float y, float z, float distance, bool arrived)
    {
        Vector3 place = new(x, y, z);
        FakeSteeredBody target = new(world, TargetId, place) { OwnRadius = radius, OwnHeight = height };
        Assert.Equal(distance, (float)body.Position.CylinderDistance(body.Radius, body.Height, target.Position, radius, height), 1e-6f);

        // It comes from the west and faces the object, so that it walks at once.
        body.Warp(FakeSteeredBody.At(new Vector3(x - 10, y, z), 90));
        body.Order().MoveToObject(TargetId, radius, height, new MovementParameters());
        Assert.True(body.Mover!.NodeAt(0).IsMove);
        body.Warp(FakeSteeredBody.At(Vector3.Zero, 90));
        body.Mover.UseTime();
        Assert.Equal(arrived, !body.Mover.IsMovingTo);
    }

    [Theory]
    [Behaviour("steering.move-to.distance-to-a-place", "spec/09b, 14.4")]
    [InlineData(0.9f, 0.599999964f, true)]
    [InlineData(0.91f, 0.610000014f, false)]
    public void A_place_is_reached_by_the_rim_of_the_body(float x, float distance, bool arrived)
    {
        Position place = FakeSteeredBody.At(x, 0);
        Assert.Equal(distance, (float)body.Position.CylinderDistance(body.Radius, body.Height, place, 0, 0), 1e-6f);
        body.Warp(FakeSteeredBody.At(x - 10, 0, 90));
        body.Order().MoveToPosition(place, new MovementParameters());
        Assert.True(body.Mover!.NodeAt(0).IsMove);
        body.Warp(FakeSteeredBody.At(0, 0, 90));
        body.Mover.UseTime();
        Assert.Equal(arrived, !body.Mover.IsMovingTo);
    }

    [Fact]
    [Behaviour("steering.move-to.first-look-is-from-the-centre", "spec/09b, 14.4 D8; MoveToManager::MoveToPosition @0x0052A240")]
    public void A_place_that_only_the_centre_is_too_far_from_is_turned_to()
    {
        body.Order().MoveToPosition(FakeSteeredBody.At(0.75f, 0), new MovementParameters());
        Assert.Equal(2, body.Mover!.NodeCount);
        Assert.Equal((false, 90f), (body.Mover.NodeAt(0).IsMove, body.Mover.NodeAt(0).Heading));
        Assert.Equal(MotionCommand.TurnRight, body.Mover.CurrentCommand);
        body.SetHeading(91);
        body.Done.Clear();
        body.Mover.UseTime();
        Assert.False(body.Mover.IsMovingTo);
        Assert.Equal(90, body.Position.Frame.Heading, 1e-4);
        Assert.DoesNotContain(body.Done, done => done.StartsWith("do", StringComparison.Ordinal));
    }

    [Fact]
    [Behaviour("steering.move-to.already-there", "spec/09b, 14.4 D9")]
    public void A_place_that_is_near_enough_only_stops_the_body()
    {
        body.Order().MoveToPosition(FakeSteeredBody.At(0.5f, 0), new MovementParameters());
        Assert.False(body.Mover!.IsMovingTo);
        Assert.Equal(["halt", "halt"], body.Done);
        Assert.Equal([MotionError.None], body.Ended);
    }
}
