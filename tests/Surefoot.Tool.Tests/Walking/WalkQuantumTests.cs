using Surefoot.Client;
using Surefoot.Physics.Motion;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Tests.Walking;

public class WalkQuantumTests
{
    private static readonly WalkLeg[] RunThenStand = [new(MovementKeys.Forward, 0.4), new(MovementKeys.None, 0.1)];

    [Fact, Behaviour("tool.walk.quantum-divides-legs", "design.md, The tool")]
    public void Legs_take_exactly_their_time_in_quanta_as_near_as_may_be_to_those_asked_for()
    {
        WalkResult walk = Walk(RunThenStand, 0.04);
        double[] expected = [0, .. Enumerable.Range(1, 10).Select(i => i * 0.04), 0.45, 0.5];
        Assert.Equal(expected.Length, walk.Samples.Count);
        for (int i = 0; i < expected.Length; i++) Assert.Equal(expected[i], walk.Samples[i].Time, 1e-9);
        Assert.True(walk.Samples[1].Speed > 0, "the key acts in the first quantum");
        Assert.Equal(0, walk.Samples[11].Speed, 1e-6);
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
