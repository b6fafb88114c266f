using System.Numerics;
using CsCheck;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>Where a frame faces: specification 03, 4.1.4.</summary>
public class FrameTests
{
    /// <summary>
    /// Pitch about x, then yaw about z: +y faces the way, and +x stays level. For a climb of 53.13 degrees half the angle has sine
    /// 0.4472136 and cosine 0.8944272.
    /// </summary>
    [Theory, Behaviour("geometry.heading.vector", "spec/03, 4.1.4, Frame::set_vector_heading @0x00535DB0")]
    [InlineData(0f, 3f, 4f, 1f, 0f)]
    [InlineData(3f, 0f, 4f, 0f, -1f)]
    [InlineData(-3f, 0f, -4f, 0f, 1f)]
    [InlineData(0f, -5f, 0f, -1f, 0f)]
    public void A_frame_faces_along_a_vector_without_rolling(float x, float y, float z, float rightX, float rightY)
    {
        Frame frame = Frame.Identity;
        frame.SetVectorHeading(new Vector3(x, y, z));
        AssertNear(Vector3.Normalize(new Vector3(x, y, z)), frame.YAxis);
        AssertNear(new Vector3(rightX, rightY, 0), frame.XAxis);
    }

    [Fact, Behaviour("geometry.heading.vector.pitch-is-about-x", "spec/03, 4.1.4, Frame::set_vector_heading @0x00535DB0")]
    public void A_climb_to_the_north_is_a_turn_about_x()
    {
        Frame frame = Frame.Identity;
        frame.SetVectorHeading(new Vector3(0, 3, 4));
        Assert.Equal(0.4472136f, frame.Rotation.X, 6);
        Assert.Equal(0f, frame.Rotation.Y, 6);
        Assert.Equal(0f, frame.Rotation.Z, 6);
        Assert.Equal(0.8944272f, frame.Rotation.W, 6);
    }

    [Fact, Behaviour("geometry.heading.vector.small", "spec/03, 4.1.4: a vector too small to have a direction changes nothing")]
    public void A_vector_without_direction_turns_nothing()
    {
        Frame frame = new(Vector3.Zero, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 1));
        Quaternion before = frame.Rotation;
        frame.SetVectorHeading(new Vector3(0.0001f, 0, 0));
        Assert.Equal(before, frame.Rotation);
    }

    [Fact, Behaviour("geometry.frame.local-z-unrounded", "spec/03, 4.1.4, and 05, 4.2, Frame::globaltolocal @0x00452680")]
    public void Only_the_local_z_is_made_of_an_unrounded_height()
    {
        // All stored would give z = −50.9447861, nothing stored x = 168.953613.
        Frame frame = new(new Vector3(110.5f, 188.4f, 194.5f), new Quaternion(0, 0.6f, 0, 0.8f));
        Assert.Equal(new Vector3(168.953598f, -0.5f, -50.9447899f), frame.GlobalToLocal(new Vector3(108.9f, 187.9f, 18.04f)));
    }

    /// <summary>Any orientation: a right-handed set of unit axes, and points go out and come back.</summary>
    [Fact, Behaviour("geometry.frame.axes", "spec/03, 4.1.4: localtoglobal, globaltolocal and the matrix")]
    public void The_axes_of_a_frame_are_right_handed_and_points_come_back() =>
        Gen.Select(Part, Part, Part, Part, Part, Part, Part).Sample(
            (x, y, z, w, a, b, c) =>
            {
                Frame frame = new(new Vector3(a, b, c), Quaternion.Identity);
                if ((x * x) + (y * y) + (z * z) + (w * w) < 0.01f || !frame.SetRotation(new(x, y, z, w))) return;
                AssertNear(frame.ZAxis, Vector3.Cross(frame.XAxis, frame.YAxis), 1e-5f);
                AssertNear(Vector3.Transform(Vector3.UnitZ, frame.Rotation), frame.ZAxis, 1e-5f);
                Vector3 point = new(c, a, b);
                AssertNear(point, frame.LocalToGlobal(frame.GlobalToLocal(point)), 1e-4f);
                AssertNear(point, frame.LocalToGlobalVector(frame.GlobalToLocalVector(point)), 1e-4f);
                AssertNear(Vector3.Transform(point, frame.Rotation) + frame.Origin, frame.LocalToGlobal(point), 1e-4f);
            },
            iter: Fuzz.Cases(500));

    [Theory, Behaviour("geometry.frame.valid", "spec/03, 4.1.4, Frame::IsValid @0x00534ED0: no NaN, |q|² within 5 EPS of 1")]
    [InlineData(0f, 0f, 0f, 1f, true)]
    [InlineData(float.NaN, 0f, 0f, 1f, false)]
    [InlineData(0f, float.NaN, 0f, 1f, false)]
    [InlineData(0f, 0f, float.NaN, 1f, false)]
    [InlineData(0f, 0f, 0f, 1.0009f, true)]
    [InlineData(0f, 0f, 0f, 1.0011f, false)]
    [InlineData(0f, 0f, 0f, 0.9991f, true)]
    [InlineData(0f, 0f, 0f, 0.9989f, false)]
    public void A_frame_has_numbers_for_an_origin_and_nearly_a_unit_quaternion(float x, float y, float z, float squared, bool valid) =>
        Assert.Equal(valid, new Frame(new Vector3(x, y, z), new(0, 0, 0, MathF.Sqrt(squared))).IsValid);

    private static readonly Gen<float> Part = Gen.Float[-1f, 1f];

    private static void AssertNear(Vector3 expected, Vector3 actual, float within) =>
        Assert.True(Vector3.Distance(expected, actual) < within, $"{actual}, expected {expected}");

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) < 1e-6f, $"{actual}, expected {expected}");

    [Fact]
    [Behaviour("geometry.frame.rotation-stores", "spec/03, 3.1 and 4.1.4: what is handed to set_rotate are floats")]
    public void The_sines_and_the_product_of_a_turn_are_stored_before_they_are_made_a_unit()
    {
        Quaternion before = new(0.1825741858f, 0.3651483717f, 0.5477225575f, 0.7302967433f);
        int told = 0;
        for (int i = 1; i <= 40; i++)
        {
            Vector3 turn = new(0.05f * i, -0.03f * i, 0.07f * i);
            Frame local = new(Vector3.Zero, before), global = local;
            local.RotateLocal(turn);
            global.RotateGlobal(turn);
            Assert.Equal(Product(before, Turn(turn), store: true), local.Rotation);
            Assert.Equal(Product(Turn(turn), before, store: true), global.Rotation);
            Assert.Equal(local.Rotation, Frame.Combine(new Frame(Vector3.Zero, before), new Frame(Vector3.Zero, Turn(turn))).Rotation);
            if (Product(before, Turn(turn), store: false) != local.Rotation) told++;
        }

        Assert.True(told > 5, "turns whose last bit hangs on the store of the product");

        // The half turn about a vector, as floats.
        static Quaternion Turn(Vector3 v)
        {
            double length = Math.Sqrt(((double)v.X * v.X) + ((double)v.Y * v.Y) + ((double)v.Z * v.Z));
            double factor = (float)(1 / length) * Math.Sin(length / 2);
            return new((float)(v.X * factor), (float)(v.Y * factor), (float)(v.Z * factor), (float)Math.Cos(length / 2));
        }

        static Quaternion Product(Quaternion a, Quaternion b, bool store)
        {
            double Stored(double value) => store ? (float)value : value;
            double w = Stored(((double)a.W * b.W) - ((double)a.X * b.X) - ((double)a.Y * b.Y) - ((double)a.Z * b.Z));
            double x = Stored(((double)a.W * b.X) + ((double)a.X * b.W) + ((double)a.Y * b.Z) - ((double)a.Z * b.Y));
            double y = Stored(((double)a.W * b.Y) + ((double)a.Y * b.W) + ((double)a.Z * b.X) - ((double)a.X * b.Z));
            double z = Stored(((double)a.W * b.Z) + ((double)a.Z * b.W) + ((double)a.X * b.Y) - ((double)a.Y * b.X));
            double inverse = 1 / Math.Sqrt((w * w) + (x * x) + (y * y) + (z * z));
            return new((float)(x * inverse), (float)(y * inverse), (float)(z * inverse), (float)(w * inverse));
        }
    }

    [Fact]
    [Behaviour("geometry.frame.heading-stores",
        "spec/03, 3.1 and 4.1.4, Frame::set_vector_heading @0x00535DB0: the two angles are handed on as floats")]
    public void The_angles_of_a_heading_are_stored_before_their_sines_are_taken()
    {
        int told = 0;
        for (int i = 0; i < 90; i++)
        {
            double radians = ((i * 4) + 1) * Math.PI / 180;
            Vector3 direction = new((float)Math.Sin(radians), (float)Math.Cos(radians), 0);
            Frame frame = Frame.Identity;
            frame.SetVectorHeading(direction);
            Assert.Equal(Level(direction, store: true), frame.Rotation);
            if (frame.Rotation != Level(direction, store: false)) told++;
        }

        Assert.True(told > 5, "headings whose last bit hangs on the store of the angle");

        // A level direction turns about z alone.
        static Quaternion Level(Vector3 direction, bool store)
        {
            double length = Math.Sqrt(((double)direction.X * direction.X) + ((double)direction.Y * direction.Y));
            float x = (float)(direction.X / length), y = (float)(direction.Y / length);
            double yaw = -((450 - (Math.Atan2(y, x) * 180 / Math.PI)) % 360) * Math.PI / 180;
            if (store) yaw = (float)yaw;
            double sine = (float)Math.Sin(yaw / 2), cosine = (float)Math.Cos(yaw / 2),
                inverse = 1 / Math.Sqrt((sine * sine) + (cosine * cosine));
            return new(0, 0, (float)(sine * inverse), (float)(cosine * inverse));
        }
    }
}
