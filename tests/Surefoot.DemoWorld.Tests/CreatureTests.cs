using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

/// <summary>The creatures as the files have them: shapes, setups, motion tables and animations of their own.</summary>
public sealed class CreatureTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    private const uint NonCombat = 0x8000003D, Ready = 0x41000003, Walk = 0x45000005, Run = 0x44000007;

    // Parts: body, head, tail, then upper and lower of front right, front left, hind right, hind left.
    private const int Parts = 11, HindRightLower = 8, HindLeftLower = 10, FrontRightLower = 4, FrontLeftLower = 6;

    [Theory, Behaviour("demo-world.creatures.tables-of-their-own", "spec/07, 7.9")]
    [InlineData(DemoIds.SmallCreatureSetup, DemoIds.CreatureMotionTable)]
    [InlineData(DemoIds.LargeCreatureSetup, DemoIds.HeavyCreatureMotionTable)]
    public void Each_creature_has_a_table_whose_animations_fit_its_parts(uint setupId, uint tableId)
    {
        var setup = world.Dats.Read<Setup>(setupId);
        Assert.Equal((tableId, Parts), (setup.DefaultMotionTableId, setup.PartIds.Length));
        Assert.Equal(Parts, setup.PlacementFrames[0].Frame.Parts.Length);
        Assert.All(setup.PartIds, id => Assert.Null(world.Dats.Read<GfxObj>(id).PhysicsTree));
        var table = world.Dats.Read<MotionTable>(tableId);
        Assert.Equal([new MotionStyle(NonCombat, Ready)], table.Styles);
        foreach (var motion in table.Cycles.Concat(table.Links.SelectMany(link => link.Targets)))
        {
            var animation = world.Dats.Read<Animation>(Assert.Single(motion.Data.Animations).AnimationId);
            Assert.Equal((uint)Parts, animation.PartCount);
            Assert.All(animation.Frames.SelectMany(frame => frame.Parts),
                part => Assert.InRange(part.Rotation.LengthSquared(), 0.9999f, 1.0001f));
        }
    }

    [Theory, Behaviour("demo-world.creatures.collide-as-before", "spec/06, 2")]
    [InlineData(DemoIds.SmallCreatureSetup, 0, 0.3f, 0.8f)]
    [InlineData(DemoIds.LargeCreatureSetup, 1, 0.8f, 2.2f)]
    public void A_creature_moves_by_two_spheres_and_the_large_one_is_met_by_a_cylinder(uint id, int cylinders, float radius, float height)
    {
        var setup = world.Dats.Read<Setup>(id);
        Assert.Equal((2, cylinders), (setup.Spheres.Length, setup.CylSpheres.Length));
        Assert.All(setup.Spheres, sphere => Assert.Equal(radius, sphere.Radius));
        Assert.Equal((radius, height), (setup.Radius, setup.Height));
    }

    [Theory, Behaviour("demo-world.creatures.legs-move", "spec/07, 7.7: part frames")]
    [InlineData(DemoIds.SmallCreatureSetup, Walk, 0.18f, 0.12f)]
    [InlineData(DemoIds.SmallCreatureSetup, Run, 0.18f, 0.2f)]
    [InlineData(DemoIds.LargeCreatureSetup, Walk, 0.5f, 0.4f)]
    [InlineData(DemoIds.LargeCreatureSetup, Run, 0.5f, 0.6f)]
    public void Its_legs_swing_as_it_goes_and_its_feet_stay_near_the_ground(uint setupId, uint motion, float shin, float reach)
    {
        Animation gait = Cycle(setupId, motion);
        int[] feet = setupId == DemoIds.SmallCreatureSetup
            ? [FrontRightLower, FrontLeftLower, HindRightLower, HindLeftLower]
            : [HindRightLower, HindLeftLower];
        foreach (int foot in feet)
        {
            Vector3[] way = [.. gait.Frames.Select(frame => SoleOf(frame.Parts[foot], shin))];
            float swing = way.Max(at => at.Y) - way.Min(at => at.Y);
            Assert.True(swing > reach, $"foot {foot} swings {swing} m");
            Assert.InRange(way.Min(at => at.Z), -0.35f * shin, 0.35f * shin);
        }

        // What is right and what is left are not lifted at the same time.
        int highestRight = HighestOf(HindRightLower), highestLeft = HighestOf(HindLeftLower);
        Assert.NotEqual(highestRight, highestLeft);

        int HighestOf(int foot) => Enumerable.Range(0, gait.Frames.Length).MaxBy(i => SoleOf(gait.Frames[i].Parts[foot], shin).Z);
    }

    [Theory, Behaviour("demo-world.creatures.stand-on-their-feet", "spec/07, 7.7")]
    [InlineData(DemoIds.SmallCreatureSetup, 0.18f)]
    [InlineData(DemoIds.LargeCreatureSetup, 0.5f)]
    public void A_creature_that_stands_has_its_feet_on_the_ground(uint setupId, float shin)
    {
        foreach (var frame in Cycle(setupId, Ready).Frames)
        {
            Assert.InRange(SoleOf(frame.Parts[HindRightLower], shin).Z, -0.04f, 0.04f);
            Assert.InRange(SoleOf(frame.Parts[HindLeftLower], shin).Z, -0.04f, 0.04f);
        }
    }

    [Fact, Behaviour("demo-world.creatures.the-heavy-one-is-slow", "spec/01b, 4")]
    public void The_heavy_creature_is_slower_than_the_quick_one_in_everything()
    {
        foreach (uint motion in new[] { Walk, Run, 0x6500000Du })
        {
            MotionData quick = Data(DemoIds.SmallCreatureSetup, motion), heavy = Data(DemoIds.LargeCreatureSetup, motion);
            Assert.InRange(heavy.Velocity.Length() + heavy.Omega.Length(), 0.1f, 0.7f * (quick.Velocity.Length() + quick.Omega.Length()));
        }
    }

    private static Vector3 SoleOf(DatFrame part, float shin) => part.Origin + Vector3.Transform(new(0, 0, -shin), part.Rotation);

    private MotionData Data(uint setupId, uint motion)
    {
        var table = world.Dats.Read<MotionTable>(world.Dats.Read<Setup>(setupId).DefaultMotionTableId);
        return Assert.Single(table.Cycles, entry => entry.Key == MotionTable.KeyOf(NonCombat, motion)).Data;
    }

    private Animation Cycle(uint setupId, uint motion)
        => world.Dats.Read<Animation>(Assert.Single(Data(setupId, motion).Animations).AnimationId);
}
