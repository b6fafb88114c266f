using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

/// <summary>
/// The windmill's sails: they turn by a degree each thirtieth of a second, four of them, before a passage that lies 8 m to the north of its
/// place. By 0.3 m of sail and 0.48 m of body to each side a sail is in the way for about 14 degrees before and after it hangs down: some
/// 29 of each 90 frames.
/// </summary>
public sealed class WindmillTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const int QuarterTurn = 90;

    // The tower ends 11.6 m north of the place.
    private const float Behind = 13;

    [Theory]
    [InlineData(0, 3.12)]
    [InlineData(300, 10.6)]
    [Behaviour("obstacles.windmill-stops-and-lets-pass",
        "spec/02, 4.19: the parts of an animated static move, and what they stop moves with them; speeds 01, 6")]
    public void A_sail_stops_a_walker_until_it_has_passed_and_lets_others_through(int skill, double speed)
    {
        // The way leads 4 degrees east of north; a stride more is left for the first frames.
        int free = (int)(Behind / Math.Cos(4 * Math.PI / 180) / speed * 30) + 2, longest = free + 40;
        int held = 0, phases = 0;
        for (int wait = 0; wait < QuarterTurn; wait += 3, phases++)
        {
            DemoWalk walk = new(files, "windmill", new CharacterStats(skill, 200));
            walk.Hold(MovementKeys.None, wait);
            int frames = 0;
            for (; frames < longest && walk.Moved.Y < Behind; frames++)
            {
                walk.Hold(skill == 0 ? MovementKeys.Forward | MovementKeys.Walk : MovementKeys.Forward, 1);
                Assert.Equal(walk.RestHeight, walk.Z, 0.001f);
                Assert.True(walk.Body.OnWalkable);
            }

            Assert.True(walk.Moved.Y >= Behind, $"who waits {wait} frames is held at {walk.Moved}");
            if (frames > free) held++;
        }

        Assert.InRange((double)held / phases, 0.25, 0.5);
    }

    [Fact]
    [Behaviour("obstacles.windmill-moves-nobody", "spec/02, 4.19: only its parts move, no body is pushed")]
    public void Who_stands_in_the_way_of_the_sails_is_not_moved_and_walks_on_between_two()
    {
        DemoWalk walk = new(files, "windmill", new CharacterStats(0, 200), eastward: 0.7f, northward: 8.1f);
        walk.Hold(MovementKeys.None, 2 * QuarterTurn, () => Assert.Equal(walk.Start, walk.Position));
        for (int i = 0; i < QuarterTurn && walk.Moved.Y < 1; i++) walk.Hold(MovementKeys.Forward, 1);
        Assert.True(walk.Moved.Y >= 1, $"held in {walk.Moved}");
        Assert.True(walk.Body.OnWalkable);
    }
}
