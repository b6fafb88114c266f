using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>Which way to turn, and when a turn is over: the tables of specification 09b, 14.2 and 14.3.</summary>
public class HeadingsTests
{
    private const MotionCommand None = MotionCommand.None, Right = MotionCommand.TurnRight, Left = MotionCommand.TurnLeft;
    private const MotionCommand Forward = MotionCommand.WalkForward, Back = MotionCommand.WalkBackwards;

    [Theory]
    [Behaviour("steering.heading.difference", "spec/09b, 14.2; heading_diff @0x00528FB0")]
    [InlineData(10f, 350f, 20f, 340f, Right)]
    [InlineData(350f, 10f, 340f, 20f, Left)]
    [InlineData(0f, 0.0001f, 0f, 0f, None)]
    [InlineData(0f, 0.0003f, 359.9997f, 0.000300000014f, Left)]
    [InlineData(359.9999f, 0f, 359.999908f, 0.0000915527344f, None)]
    [InlineData(0f, 359.9999f, 0.0000915527344f, 0.0000915527344f, None)]
    [InlineData(0f, 359.9997f, 0.000305175781f, 359.999695f, Right)]
    [InlineData(180f, 0f, 180f, 180f, Right)]
    [InlineData(0f, 180f, 180f, 180f, Right)]
    [InlineData(270f, 90f, 180f, 180f, Right)]
    [InlineData(90f, 270.001f, 179.998993f, 180.001007f, Right)]
    public void A_body_turns_the_short_way_and_to_the_right_when_both_are_equal(
        float goal, float own, float right, float left, MotionCommand turn)
    {
        Assert.Equal(right, (float)Headings.Difference(goal, own, Right));
        Assert.Equal(left, (float)Headings.Difference(goal, own, Left));
        Assert.Equal(turn, Headings.TurnTo(goal, own, out float difference));
        Assert.Equal(right, difference);
    }

    [Theory]
    [Behaviour("steering.heading.past", "spec/09b, 14.2; heading_greater @0x00528F60")]
    [InlineData(350f, 10f, false)]
    [InlineData(5f, 10f, false)]
    [InlineData(10f, 10f, false)]
    [InlineData(10.5f, 10f, true)]
    [InlineData(359f, 1f, false)]
    [InlineData(1f, 359f, true)]
    [InlineData(190f, 10f, true)]
    [InlineData(190.1f, 10f, false)]
    [InlineData(0f, 180f, false)]
    [InlineData(180f, 0f, true)]
    public void A_right_turn_is_over_past_its_goal_and_a_left_turn_at_it(float own, float goal, bool isRightTurnOver)
    {
        Assert.Equal(isRightTurnOver, Headings.IsPast(own, goal, Right));
        Assert.Equal(!isRightTurnOver, Headings.IsPast(own, goal, Left));
    }

    [Theory]
    [Behaviour("steering.heading.of-a-position", "spec/09b, 14.2; Position::heading @0x005A9520")]
    [InlineData(0f, 10f, 0f)]
    [InlineData(10f, 0f, 90f)]
    [InlineData(0f, -10f, 180f)]
    [InlineData(-10f, 0f, 270f)]
    [InlineData(10f, 10f, 45f)]
    [InlineData(-1f, 10f, 354.289398f)]
    [InlineData(0.0001f, 0.0001f, 0f)]
    public void North_is_0_east_is_90_and_what_is_too_near_is_north(float x, float y, float heading) =>
        Assert.Equal(heading, FakeSteeredBody.At(Vector3.Zero).HeadingTo(FakeSteeredBody.At(x, y)), 1e-4f);

    [Theory]
    [Behaviour("steering.heading.turn-while-moving", "spec/09b, 14.3; MoveToManager::HandleMoveToPosition @0x00529D80")]
    [InlineData(0f, Forward, false, Right)]
    [InlineData(70f, Forward, false, None)]
    [InlineData(69.9f, Forward, false, Right)]
    [InlineData(110f, Forward, false, None)]
    [InlineData(110.1f, Forward, false, Left)]
    [InlineData(270f, Forward, false, Left)]
    [InlineData(90f, Forward, true, Left)]
    [InlineData(260f, Forward, true, None)]
    [InlineData(75f, Back, true, None)]
    public void A_body_on_its_way_turns_when_it_is_more_than_twenty_degrees_off(
        float own, MotionCommand command, bool away, MotionCommand turn)
    {
        float target = FakeSteeredBody.At(Vector3.Zero).HeadingTo(FakeSteeredBody.At(10, 0));
        float wanted = Headings.Add(target, MoveToChoice.FacingOffset(command, away));
        Assert.Equal(turn, Headings.TurnWhileMoving(wanted, own));
    }
}
