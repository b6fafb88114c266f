using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;

namespace Surefoot.DemoWorld.Human;

/// <summary>The human's setup and the shapes of its parts.</summary>
internal static class HumanBody
{
    private const uint Hips = 0x01000001, Chest = 0x01000002, Head = 0x01000003, UpperArm = 0x01000004,
        Forearm = 0x01000005, Thigh = 0x01000006, Shin = 0x01000007;

    /// <summary>Setup and shapes.</summary>
    public static IEnumerable<DatRecord> All() => [Setup(), .. Shapes()];

    private static Setup Setup() => new()
    {
        Id = DemoIds.HumanSetup,
        Flags = SetupFlags.HasParents | SetupFlags.AllowFreeHeading,
        PartIds = [Hips, Chest, Head, UpperArm, Forearm, UpperArm, Forearm, Thigh, Shin, Thigh, Shin],
        ParentParts = [Dats.Records.Setup.NoParent, 0, 1, 1, 3, 1, 5, 0, 7, 0, 9],
        PlacementFrames = [new(0, HumanPoses.Ready(0).ToFrame())],
        Spheres = [new(new(0, 0, 0.475f), 0.48f), new(new(0, 0, 1.35f), 0.48f)],
        Height = 1.835f,
        Radius = 0.6788225f,
        StepUpHeight = 0.6f,
        StepDownHeight = 1.5f,
        SortingSphere = new(new(0, 0, 0.9f), 1.1f),
        SelectionSphere = new(new(0, 0, 0.9f), 0.9f),
        DefaultMotionTableId = DemoIds.HumanMotionTable,
    };

    // Boxes about the joint that each part turns around.
    private static IEnumerable<DatRecord> Shapes()
    {
        yield return new ShapeBuilder()
            .Box(new(-0.17f, -0.1f, -0.08f), new(0.17f, 0.1f, 0.14f), DemoIds.Trousers)
            .Build(Hips);
        yield return new ShapeBuilder()
            .Box(new(-0.2f, -0.12f, 0f), new(0.2f, 0.12f, 0.42f), DemoIds.Shirt)
            .Box(new(-0.06f, -0.06f, 0.42f), new(0.06f, 0.06f, 0.5f), DemoIds.Skin)
            .Build(Chest);
        yield return new ShapeBuilder()
            .Box(new(-0.1f, -0.11f, 0f), new(0.1f, 0.12f, 0.21f), DemoIds.Skin)
            .Box(new(-0.02f, 0.12f, 0.07f), new(0.02f, 0.155f, 0.12f), DemoIds.Skin)
            .Box(new(-0.11f, -0.13f, 0.1f), new(0.11f, 0.06f, 0.29f), DemoIds.Hair)
            .Build(Head);
        yield return new ShapeBuilder()
            .Box(new(-0.055f, -0.06f, -0.31f), new(0.055f, 0.06f, 0.05f), DemoIds.Shirt)
            .Build(UpperArm);
        yield return new ShapeBuilder()
            .Box(new(-0.045f, -0.05f, -0.27f), new(0.045f, 0.05f, 0f), DemoIds.Shirt)
            .Box(new(-0.04f, -0.05f, -0.42f), new(0.04f, 0.05f, -0.27f), DemoIds.Skin)
            .Build(Forearm);
        yield return new ShapeBuilder()
            .Box(new(-0.08f, -0.09f, -0.46f), new(0.08f, 0.09f, 0.03f), DemoIds.Trousers)
            .Build(Thigh);
        yield return new ShapeBuilder()
            .Box(new(-0.07f, -0.08f, -0.34f), new(0.07f, 0.07f, 0f), DemoIds.Trousers)
            .Box(new(-0.07f, -0.1f, -0.48f), new(0.07f, 0.17f, -0.34f), DemoIds.Boots)
            .Build(Shin);
    }
}
