using Surefoot.Client;
using Surefoot.Physics.Motion;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Tests.Walking;

public class WalkQuantumTests
{
    private static readonly WalkLeg[] RunThenStand = [new(MovementKeys.Forward, 0.4), new(MovementKeys.None, 0.1)];

    [Fact, Behaviour("tool.walk.quanta-of-one-length", "design.md, The tool")]
    public void Quanta_are_of_the_length_asked_for_and_keys_act_in_the_one_that_their_moment_falls_into()
    {
        // The key comes up after ten quanta, and again in the midst of one, of which it then has nothing.
        foreach (double held in (double[])[0.4, 0.43])
        {
            WalkResult walk = Walk([new(MovementKeys.Forward, held), new(MovementKeys.None, 0.5 - held)], 0.04);
            Assert.Equal(14, walk.Samples.Count);
            for (int i = 0; i < walk.Samples.Count; i++) Assert.Equal(i * 0.04, walk.Samples[i].Time, 1e-9);
            Assert.True(walk.Samples[1].Speed > 0, "the key acts in the first quantum");
            Assert.True(walk.Samples[10].Speed > 0, "the key is held");
            Assert.Equal(0, walk.Samples[11].Speed, 1e-6);
        }
    }

    [Fact, Behaviour("tool.walk.times-of-the-page", "design.md, The tool")]
    public void With_the_pages_quantum_a_leg_written_with_three_digits_has_the_length_that_was_meant()
    {
        // 0.605 s are 310 units of 1/512 s, whose charge is 310/512; 0.039 s are 20 units, past the first quantum of 18.
        WalkLeg[] legs = [new(MovementKeys.Jump, 0.605), new(MovementKeys.None, 0.039)];
        WalkResult walk = Walk(legs, 18.0 / 512);
        Assert.Single(walk.Events, one => one.What.StartsWith("sends Jump: extent 0.605,", StringComparison.Ordinal));
        Assert.Equal((310.0 + 20) / 512, walk.Samples[^1].Time, 18.0 / 512);
        Assert.All(walk.Samples, (one, i) => Assert.Equal(i * 18.0 / 512, one.Time));
    }

    [Fact, Behaviour("tool.walk.auto-runs", "spec/09b, 9")]
    public void Auto_runs_ahead_without_a_key()
    {
        WalkResult byKey = Walk([new(MovementKeys.Forward, 0.5)], 0.05), alone = Walk([new(MovementKeys.None, 0.5, AutoRun: true)], 0.05);
        Assert.True(WayEast(alone) > 3);
        Assert.Equal(WayEast(byKey), WayEast(alone));
    }

    [Fact, Behaviour("tool.walk.quantum-leaves-the-way", "spec/01, 6")]
    public void Over_level_ground_the_way_is_the_same_whatever_the_quanta()
    {
        // Run skill 300 without burden plays the run of 4 m/s, 30 frames a second, at 2.65 times its speed: 31 whole frames in 0.4 s.
        const double Way = 31 * 4.0 / 30;
        Assert.Equal(Way, WayEast(Walk(RunThenStand, 0.04)), 0.0001);
        Assert.Equal(Way, WayEast(Walk(RunThenStand, 0.1)), 0.0001);
    }

    [Fact, Behaviour("tool.walk.quantum-charges-for-a-legs-time", "spec/09b, 10")]
    public void A_jump_is_charged_for_the_time_of_its_leg()
    {
        const MovementKeys Charging = MovementKeys.Jump | MovementKeys.Forward;
        WalkLeg[] legs = [new(MovementKeys.Forward, 0.5), new(Charging, 0.615), new(MovementKeys.None, 0.2)];
        WalkResult walk = Walk(legs, 0.05);
        Assert.Single(walk.Events, one => one.What.StartsWith("sends Jump: extent 0.615,", StringComparison.Ordinal));
    }

    private static double WayEast(WalkResult walk) => walk.Samples[^1].Local.X - walk.Samples[0].Local.X;

    private static WalkResult Walk(IReadOnlyList<WalkLeg> legs, double quantum)
    {
        using WalkScene scene = WalkScene.Open(null);
        return WalkRunner.Run(scene, scene.FindPlace("runway"), new CharacterStats(300, 250), legs, "", 0, quantum);
    }
}
