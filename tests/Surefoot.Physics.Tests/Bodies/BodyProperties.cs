using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>What holds for every body on every slope.</summary>
public class BodyProperties
{
    private const float StepHeight = 0.6f;

    private static readonly Gen<(float Degrees, float Direction, Vector3 Start, Vector3 Velocity, float[] Quanta)> Falls =
        Gen.Select(
            Gen.Float[0, 80], Gen.Float[0, 6.28f], Gen.Float[0, 20],
            Gen.Select(Gen.Float[-25, 25], Gen.Float[-25, 25], Gen.Float[-20, 20], (x, y, z) => new Vector3(x, y, z)),
            Gen.Float[0.0333f, 0.2f].Array[1, 60],
            (degrees, direction, height, velocity, quanta) => (degrees, direction, new Vector3(0, 0, height), velocity, quanta));

    private static Plane SlopeOf(float degrees, float direction)
    {
        double tilt = degrees * Math.PI / 180;
        return new Plane(
            (float)(Math.Sin(tilt) * Math.Cos(direction)), (float)(Math.Sin(tilt) * Math.Sin(direction)), (float)Math.Cos(tilt), 0);
    }

    private static (PhysicsEngine Engine, PhysicsBody Body) Drop(Plane slope, Vector3 start, Vector3 velocity)
    {
        StubWorld world = new(_ => slope);
        PhysicsEngine engine = new(world);
        PhysicsBody body = engine.CreateBody(
            1, StubWorld.Setup(new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)));
        body.Seat(new BodySeat(new Position(StubWorld.CellId, start), velocity, TransientState.None, default, 0, Vector3.Zero));
        body.SetActive(true);
        return (engine, body);
    }

    [Fact, Behaviour("property.body.never-below-the-ground", "design.md, spec/03, 4.4")]
    public void A_body_never_ends_a_quantum_below_the_ground_it_touches() =>
        Falls.Sample(
            f =>
            {
                Plane slope = SlopeOf(f.Degrees, f.Direction);
                (_, PhysicsBody body) = Drop(slope, f.Start, f.Velocity);
                foreach (float q in f.Quanta)
                {
                    body.AdvanceQuantum(q);
                    Vector3 at = body.Position.Frame.Origin;
                    Assert.True(RetailMath.IsFinite(at) && RetailMath.IsFinite(body.Velocity));
                    // The lowest point may sink by what the tolerance allows, measured straight down.
                    double below = -RetailMath.Distance(slope, at) / slope.Normal.Z;
                    // While it walks and meets ground beyond the limit retail answers OK without lifting (spec/03, 4.4, last rule).
                    if (body.HasContact) Assert.True(below < 0.01, $"{below} m below the ground");
                }
            },
            iter: Fuzz.Cases(1000));

    [Fact, Behaviour("property.body.moves-no-further-than-asked", "design.md, spec/03, 4.6")]
    public void One_quantum_moves_no_further_than_asked_plus_the_step_heights() =>
        Falls.Sample(
            f =>
            {
                (_, PhysicsBody body) = Drop(SlopeOf(f.Degrees, f.Direction), f.Start, f.Velocity);
                foreach (float q in f.Quanta)
                {
                    Vector3 before = body.Position.Frame.Origin;
                    double asked = (Math.Max(body.Velocity.Length(), 50) * q) + (0.5 * 9.8 * q * q);
                    body.AdvanceQuantum(q);
                    double moved = Vector3.Distance(before, body.Position.Frame.Origin);
                    // Downhill the sub-step keeps x and y and takes z from the plane: up to 1/N.z longer (spec/03, 4.6, adjust_offset).
                    double longer = 1 / Math.Cos(f.Degrees * Math.PI / 180);
                    Assert.True(moved <= (asked * longer) + (2 * StepHeight), $"moved {moved} m, asked {asked} m");
                }
            },
            iter: Fuzz.Cases(1000));

    [Fact, Behaviour("property.body.deterministic", "design.md, decision 5")]
    public void The_same_inputs_give_the_same_bits() =>
        Falls.Sample(
            f =>
            {
                ulong Run()
                {
                    (PhysicsEngine engine, PhysicsBody body) = Drop(SlopeOf(f.Degrees, f.Direction), f.Start, f.Velocity);
                    foreach (float q in f.Quanta) body.AdvanceQuantum(q);
                    return engine.HashState();
                }

                Assert.Equal(Run(), Run());
            },
            iter: Fuzz.Cases(300));

    [Fact, Behaviour("property.body.comes-to-rest", "spec/02, 4.7 and 4.14")]
    public void A_body_dropped_on_walkable_ground_comes_to_rest_on_it() =>
        Gen.Select(Gen.Float[0, 48], Gen.Float[0, 6.28f], Gen.Float[0, 20]).Sample(
            (degrees, direction, height) =>
            {
                (_, PhysicsBody body) = Drop(SlopeOf(degrees, direction), new Vector3(0, 0, height), Vector3.Zero);
                for (int i = 0; i < 600 && (body.IsActive || i < 2); i++) body.AdvanceQuantum(1f / 30);
                Assert.True(body.OnWalkable);
                Assert.Equal(Vector3.Zero, body.Velocity);
            },
            iter: Fuzz.Cases(300));
}
