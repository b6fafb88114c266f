using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Tracking an object: the examples of specification 09b, 14.6.</summary>
public class TargetTests
{
    private const uint TargetId = 2;

    private readonly FakeSteeredWorld world = new() { Now = 0 };
    private readonly FakeSteeredBody body;

    public TargetTests() => body = new FakeSteeredBody(world, 1, new Vector3(0, -10, 0));

    [Fact]
    [Behaviour("steering.target.quantum", "spec/09b, 14.6 Q; MoveToManager::HandleMoveToPosition @0x00529D80")]
    public void The_place_of_a_target_is_foretold_as_far_ahead_as_the_way_takes_when_that_changed_by_a_second()
    {
        FakeSteeredBody target = Spawn();
        target.Warp(FakeSteeredBody.At(Vector3.Zero));
        MovementParameters way = new() { Flags = MovementFlags.Default & ~MovementFlags.UseSpheres };
        body.Order().MoveToObject(TargetId, 0.5f, 1.8f, way);
        (float Distance, float Speed, double Quantum)[] rows =
        [
            (10, 0.05f, 0), (10, 10.6f, 0), (30, 10.6f, 2.83018858), (20, 10.6f, 2.83018858), (18, 10.6f, 1.69811315),
            (9, 10.6f, 1.69811315), (1, 3.12f, 0.320512832),
        ];
        foreach ((float distance, float speed, double quantum) in rows)
        {
            body.Achieved = new Vector3(0, speed, 0);
            body.Warp(FakeSteeredBody.At(0, -distance));
            body.Mover!.UseTime();
            Assert.Equal(quantum, body.TargetManager!.Quantum, 1e-8);
            Assert.Equal(quantum, target.TargetManager!.Voyeurs[0].Quantum, 1e-7);
        }

        Assert.Single(body.Reports);
    }

    [Theory]
    [Behaviour("steering.target.reports", "spec/09b, 14.6 V1 and V2; TargetManager::CheckAndUpdateVoyeur @0x0051A650")]
    [InlineData(0f, new[] { 2f, 4f, 6f })]
    [InlineData(2f, new[] { 10f, 12f, 14f })]
    public void A_moving_target_reports_every_half_second_where_it_is_and_will_be(float quantum, float[] foretold)
    {
        FakeSteeredBody target = Spawn();
        body.SetTarget(0, TargetId, 0.5f, quantum);
        Assert.Equal(Vector3.Zero, Assert.Single(body.Reports).InterpolatedPosition.Frame.Origin);
        target.Achieved = new Vector3(4, 0, 0);
        for (int i = 0; i < 3; i++)
        {
            float x = 2 * (i + 1);
            Check(target, x, 0.5 * (i + 1));
            Assert.Equal(i + 2, body.Reports.Count);
            TargetInfo report = body.Reports[^1];
            Assert.Equal((x, foretold[i], TargetStatus.OK),
                (report.TargetPosition.Frame.Origin.X, report.InterpolatedPosition.Frame.Origin.X, report.Status));
        }
    }

    [Theory]
    [Behaviour("steering.target.radius", "spec/09b, 14.6 V3")]
    [InlineData(0f, 5)]
    [InlineData(2f, 1)]
    public void A_slow_target_reports_when_it_will_be_more_than_half_a_metre_off(float quantum, int firstCheck)
    {
        FakeSteeredBody target = Spawn();
        body.SetTarget(0, TargetId, 0.5f, quantum);
        target.Achieved = new Vector3(0.25f, 0, 0);
        for (int i = 1; i <= firstCheck; i++)
        {
            Assert.Single(body.Reports);
            Check(target, 0.125f * i, 0.5 * i);
        }

        for (int i = firstCheck + 1; i <= firstCheck + 2; i++)
        {
            Check(target, 0.125f * i, 0.5 * i);
            Assert.Equal(2, body.Reports.Count);
        }
    }

    [Fact]
    [Behaviour("steering.target.time-out", "spec/09b, 14.6 V4; TargetManager::HandleTargetting @0x0051AA90")]
    public void An_order_to_an_object_that_never_reports_ends_after_ten_seconds()
    {
        body.Order().MoveToObject(TargetId, 0.5f, 1.8f, new MovementParameters());
        for (double time = 0.5; time <= 10; time += 0.5)
        {
            world.Now = time;
            body.HandleTargetting(time);
            Assert.True(body.Mover!.IsMovingTo);
        }

        world.Now = 10.5;
        body.HandleTargetting(10.5);
        Assert.False(body.Mover!.IsMovingTo);
        Assert.Equal([MotionError.NoTarget], body.Ended);
        Assert.Equal(TargetStatus.TimedOut, Assert.Single(body.Reports).Status);
    }

    [Theory]
    [Behaviour("steering.target.gone", "spec/09b, 14.6 V5; TargetManager::NotifyVoyeurOfEvent @0x0051A6F0")]
    [InlineData(true)]
    [InlineData(false)]
    public void An_order_ends_when_its_target_is_teleported_or_deleted(bool teleported)
    {
        FakeSteeredBody target = Spawn();
        body.Order().MoveToObject(TargetId, 0.5f, 1.8f, new MovementParameters());
        Assert.True(body.Mover!.IsInitialised);
        if (teleported) target.HandleTeleport();
        else target.HandleExitWorld();
        Assert.False(body.Mover.IsMovingTo);
        Assert.Equal([MotionError.TargetGone], body.Ended);
        Assert.Equal(teleported ? TargetStatus.Teleported : TargetStatus.LeftWorld, body.Reports[^1].Status);
        Assert.False(body.TargetManager!.HasTarget);
        Assert.Equal(0, target.TargetManager!.Voyeurs.Count);
    }

    [Fact]
    [Behaviour("steering.target.stick-after-arrival", "spec/09b, 14.6 V6 and 14.7 M4")]
    public void A_sticky_order_tracks_its_target_anew_when_it_arrives()
    {
        FakeSteeredBody target = Spawn();
        body.Order().MoveToObject(
            TargetId, 0.5f, 1.8f, new MovementParameters { Flags = MovementFlags.Default | MovementFlags.Sticky });
        Assert.Equal((0.5f, 0.0), (target.TargetManager!.Voyeurs[0].Radius, target.TargetManager.Voyeurs[0].Quantum));
        body.Warp(FakeSteeredBody.At(0, -1));
        body.Mover!.UseTime();
        Assert.Equal((false, TargetId), (body.Mover.IsMovingTo, body.StickyObjectId));
        Assert.Equal((0.5f, 0.5), (target.TargetManager.Voyeurs[0].Radius, target.TargetManager.Voyeurs[0].Quantum));
        Assert.Equal(2, body.Reports.Count);
    }

    private FakeSteeredBody Spawn() => new(world, TargetId, Vector3.Zero);

    private void Check(FakeSteeredBody target, float x, double time)
    {
        target.Warp(FakeSteeredBody.At(x, 0));
        world.Now = time;
        target.HandleTargetting(time);
    }
}
