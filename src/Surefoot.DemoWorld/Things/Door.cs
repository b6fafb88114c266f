using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>A door that fills a house's doorway.</summary>
internal static class Door
{
    private const uint Shape = 0x01000172;

    /// <summary>Shape and setup.</summary>
    public static IEnumerable<DatRecord> All() =>
    [
        Meshes.Solid(Shape, new BoxGrid().Fill(new(-0.6, -0.06, 0, 0.6, 0.06, 2.2), Surfaces.Timber).Faces()),
        new Setup
        {
            Id = DemoIds.DoorSetup,
            Flags = SetupFlags.HasPhysicsBsp,
            PartIds = [Shape],
            PlacementFrames = [new(0, new([DatFrame.Identity]))],
            Height = 2.2f,
            Radius = 1.3f,
            SortingSphere = new(new(0, 0, 1.1f), 1.3f),
            SelectionSphere = new(new(0, 0, 1.1f), 1.3f),
        },
    ];
}
