using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>How a body goes about a distance: the table of specification 09b, 14.1.</summary>
public class MoveToChoiceTests
{
    private const uint Defaults = 0x1EE0F, TowardsAndAway = 0x1EF0F, AwayOnly = 0x1ED0F, Neither = 0x1EC0F;

    private const MotionCommand None = MotionCommand.None, Forward = MotionCommand.WalkForward, Back = MotionCommand.WalkBackwards;

    [Theory]
    [Behaviour("steering.move-to.command", "spec/09b, 14.1; MovementParameters::get_command @0x0052AA00, towards_and_away @0x0052A9A0")]
    [InlineData(Defaults, 0.6f, 0f, 0.5f, None, false)]
    [InlineData(Defaults, 0.6f, 0f, 0.6f, None, false)]
    [InlineData(Defaults, 0.6f, 0f, 0.600001f, Forward, false)]
    [InlineData(TowardsAndAway, 2f, 1f, 5f, Forward, false)]
    [InlineData(TowardsAndAway, 2f, 1f, 2f, None, false)]
    [InlineData(TowardsAndAway, 2f, 1f, 1.5f, None, false)]
    [InlineData(TowardsAndAway, 2f, 1f, 1.0002f, None, false)]
    [InlineData(TowardsAndAway, 2f, 1f, 1.0001f, Back, true)]
    [InlineData(TowardsAndAway, 2f, 1f, 1f, Back, true)]
    [InlineData(TowardsAndAway, 2f, 1f, 0.5f, Back, true)]
    [InlineData(TowardsAndAway, 2f, 1f, -0.3f, Back, true)]
    [InlineData(AwayOnly, 0.6f, 10f, 3f, Forward, true)]
    [InlineData(AwayOnly, 0.6f, 10f, 9.99f, Forward, true)]
    [InlineData(AwayOnly, 0.6f, 10f, 10f, None, false)]
    [InlineData(Neither, 0.6f, 10f, 0.5f, None, false)]
    [InlineData(Neither, 0.6f, 10f, 3f, Forward, false)]
    public void A_body_approaches_backs_off_flees_or_stays(
        uint flags, float far, float near, float distance, MotionCommand command, bool away)
    {
        MoveToChoice choice = Of(flags, far, near, distance);
        Assert.Equal((command, away), (choice.Command, choice.MovingAway));
    }

    [Theory]
    [Behaviour("steering.move-to.walk-or-run", "spec/09b, 14.1; MovementParameters::get_command @0x0052AA00")]
    [InlineData(Defaults, 0f, 0.600001f, HoldKey.None)]
    [InlineData(Defaults, 0f, 15.59f, HoldKey.None)]
    [InlineData(Defaults, 0f, 15.6f, HoldKey.Run)]
    [InlineData(Defaults | 0x10, 0f, 1f, HoldKey.Run)]
    [InlineData(Defaults & ~0x1u, 0f, 1f, HoldKey.Run)]
    [InlineData(Defaults & ~0x2u, 0f, 100f, HoldKey.None)]
    [InlineData(Defaults & ~0x3u, 0f, 100f, HoldKey.None)]
    [InlineData(AwayOnly, 10f, 3f, HoldKey.None)]
    [InlineData(AwayOnly, 30f, 20f, HoldKey.Run)]
    public void A_body_runs_when_it_is_far_even_when_it_flees(uint flags, float near, float distance, HoldKey key) =>
        Assert.Equal(key, Of(flags, 0.6f, near, distance).Key);

    private static MoveToChoice Of(uint flags, float far, float near, float distance)
    {
        MovementParameters p = new() { Flags = (MovementFlags)flags, DistanceToObject = far, MinDistance = near };
        return MoveToChoice.Of(p, distance);
    }
}
