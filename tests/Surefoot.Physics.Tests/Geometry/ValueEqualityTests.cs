using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>Values that people put into sets and compare.</summary>
public class ValueEqualityTests
{
    [Fact, Behaviour("geometry.values.equal-bit-for-bit", "design, decision 5: the same bits")]
    public void Frames_positions_boxes_and_stamps_are_equal_when_all_their_numbers_are()
    {
        Frame frame = new(new Vector3(1, 2, 3), new Quaternion(0, 0, 0.6f, 0.8f));
        Frame[] frames =
        [
            new(new Vector3(1, 2, 3.0000002f), frame.Rotation), new(new Vector3(0, 2, 3), frame.Rotation),
            new(frame.Origin, new Quaternion(0, 0, -0.6f, -0.8f)), new(frame.Origin, Quaternion.Identity),
        ];
        AssertApart(frame, frame with { }, frames, (a, b) => a == b, (a, b) => a != b);

        Position position = new(0xA9B40001, frame);
        Position[] positions = [new(0xA9B40002, frame), .. frames.Select(other => new Position(0xA9B40001, other))];
        AssertApart(position, new Position(0xA9B40001, frame), positions, (a, b) => a == b, (a, b) => a != b);

        BoundingBox box = BoxOf(new Vector3(0, 0, 0), new Vector3(1, 2, 3));
        BoundingBox[] boxes = [BoxOf(new Vector3(0, 0, 0), new Vector3(1, 2, 4)), BoxOf(new Vector3(-1, 0, 0), new Vector3(1, 2, 3))];
        AssertApart(box, BoxOf(new Vector3(1, 2, 3), new Vector3(0, 0, 0)), boxes, (a, b) => a == b, (a, b) => a != b);

        MessageStamps stamps = new([1, 2, 3, 4, 5, 6, 7, 8, 9]);
        MessageStamps[] others = [new([1, 2, 3, 4, 5, 6, 7, 8, 10]), new([0, 2, 3, 4, 5, 6, 7, 8, 9])];
        AssertApart(stamps, new MessageStamps([1, 2, 3, 4, 5, 6, 7, 8, 9]), others, (a, b) => a == b, (a, b) => a != b);
    }

    private static BoundingBox BoxOf(params Vector3[] corners)
    {
        BoundingBox box = BoundingBox.Empty;
        foreach (Vector3 corner in corners) box.Include(corner);
        return box;
    }

    private static void AssertApart<T>(T one, T same, T[] others, Func<T, T, bool> equal, Func<T, T, bool> unequal)
        where T : struct
    {
        Assert.True(equal(one, same) && !unequal(one, same) && one.Equals((object)same));
        Assert.Equal(one.GetHashCode(), same.GetHashCode());
        Assert.False(one.Equals("something else"));
        foreach (T other in others) Assert.True(!equal(one, other) && unequal(one, other) && !one.Equals((object)other));
        HashSet<T> set = [one, same, .. others];
        Assert.Equal(1 + others.Length, set.Count);
    }
}
