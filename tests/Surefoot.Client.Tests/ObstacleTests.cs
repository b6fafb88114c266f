using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>What a walker meets in the town and the obstacle park.</summary>
public sealed class ObstacleTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private static readonly CharacterStats Runner = new(300, 200);

    [Theory]
    [Behaviour("obstacles.steps-up-to-the-step-height", "spec/03, 4.7 step_up; setup's step up of 0.6 m")]
    [InlineData("steps-20", 0.8f)]
    [InlineData("steps-30", 1.2f)]
    [InlineData("steps-40", 1.6f)]
    [InlineData("steps-50", 2.0f)]
    [InlineData("steps-55", 2.2f)]
    public void Steps_below_the_limit_are_run_up(string place, float rise)
    {
        DemoWalk walk = new(files, place, Runner);
        float highest = walk.RestHeight;
        walk.Hold(MovementKeys.Forward, 60, () => highest = Math.Max(highest, walk.Z));
        Assert.True(highest > walk.RestHeight + rise - 0.05f, $"rose {highest - walk.RestHeight} of {rise} m");
    }

    [Theory]
    [Behaviour("obstacles.steps-above-the-step-height", "spec/03, 4.7 step_up; setup's step up of 0.6 m")]
    [InlineData("steps-70")]
    [InlineData("steps-80")]
    [InlineData("steps-90")]
    public void Steps_above_the_limit_are_refused(string place)
    {
        DemoWalk walk = new(files, place, Runner);
        walk.Hold(MovementKeys.Forward, 60);
        Assert.True(walk.Z < walk.RestHeight + 0.1f, $"rose {walk.Z - walk.RestHeight} m");
        Assert.True(walk.Body.OnWalkable);
    }

    [Theory]
    [Behaviour("obstacles.wedges-around-the-walkable-limit", "spec/03, 3 and 6.1: 48.38 degrees")]
    [InlineData("wedge-30", true)]
    [InlineData("wedge-45", true)]
    [InlineData("wedge-47", true)]
    [InlineData("wedge-48", true)]
    [InlineData("wedge-49", false)]
    [InlineData("wedge-50", false)]
    [InlineData("wedge-60", false)]
    public void A_wedge_is_climbed_below_the_limit_and_refused_above(string place, bool climbs)
    {
        DemoWalk walk = new(files, place, Runner);
        float highest = walk.RestHeight;
        walk.Hold(MovementKeys.Forward, 60, () => highest = Math.Max(highest, walk.Z));
        Assert.Equal(climbs, highest > walk.RestHeight + 1);
    }

    [Fact]
    [Behaviour("obstacles.doorway-enters-the-room", "spec/05, 4.13 to 4.15")]
    public void A_doorway_leads_from_outdoors_into_the_room_and_back()
    {
        DemoWalk walk = new(files, "house-door", Runner);
        Assert.True(CellIds.IsOutdoor(walk.Position.CellId));
        bool inside = false;
        walk.Hold(MovementKeys.Forward, 45, () => inside |= !CellIds.IsOutdoor(walk.Position.CellId));
        Assert.True(inside);
        Assert.True(walk.Body.OnWalkable);
        walk.Hold(MovementKeys.Back, 150);
        Assert.True(CellIds.IsOutdoor(walk.Position.CellId));
        Assert.True(walk.Body.OnWalkable);
    }

    [Theory]
    [Behaviour("obstacles.stairs-through-floors", "spec/03, 4.7; spec/05, 4.14")]
    [InlineData("house-stairs", 0x102u)]
    [InlineData("house-cellar", 0x101u)]
    public void Stairs_are_climbed_through_the_hole_without_catching_on_the_floor(string place, uint roomAbove)
    {
        DemoWalk walk = new(files, place, Runner);
        float highest = walk.RestHeight;
        bool arrived = false;
        walk.Hold(MovementKeys.Forward, 90, () =>
        {
            highest = Math.Max(highest, walk.Z);
            arrived |= (walk.Position.CellId & 0xFFFF) == roomAbove;
        });
        Assert.True(arrived, $"ended in {walk.Position}");
        Assert.True(highest > walk.RestHeight + 2, $"rose {highest - walk.RestHeight} m");
    }

    [Theory]
    [Behaviour("obstacles.seam-between-two-stairs", "spec/03, 4.7 step_up and step_down")]
    [InlineData(0)]
    [InlineData(100)]
    [InlineData(300)]
    [InlineData(800)]
    public void The_seam_between_two_stair_objects_is_run_over_up_and_down_with_the_ground_under_the_feet(int runSkill)
    {
        // 24 stairs of 0.25 m in two objects that meet 3 m up, and a platform of 5 m.
        DemoWalk up = new(files, "long-stair", new CharacterStats(runSkill, 200));
        float last = up.Z;
        for (int frame = 0; frame < 300 && up.Moved.Y < 5 + 7.2f + 1; frame++)
        {
            up.Hold(MovementKeys.Forward, 1);
            Assert.True(up.Body.OnWalkable, $"lost the ground at {up.Moved}");
            Assert.True(up.Z >= last - 0.001f, $"sank from {last} to {up.Z} at {up.Moved}");
            last = up.Z;
        }

        Assert.Equal(6, up.Moved.Z, 0.01);

        DemoWalk down = new(files, "platform", new CharacterStats(runSkill, 200));
        down.Hold(MovementKeys.Forward, 150, () => Assert.True(down.Body.OnWalkable, $"lost the ground at {down.Moved}"));
        Assert.Equal(-6, down.Moved.Z, 0.01);
        Assert.True(down.Moved.Y < -10);
    }

    [Fact]
    [Behaviour("obstacles.standing-indoors-never-moves", "spec/02, 4.4 step 6")]
    public void Standing_still_indoors_moves_by_no_bit_in_ten_thousand_quanta()
    {
        DemoWalk walk = new(files, "house-hall", Runner);
        walk.Hold(MovementKeys.None, 60);
        Position stood = walk.Position;
        walk.Hold(MovementKeys.None, 10_000);
        Assert.Equal(stood, walk.Position);
    }

    [Fact]
    [Behaviour("obstacles.low-ceiling-stops-a-jump", "spec/03, 4.6")]
    public void A_low_ceiling_stops_the_head_and_the_body_lands_again()
    {
        DemoWalk walk = new(files, "low-ceiling", new CharacterStats(300, 300));
        float highest = walk.RestHeight;
        walk.Hold(MovementKeys.Jump, 30);
        walk.Hold(MovementKeys.None, 120, () => highest = Math.Max(highest, walk.Z));
        // The ceiling is at 2.2 m and the head's sphere ends at 1.83 m.
        Assert.InRange(highest - walk.RestHeight, 0.05f, 0.42f);
        Assert.True(walk.Body.OnWalkable);
    }

    [Fact]
    [Behaviour("obstacles.gaps-a-centimetre-wider-and-narrower", "setup's radius of 0.48 m; spec/04")]
    public void A_gap_a_centimetre_wider_than_the_body_is_passed_and_one_narrower_is_not()
    {
        DemoWalk walk = new(files, "gaps", new CharacterStats(0, 0));
        float furthest = 0;
        walk.Hold(MovementKeys.Forward | MovementKeys.Walk, 600, () => furthest = Math.Max(furthest, walk.Moved.Y));
        Vector3 end = walk.Moved;
        walk.Hold(MovementKeys.Forward | MovementKeys.Walk, 60);
        Assert.True(furthest > 6, $"got {furthest} m north");
        Assert.True(Vector3.Distance(end, walk.Moved) < 0.01f, "went on through a gap narrower than the body");
        Assert.Equal(TransientState.OnWalkable, walk.Body.Transient & TransientState.OnWalkable);
    }
}
