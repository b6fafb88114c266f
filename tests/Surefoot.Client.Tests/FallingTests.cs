using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>Falling off things, between things and onto slopes.</summary>
public sealed class FallingTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private static readonly CharacterStats Runner = new(300, 200);

    [Fact]
    [Behaviour("obstacles.gap-edges-hold-walkers-and-jumps-cross", "spec/03, 4.7 edge_slide")]
    public void A_walker_is_held_at_the_edge_of_a_gap_and_a_jump_crosses_it()
    {
        for (int frames = 2; frames <= 30; frames += 4)
        {
            DemoWalk walk = new(files, "close-blocks", new CharacterStats(0, 0));
            walk.Hold(MovementKeys.Forward | MovementKeys.Walk, 90);
            // The edge is 1.5 m east; a body is held where its middle leaves what it stands on by half its radius.
            Assert.InRange(walk.Moved.X, 1.5f - 0.24f, 1.5f + 0.24f);
            walk.Hold(MovementKeys.Forward | MovementKeys.Jump, frames);
            walk.Hold(MovementKeys.Forward, 30);
            Assert.True(walk.Body.OnWalkable);
            Assert.Equal(0, walk.Moved.Z, 0.01);
            Assert.True(walk.Moved.X > 2.4f, $"a jump after {frames} frames ended at {walk.Moved}");
        }
    }

    [Fact]
    [Behaviour("obstacles.close-objects-do-not-hold-a-faller", "spec/02, 4.14 stationary fall; spec/03, 4.6")]
    public void Between_close_blocks_a_body_rests_or_falls_through_and_never_hangs_in_the_air()
    {
        // Blocks of 3 m: from 1.5 to 2.4 m east of the place a gap of 0.9, from 5.4 to 6.44 one of 1.04; the body is 0.96 wide.
        foreach ((float middle, bool passable) in (ReadOnlySpan<(float, bool)>)[(1.95f, false), (5.92f, true)])
        {
            for (float aside = -0.6f; aside <= 0.61f; aside += 0.05f)
            {
                DemoWalk walk = new(files, "close-blocks", Runner, eastward: middle + aside, upward: 1);
                walk.Hold(MovementKeys.None, 300);
                Vector3 at = walk.FromPlace;
                Assert.True(walk.Body.OnWalkable,
                    $"let go {aside} m beside the middle of the gap at {middle} m it hangs at {at}: {walk.Body.Transient}");
                bool onTheGround = Math.Abs(at.Z + 3) < 0.01f;
                // Across the narrow gap the sphere sinks until both edges hold it: by 0.48 - sqrt(0.48² - 0.45²) = 0.313 m.
                Assert.True(onTheGround || Math.Abs(at.Z) < 0.32f, $"rests at {at}");
                if (!passable) Assert.False(onTheGround, $"fell through the narrow gap {aside} m beside its middle");
                if (passable && Math.Abs(aside) < 0.03f) Assert.True(onTheGround, $"stays on the wide gap at {at}");
            }
        }
    }

    [Theory]
    [Behaviour("obstacles.steep-slope-is-glided-down", "spec/03, 3 walkable limit; spec/02, 4.14")]
    [InlineData("wedge-49", 49)]
    [InlineData("wedge-50", 50)]
    [InlineData("wedge-60", 60)]
    public void Landing_on_a_slope_beyond_the_limit_glides_down_to_the_ground(string place, double degrees)
    {
        // The slope begins 5 m north of the place; let go a metre above it, 2 m further.
        float above = (float)(2 * Math.Tan(degrees * Math.PI / 180)) + 2;
        DemoWalk walk = new(files, place, Runner, northward: 7, upward: above);
        float last = walk.Z;
        bool touched = false;
        for (int frame = 0; frame < 300 && !walk.Body.OnWalkable; frame++)
        {
            walk.Hold(MovementKeys.None, 1);
            touched |= walk.Body.HasContact && !walk.Body.OnWalkable;
            Assert.True(walk.Z <= last + 0.02f, $"rose from {last} to {walk.Z} while gliding");
            last = walk.Z;
        }

        Assert.True(touched, "never touched the slope");
        Assert.True(walk.Body.OnWalkable, $"hangs at {walk.Moved}");
        Assert.Equal(-above, walk.Moved.Z, 0.05);
        Assert.True(walk.Moved.Y < -1, $"came down at {walk.Moved}");
    }

    [Fact]
    [Behaviour("obstacles.roof-edge-holds-a-walker", "spec/03, 4.7 edge_slide")]
    public void The_edge_of_a_roof_holds_whoever_walks()
    {
        DemoWalk walk = new(files, "house-roof", Runner);
        walk.Hold(MovementKeys.Forward, 60);
        Assert.Equal(walk.RestHeight, walk.Z, 0.01);
        Assert.True(walk.Body.OnWalkable);
        // The edge is 1.3 m south of the place.
        Assert.InRange(walk.Moved.Y, -1.8f, -1.2f);
    }

    [Fact]
    [Behaviour("obstacles.roof-is-walked-off-without-edge-slide", "spec/03, 4.7; spec/02, 2.2 EDGE_SLIDE")]
    public void Without_the_edge_slide_bit_a_roof_is_walked_off_and_the_ground_reached()
    {
        DemoWalk walk = new(files, "house-roof", Runner);
        walk.Body.SetState(walk.Body.State & ~PhysicsState.EdgeSlide);
        AssertFallsToTheGround(walk, MovementKeys.Forward);
    }

    [Fact]
    [Behaviour("obstacles.roof-is-jumped-off", "spec/01, 4; spec/02, 4.7")]
    public void A_jump_from_a_roof_falls_to_the_ground()
    {
        DemoWalk walk = new(files, "house-roof", Runner);
        walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 8);
        AssertFallsToTheGround(walk, MovementKeys.Forward);
    }

    private static void AssertFallsToTheGround(DemoWalk walk, MovementKeys keys)
    {
        bool airborne = false;
        walk.Hold(keys, 40, () => airborne |= !walk.Body.HasContact);
        walk.Hold(MovementKeys.None, 120);
        Assert.True(airborne);
        Assert.True(walk.Body.OnWalkable, $"hangs at {walk.Moved}");
        // The roof is 6.5 m above the floor, which is 0.1 m above the ground.
        Assert.Equal(-6.6, walk.Moved.Z, 0.05);
    }
}
