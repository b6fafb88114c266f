using System.Numerics;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

public sealed class HumanTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    private const uint NonCombat = 0x8000003D, HandCombat = 0x8000003C, Ready = 0x41000003, Wave = 0x13000087, Attack = 0x10000063;

    private MotionTable Table => world.Dats.Read<MotionTable>(DemoIds.HumanMotionTable);

    [Fact, Behaviour("demo-world.human.collides-by-two-spheres", "spec/03, sphere path")]
    public void A_human_has_two_spheres_and_retail_step_heights()
    {
        var setup = world.Dats.Read<Setup>(DemoIds.HumanSetup);
        Assert.Equal([new DatSphere(new(0, 0, 0.475f), 0.48f), new DatSphere(new(0, 0, 1.35f), 0.48f)], setup.Spheres);
        Assert.Empty(setup.CylSpheres);
        Assert.Equal((0.6f, 1.5f), (setup.StepUpHeight, setup.StepDownHeight));
        Assert.Equal(DemoIds.HumanMotionTable, setup.DefaultMotionTableId);
        Assert.False(setup.Flags.HasFlag(SetupFlags.HasPhysicsBsp));
        Assert.All(setup.PartIds, id => Assert.Null(world.Dats.Read<GfxObj>(id).PhysicsTree));
    }

    [Theory]
    [InlineData(0x41000003, 0f, 0f, 0f)]
    [InlineData(0x45000005, 0f, 3.12f, 0f)]
    [InlineData(0x44000007, 0f, 4f, 0f)]
    [InlineData(0x6500000F, 1.25f, 0f, 0f)]
    [InlineData(0x6500000D, 0f, 0f, -1.5f)]
    [InlineData(0x40000015, 0f, 0f, 0f)]
    [Behaviour("demo-world.human.moves-at-retail-speeds", "spec/01, 3 and 4.11")]
    public void A_cycle_has_the_velocity_of_retail(uint motion, float x, float y, float turn)
    {
        foreach (uint style in new[] { NonCombat, HandCombat })
        {
            var data = Cycle(motion, style);
            Assert.Equal(new Vector3(x, y, 0), data.Velocity);
            Assert.Equal(new Vector3(0, 0, turn), data.Omega);
            var animation = Assert.Single(data.Animations);
            Assert.Equal(30f, animation.FramesPerSecond);
            Assert.Equal((0, -1), (animation.LowFrame, animation.HighFrame));
        }
    }

    [Fact, Behaviour("demo-world.human.turns-and-sidesteps-while-moving", "spec/01b, 2")]
    public void Turning_and_sidestepping_are_cycles_from_ready_and_modifiers_otherwise()
    {
        foreach (uint style in new[] { NonCombat, HandCombat })
        {
            foreach (uint motion in new[] { 0x6500000Du, 0x6500000Fu })
            {
                Assert.Equal(2, Cycle(motion, style).Bitfield);
                var modifier = Assert.Single(Table.Modifiers, entry => entry.Key == MotionTable.KeyOf(style, motion)).Data;
                Assert.Equal((Cycle(motion).Velocity, Cycle(motion).Omega), (modifier.Velocity, modifier.Omega));
                Assert.Empty(modifier.Animations);
            }

            // Rule 4 takes modifiers only on cycles without bit 1, and rule 2 makes a turn the substate of who stops running only where
            // the turn was not taken off.
            foreach (uint motion in new[] { 0x41000003u, 0x45000005u, 0x44000007u, 0x40000015u, 0x6500000Du, 0x6500000Fu })
                Assert.Equal(0, Cycle(motion, style).Bitfield & 1);
        }
    }

    [Fact, Behaviour("demo-world.human.has-every-substate", "spec/01, 2.1")]
    public void Every_locomotion_substate_has_a_cycle_and_left_and_backward_have_none()
    {
        uint[] motions =
        [
            0x41000003u, 0x45000005u, 0x44000007u, 0x40000008u, 0x40000011u, 0x40000015u, 0x41000012u, 0x41000013u, 0x41000014u,
        ];
        foreach (uint motion in motions)
            Assert.NotEmpty(Cycle(motion).Animations);
        foreach (uint motion in new[] { 0x45000006u, 0x6500000Eu, 0x65000010u })
            Assert.DoesNotContain(Table.Cycles.Concat(Table.Modifiers), entry => entry.Key == MotionTable.KeyOf(NonCombat, motion));
        Assert.Equal(NonCombat, Table.DefaultStyle);
        Assert.Equal([new MotionStyle(NonCombat, Ready), new MotionStyle(HandCombat, Ready)], Table.Styles);
    }

    [Fact, Behaviour("demo-world.human.links-are-short", "spec/01b, 2")]
    public void Links_between_gaits_play_at_30_frames_a_second_and_end_within_a_fifth_of_a_second()
    {
        uint[] gaits = [0x41000003, 0x45000005, 0x44000007];
        uint[] keys = [.. gaits.SelectMany(gait => new[] { MotionTable.KeyOf(NonCombat, gait), MotionTable.KeyOf(HandCombat, gait) })];
        Assert.All(keys, key => Assert.Contains(Table.Links, link => link.Key == key));
        foreach (var link in Table.Links.Where(link => keys.Contains(link.Key)))
        {
            foreach (var target in link.Targets.Where(target => gaits.Contains(target.Key)))
            {
                var animation = Assert.Single(target.Data.Animations);
                Assert.Equal(30f, animation.FramesPerSecond);
                Assert.InRange(world.Dats.Read<Animation>(animation.AnimationId).Frames.Length, 1, 6);
                Assert.Equal((Vector3.Zero, Vector3.Zero), (target.Data.Velocity, target.Data.Omega));
            }
        }
    }

    [Fact, Behaviour("demo-world.human.parts-fit-the-body", "spec/07, 7.6 and 7.7")]
    public void Poses_have_a_valid_frame_for_each_part_and_feet_stay_near_the_ground()
    {
        int parts = world.Dats.Read<Setup>(DemoIds.HumanSetup).PartIds.Length;
        var entries = Table.Cycles.Concat(Table.Links.SelectMany(link => link.Targets));
        foreach (uint id in entries.SelectMany(entry => entry.Data.Animations).Select(play => play.AnimationId).Distinct())
        {
            var animation = world.Dats.Read<Animation>(id);
            Assert.Equal((uint)parts, animation.PartCount);
            Assert.Empty(animation.RootMotion);
            foreach (var frame in animation.Frames.SelectMany(frame => frame.Parts))
            {
                Assert.InRange(frame.Rotation.LengthSquared(), 0.9999f, 1.0001f);
                Assert.InRange(frame.Origin.Z, -0.1f, 1.8f);
                Assert.InRange(frame.Origin.X, -1.2f, 1.2f);
            }
        }
    }

    [Fact, Behaviour("demo-world.human.stance-with-links", "spec/01b, 2, rule 1: the links of a style")]
    public void Fists_go_up_and_down_over_links_and_strike_and_wave_are_actions_from_standing()
    {
        Assert.NotEmpty(Link(NonCombat, Ready, HandCombat).Animations);
        Assert.NotEmpty(Link(HandCombat, Ready, NonCombat).Animations);
        Assert.NotEmpty(Link(HandCombat, Ready, Attack).Animations);
        Assert.NotEmpty(Link(NonCombat, Ready, Wave).Animations);
        Assert.DoesNotContain(Table.Links, link => link.Key == MotionTable.KeyOf(HandCombat, Ready) &&
            link.Targets.Any(target => target.Key == Wave));
    }

    [Fact, Behaviour("demo-world.human.waves-with-the-right", "spec/07, 7.7: part frames")]
    public void In_the_middle_of_a_wave_the_right_hand_is_over_the_head_and_goes_from_side_to_side()
    {
        var frames = world.Dats.Read<Animation>(Assert.Single(Link(NonCombat, Ready, Wave).Animations).AnimationId).Frames;
        const int head = 2, rightForearm = 4;
        Vector3[] hand = [.. frames[12..38].Select(frame => frame.Parts[rightForearm])
            .Select(part => part.Origin + Vector3.Transform(new(0, 0, -0.42f), part.Rotation))];
        Assert.All(hand, at => Assert.True(at.Z > frames[12].Parts[head].Origin.Z + 0.1f, $"the hand is at {at}"));
        Assert.True(hand.Max(at => at.X) - hand.Min(at => at.X) > 0.2f);
    }

    [Fact, Behaviour("demo-world.human.postures-are-low", "spec/07, 7.7: part frames")]
    public void Who_crouches_sits_or_sleeps_is_lower_than_who_stands_and_breathes()
    {
        float standing = HeadOf(Ready).Max();
        (uint Posture, float Share)[] postures = [(0x41000012, 0.8f), (0x41000013, 0.6f), (0x41000014, 0.3f)];
        foreach (var (posture, share) in postures)
        {
            float[] heads = HeadOf(posture);
            Assert.InRange(heads.Max(), 0, share * standing);
            Assert.True(heads.Length > 30 && heads.Distinct().Count() > 10);
        }

        float[] HeadOf(uint motion)
            => [.. world.Dats.Read<Animation>(Cycle(motion).Animations[0].AnimationId).Frames.Select(frame => frame.Parts[2].Origin.Z)];
    }

    private MotionData Cycle(uint motion, uint style = NonCombat)
        => Assert.Single(Table.Cycles, entry => entry.Key == MotionTable.KeyOf(style, motion)).Data;

    private MotionData Link(uint style, uint from, uint to)
    {
        var links = Assert.Single(Table.Links, link => link.Key == MotionTable.KeyOf(style, from));
        return Assert.Single(links.Targets, target => target.Key == to).Data;
    }
}
