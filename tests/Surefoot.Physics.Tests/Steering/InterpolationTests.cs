using System.Numerics;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Following a server's positions: the worked examples of specification 09, 6.1 to 6.4.</summary>
public class InterpolationTests
{
    private const float Run = 10.6f;

    private readonly FakeSteeredBody body = new(new FakeSteeredWorld(), 1, new Vector3(10, 10, 0));

    [Fact]
    [Behaviour("steering.interpolation.catches-up-at-twice-the-speed", "spec/09, 6.1; InterpolationManager::adjust_offset @0x00555D30")]
    public void A_body_catches_up_at_twice_its_running_speed()
    {
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        (float Offset, float Y, int Frames, float Time, int Queue)[] expected =
        [
            (0.266666681f, 10.2666664f, 1, 0.0333333351f, 1),
            (0.266666681f, 10.5333328f, 2, 0.0666666701f, 1),
            (0.266666681f, 10.7999992f, 3, 0.100000009f, 1),
            (0.200000763f, 11f, 4, 0.13333334f, 1),
            (0f, 11f, 0, 0f, 0),
        ];
        foreach (var row in expected)
        {
            body.Advance();
            InterpolationManager manager = body.Interpolation;
            Assert.Equal(row, (body.Offset.Origin.Y, body.Y, manager.FrameCounter, manager.ProgressTime, manager.QueueLength));
        }
    }

    [Fact]
    [Behaviour("steering.interpolation.runner-uses-its-own-speed", "spec/09, 3.2 step 3 and 6.1")]
    public void A_runner_is_caught_up_with_at_twice_the_speed_of_its_own_run()
    {
        body.Adjusted = Run;
        body.InterpolateTo(FakeSteeredBody.At(10, 15), keepHeading: false);
        float[] expected = [10.7066669f, 11.4133339f, 12.1200008f, 12.8266678f, 13.5333347f, 14.2400017f, 14.9466686f, 15f];
        for (int i = 0; i < expected.Length; i++)
        {
            body.Advance();
            Assert.Equal(expected[i], body.Y);
            // The fifth quantum looks at the progress since infinity, and counts from here.
            if (i == 4) Assert.Equal((0, 2.17333221f), (body.Interpolation.FrameCounter, body.Interpolation.OriginalDistance));
        }

        body.Advance();
        Assert.False(body.IsInterpolating);
    }

    [Fact]
    [Behaviour("steering.interpolation.long-quanta", "spec/09, 6.1")]
    public void Long_quanta_take_long_strides()
    {
        body.Adjusted = Run;
        body.InterpolateTo(FakeSteeredBody.At(10, 15), keepHeading: false);
        body.Advance(0.2f);
        Assert.Equal(14.2399998f, body.Y);
        body.Advance(0.2f);
        Assert.Equal((15f, true), (body.Y, body.IsInterpolating));
        body.Advance(0.2f);
        Assert.False(body.IsInterpolating);
    }

    [Fact]
    [Behaviour("steering.interpolation.heading-at-once", "spec/09, 6.2")]
    public void The_heading_of_a_position_is_taken_in_the_first_quantum()
    {
        body.InterpolateTo(FakeSteeredBody.At(11, 10, heading: 90), keepHeading: false);
        body.Advance();
        Assert.Equal(new Vector3(0.266666681f, 0, 0), body.Offset.Origin);
        Assert.Equal(new Vector3(10.2666664f, 10, 0), body.Position.Frame.Origin);
        Assert.Equal(90, body.Position.Frame.Heading, 1e-5);
        body.Advance();
        Assert.Equal(0.266666681f, body.Offset.Origin.Y, 1e-6f);
        body.Advance(2);
        Assert.Equal(11f, body.Position.Frame.Origin.X, 1e-6f);
    }

    [Fact]
    [Behaviour("steering.interpolation.keep-heading", "spec/09, 6.2")]
    public void A_body_that_keeps_its_heading_walks_sideways()
    {
        body.SetHeading(45);
        body.InterpolateTo(FakeSteeredBody.At(11, 10, heading: 90), keepHeading: true);
        Assert.Equal(45, body.Interpolation.QueueAt(0).Frame.Heading, 1e-5);
        body.Advance();
        Assert.Equal(0.188561812f, body.Offset.Origin.X, 1e-6f);
        Assert.Equal(0.188561827f, body.Offset.Origin.Y, 1e-6f);
        Assert.Equal(10.2666664f, body.Position.Frame.Origin.X, 1e-6f);
        for (int i = 0; i < 4; i++, body.Advance()) Assert.Equal(45, body.Position.Frame.Heading, 1e-4);
    }

    [Fact]
    [Behaviour("steering.interpolation.already-there", "spec/09, 3.2 and 6.2; InterpolationManager::InterpolateTo @0x00555B20")]
    public void A_position_where_the_body_is_turns_it_and_ends_the_queue()
    {
        body.InterpolateTo(FakeSteeredBody.At(10, 20), keepHeading: false);
        body.InterpolateTo(FakeSteeredBody.At(10.04f, 10, heading: 90), keepHeading: false);
        Assert.Equal(90, body.Position.Frame.Heading, 1e-5);
        Assert.Equal((new Vector3(10, 10, 0), false), (body.Position.Frame.Origin, body.IsInterpolating));
        body.InterpolateTo(FakeSteeredBody.At(10.04f, 10, heading: 180), keepHeading: true);
        Assert.Equal(90, body.Position.Frame.Heading, 1e-5);
    }

    [Fact]
    [Behaviour("steering.interpolation.queue-of-twenty", "spec/09, 6.3")]
    public void Twenty_positions_are_kept_and_near_ones_replace_each_other()
    {
        for (int y = 11; y <= 35; y++) body.InterpolateTo(FakeSteeredBody.At(10, y), keepHeading: false);
        Assert.Equal((20, 16f, 35f), Queue());
        body.InterpolateTo(FakeSteeredBody.At(10, 35.03f), keepHeading: false);
        Assert.Equal((20, 16f, 35.03f), Queue());
        body.InterpolateTo(FakeSteeredBody.At(10, 35.08f), keepHeading: false);
        Assert.Equal((20, 17f, 35.08f), Queue());
    }

    [Fact]
    [Behaviour("steering.interpolation.reached-lets-root-motion-through", "spec/09, 6.3")]
    public void In_the_quantum_in_which_a_position_is_reached_the_body_moves_by_itself()
    {
        body.Root = new Vector3(0, 0.1f, 0);
        body.InterpolateTo(FakeSteeredBody.At(10, 10.3f), keepHeading: false);
        body.InterpolateTo(FakeSteeredBody.At(10, 10.8f), keepHeading: false);
        float[] expected = [10.2666664f, 10.3666668f, 10.6333332f, 10.8000002f, 10.9000006f, 11.0000006f];
        for (int i = 0; i < expected.Length; i++)
        {
            body.Advance();
            Assert.Equal(expected[i], body.Y, 1e-6f);
            if (i == 1) Assert.Equal(0.533333778f, body.Interpolation.OriginalDistance);
        }
    }

    [Fact]
    [Behaviour("steering.interpolation.blip-when-stuck", "spec/09, 6.4 a; InterpolationManager::UseTime @0x00555F20")]
    public void A_body_that_cannot_get_there_is_put_there()
    {
        body.Blocked = true;
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        body.Advance(5);
        Assert.Equal((0, 1f), (body.Interpolation.FrameCounter, body.Interpolation.OriginalDistance));
        body.Advance(4);
        Assert.Equal((10f, true), (body.Y, body.IsInterpolating));
        body.Advance();
        Assert.Equal((11f, false, 0), (body.Y, body.IsInterpolating, body.Interpolation.FailCount));
    }

    [Fact]
    [Behaviour("steering.interpolation.refused-blip-is-tried-again", "spec/09, 6.4 a")]
    public void A_refused_blip_is_tried_again_after_every_quantum()
    {
        (body.Blocked, body.Refuses) = (true, true);
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        body.Advance(12);
        Assert.Equal((3, 1, false), (body.Placements.Count, body.Interpolation.FailCount, body.IsInterpolating));

        // A position that comes later suspends that; only its end clears the failure.
        body.InterpolateTo(FakeSteeredBody.At(10, 12), keepHeading: false);
        body.Advance();
        Assert.Equal((3, 1), (body.Placements.Count, body.Interpolation.FailCount));
        body.Blocked = false;
        body.Advance(20);
        Assert.Equal((3, 0), (body.Placements.Count, body.Interpolation.FailCount));
    }

    [Fact]
    [Behaviour("steering.interpolation.fourth-failure-blips-to-the-newest", "spec/09, 6.4 b")]
    public void The_fourth_position_given_up_puts_the_body_to_the_newest()
    {
        body.Blocked = true;
        for (float y = 11; y <= 13; y += 0.5f) body.InterpolateTo(FakeSteeredBody.At(10, y), keepHeading: false);
        (int Quanta, int Fails, float Distance)[] expected = [(10, 1, 1.5f), (5, 2, 2f), (5, 3, 2.5f)];
        foreach (var row in expected)
        {
            body.Advance(row.Quanta);
            Assert.Equal((row.Fails, row.Distance, 10f), (body.Interpolation.FailCount, body.Interpolation.OriginalDistance, body.Y));
        }

        body.Advance(5);
        Assert.Equal((13f, false), (body.Y, body.IsInterpolating));
    }

    [Theory]
    [Behaviour("steering.interpolation.least-progress", "spec/09, 6.4 c")]
    [InlineData(4f, 1f / 30, 0.400000006f, false)]
    [InlineData(4f, 1f / 30, 0.400000036f, true)]
    [InlineData(10.6000004f, 1f / 30, 1.06000006f, false)]
    [InlineData(10.6000004f, 1f / 30, 1.06000018f, true)]
    [InlineData(4f, 0.2f, 2.39999986f, false)]
    [InlineData(4f, 0.2f, 2.4000001f, true)]
    public void Three_tenths_of_the_speed_are_progress(float speed, float quantum, float made, bool good)
    {
        // Seen for the second time the body is 1/16 m before its place, so that what it made is exact; what is given up that close is given
        // up quietly.
        const float Left = 0.0625f;
        body.Adjusted = speed;
        body.Blocked = true;
        body.Warp(FakeSteeredBody.At(0, 0));
        body.InterpolateTo(FakeSteeredBody.At(0, made + Left), keepHeading: false);
        body.InterpolateTo(FakeSteeredBody.At(0, 9), keepHeading: false);
        for (int i = 0; i < 5; i++) body.Advance(quantum);
        Assert.Equal(made, body.Interpolation.OriginalDistance - Left);
        for (int i = 0; i < 4; i++) body.Advance(quantum);
        body.Warp(FakeSteeredBody.At(0, made));
        body.Advance(quantum);
        Assert.Equal((good ? 2 : 1, 0), (body.Interpolation.QueueLength, body.Interpolation.FailCount));
    }

    [Fact]
    [Behaviour("steering.interpolation.close-enough-is-given-up-quietly", "spec/09, 6.4 d")]
    public void Close_to_its_place_a_body_gives_up_without_a_blip()
    {
        body.Blocked = true;
        body.InterpolateTo(FakeSteeredBody.At(10, 10.15f), keepHeading: false);
        body.Advance(10);
        Assert.Equal((10f, false, 0), (body.Y, body.IsInterpolating, body.Placements.Count));
    }

    [Fact]
    [Behaviour("steering.interpolation.stuck-to-something-never-fails", "spec/09, 6.4 e")]
    public void A_body_that_sticks_to_something_never_fails()
    {
        // The object it sticks to is not there, so that nothing but the sticking itself counts.
        body.Blocked = true;
        body.MakePositionManager().StickTo(0x77, 0.5f);
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        body.Advance(25);
        Assert.Equal((true, 0, 0), (body.IsInterpolating, body.Interpolation.FailCount, body.Placements.Count));
    }

    [Theory]
    [Behaviour("steering.interpolation.far-is-a-blip", "spec/09, 6.4 f; CPhysicsObj::GetAutonomyBlipDistance @0x0050EB70")]
    [InlineData(0xA9B40019u, false, 100f, false)]
    [InlineData(0xA9B40019u, false, 100.01f, true)]
    [InlineData(0xA9B40101u, false, 20f, false)]
    [InlineData(0xA9B40101u, false, 20.01f, true)]
    [InlineData(0xA9B40101u, true, 25f, false)]
    [InlineData(0xA9B40101u, true, 25.01f, true)]
    public void A_position_too_far_away_is_jumped_to_after_one_quantum_of_walking(uint cell, bool player, float away, bool blips)
    {
        body.Player = player;
        body.Warp(new Position(cell, Vector3.Zero));
        body.InterpolateTo(new Position(cell, new Vector3(0, away, 0)), keepHeading: false);
        Assert.Equal(blips ? 4 : 0, body.Interpolation.FailCount);
        body.Advance();
        Assert.Equal(0.266666681f, body.Offset.Origin.Y);
        Assert.Equal(blips ? away : 0.266666681f, body.Y);
    }

    [Fact]
    [Behaviour("steering.interpolation.distance-counts-from-the-newest", "spec/09, 6.4 f")]
    public void What_is_too_far_is_measured_from_the_newest_position()
    {
        body.InterpolateTo(FakeSteeredBody.At(10, 60), keepHeading: false);
        body.InterpolateTo(FakeSteeredBody.At(10, 155), keepHeading: false);
        Assert.Equal((2, 0), (body.Interpolation.QueueLength, body.Interpolation.FailCount));
    }

    [Fact]
    [Behaviour("steering.interpolation.sleeps-without-contact", "spec/09, 3.2 step 1")]
    public void In_the_air_the_positions_wait()
    {
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        body.Contact = false;
        body.Root = new Vector3(0, 0.1f, 0);
        body.Advance();
        Assert.Equal((10.1f, 0, true), (body.Y, body.Interpolation.FrameCounter, body.IsInterpolating));
    }

    [Fact]
    [Behaviour("steering.interpolation.speedless-bodies-use-a-fixed-speed", "spec/09, 3.2 step 3")]
    public void A_body_without_speed_is_moved_at_seven_and_a_half_metres_a_second()
    {
        body.Speed = 0;
        body.InterpolateTo(FakeSteeredBody.At(10, 11), keepHeading: false);
        body.Advance();
        Assert.Equal(0.25f, body.Offset.Origin.Y, 1e-7f);
    }

    [Fact]
    [Behaviour("steering.interpolation.bounded", "design.md, decision 7")]
    public void Ten_thousand_positions_out_of_reach_are_bounded()
    {
        for (int i = 0; i < 10000; i++) body.InterpolateTo(FakeSteeredBody.At(i % 2 == 0 ? 500 : -500, 0), keepHeading: false);
        Assert.InRange(body.Interpolation.QueueLength, 1, 32);
        body.Advance();
        Assert.Equal(-500f, body.Position.Frame.Origin.X);
    }

    private (int Count, float Head, float Tail) Queue()
    {
        InterpolationManager manager = body.Interpolation;
        return (manager.QueueLength, manager.QueueAt(0).Frame.Origin.Y, manager.QueueAt(manager.QueueLength - 1).Frame.Origin.Y);
    }
}
