using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>The acceptance lines of movement in the world that everybody can write: real files, real terrain, real keys.</summary>
public class DemoWorldTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const double FrameTime = WalkFixture.FrameTime;

    [Theory]
    [Behaviour("acceptance.run-speed-on-terrain", "design; spec/01, 4.1 and 6")]
    [InlineData(0, 0, 4.0)]
    [InlineData(100, 0, 7.66666652)]
    [InlineData(300, 0, 10.6000004)]
    [InlineData(300, 22500, 7.3000002)]
    [InlineData(800, 0, 18.0)]
    public void A_runner_on_the_runway_covers_the_formulas_distance(int skill, int burden, double expected)
    {
        DemoWalk walk = new(files, "runway", new CharacterStats(skill, 300, Burden: burden));
        walk.Hold(MovementKeys.Forward, 15);
        Vector3 from = walk.Moved;
        const int count = 600;
        HashSet<uint> blocks = [];
        walk.Hold(MovementKeys.Forward, count, () =>
        {
            Assert.True(walk.Body.OnWalkable);
            Assert.Equal(walk.RestHeight, walk.Z, 1e-3f);
            blocks.Add(CellIds.BlockOf(walk.Position.CellId));
        });
        Vector3 way = walk.Moved - from;
        Assert.Equal(expected, way.X / (count * FrameTime), 2 * 4.0 / 30 / (count * FrameTime));
        Assert.Equal(0f, way.Y, 0.01f);
        if (skill == 800) Assert.True(blocks.Count >= 2);
    }

    [Theory]
    [Behaviour("acceptance.walk-speed-on-terrain", "design; spec/01, 3 and 4.3")]
    [InlineData(0)]
    [InlineData(800)]
    public void A_walker_on_the_runway_covers_three_point_one_two_metres_a_second(int skill)
    {
        DemoWalk walk = new(files, "runway", new CharacterStats(skill, 300));
        const MovementKeys keys = MovementKeys.Forward | MovementKeys.Walk;
        walk.Hold(keys, 15);
        float from = walk.Moved.X;
        walk.Hold(keys, 300);
        Assert.Equal(3.12, (walk.Moved.X - from) / (300 * FrameTime), 2 * 0.104 / (300 * FrameTime));
    }

    [Fact]
    [Behaviour("demo-world.human.turns-on-when-it-stops-running", "spec/01b, 2 (re_modify and rule 2) and 4")]
    public void Who_lets_go_of_the_run_key_goes_on_turning_and_stops_with_the_turn_key()
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(200, 200));
        walk.Hold(MovementKeys.Forward | MovementKeys.TurnRight, 15);
        walk.Hold(MovementKeys.TurnRight, 1);
        double from = walk.Position.Frame.Heading;
        walk.Hold(MovementKeys.TurnRight, 30);

        // 1.5 rad/s at the turning speed of a runner, 1.5; three frames of the animation more or less.
        double turned = (walk.Position.Frame.Heading - from + 360) % 360, frame = 0.05 * 180 / Math.PI;
        Assert.Equal(1.5 * 1.5 * 30 * FrameTime * 180 / Math.PI, turned, 3 * frame);
        walk.Hold(MovementKeys.None, 2);
        from = walk.Position.Frame.Heading;
        walk.Hold(MovementKeys.None, 10);
        Assert.Equal(from, walk.Position.Frame.Heading);
    }

    [Theory]
    [Behaviour("acceptance.jump-apex-on-terrain", "design; spec/01, 4.1 and 6; spec/02, 6.4 and 6.5")]
    [InlineData(300, 30, 4.21231575)]
    [InlineData(0, 30, 0.349998266)]
    [InlineData(1000, 1, 0.349998266)]
    public void A_jump_in_the_meadow_reaches_its_height(int skill, int chargeFrames, double apex)
    {
        DemoWalk walk = new(files, "meadow", new CharacterStats(300, skill));
        walk.Hold(MovementKeys.Jump, chargeFrames);
        float highest = 0;
        walk.Hold(MovementKeys.None, 60, () => highest = Math.Max(highest, walk.Z - walk.RestHeight));
        Assert.Single(walk.Sent.Jumps);

        // The heights are those of the integration at 1/30 s; a jump from a charge of one frame has an extent a little above the least.
        Assert.Equal(apex, highest, 1e-3);
        walk.Hold(MovementKeys.None, 30);
        Assert.True(walk.Body.OnWalkable);
    }

    [Theory]
    [Behaviour("acceptance.hill-below-the-limit-keeps-the-ground", "design; spec/03")]
    [InlineData("slope-15")]
    [InlineData("slope-30")]
    [InlineData("slope-45")]
    public void A_hill_below_the_limit_is_run_up_and_down_with_the_ground_under_the_feet(string place)
    {
        DemoWalk walk = new(files, place, new CharacterStats(200, 300));
        float highest = walk.RestHeight;
        walk.Hold(MovementKeys.Forward, 60, () =>
        {
            Assert.True(walk.Body.OnWalkable);
            highest = Math.Max(highest, walk.Z);
        });
        Assert.True(highest > walk.RestHeight + 2, $"climbed from {walk.RestHeight} to {highest}");
        walk.Hold(MovementKeys.Back | MovementKeys.Walk, 150, () => Assert.True(walk.Body.OnWalkable));
        Assert.True(walk.Z < highest - 1, $"came down from {highest} to {walk.Z}");
    }

    [Theory]
    [Behaviour("acceptance.slope-above-the-limit-is-not-climbed", "design; spec/03")]
    [InlineData("slope-55")]
    [InlineData("slope-60")]
    public void A_slope_above_the_limit_is_not_climbed(string place)
    {
        DemoWalk walk = new(files, place, new CharacterStats(300, 300));
        float highest = walk.RestHeight;
        walk.Hold(MovementKeys.Forward, 300, () => highest = Math.Max(highest, walk.Z));
        Assert.True(highest < walk.RestHeight + 2, $"climbed from {walk.RestHeight} to {highest}");
    }

    [Theory]
    [Behaviour("acceptance.cliff-falls-and-lands", "design; spec/02, 4.10 and 4.13; spec/03, edge_slide case A")]
    [InlineData(MovementKeys.Forward)]
    [InlineData(MovementKeys.Forward | MovementKeys.Walk)]
    public void Going_off_a_cliff_falls_and_lands_with_contact(MovementKeys keys)
    {
        DemoWalk walk = new(files, "cliff-edge", new CharacterStats(300, 300));
        walk.Body.SetState(walk.Body.State & ~PhysicsState.EdgeSlide);
        AssertFallsAndLands(walk, keys);
    }

    [Fact]
    [Behaviour("acceptance.cliff-holds-a-player-until-it-jumps", "spec/02, 2.2; spec/03, edge_slide cases B to E")]
    public void A_player_is_held_at_the_brink_and_jumps_off_it()
    {
        // Players have the edge slide bit: on foot they do not go over a brink.
        DemoWalk walk = new(files, "cliff-edge", new CharacterStats(300, 300));
        walk.Hold(MovementKeys.Forward, 60, () => Assert.True(walk.Body.OnWalkable));
        Assert.Equal(walk.RestHeight, walk.Z, 1e-3f);
        walk.Hold(MovementKeys.Forward | MovementKeys.Jump, 15);
        AssertFallsAndLands(walk, MovementKeys.Forward);
    }

    private static void AssertFallsAndLands(DemoWalk walk, MovementKeys keys)
    {
        bool fell = false;
        walk.Hold(keys, 150, () => fell |= !walk.Body.HasContact);
        Assert.True(fell);
        walk.Hold(MovementKeys.None, 240);
        Assert.True(walk.Body.HasContact);
        Assert.True(walk.Z < walk.RestHeight - 5, $"from {walk.RestHeight} to {walk.Z}");
    }

    [Fact]
    [Behaviour("acceptance.borders-change-only-the-cell-id", "design; spec/05")]
    public void Crossing_a_border_changes_the_cell_and_nothing_else()
    {
        DemoWalk across = new(files, "landblock-border", new CharacterStats(300, 300));
        DemoWalk away = new(files, "landblock-border", new CharacterStats(300, 300), eastward: -96);
        HashSet<uint> blocks = [];
        for (int i = 0; i < 120; i++)
        {
            MovementKeys keys = MovementKeys.Forward | (i % 40 > 30 ? MovementKeys.Jump : 0) | (i % 50 > 44 ? MovementKeys.TurnLeft : 0);
            across.Hold(keys, 1);
            away.Hold(keys, 1);
            blocks.Add(CellIds.BlockOf(across.Position.CellId));
            Assert.Equal(across.Moved.X, away.Moved.X, 2e-3f);
            Assert.Equal(across.Moved.Y, away.Moved.Y, 2e-3f);
            Assert.Equal(across.Moved.Z, away.Moved.Z, 2e-3f);
            Assert.Equal(across.Body.Transient, away.Body.Transient);
        }

        Assert.True(blocks.Count > 1);
    }
}
