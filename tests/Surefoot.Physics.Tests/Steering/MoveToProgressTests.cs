using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>What counts as progress on the way: the tables of specification 09b, 14.5.</summary>
public class MoveToProgressTests
{
    private const uint TargetId = 2;

    /// <summary>Distances from centre to centre; a body at (0, -d) that faces north is d metres from the target.</summary>
    private const MovementFlags Centres = MovementFlags.Default & ~MovementFlags.UseSpheres;

    private readonly FakeSteeredWorld world = new() { Now = 0 };
    private readonly FakeSteeredBody body;

    public MoveToProgressTests()
    {
        body = new FakeSteeredBody(world, 1, new Vector3(0, -10, 0));
        _ = new FakeSteeredBody(world, TargetId, Vector3.Zero);
    }

    [Fact]
    [Behaviour("steering.move-to.progress", "spec/09b, 14.5; MoveToManager::CheckProgressMade @0x005290F0")]
    public void A_quarter_of_a_metre_a_second_is_progress_and_too_little_keeps_the_reference()
    {
        body.Order().MoveToPosition(FakeSteeredBody.At(Vector3.Zero), new MovementParameters { Flags = Centres, DistanceToObject = 3.5f });
        Assert.Equal((10f, 0.0), body.Mover!.Previous);
        (double Time, float Distance, bool Progress, (float, double) Reference)[] rows =
        [
            (0.5, 9.9f, true, (10f, 0)),
            (1.0, 9.9f, true, (10f, 0)),
            (1.01, 9.9f, false, (10f, 0)),
            (1.5, 9.7f, false, (10f, 0)),
            (1.6, 9.59f, true, (9.59f, 1.6)),
            (2.7, 9.2f, true, (9.2f, 2.7)),
            (3.8, 9.0f, false, (9.2f, 2.7)),
            (5.0, 8.2f, true, (8.2f, 5.0)),
            (6.1, 8.0f, false, (8.2f, 5.0)),
            (7.2, 7.6f, true, (7.6f, 7.2)),
            (20, 7.0f, false, (7.6f, 7.2)),
            (30, 3.0f, false, (7.6f, 7.2)),
        ];
        foreach ((double time, float distance, bool progress, (float, double) reference) in rows)
        {
            Assert.Equal((time, progress), (time, IsProgress(time, distance)));
            Assert.Equal((time, reference), (time, body.Mover.Previous));
        }

        // Near enough in the last row, but without progress nobody looks.
        Assert.True(body.Mover.IsMovingTo);
    }

    [Fact]
    [Behaviour("steering.move-to.report-while-approaching", "spec/09b, 14.5 and 6.6; MoveToManager::HandleUpdateTarget @0x0052A7D0")]
    public void After_a_report_of_its_target_an_approach_looks_like_great_progress()
    {
        BeginAndReport(Centres, at: 5);
        Assert.True(IsProgress(6.1, 9.5f));
        Assert.Equal((9.5f, 6.1), body.Mover!.Previous);
        Assert.True(IsProgress(7.2, 9.2f));
    }

    [Fact]
    [Behaviour("steering.move-to.report-while-fleeing", "spec/09b, 14.5 and 6.6")]
    public void After_a_report_of_its_target_a_body_that_flees_overshoots()
    {
        MovementFlags away = (Centres | MovementFlags.MoveAway) & ~MovementFlags.MoveTowards;
        BeginAndReport(away, at: 5);
        Assert.True(body.Mover!.IsMovingAway);
        Assert.True(IsProgress(5.9, 7f));
        Assert.True(IsProgress(6, 7.6f));
        Assert.False(IsProgress(6.1, 8f));
        Assert.False(IsProgress(20, 60f));
        Assert.True(body.Mover.IsMovingTo, "it never notices that it is 30 m away");
    }

    [Theory]
    [Behaviour("steering.move-to.fail-distance", "spec/09b, 14.5; MoveToManager::HandleMoveToPosition @0x00529D80")]
    [InlineData(5.01f, 0.5, true)]
    [InlineData(5f, 0.5, false)]
    [InlineData(5.01f, 1.01, false)]
    public void Too_far_from_where_it_began_a_body_gives_up_when_it_makes_progress(float x, double time, bool gaveUp)
    {
        body.Warp(FakeSteeredBody.At(Vector3.Zero));
        MovementParameters way = new() { Flags = Centres, FailDistance = 5 };
        body.Order().MoveToPosition(FakeSteeredBody.At(0, 100), way);
        Assert.True(body.Mover!.IsMovingTo);
        world.Now = time;
        body.Warp(FakeSteeredBody.At(x, 0));
        body.Mover.UseTime();
        Assert.Equal(gaveUp, !body.Mover.IsMovingTo);
        Assert.Equal(gaveUp ? [MotionError.ChargedTooFar] : [], body.Ended);
    }

    private void BeginAndReport(MovementFlags flags, double at)
    {
        body.Order().MoveToObject(TargetId, 0.5f, 1.8f, new MovementParameters { Flags = flags, MinDistance = 30 });
        Assert.True(body.Mover!.NodeAt(0).IsMove);
        world.Now = at;
        TargetInfo report = new() { ObjectId = TargetId, Status = TargetStatus.OK, TargetPosition = FakeSteeredBody.At(Vector3.Zero) };
        body.HandleUpdateTarget(report);
    }

    /// <summary>A quantum at a time and a distance: without progress one more stalled quantum is counted.</summary>
    private bool IsProgress(double time, float distance)
    {
        world.Now = time;
        body.Warp(FakeSteeredBody.At(new Vector3(0, -distance, 0), (float)body.Position.Frame.Heading));
        int before = body.Mover!.StallCount;
        body.Mover.UseTime();
        if (body.Mover.StallCount == 0) return true;
        Assert.Equal(before + 1, body.Mover.StallCount);
        return false;
    }
}
