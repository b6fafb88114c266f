using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>
/// Balls and cylinders have no favourite direction and no favourite place: what a mover meets of one, it meets turned of one that is
/// turned, and elsewhere of one that stands elsewhere. And what is pulled back touches, by as much of its way as it lost.
/// </summary>
public sealed class RoundObstacleTests
{
    private const float Radius = 0.48f;
    private static readonly Vector3 Away = new(7, 11, 3);

    /// <summary>How a mover asks: what it is, and what is looked for.</summary>
    public static TheoryData<string> Ways => ["walks", "climbs", "lands", "probes", "is clipped", "falls"];

    [Theory, Behaviour("obstacle.round.no-favourite-direction", "spec/04, 4.8 and 4.9: all rows")]
    [MemberData(nameof(Ways))]
    public void What_a_round_thing_answers_turns_with_the_scene_and_moves_with_it(string way)
    {
        Random random = new(1);
        int answers = 0;
        for (int i = 0; i < 400; i++)
        {
            bool ball = random.Next(2) == 0;
            Vector3 check = Point(random, 0.8f), curr = check - (Point(random, 0.5f) with { Z = -0.1f - (0.4f * random.NextSingle()) });
            (TransitionState answer, Mover mover) = Ask(way, ball, curr, check, v => v);
            if (answer != TransitionState.OK) answers++;
            (TransitionState turned, Mover other) = Ask(way, ball, curr, check, Turn);
            (TransitionState moved, Mover far) = Ask(way, ball, curr, check, v => v + Away);
            Assert.Equal((answer, answer), (turned, moved));
            Same(Turn(mover.Moved), other.Moved);
            Same(mover.Moved, far.Moved);
            Assert.Equal(mover.Path.WalkInterp, other.Path.WalkInterp, 1e-4f);
            Assert.Equal(mover.Path.WalkInterp, far.Path.WalkInterp, 1e-4f);
            Assert.Equal(mover.Collision.CollisionNormalValid, far.Collision.CollisionNormalValid);
            Same(Turn(mover.Collision.CollisionNormal), other.Collision.CollisionNormal);
            Same(mover.Collision.CollisionNormal, far.Collision.CollisionNormal);
            Assert.Equal(mover.Collision.ContactPlaneValid, far.Collision.ContactPlaneValid);
            Same(Turn(mover.Collision.ContactPlane.Normal), other.Collision.ContactPlane.Normal);
            Same(mover.Collision.ContactPlane.Normal, far.Collision.ContactPlane.Normal);
        }

        Assert.True(answers > 20, $"{answers} of 400 met something");
    }

    [Fact, Behaviour("obstacle.round.rests-touching", "spec/04, 4.8 and 4.9, rows 5 and 6: pulled back onto the ball, lifted onto it")]
    public void Who_lands_on_a_ball_or_is_lifted_onto_it_touches_it_and_keeps_the_rest_of_its_way()
    {
        Random random = new(2);
        int landed = 0, lifted = 0;
        for (int i = 0; i < 2000; i++)
        {
            Vector3 check = Point(random, 0.5f) + new Vector3(0, 0, 1), curr = check + Point(random, 0.3f) + new Vector3(0, 0, 0.4f);
            (TransitionState answer, Mover mover) = Ask("lands", true, curr, check, v => v);
            if (answer == TransitionState.Adjusted)
            {
                landed++;
                Assert.Equal(0.5f + Radius, (mover.At - Ball(v => v).Center).Length(), 1e-4f);
                float share = mover.Moved.Length() / (check - curr).Length();
                Assert.Equal(0.5f * (1 - share), mover.Path.WalkInterp, 1e-4f);
                Same(Vector3.Normalize(mover.At - Ball(v => v).Center), mover.Collision.ContactPlane.Normal);
            }

            (answer, mover) = Ask("probes", true, check, check, v => v);
            if (answer != TransitionState.Adjusted) continue;
            lifted++;
            Assert.Equal((0f, 0f), (mover.Moved.X, mover.Moved.Y));
            Assert.Equal(0.5f + Radius, (mover.At - Ball(v => v).Center).Length(), 1e-4f);
            // The step down is 0.6 m, half of it is left to go.
            Assert.Equal(0.5f * (1 - (mover.Moved.Z / 0.3f)), mover.Path.WalkInterp, 1e-4f);
        }

        Assert.True(landed > 50 && lifted > 50, $"{landed} landed, {lifted} lifted");
    }

    /// <summary>The top is at 1.05 m, so that a foot rests with its centre at 1.53 m.</summary>
    [Fact, Behaviour("obstacle.cylinder.rests-on-top", "spec/04, 4.9, rows 2 and 4: pulled back onto the top, lifted onto it")]
    public void Who_lands_on_a_cylinder_or_is_lifted_onto_it_stands_on_its_top_and_keeps_the_rest_of_its_way()
    {
        Random random = new(3);
        int landed = 0, lifted = 0;
        for (int i = 0; i < 2000; i++)
        {
            Vector3 check = Point(random, 0.5f) + new Vector3(0, 0, 1.2f), curr = check + Point(random, 0.3f) + new Vector3(0, 0, 0.4f);
            (TransitionState answer, Mover mover) = Ask("lands", false, curr, check, v => v);
            if (answer == TransitionState.Adjusted)
            {
                landed++;
                Assert.Equal(1.53f, mover.At.Z, 1e-4f);
                float share = mover.Moved.Length() / (check - curr).Length();
                Same(check + ((curr - check) * share), mover.At);
                Assert.Equal(0.5f * (1 - share), mover.Path.WalkInterp, 1e-4f);
            }

            (answer, mover) = Ask("probes", false, check, check, v => v);
            if (answer != TransitionState.Adjusted) continue;
            lifted++;
            Same(check with { Z = 1.53f }, mover.At);
            Assert.Equal(0.5f * (1 - (mover.Moved.Z / 0.3f)), mover.Path.WalkInterp, 1e-4f);
        }

        Assert.True(landed > 50 && lifted > 50, $"{landed} landed, {lifted} lifted");
    }

    private static (TransitionState Answer, Mover Mover) Ask(
        string way, bool ball, Vector3 curr, Vector3 check, Func<Vector3, Vector3> place)
    {
        MoverFlags flags = way switch
        {
            "is clipped" => MoverFlags.PathClipped | MoverFlags.PerfectClip,
            "lands" or "falls" => MoverFlags.None,
            _ => MoverFlags.Contact | MoverFlags.OnWalkable,
        };
        Mover mover = new Mover(flags, place(curr), place(check), Radius, stepUpHeight: way == "climbs" ? 2f : 0.05f).With(p =>
        {
            p.WalkInterp = 0.5f;
            if (way == "lands") (p.Collide, p.WalkableAllowance) = (true, RetailMath.LandingZ);
            if (way == "probes") (p.SteppingDown, p.StepDownAmount) = (true, 0.6f);
        });
        if (way is "walks" or "climbs") mover.Standing(Vector3.UnitZ);
        return (ball ? mover.Ask(Ball(place)) : mover.Ask(new CylSphere(place(new Vector3(0.1f, 0.2f, 0.05f)), 0.5f, 1)), mover);
    }

    private static Sphere Ball(Func<Vector3, Vector3> place) => new(place(new Vector3(0.1f, 0.2f, 0.05f)), 0.5f);

    private static Vector3 Turn(Vector3 v) => new(-v.Y, v.X, v.Z);

    private static Vector3 Point(Random random, float reach) =>
        new Vector3(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f) * (2 * reach);

    private static void Same(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) < 2e-4f, $"{actual}, expected {expected}");
}
