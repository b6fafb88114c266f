using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

/// <summary>Creatures in the way.</summary>
public sealed class CrowdTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private static readonly CharacterStats Runner = new(300, 300);

    [Fact]
    [Behaviour("obstacles.guard-blocks-and-is-slid-around", "spec/06, 4; spec/04, spheres")]
    public void A_guard_blocks_and_one_slides_around_him()
    {
        // The western guard stands 3 m west and 8 m north of the place.
        DemoWalk walk = new(files, "guards", Runner, eastward: -3.2f);
        List<PhysicsBody> guards = walk.Spawn(DemoSpawnKind.Guard);
        float closest = float.MaxValue;
        walk.Hold(MovementKeys.Forward, 90, () => closest = Math.Min(closest, Between(walk.Body, guards)));
        Assert.InRange(closest, 0.959f, 1.0f);
        Assert.True(walk.Moved.Y > 8, $"did not get around the guard: {walk.Moved}");
        Assert.True(walk.Body.OnWalkable);
    }

    [Fact]
    [Behaviour("obstacles.crowd-is-run-into-and-jumped-out-of", "spec/06, 4; spec/02, 4.14")]
    public void A_crowd_stops_a_runner_who_jumps_out_of_it_again()
    {
        DemoWalk walk = new(files, "crowd", Runner);
        List<PhysicsBody> crowd = walk.Spawn(DemoSpawnKind.Crowd);
        Assert.Equal(100, crowd.Count);
        walk.Hold(MovementKeys.Forward, 90, () => Assert.True(Between(walk.Body, crowd) > 0.959f, $"inside somebody at {walk.Moved}"));
        // 1.6 m from middle to middle leaves 0.64 m, and a body is 0.96 m wide.
        Assert.InRange(walk.Moved.Y, 5, 8);

        // Jumps into the middle of it, on and between heads, and out again.
        for (int jump = 0; jump < 4; jump++)
        {
            walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 25, Outside);
            walk.Hold(MovementKeys.Forward, 40, Outside);
        }

        walk.Face(180);
        for (int jump = 0; jump < 12 && walk.Moved.Y > 4; jump++)
        {
            walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 25, Outside);
            walk.Hold(MovementKeys.Forward, 40, Outside);
        }

        walk.Hold(MovementKeys.None, 60);
        Assert.True(walk.Moved.Y <= 4, $"the crowd holds the body at {walk.Moved}");
        Assert.True(walk.Body.OnWalkable);

        void Outside() => Assert.True(Between(walk.Body, crowd) > 0.95f, $"inside somebody at {walk.Moved}");
    }

    /// <summary>Distance from the body's spheres to the nearest one's, middle to middle.</summary>
    private static float Between(PhysicsBody body, List<PhysicsBody> others)
    {
        float least = float.MaxValue;
        foreach (PhysicsBody other in others)
        {
            Vector3 way = other.Position.OffsetTo(body.Position);
            foreach (float mine in (ReadOnlySpan<float>)[0.475f, 1.35f])
            {
                foreach (float his in (ReadOnlySpan<float>)[0.475f, 1.35f])
                    least = Math.Min(least, (way + new Vector3(0, 0, mine - his)).Length());
            }
        }

        return least;
    }
}
