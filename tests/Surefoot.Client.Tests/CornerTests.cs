using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

/// <summary>Corners between walls, the end of a wall, a wall against a slope.</summary>
public sealed class CornerTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const float Radius = 0.48f;
    private static readonly CharacterStats Runner = new(300, 200);

    // The walls of the place "corners", whose origin is 3 m north of where the place puts the player.
    private static readonly (Vector2 Low, Vector2 High)[] Walls =
    [
        (new(-5, 6), new(5, 6.5f)),
        (new(4.5f, 0), new(5, 6.5f)),
        (new(-5.5f, 6), new(-5, 10)),
    ];

    [Fact]
    [Behaviour("obstacles.concave-corner-at-every-angle", "spec/03, 4.8 slide_sphere: crease")]
    public void Running_into_a_concave_corner_at_any_angle_ends_still_in_the_corner()
    {
        for (int heading = 5; heading <= 85; heading += 5)
        {
            DemoWalk walk = new(files, "corners", Runner, eastward: 2.5f, northward: 4, heading: heading);
            walk.Hold(MovementKeys.Forward, 90, () => AssertOutsideWalls(walk, heading));
            // A sub-step that would go into a wall is not shortened but bent, so that up to one sub-step is left to either wall.
            Vector3 rest = walk.FromPlace;
            float stride = (float)(11 * 1.0 / 30) + 0.1f;
            Assert.True(
                4.5f - Radius - rest.X < stride && 6 - Radius - rest.Y < stride,
                $"at {heading} degrees the run ended at {rest}");
            walk.Hold(MovementKeys.Forward, 30);
            Assert.True(Vector3.Distance(rest, walk.FromPlace) < 0.002f, $"at {heading} degrees the corner trembles");
            Assert.True(walk.Body.OnWalkable);
            walk.Hold(MovementKeys.Back, 15);
            Assert.True(Vector3.Distance(rest, walk.FromPlace) > 0.5f, $"at {heading} degrees the corner holds");
        }
    }

    [Fact]
    [Behaviour("obstacles.convex-corner-at-every-angle", "spec/03, 4.8 slide_sphere; spec/04, 4.3 edges")]
    public void A_convex_corner_is_rounded_at_every_angle_without_touching_the_inside_of_the_wall()
    {
        // The corner in the south-west, where two walls end: aimed at it and a little past it on either side.
        Vector2 corner = new(-5, 6);
        for (int heading = 0; heading < 360; heading += 10)
        {
            foreach (float aside in (ReadOnlySpan<float>)[-0.4f, -0.1f, 0, 0.1f, 0.4f])
            {
                (double sin, double cos) = Math.SinCos(heading * Math.PI / 180);
                Vector2 from = corner - (2.5f * new Vector2((float)sin, (float)cos)) + (aside * new Vector2((float)cos, (float)-sin));
                if (Clearance(from) < Radius + 0.05f) continue;
                DemoWalk walk = new(files, "corners", Runner, eastward: from.X, northward: from.Y, heading: heading);
                walk.Hold(MovementKeys.Forward, 45, () => AssertOutsideWalls(walk, heading));
                Assert.True(walk.Body.OnWalkable);
            }
        }
    }

    [Fact]
    [Behaviour("obstacles.wall-slides-by-the-tangent", "spec/03, 4.8 slide_sphere")]
    public void A_wall_met_at_an_angle_is_slid_along_with_the_tangential_part_of_the_speed()
    {
        DemoWalk walk = new(files, "corners", Runner, eastward: -3, northward: 5, heading: 30);
        DemoWalk free = new(files, "runway", Runner, heading: 30);
        walk.Hold(MovementKeys.Forward, 10);
        free.Hold(MovementKeys.Forward, 10);
        Vector3 before = walk.FromPlace, freeBefore = free.Moved;
        walk.Hold(MovementKeys.Forward, 10);
        free.Hold(MovementKeys.Forward, 10);
        Vector3 slid = walk.FromPlace - before;
        Assert.Equal(0, slid.Y, 1e-3);
        Assert.Equal((free.Moved - freeBefore).X, slid.X, 1e-3);
    }

    [Fact]
    [Behaviour("obstacles.wedge-between-wall-and-steep-slope", "spec/03, 4.6 and 4.8")]
    public void Between_a_wall_and_a_steep_slope_nothing_wedges_for_good()
    {
        // The slope of 60 degrees begins 4 m north of the place and ends at the wall, whose face is 0.7 m to the east.
        for (int heading = 0; heading <= 60; heading += 5)
        {
            DemoWalk walk = new(files, "wall-and-slope", Runner, heading: heading == 0 ? 0.5f : heading);
            walk.Hold(MovementKeys.Forward, 20);
            walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 20);
            walk.Hold(MovementKeys.Forward, 90);
            walk.Hold(MovementKeys.None, 120);
            Assert.True(walk.Body.OnWalkable, $"at {heading} degrees the body hangs at {walk.Moved}, {walk.Body.Transient}");
            Vector3 rest = walk.Moved;
            // The wall's top, if the jump got there, holds walkers at its edge.
            walk.Face(180);
            walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 10);
            walk.Hold(MovementKeys.Forward, 40);
            Assert.True(rest.Y - walk.Moved.Y > 1, $"at {heading} degrees the corner holds the body at {walk.Moved}");
        }
    }

    private static void AssertOutsideWalls(DemoWalk walk, int heading)
    {
        Vector3 at = walk.FromPlace;
        float clearance = Clearance(new Vector2(at.X, at.Y));
        // Retail stops a sphere within 0.0002 m of a surface, measured along the surface's normal.
        Assert.True(clearance > Radius - 0.001f, $"at {heading} degrees {at} is {clearance} m from a wall");
    }

    private static float Clearance(Vector2 at) =>
        Walls.Min(wall => Vector2.Distance(at, Vector2.Clamp(at, wall.Low, wall.High)));
}
