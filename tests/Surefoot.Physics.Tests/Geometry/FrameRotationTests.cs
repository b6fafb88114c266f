using System.Numerics;
using CsCheck;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>Frames whose orientation is refused, and frames taken out of one another.</summary>
public class FrameRotationTests
{
    [Theory, Behaviour("geometry.frame.refuses-no-rotation", "spec/03, 4.1; Frame::set_rotate @0x00535080, IsValid @0x00534ED0")]
    [InlineData(0f, 0f, 0f, 0f)]
    [InlineData(float.NaN, 0f, 0f, 1f)]
    [InlineData(0f, float.PositiveInfinity, 0f, 1f)]
    public void An_orientation_that_cannot_be_made_unit_is_refused_and_the_old_one_stays(float x, float y, float z, float w)
    {
        Frame frame = new(new Vector3(1, 2, 3), new Quaternion(0, 0, 0.6f, 0.8f));
        Frame before = frame;
        Assert.False(frame.SetRotation(new Quaternion(x, y, z, w)));
        Assert.Equal(before, frame);
        Assert.Equal(before.LocalToGlobal(new Vector3(1, 0, 0)), frame.LocalToGlobal(new Vector3(1, 0, 0)));
    }

    /// <summary>Turned left by 90 degrees, two metres ahead is two metres west.</summary>
    [Fact, Behaviour("geometry.frame.subtract", "Frame::subtract1: the inverse of combine")]
    public void A_movement_that_is_taken_out_leads_back_to_where_it_began()
    {
        Frame left = new(Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2));
        Frame movement = new(new Vector3(0, 2, 0), left.Rotation);
        Frame begin = new(new Vector3(10, 20, 5), left.Rotation);
        Frame end = Frame.Combine(begin, movement);
        AssertNear(new Vector3(8, 20, 5), end.Origin);
        Frame back = Frame.Subtract(end, movement);
        AssertNear(begin.Origin, back.Origin);
        Assert.Equal(1, Math.Abs(Quaternion.Dot(begin.Rotation, back.Rotation)), 1e-6);
    }

    [Fact, Behaviour("geometry.frame.subtract-undoes-combine", "Frame::subtract1: the inverse of combine")]
    public void Taking_out_what_was_put_on_gives_the_frame_back() =>
        Gen.Select(Frames, Frames).Sample(
            (outer, inner) =>
            {
                Frame back = Frame.Subtract(Frame.Combine(outer, inner), inner);
                AssertNear(outer.Origin, back.Origin);
                Assert.Equal(1, Math.Abs(Quaternion.Dot(outer.Rotation, back.Rotation)), 1e-5);
            },
            iter: Fuzz.Cases(200));

    /// <summary>Half, a quarter and all of a turn are as far along the shorter arc, whichever sign the end is written with.</summary>
    [Fact, Behaviour("geometry.frame.between", "spec/03, 4.1.4, Frame::interpolate_rotation @0x00535390")]
    public void A_share_of_a_turn_is_the_same_share_of_its_angle_by_the_shorter_way() =>
        Gen.Select(Frames, Gen.Float[-1, 1], Gen.Float[-1, 1], Gen.Float[0.05f, 3f], Gen.Float[0, 1], Gen.Bool).Sample(
            (from, ax, ay, angle, share, negated) =>
            {
                Vector3 axis = Vector3.Normalize(new Vector3(ax, ay, 0.5f));
                Quaternion end = Quaternion.CreateFromAxisAngle(axis, angle) * from.Rotation;
                Quaternion expected = Quaternion.CreateFromAxisAngle(axis, angle * share) * from.Rotation;
                Frame between = Frame.Identity;
                between.InterpolateRotation(from, new Frame(Vector3.One, negated ? -end : end), share);
                Assert.Equal(1, Math.Abs(Quaternion.Dot(expected, between.Rotation)), 2e-6);
                Assert.Equal(Vector3.Zero, between.Origin);
            },
            iter: Fuzz.Cases(300));

    /// <summary>
    /// Half a degree apart the cosine is above 1 − EPS and the quaternions are mixed as they are: of the sine and cosine of a quarter of
    /// that, made a unit, which is the half-way turn again; at a fifth of the way the mix lags behind the arc by less than a float shows.
    /// </summary>
    [Theory, Behaviour("geometry.frame.between.near", "spec/03, 4.1.4, interpolate_rotation: 1 - c at most EPS")]
    [InlineData(0.5f, 0.25f)]
    [InlineData(0f, 0f)]
    [InlineData(1f, 0.5f)]
    public void Turns_that_are_nearly_the_same_are_mixed_without_sines(float share, float degrees)
    {
        Frame from = new(Vector3.Zero, Quaternion.Identity), to = new(Vector3.Zero, About(0.5f)), between = from;
        between.InterpolateRotation(from, to, share);
        Assert.Equal(About(degrees).Z, between.Rotation.Z, 1e-6f);
        Assert.Equal(1 - (2 * (double)between.Rotation.Z * between.Rotation.Z), between.XAxis.X, 1e-6);
    }

    /// <summary>Beyond the end a weight is less than 0, and so 1.5 of 90° is a straight mix: −½ of one, 1½ of the other.</summary>
    [Fact, Behaviour("geometry.frame.between.outside", "spec/03, 4.1.4, interpolate_rotation: a or b outside [0,1]")]
    public void Beyond_its_end_a_turn_is_mixed_straight()
    {
        Frame from = new(Vector3.Zero, Quaternion.Identity), between = from;
        between.InterpolateRotation(from, new Frame(Vector3.Zero, About(90)), 1.5f);
        double z = 1.5 * Math.Sqrt(0.5), w = (1.5 * Math.Sqrt(0.5)) - 0.5, length = Math.Sqrt((z * z) + (w * w));
        Assert.Equal(z / length, between.Rotation.Z, 1e-6);
        Assert.Equal(w / length, between.Rotation.W, 1e-6);
    }

    [Fact, Behaviour("geometry.frame.nearly-equal", "spec/03, 4.1.4, Frame::is_equal @0x00424C30: origins at most EPS, quaternions less")]
    public void Frames_are_equal_within_the_tolerance_on_every_axis()
    {
        Quaternion q = new(0.5f, 0.5f, 0.5f, 0.5f);
        for (int part = 0; part < 3; part++)
        {
            Assert.True(Equal(Moved(part, RetailMath.Epsilon), Vector3.Zero));
            Assert.False(Equal(Moved(part, 1.01f * RetailMath.Epsilon), Vector3.Zero));
            Assert.False(Equal(Moved(part, 1), Moved(part, -1)));
        }

        for (int part = 0; part < 4; part++)
        {
            Assert.True(Frame.NearlyEqual(new(Vector3.One, q), new(Vector3.One, Turned(part, 0.9f))));
            Assert.False(Frame.NearlyEqual(new(Vector3.One, q), new(Vector3.One, Turned(part, 1.1f))));
        }

        bool Equal(Vector3 a, Vector3 b) => Frame.NearlyEqual(new(a, q), new(b, q));

        Vector3 Moved(int part, float by)
        {
            Vector3 moved = default;
            moved[part] = by;
            return moved;
        }

        Quaternion Turned(int part, float tolerances)
        {
            Quaternion other = q;
            other[part] -= tolerances * RetailMath.Epsilon;
            return other;
        }
    }

    [Fact, Behaviour("geometry.frame.nearly-equal.sign", "spec/03, 4.1.4, Frame::is_equal: q and -q count as different")]
    public void The_two_quaternions_of_one_orientation_are_not_equal()
    {
        foreach (Quaternion q in (Quaternion[])[new(1, 0, 0, 0), new(0, 1, 0, 0), new(0, 0, 1, 0), new(0, 0, 0, 1)])
            Assert.False(Frame.NearlyEqual(new(Vector3.Zero, q), new(Vector3.Zero, -q)));
    }

    [Fact, Behaviour("geometry.frame.small-turn", "spec/02, 4.6, Frame::grotate: a turn shorter than EPS is none")]
    public void A_turn_shorter_than_the_tolerance_turns_nothing()
    {
        Frame frame = new(Vector3.Zero, new Quaternion(0, 0, 0.6f, 0.8f)), before = frame;
        frame.RotateGlobal(new Vector3(0, 0, 0.9f * RetailMath.Epsilon));
        frame.RotateLocal(new Vector3(0.9f * RetailMath.Epsilon, 0, 0));
        Assert.Equal(before, frame);
        frame.RotateGlobal(new Vector3(0, 0, 1.1f * RetailMath.Epsilon));
        Assert.NotEqual(before, frame);
    }

    private static Quaternion About(float degrees)
    {
        double half = degrees * Math.PI / 360;
        return new(0, 0, (float)Math.Sin(half), (float)Math.Cos(half));
    }

    private static Gen<Frame> Frames =>
        Gen.Select(Gen.Float[-50, 50], Gen.Float[-50, 50], Gen.Float[-50, 50], Gen.Float[-3, 3], Gen.Float[-1, 1], Gen.Float[-1, 1]).Select(
            (x, y, z, angle, ax, ay) => new Frame(
                new Vector3(x, y, z), Quaternion.CreateFromAxisAngle(Vector3.Normalize(new Vector3(ax, ay, 1)), angle)));

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True((expected - actual).Length() < 2e-4f, $"{expected} expected, {actual} found");
}
