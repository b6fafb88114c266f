using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>An arrow, which points along +y from its middle, and the target it is shot at, which stands on z = 0.</summary>
internal static class Arrow
{
    /// <summary>A round of straw on a frame, met from -y.</summary>
    public const uint Target = 0x010001A1;

    private const uint Shape = 0x010001A0;

    /// <summary>Shapes and setup.</summary>
    public static IEnumerable<DatRecord> All() =>
    [
        Meshes.Drawn(Shape, new BoxGrid()
            .Fill(new(-0.012, -0.35, -0.012, 0.012, 0.3, 0.012), Surfaces.Timber)
            .Fill(new(-0.02, 0.3, -0.02, 0.02, 0.38, 0.02), Surfaces.DarkStone)
            .Fill(new(-0.004, -0.38, -0.05, 0.004, -0.24, 0.05), Surfaces.Plaster).Faces()),
        Meshes.Solid(Target, new BoxGrid()
            .Fill(new(-0.75, 0, 0.3, 0.75, 0.3, 1.9), Surfaces.Sandstone)
            .Fill(new(-0.25, -0.02, 0.85, 0.25, 0, 1.35), Surfaces.WarningRed)
            .Fill(new(-0.7, 0.1, 0, -0.5, 0.3, 0.3), Surfaces.Timber)
            .Fill(new(0.5, 0.1, 0, 0.7, 0.3, 0.3), Surfaces.Timber).Faces()),
        new Setup
        {
            Id = DemoIds.ArrowSetup,
            PartIds = [Shape],
            PlacementFrames = [new(0, new([DatFrame.Identity]))],
            Spheres = [new(new(0, 0, 0), 0.1f)],
            Height = 0.1f,
            Radius = 0.1f,
            SortingSphere = new(new(0, 0, 0), 0.4f),
            SelectionSphere = new(new(0, 0, 0), 0.4f),
        },
    ];
}
