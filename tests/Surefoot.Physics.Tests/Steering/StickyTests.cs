using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Sticking to an object: the worked examples of specification 09, 6.6.</summary>
public class StickyTests
{
    private const uint TargetId = 2;

    private readonly FakeSteeredWorld world = new();
    private readonly FakeSteeredBody body;
    private readonly FakeSteeredBody target;

    public StickyTests()
    {
        body = new FakeSteeredBody(world, 1, new Vector3(10, 10, 0));
        target = new FakeSteeredBody(world, TargetId, new Vector3(10, 14, 0)) { OwnRadius = 0.6f };
    }

    [Theory]
    [Behaviour("steering.sticky.one-quantum", "spec/09, 6.6; StickyManager::adjust_offset @0x00555430")]
    [InlineData(0f, 10f, 14f, 0f, 4f, 0f, 0.666666687f, 0f)]
    [InlineData(0f, 14f, 10f, 0f, 4f, 0.666666687f, 0f, 90f)]
    [InlineData(90f, 10f, 14f, 0f, 4f, -0.666666687f, 0f, 270f)]
    [InlineData(0f, 13f, 10f, 4f, 4f, 0.666666687f, 0f, 90f)]
    [InlineData(0f, 10f, 11f, 0f, 4f, 0f, -0.400000036f, 0f)]
    [InlineData(0f, 10f, 11f, 0f, 0.4f, 0f, 0.0666666701f, 0f)]
    [InlineData(0f, 10f, 10f, 0f, 4f, 0f, 0f, 0f)]
    public void A_body_goes_up_to_its_target_backs_off_or_first_goes_further_in(
        float own, float x, float y, float z, float speed, float offsetX, float offsetY, float turn)
    {
        body.SetHeading(own);
        body.Speed = speed;
        target.Warp(FakeSteeredBody.At(new Vector3(x, y, z)));
        body.StickToObject(TargetId);
        body.Advance();
        Assert.Equal(offsetX, body.Offset.Origin.X, 1e-6f);
        Assert.Equal(offsetY, body.Offset.Origin.Y, 1e-6f);
        Assert.Equal(0f, body.Offset.Origin.Z);
        Assert.Equal(turn, body.Offset.Heading, 1e-4);
    }

    [Fact]
    [Behaviour("steering.sticky.stays-next-to-it", "spec/09, 6.6")]
    public void A_body_comes_up_to_its_target_and_stays_there()
    {
        body.StickToObject(TargetId);
        foreach (float y in (float[])[10.666667f, 11.333334f, 12.000001f, 12.6000004f, 12.6000004f])
        {
            body.Advance();
            Assert.Equal(y, body.Y, 1e-6f);
        }
    }

    [Fact]
    [Behaviour("steering.sticky.one-second", "spec/09, 6.6; StickyManager::UseTime @0x00555610")]
    public void It_lasts_a_second_whatever_the_target_does()
    {
        body.StickToObject(TargetId);
        world.Now = 101;
        body.Advance();
        Assert.Equal(TargetId, body.StickyObjectId);
        world.Now = 101.0001;
        body.Advance();
        Assert.Equal(0u, body.StickyObjectId);
        Assert.False(body.TargetManager!.HasTarget);
        Assert.Equal(0, target.TargetManager!.Voyeurs.Count);
    }

    [Fact]
    [Behaviour("steering.sticky.again-releases-first", "spec/09, 6.6; StickyManager::StickTo @0x00555710")]
    public void Sticking_again_lets_go_first_and_that_ends_a_move_to()
    {
        body.StickToObject(TargetId);
        body.Order().TurnToHeading(new MovementParameters { DesiredHeading = 90 });
        Assert.True(body.Mover!.IsMovingTo);
        Assert.Equal(0u, body.StickyObjectId);
        body.StickToObject(TargetId);
        Assert.True(body.Mover.IsMovingTo);

        world.Now = 100.5;
        body.StickToObject(TargetId);
        Assert.False(body.Mover.IsMovingTo);
        Assert.Equal((TargetId, 101.5), (body.StickyObjectId, body.Sticky.Until));
    }

    [Fact]
    [Behaviour("steering.sticky.parent-is-stuck-to", "spec/09, 3.3; CPhysicsObj::stick_to_object @0x005127E0")]
    public void What_a_creature_holds_is_stuck_to_at_the_creature()
    {
        _ = new FakeSteeredBody(world, 3, new Vector3(0, 0, 0)) { Parent = target };
        body.StickToObject(3);
        Assert.Equal(TargetId, body.StickyObjectId);
        body.Unstick();
        body.StickToObject(99);
        Assert.Equal(0u, body.StickyObjectId);
    }

    [Fact]
    [Behaviour("steering.sticky.ends-with-its-target", "spec/09, 3.3; StickyManager::HandleUpdateTarget @0x00555780")]
    public void A_target_that_leaves_the_world_is_let_go()
    {
        body.StickToObject(TargetId);
        target.HandleExitWorld();
        Assert.Equal(0u, body.StickyObjectId);
        Assert.False(body.TargetManager!.HasTarget);
    }

    [Fact]
    [Behaviour("steering.sticky.unknown-target-waits", "spec/09, 3.3")]
    public void Sticking_to_what_is_not_there_moves_nothing()
    {
        body.MakePositionManager().StickTo(99, 0.5f);
        body.Advance();
        Assert.Equal((99u, false, 10f), (body.StickyObjectId, body.Sticky.IsInitialised, body.Y));
    }

    [Fact]
    [Behaviour("steering.sticky.overrides-interpolation", "spec/09, 3.1 and 3.3")]
    public void Sticking_overrides_the_way_to_a_servers_position()
    {
        body.InterpolateTo(FakeSteeredBody.At(20, 10), keepHeading: false);
        body.StickToObject(TargetId);
        body.Advance();
        Assert.Equal((10f, 10.666667f), (body.Position.Frame.Origin.X, body.Y));
    }

    [Fact]
    [Behaviour("steering.sticky.speedless-bodies-use-a-fixed-speed", "spec/09, 3.3 step 4")]
    public void A_body_without_speed_sticks_at_fifteen_metres_a_second()
    {
        body.Speed = 0;
        body.StickToObject(TargetId);
        body.Advance();
        Assert.Equal(0.5f, body.Offset.Origin.Y, 1e-6f);
    }
}
