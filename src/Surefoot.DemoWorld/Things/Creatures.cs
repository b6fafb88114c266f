using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Human;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>Creatures of one part with a motion table of their own, and a door.</summary>
internal static class Creatures
{
    private const uint SmallShape = 0x01000170, LargeShape = 0x01000171, DoorShape = 0x01000172;
    private const uint FirstAnimation = 0x03000101;
    private const uint NonCombat = 0x8000003D;

    /// <summary>Shapes, setups, animations and the motion table.</summary>
    public static IEnumerable<DatRecord> All()
    {
        List<Animation> animations = [];
        var table = Table(animations);
        return
        [
            Meshes.Drawn(SmallShape, new BoxGrid()
                .Fill(new(-0.25, -0.4, 0.1, 0.25, 0.3, 0.6), Surfaces.Hide)
                .Fill(new(-0.15, 0.3, 0.35, 0.15, 0.6, 0.7), Surfaces.Hide).Faces()),
            Meshes.Drawn(LargeShape, new BoxGrid()
                .Fill(new(-0.6, -0.7, 0.1, 0.6, 0.5, 1.5), Surfaces.Scales)
                .Fill(new(-0.35, 0.3, 1.3, 0.35, 1, 2), Surfaces.Scales).Faces()),
            Meshes.Solid(DoorShape, new BoxGrid().Fill(new(-0.6, -0.06, 0, 0.6, 0.06, 2.2), Surfaces.Timber).Faces()),
            Creature(DemoIds.SmallCreatureSetup, SmallShape, 0.8f, 0.3f, [new(new(0, 0, 0.3f), 0.3f), new(new(0, 0, 0.55f), 0.3f)], []),
            // Others meet its cylinder; it moves by its spheres, without which a body stays where it is.
            Creature(DemoIds.LargeCreatureSetup, LargeShape, 2.2f, 0.8f, [new(new(0, 0, 0.8f), 0.8f), new(new(0, 0, 1.4f), 0.8f)],
                [new(Vector3.Zero, 0.8f, 2.2f)]),
            new Setup
            {
                Id = DemoIds.DoorSetup,
                Flags = SetupFlags.HasPhysicsBsp,
                PartIds = [DoorShape],
                PlacementFrames = [new(0, new([DatFrame.Identity]))],
                Height = 2.2f,
                Radius = 1.3f,
                SortingSphere = new(new(0, 0, 1.1f), 1.3f),
                SelectionSphere = new(new(0, 0, 1.1f), 1.3f),
            },
            table,
            .. animations,
        ];
    }
    private static Setup Creature(
        uint id, uint shape, float height, float radius, ImmutableArray<DatSphere> spheres, ImmutableArray<DatCylSphere> cylinders) =>
        new()
        {
            Id = id,
            PartIds = [shape],
            PlacementFrames = [new(0, new([DatFrame.Identity]))],
            Spheres = spheres,
            CylSpheres = cylinders,
            Height = height,
            Radius = radius,
            StepUpHeight = 0.4f,
            StepDownHeight = 0.6f,
            SortingSphere = new(new(0, 0, height / 2), (height / 2) + radius),
            SelectionSphere = new(new(0, 0, height / 2), height / 2),
            DefaultMotionTableId = DemoIds.CreatureMotionTable,
        };

    // The same motions and rules as the human's table (see HumanMotions); one part that bobs.
    private static MotionTable Table(List<Animation> animations)
    {
        KeyedMotion Cycle(uint motion, byte bitfield, int frames, double bob, Vector3 velocity = default, Vector3 omega = default)
            => new(MotionTable.KeyOf(NonCombat, motion), Data(bitfield, Bobbing(animations, frames, bob), velocity, omega));
        KeyedMotion Modifier(uint motion, Vector3 velocity = default, Vector3 omega = default)
            => new(MotionTable.KeyOf(NonCombat, motion), Data(0, null, velocity, omega));
        return new()
        {
            Id = DemoIds.CreatureMotionTable,
            DefaultStyle = NonCombat,
            Styles = [new(NonCombat, 0x41000003)],
            Cycles =
            [
                Cycle(0x41000003, 1, 40, 0.02),
                Cycle(0x45000005, 0, 16, 0.05, velocity: new(0, 1.5f, 0)),
                Cycle(0x44000007, 0, 12, 0.1, velocity: new(0, 3f, 0)),
                Cycle(0x40000011, 1, 1, 0),
                Cycle(0x40000015, 0, 10, 0.03),
                Cycle(0x6500000D, 2, 12, 0.03, omega: new(0, 0, -1.5f)),
                Cycle(0x6500000F, 2, 12, 0.04, velocity: new(0.8f, 0, 0)),
            ],
            Modifiers = [Modifier(0x6500000D, omega: new(0, 0, -1.5f)), Modifier(0x6500000F, velocity: new(0.8f, 0, 0))],
        };
    }

    private static MotionData Data(byte bitfield, uint? animation, Vector3 velocity, Vector3 omega) => new()
    {
        Bitfield = bitfield,
        Flags = (velocity != default ? MotionDataFlags.HasVelocity : 0) | (omega != default ? MotionDataFlags.HasOmega : 0),
        Animations = animation is { } id ? [new(id, 0, -1, 30f)] : [],
        Velocity = velocity,
        Omega = omega,
    };

    private static uint Bobbing(List<Animation> animations, int frames, double height)
    {
        uint id = FirstAnimation + (uint)animations.Count;
        animations.Add(new()
        {
            Id = id,
            PartCount = 1,
            Frames = [
                .. Enumerable.Range(0, frames)
                    .Select(i => new AnimFrame([Joint.At(0, 0, height * (1 - Math.Cos(2 * Math.PI * i / frames))).ToFrame()]))],
        });
        return id;
    }
}
