using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>Where a frame faces: specification 03, 4.1.4.</summary>
public class FrameTests
{
    /// <summary>Pitch about x, then yaw about z: +y faces the way, and +x stays level. For a climb of 53.13 degrees half the angle has sine 0.4472136 and cosine 0.8944272.</summary>
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

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True(Vector3.Distance(expected, actual) < 1e-6f, $"{actual}, expected {expected}");
}
