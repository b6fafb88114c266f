using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using static Surefoot.Physics.Tests.Bodies.ShootingRange;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Missiles at the greatest speed there is against walls of every thickness, size and turn.</summary>
public class MissileProperties
{
    private static readonly Vector3 Middle = new(96, 84, 60);

    private static readonly float[] Quanta = [1f / 30, 0.05f, 0.1f, 0.2f];

    private static readonly Gen<Shot> Shots =
        from half in Gen.Select(Gen.Float[0.5f, 4], Gen.Float[0.5f, 4], (x, z) => new Vector2(x, z))
        from thickness in Gen.OneOf(Gen.Float[0.001f, 0.05f], Gen.Float[0.05f, 2])
        from axis in Directions
        from angle in Gen.Float[0, MathF.PI]
        from direction in Directions
        from aim in Gen.Select(Gen.Float[-0.8f, 0.8f], Gen.Float[-0.8f, 0.8f], Gen.Float[-1, 1], (x, y, z) => new Vector3(x, y, z))
        from distance in Gen.Float[6, 16]
        from quantum in Gen.Int[0, 3].Select(i => Quanta[i])
        from falls in Gen.Bool
        select new Shot(new Vector3(half.X, thickness / 2, half.Y), axis, angle, direction, aim, distance, quantum, falls);

    private static Gen<Vector3> Directions =>
        from z in Gen.Double[-1, 1]
        from turn in Gen.Double[0, Math.Tau]
        select new Vector3(
            (float)(Math.Sqrt(1 - (z * z)) * Math.Cos(turn)), (float)(Math.Sqrt(1 - (z * z)) * Math.Sin(turn)), (float)z);

    [Fact]
    [Behaviour("missile.walls.never-passed", "spec/02, 3: 50 m/s is the greatest speed; spec/03, 4.6: sub-steps of at most a radius")]
    public void At_fifty_metres_a_second_no_missile_passes_a_wall_of_any_thickness()
    {
        Shots.Sample(
            shot =>
            {
                ShootingRange range = new();
                Frame wall = new(Middle, Quaternion.CreateFromAxisAngle(shot.Axis, shot.Angle));
                range.Build(Middle, shot.Half, wall.Rotation);
                Vector3 target = wall.LocalToGlobal(shot.Aim * shot.Half);
                Vector3 start = target - (shot.Direction * shot.Distance);
                // A shot at the far side of a wall that is longer than its way would begin in the wall.
                if (DistanceTo(wall, shot.Half, start) < 2 * Radius) return;
                range.Shoot(start, shot.Direction * PhysicsBody.MaxVelocity, shot.Falls ? Arrow : Bolt);
                for (double time = 0; time < 0.6; time += shot.Quantum)
                {
                    Vector3 before = range.At;
                    range.Fly(1, shot.Quantum);
                    Assert.False(Enters(wall, shot.Half, before, range.At), $"from {before} to {range.At} it passes the wall");
                }

                if (shot.Falls) return;
                Hit hit = Assert.Single(range.Hits);
                Assert.Equal((MissileId, 0u), (hit.Told, hit.Of));
                Assert.InRange(DistanceTo(wall, shot.Half, hit.Impact.Place.Frame.Origin), Radius - 0.001, (2 * Radius) + 0.001);
                // One of the six faces, and one that it flew against.
                Vector3 local = wall.GlobalToLocalVector(hit.Impact.Normal);
                Assert.Equal(1, Math.Max(Math.Abs(local.X), Math.Max(Math.Abs(local.Y), Math.Abs(local.Z))), 1e-4f);
                Assert.True(Vector3.Dot(hit.Impact.Normal, shot.Direction) < 0);
            },
            iter: 2000);
    }

    /// <summary>Whether a piece of way goes through a box that is a hair smaller than the wall.</summary>
    private static bool Enters(in Frame wall, in Vector3 half, Vector3 from, Vector3 to)
    {
        Vector3 a = wall.GlobalToLocal(from), way = wall.GlobalToLocal(to) - a;
        double enter = 0, leave = 1;
        for (int axis = 0; axis < 3; axis++)
        {
            double reach = half[axis] * 0.9, start = a[axis], step = way[axis];
            if (Math.Abs(step) < 1e-9)
            {
                if (Math.Abs(start) > reach) return false;
                continue;
            }

            double first = (-reach - start) / step, second = (reach - start) / step;
            enter = Math.Max(enter, Math.Min(first, second));
            leave = Math.Min(leave, Math.Max(first, second));
        }

        return enter < leave;
    }

    private static double DistanceTo(in Frame wall, in Vector3 half, Vector3 point)
    {
        Vector3 local = Vector3.Abs(wall.GlobalToLocal(point));
        return Vector3.Max(local - half, Vector3.Zero).Length();
    }

    /// <summary>A wall and a shot at it.</summary>
    /// <param name="Half">Half of the wall's extent along its own axes, metres.</param>
    /// <param name="Axis">What it is turned about.</param>
    /// <param name="Angle">By how much, radians.</param>
    /// <param name="Direction">Of the flight.</param>
    /// <param name="Aim">The point aimed at, -1 to 1 of the half extents.</param>
    /// <param name="Distance">From there, metres.</param>
    /// <param name="Quantum">Seconds.</param>
    /// <param name="Falls">It has weight.</param>
    private sealed record Shot(
        Vector3 Half, Vector3 Axis, float Angle, Vector3 Direction, Vector3 Aim, float Distance, float Quantum, bool Falls);
}
