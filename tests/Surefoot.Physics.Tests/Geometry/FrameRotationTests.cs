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

    private static Gen<Frame> Frames =>
        Gen.Select(Gen.Float[-50, 50], Gen.Float[-50, 50], Gen.Float[-50, 50], Gen.Float[-3, 3], Gen.Float[-1, 1], Gen.Float[-1, 1]).Select(
            (x, y, z, angle, ax, ay) => new Frame(
                new Vector3(x, y, z), Quaternion.CreateFromAxisAngle(Vector3.Normalize(new Vector3(ax, ay, 1)), angle)));

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True((expected - actual).Length() < 2e-4f, $"{expected} expected, {actual} found");
}
