using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>A step in steady state allocates nothing: neither the keys, nor the motions, nor the body, nor its transition.</summary>
public sealed class AllocationTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const int Steps = 200;

    [Theory]
    [Behaviour("performance.step-allocates-nothing", "design.md, decision 4")]
    [InlineData("runway", MovementKeys.Forward)]
    [InlineData("hills", MovementKeys.Forward | MovementKeys.TurnRight)]
    [InlineData("slope-50", MovementKeys.Forward)]
    [InlineData("meadow", MovementKeys.SidestepLeft | MovementKeys.Walk)]
    public void A_walking_player_allocates_nothing(string place, MovementKeys keys)
    {
        DemoWalk walk = new(files, place, new CharacterStats(300, 300));
        walk.Hold(keys, Steps);
        Assert.Equal(0, Allocated(() => Step(walk)));
    }

    [Fact]
    [Behaviour("performance.fall-allocates-nothing", "design.md, decision 4")]
    public void A_falling_body_allocates_nothing()
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(300, 300));
        Position high = walk.Position;
        high.Frame.Origin += new Vector3(0, 0, 40);
        BodySeat seat = new(high, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero);
        int count = 0;
        void Fall()
        {
            if (count++ % 100 == 0) walk.Body.Seat(seat);
            walk.Body.SetActive(true);
            walk.Body.Step(1f / 30);
        }

        for (int i = 0; i < Steps; i++) Fall();
        Assert.Equal(0, Allocated(Fall));
    }

    private static void Step(DemoWalk walk) => walk.Body.Step(1f / 30);

    private static long Allocated(Action step)
    {
        for (int i = 0; i < Steps; i++) step();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < Steps; i++) step();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
