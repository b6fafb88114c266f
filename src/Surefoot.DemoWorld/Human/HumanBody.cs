using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

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
    private static IEnumerable<DatRecord> Shapes() =>
    [
        Drawn(Hips, (new(-0.17, -0.1, -0.08, 0.17, 0.1, 0.14), Surfaces.Trousers)),
        Drawn(Chest, (new(-0.2, -0.12, 0, 0.2, 0.12, 0.42), Surfaces.Shirt), (new(-0.06, -0.06, 0.42, 0.06, 0.06, 0.5), Surfaces.Skin)),
        Drawn(
            Head,
            (new(-0.1, -0.11, 0, 0.1, 0.12, 0.21), Surfaces.Skin),
            (new(-0.02, 0.12, 0.07, 0.02, 0.155, 0.12), Surfaces.Skin),
            (new(-0.11, -0.13, 0.1, 0.11, 0.06, 0.29), Surfaces.Hair)),
        Drawn(UpperArm, (new(-0.055, -0.06, -0.31, 0.055, 0.06, 0.05), Surfaces.Shirt)),
        Drawn(Forearm, (new(-0.045, -0.05, -0.27, 0.045, 0.05, 0), Surfaces.Shirt),
            (new(-0.04, -0.05, -0.42, 0.04, 0.05, -0.27), Surfaces.Skin)),
        Drawn(Thigh, (new(-0.08, -0.09, -0.46, 0.08, 0.09, 0.03), Surfaces.Trousers)),
        Drawn(Shin, (new(-0.07, -0.08, -0.34, 0.07, 0.07, 0), Surfaces.Trousers),
            (new(-0.07, -0.1, -0.48, 0.07, 0.17, -0.34), Surfaces.Boots)),
    ];

    private static GfxObj Drawn(uint id, params ReadOnlySpan<(Box Box, uint Surface)> boxes)
    {
        var grid = new BoxGrid();
        foreach (var (box, surface) in boxes)
            grid.Fill(box, surface);
        return Meshes.Drawn(id, grid.Faces());
    }
}
