using System.Globalization;
using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>What is kept of what a player did, and the words for it.</summary>
public sealed class WalkRecorderTests
{
    private const PlayerKeys Forward = PlayerKeys.Forward;
    private const double Q = WorldTime.Quantum;

    private readonly WalkRecorder record = new(new PlayerSettings(300, 250, 0));
    private double tick = 64;
    private float north = 24;
    private byte turns;

    public WalkRecorderTests() => record.Place(Here());

    private string Script => record.Command(null).Split("--script ")[1];

    [Fact]
    [Behaviour("workbench.walk.from-setting-off-to-standing", "design.md, The tool")]
    public void It_begins_where_the_player_set_off_and_ends_when_it_stands()
    {
        Assert.Equal(Line("24", "Wait 1"), record.Command(null));
        Ticks(3);
        record.Act(Forward, false, tick);
        Ticks(64, speed: 8);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(1, speed: 8);
        Ticks(400);
        // 64 quanta are 2.25 s; it stands from the second quantum after that on, and is watched for less than 8 (0.28 s).
        Assert.Equal(Line("24", $"W 2.25; Wait {9 * Q:0.###}"), record.Command(null));
    }

    [Fact]
    [Behaviour("workbench.walk.rest-begins-anew", "design.md, The tool")]
    public void It_goes_on_over_a_short_halt_and_begins_anew_after_a_rest()
    {
        Ticks(1);
        byte before = record.Count;
        record.Act(Forward, false, tick);
        Ticks(64, speed: 8);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(32);
        record.Act(PlayerKeys.Back, false, tick);
        Assert.Equal((byte)(before + 1), record.Count);
        Ticks(32, speed: -8);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(1);
        Assert.Equal($"\"W 2.25; Wait 1.125; S 1.125; Wait {Q:0.###}\"", Script);
        Ticks(43);
        record.Act(PlayerKeys.TurnLeft, false, tick);
        turns = 1;
        Ticks(32);
        Assert.Equal((byte)(before + 2), record.Count);
        Assert.Equal(Line("32", "A 1.125"), record.Command(null));
    }

    [Fact]
    [Behaviour("workbench.walk.keys-act-from-the-tick-before", "design.md, The tool")]
    public void A_key_counts_from_the_tick_before_and_only_a_jumps_charge_from_its_moment()
    {
        Ticks(1);
        record.Act(Forward, false, tick + (5.0 / 512));
        Ticks(64, speed: 8);
        record.Act(Forward | PlayerKeys.Jump, false, tick + (10.0 / 512));
        Ticks(16, speed: 8);
        record.Act(Forward, false, tick + (6.0 / 512));
        record.Act(Forward | PlayerKeys.TurnLeft, false, tick + (7.0 / 512));
        Ticks(8, speed: 8);
        // 64 × 18 + 10 = 1162; 16 × 18 − 10 + 6 = 284; then nothing; 8 × 18 − 6 = 138: units of 1/512 s.
        Assert.Equal("\"W 2.27; W+Space 0.555; W 0; W+A 0.27\"", Script);
    }

    [Fact]
    [Behaviour("workbench.walk.jump-on-the-spot", "design.md, The tool")]
    public void Who_charges_a_jump_where_it_stands_waits_for_the_moment_of_the_key()
    {
        Ticks(1);
        record.Act(PlayerKeys.Jump, false, tick + (9.0 / 512));
        Ticks(16);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(1);
        Assert.Equal($"\"Wait 0.018; Space 0.545; Wait {Q:0.###}\"", Script);
    }

    [Fact]
    [Behaviour("workbench.walk.auto-run", "spec/09b, 9")]
    public void Running_without_a_key_is_said()
    {
        Ticks(1);
        record.Act(PlayerKeys.None, true, tick);
        Ticks(64, speed: 8);
        record.Act(PlayerKeys.TurnLeft, true, tick);
        Ticks(32, speed: 8);
        Assert.Equal("\"Auto 2.25; Auto+A 1.125\"", Script);
    }

    [Fact]
    [Behaviour("workbench.walk.left-out", "design.md, The tool")]
    public void What_no_script_can_say_is_said_of_the_walk_it_belongs_to()
    {
        Touch house = new(false, TouchKind.Building, 1, Vector3.UnitX, ""), creature = house with { Kind = TouchKind.Body };
        Ticks(1);
        record.Miss("the door");
        record.Act(Forward, false, tick);
        Ticks(1, speed: 8, house);
        Assert.Equal("", record.LeftOut);
        Ticks(1, speed: 8, house, creature);
        record.Configure(new PlayerSettings(100, 250, 0));
        Assert.Equal("the change of skills on the way and who was in the way", record.LeftOut);
        Assert.Contains("--run 300 ", record.Command(null), StringComparison.Ordinal);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(60);
        record.Act(Forward, false, tick);
        Assert.Equal("", record.LeftOut);
        Assert.Contains("--run 100 ", record.Command(null), StringComparison.Ordinal);
        Ticks(1, speed: 8);
        record.Place(Here());
        Ticks(1, speed: 3);
        record.Act(Forward, false, tick);
        Assert.Equal("what moved the player before", record.LeftOut);
    }

    [Fact]
    [Behaviour("workbench.walk.bounded", "design.md, Errors")]
    public void A_walk_without_end_is_kept_as_far_as_a_script_goes()
    {
        Ticks(1);
        for (int i = 0; i < 2 * WalkRecorder.MostLegs; i++)
        {
            record.Act(i % 2 == 0 ? Forward : Forward | PlayerKeys.TurnLeft, false, tick);
            Ticks(1, speed: 8);
        }

        Assert.Equal(WalkRecorder.MostLegs, Script.Split(';').Length);
        Assert.Equal("what came after 4000 changes of keys or an hour", record.LeftOut);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(60);
        record.Act(PlayerKeys.Back, false, tick);
        Ticks(32);
        Assert.Equal(("\"S 1.125\"", ""), (Script, record.LeftOut));
    }

    [Fact]
    [Behaviour("workbench.walk.an-hour", "design.md, Errors")]
    public void A_walk_of_more_than_an_hour_ends_where_a_script_does_and_the_next_one_begins_anew()
    {
        Ticks(1);
        record.Act(PlayerKeys.None, true, tick);
        Ticks((int)(3700 / Q), speed: 8);
        Assert.InRange(double.Parse(Script.Split(' ')[1].Trim('"'), CultureInfo.InvariantCulture), 3580, 3600);
        Assert.Equal("what came after 4000 changes of keys or an hour", record.LeftOut);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(60);
        record.Act(Forward, false, tick);
        Ticks(32, speed: 8);
        Assert.Equal(("\"W 1.125\"", ""), (Script, record.LeftOut));
    }

    /// <summary>Both buttons run ahead, and the right one turns: a walk of its own, of which nothing can be said by keys.</summary>
    [Fact]
    [Behaviour("workbench.walk.mouse-buttons", "spec/09b, 9.7")]
    public void What_the_mouse_moves_after_a_rest_begins_a_walk_that_says_so()
    {
        Ticks(1);
        record.Act(Forward, false, tick);
        Ticks(32, speed: 8);
        record.Act(PlayerKeys.None, false, tick);
        Ticks(60);
        byte before = record.Count;
        record.Steer(true);
        Ticks(32, speed: 8);
        record.Steer(false);
        Ticks(1);
        Assert.Equal(((byte)(before + 1), "what the mouse did"), (record.Count, record.LeftOut));
        Assert.StartsWith("surefoot walk --at 0xA9B50032,156,32,20,0 ", record.Command(null), StringComparison.Ordinal);
        Ticks(60);
        record.Steer(true);
        Ticks(60);
        record.Act(PlayerKeys.TurnLeft, false, tick);
        Ticks(1);
        Assert.Equal("what the mouse did", record.LeftOut);
    }

    [Theory]
    [Behaviour("workbench.walk.paths-are-quoted", "design.md, The tool")]
    [InlineData("/games/ac", "/games/ac")]
    [InlineData("/games/Asheron's Call", "'/games/Asheron'\\''s Call'")]
    [InlineData("C:\\Games\\AC", "\"C:\\Games\\AC\"")]
    public void A_folder_is_written_as_the_shell_of_its_system_reads_it(string folder, string written) =>
        Assert.Contains($" --dats {written} --quantum ", record.Command(folder), StringComparison.Ordinal);

    [Fact]
    [Behaviour("workbench.walk.place-to-the-last-bit", "design.md, The tool")]
    public void A_rotation_that_no_heading_gives_is_written_as_the_game_prints_it()
    {
        Position place = Here();
        place.Frame.SetHeading(90);
        record.Place(place);
        Assert.StartsWith("surefoot walk --at 0xA9B50032,156,24,20,90 --run", record.Command(null), StringComparison.Ordinal);
        Position tilted = new(place.CellId, new Frame(place.Frame.Origin with { X = 0.1f }, new Quaternion(0, 0.6f, 0, 0.8f)));
        record.Place(tilted);
        string command = record.Command(null);
        Assert.StartsWith("surefoot walk --at \"0xA9B50032 [0.1 24 20] 0.8 0 0.6 0\" --run", command, StringComparison.Ordinal);
        Position read = Place.Parse(command.Split('"')[1]).Position;
        Assert.Equal((tilted.CellId, tilted.Frame.Origin, tilted.Frame.Rotation), (read.CellId, read.Frame.Origin, read.Frame.Rotation));
    }

    private static string Line(string north, string script) => FormattableString.Invariant(
        $"surefoot walk --at 0xA9B50032,156,{north},20,0 --run 300 --jump 250 --quantum 35.15625 --script \"{script}\"");

    private Position Here() => new(0xA9B50032, new Vector3(156, north, 20));

    private void Ticks(int count, float speed = 0, params Touch[] touches)
    {
        north += speed * count / 32;
        for (int i = 0; i < count; i++)
        {
            PlayerPose pose = new(
                tick += Q, 0xA9B50032, Here().Frame.Origin, 0, new Vector3(0, speed, 0), Math.Abs(speed),
                PoseFlags.Contact | PoseFlags.OnWalkable, default, 0, (float)Q, 1, 0, 0, 0, turns, 0);
            record.Observe(Here(), pose, touches, tick);
        }

        turns = 0;
    }
}
