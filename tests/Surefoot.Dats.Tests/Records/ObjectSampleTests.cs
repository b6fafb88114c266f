using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Setups, animations and motion tables parse to the values that come with the samples.</summary>
public sealed class ObjectSampleTests
{
    private static readonly Quaternion QuarterTurn = new(0, 0, 0.70710677f, 0.70710677f);

    [Fact]
    [Behaviour("dats.sample.setup", "data/dat-samples/README.md; spec/07, section 7")]
    public void Slab_setup()
    {
        var setup = TestData.Sample<Setup>("setup-02000010");

        Assert.Equal(SetupFlags.HasPhysicsBsp, setup.Flags);
        Assert.Equal([0x01000010u], setup.PartIds);
        PlacementFrame placement = Assert.Single(setup.PlacementFrames);
        Assert.Equal(0u, placement.Placement);
        Assert.Equal([DatFrame.Identity], placement.Frame.Parts);
        Assert.Empty(placement.Frame.Hooks);
        Assert.Empty(setup.CylSpheres);
        Assert.Empty(setup.Spheres);
        Assert.Empty(setup.Lights);
        Assert.Equal((0f, 1.5f, 0f, 0f), (setup.Height, setup.Radius, setup.StepUpHeight, setup.StepDownHeight));
        Assert.Equal(new DatSphere(Vector3.Zero, 1.5f), setup.SortingSphere);
        Assert.Equal(new DatSphere(Vector3.Zero, 1.5f), setup.SelectionSphere);
        Assert.Equal((0u, 0u, 0u), (setup.DefaultAnimationId, setup.DefaultScriptId, setup.DefaultMotionTableId));
        Assert.Equal((0u, 0u), (setup.DefaultSoundTableId, setup.DefaultScriptTableId));
    }

    [Fact]
    [Behaviour("dats.sample.setup-body", "data/dat-samples/README.md; spec/07, section 7")]
    public void Body_setup()
    {
        var setup = TestData.Sample<Setup>("setup-02000001");

        Assert.Equal(SetupFlags.HasParents | SetupFlags.HasScales | SetupFlags.AllowFreeHeading, setup.Flags);
        Assert.Equal([0x01000011u, 0x01000011u], setup.PartIds);
        Assert.Equal([Setup.NoParent, 0u], setup.ParentParts);
        Assert.Equal([Vector3.One, new Vector3(0.5f, 0.5f, 2)], setup.DefaultScales);
        Assert.Equal([new SetupLocation(1, 1, new(new(0.1f, 0.2f, 0.3f), QuarterTurn))], setup.HoldingLocations);
        Assert.Equal([new SetupLocation(3, 0, new(new(0, -0.25f, 1), Quaternion.Identity))], setup.ConnectionPoints);
        Assert.Equal([0u, 0x65u], setup.PlacementFrames.Select(p => p.Placement));
        Assert.Equal([Vector3.Zero, Vector3.UnitZ], setup.PlacementFrames[0].Frame.Parts.Select(p => p.Origin));
        Assert.Equal([Vector3.Zero, new(0, 0, 0.5f)], setup.PlacementFrames[1].Frame.Parts.Select(p => p.Origin));
        Assert.Empty(setup.PlacementFrames[0].Frame.Hooks);
        Assert.Equal([new SoundHook(0x0A000001)], setup.PlacementFrames[1].Frame.Hooks);
        Assert.Equal([new DatCylSphere(new(0, 0, 0.25f), 0.35f, 1.5f)], setup.CylSpheres);
        Assert.Equal([new DatSphere(new(0, 0, 0.475f), 0.48f), new DatSphere(new(0, 0, 1.35f), 0.48f)], setup.Spheres);
        Assert.Equal((1.835f, 0.6788225f, 0.6f, 1.5f), (setup.Height, setup.Radius, setup.StepUpHeight, setup.StepDownHeight));
        Assert.Equal(new DatSphere(new(0, 0, 0.9f), 1.1f), setup.SortingSphere);
        Assert.Equal(new DatSphere(new(0, 0, 0.9f), 0.9f), setup.SelectionSphere);
        Assert.Equal([new SetupLight(0, new(new(0, 0, 1.5f), Quaternion.Identity), new(3, 2, 1, 4), 0.5f, 6, 0)], setup.Lights);
        Assert.Equal((0x03000001u, 0x33000001u, 0x09000001u),
            (setup.DefaultAnimationId, setup.DefaultScriptId, setup.DefaultMotionTableId));
        Assert.Equal((0x20000001u, 0x34000001u), (setup.DefaultSoundTableId, setup.DefaultScriptTableId));
    }

    [Fact]
    [Behaviour("dats.sample.animation", "data/dat-samples/README.md; spec/07, section 7")]
    public void Animation_with_root_motion()
    {
        var animation = TestData.Sample<Animation>("animation-03000001");

        Assert.Equal(AnimationFlags.HasRootMotion | AnimationFlags.HasHooks, animation.Flags);
        Assert.Equal(2u, animation.PartCount);
        Assert.Equal([Vector3.Zero, new Vector3(0, 0.1f, 0)], animation.RootMotion.Select(f => f.Origin));
        Assert.Equal([0f, 1f], animation.Frames[0].Parts.Select(p => p.Origin.Z));
        Assert.Equal([0.1f, 1.1f], animation.Frames[1].Parts.Select(p => p.Origin.Z));
        Assert.Empty(animation.Frames[0].Hooks);
        Assert.Equal([new SoundHook(0x0A000001) { Direction = 1 }], animation.Frames[1].Hooks);
    }

    [Fact]
    [Behaviour("dats.sample.animation-hooks", "data/dat-samples/README.md; spec/07, section 7")]
    public void Animation_with_one_hook_of_each_type()
    {
        var animation = TestData.Sample<Animation>("animation-03000002");
        var offset = new DatFrame(new(1, 2, 3), Quaternion.Identity);

        AnimFrame frame = Assert.Single(animation.Frames);
        Assert.Equal(AnimationFlags.HasHooks, animation.Flags);
        Assert.Equal(1u, animation.PartCount);
        AnimationHook[] expected =
        [
            new SoundHook(0x0A000001),
            new SoundTableHook(0x15) { Direction = 1 },
            new AttackHook(9, -0.5f, 0.5f, 0.5f, 0.5f, 2, 1) { Direction = 1 },
            new AnimationDoneHook(),
            new EtherealHook(1) { Direction = -1 },
            new TransparentPartHook(3, 0, 1, 2),
            new LuminousHook(0, 1, 2),
            new LuminousPartHook(3, 0, 1, 2),
            new DiffuseHook(0, 1, 2),
            new DiffusePartHook(3, 0, 1, 2),
            new ScaleHook(2, 0.5f),
            new CreateParticleHook(0x32000001, 1, offset, 7),
            new DestroyParticleHook(7),
            new StopParticleHook(7),
            new NoDrawHook(1),
            new DefaultScriptHook(),
            new DefaultScriptPartHook(2),
            new CallScriptHook(0x33000001, 1.5f),
            new TransparentHook(0, 1, 2),
            new SoundTweakedHook(0x0A000002, 0.25f, 0.5f, 0.75f),
            new SetOmegaHook(new(0, 0, 1.5f)),
            new TextureVelocityHook(0.1f, 0.2f),
            new TextureVelocityPartHook(4, 0.1f, 0.2f),
            new SetLightHook(1),
        ];
        Assert.Equal(expected, frame.Hooks);
    }

    [Fact]
    [Behaviour("dats.sample.animation-contested-hooks", "data/dat-samples/README.md; spec/07, section 7")]
    public void Animation_with_the_contested_hooks_in_retail_form()
    {
        AnimFrame frame = Assert.Single(TestData.Sample<Animation>("animation-03000003").Frames);

        AnimationHook[] expected =
        [
            new ReplaceObjectHook(3, 0x01000123),
            new ReplaceObjectHook(4, 0x01005678),
            new CreateBlockingParticleHook(0x32000001, 1, new(new(1, 2, 3), Quaternion.Identity), 7),
            new SoundHook(0x0A000009),
        ];
        Assert.Equal(expected, frame.Hooks);
    }

    [Fact]
    [Behaviour("dats.sample.animation-still", "data/dat-samples/README.md; spec/07, section 7")]
    public void Still_animation()
    {
        var animation = TestData.Sample<Animation>("animation-03000010");

        Assert.Equal(AnimationFlags.None, animation.Flags);
        Assert.Equal([DatFrame.Identity], Assert.Single(animation.Frames).Parts);
        Assert.Empty(animation.RootMotion);
    }

    [Fact]
    [Behaviour("dats.sample.motion-table-one-cycle", "data/dat-samples/README.md; spec/07, section 7")]
    public void Motion_table_of_one_cycle()
    {
        var table = TestData.Sample<MotionTable>("motiontable-09000010");

        Assert.Equal(0x8000003Du, table.DefaultStyle);
        Assert.Equal([new MotionStyle(0x8000003D, 0x41000003)], table.Styles);
        KeyedMotion cycle = Assert.Single(table.Cycles);
        Assert.Equal(0x003D0003u, cycle.Key);
        Assert.Equal(MotionTable.KeyOf(0x8000003D, 0x41000003), cycle.Key);
        AssertMotion(cycle.Data, 1, new(0, 3.12f, 0), Vector3.Zero, new MotionAnimation(0x03000010, 0, -1, 30));
        Assert.Empty(table.Modifiers);
        Assert.Empty(table.Links);
    }

    [Fact]
    [Behaviour("dats.sample.motion-table", "data/dat-samples/README.md; spec/07, section 7")]
    public void Motion_table_with_cycles_modifier_and_links()
    {
        var table = TestData.Sample<MotionTable>("motiontable-09000001");
        var play = new MotionAnimation(0x03000001, 0, -1, 30);

        Assert.Equal(0x8000003Du, table.DefaultStyle);
        Assert.Equal([new MotionStyle(0x8000003D, 0x41000003)], table.Styles);
        Assert.Equal([0x003D0003u, 0x003D0005u, 0x003D0007u, 0x003D000Du], table.Cycles.Select(c => c.Key));
        AssertMotion(table.Cycles[0].Data, 1, Vector3.Zero, Vector3.Zero, play);
        AssertMotion(table.Cycles[1].Data, 1, new(0, 3.12f, 0), Vector3.Zero, play);
        AssertMotion(table.Cycles[2].Data, 1, new(0, 4, 0), Vector3.Zero, play);
        AssertMotion(table.Cycles[3].Data, 1, Vector3.Zero, new(0, 0, -1.5f), play);
        KeyedMotion modifier = Assert.Single(table.Modifiers);
        Assert.Equal(0x003D000Du, modifier.Key);
        AssertMotion(modifier.Data, 1, Vector3.Zero, new(0, 0, -1.5f));
        MotionLinks links = Assert.Single(table.Links);
        Assert.Equal(0x003D0003u, links.Key);
        Assert.Equal([0x45000005u, 0x44000007u], links.Targets.Select(t => t.Key));
        AssertMotion(links.Targets[0].Data, 0, Vector3.Zero, Vector3.Zero, play);
        AssertMotion(
            links.Targets[1].Data, 3, new(0, 1, 0), new(0, 0, 1), new MotionAnimation(0x03000001, 0, 0, 30),
            new MotionAnimation(0x03000002, 0, -1, -15));
    }

    private static void AssertMotion(MotionData data, byte bitfield, Vector3 velocity, Vector3 omega, params MotionAnimation[] animations)
    {
        Assert.Equal(bitfield, data.Bitfield);
        Assert.Equal(velocity, data.Velocity);
        Assert.Equal(omega, data.Omega);
        Assert.Equal(animations, data.Animations);
    }
}
