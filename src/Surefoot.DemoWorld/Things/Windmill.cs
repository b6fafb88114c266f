using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>
/// A windmill on z = 0, met from -y: a tower with a passage through its foot, and four sails before it that its setup's default animation
/// turns for ever, so low that they sweep through whoever stands in the way.
/// </summary>
internal static class Windmill
{
    /// <summary>The tower, which stands still.</summary>
    public const uint Tower = 0x01000180;

    private const uint Sails = 0x01000181, Turning = 0x03000180;

    /// <summary>A quarter of a turn, after which four sails look as before: 12 s for a whole one.</summary>
    private const int Frames = 90;

    /// <summary>Where the sails turn, metres.</summary>
    private const double HubBefore = -1.9, HubHeight = 4.4, SailLength = 4.1;

    /// <summary>Shapes, setup and animation.</summary>
    public static IEnumerable<DatRecord> All()
    {
        AnimFrame[] frames = [.. Enumerable.Range(0, Frames).Select(FrameAt)];
        return
        [
            Meshes.Solid(Tower, new BoxGrid()
                .Fill(new(-1.6, -1.6, -0.3, 1.6, 1.6, 6), Surfaces.Plaster)
                .Clear(new(-1.1, -1.6, 0, 1.1, 1.6, 2.4))
                .Fill(new(-1.8, -1.8, 6, 1.8, 1.8, 6.3), Surfaces.Tiles)
                .Fill(new(-1.1, -1.1, 6.3, 1.1, 1.1, 7), Surfaces.Tiles).Faces()),
            Meshes.Solid(Sails, new BoxGrid()
                .Fill(new(-0.3, -0.08, -SailLength, 0.3, 0.08, SailLength), Surfaces.Boards)
                .Fill(new(-SailLength, -0.08, -0.3, SailLength, 0.08, 0.3), Surfaces.Boards)
                .Fill(new(-0.15, 0.08, -0.15, 0.15, 0.3, 0.15), Surfaces.Timber).Faces()),
            new Setup
            {
                Id = DemoIds.WindmillSetup,
                Flags = SetupFlags.HasPhysicsBsp,
                PartIds = [Tower, Sails],
                PlacementFrames = [new(0, frames[0])],
                Height = 7f,
                Radius = (float)SailLength,
                SortingSphere = new(new(0, 0, (float)HubHeight), 5f),
                SelectionSphere = new(new(0, 0, (float)HubHeight), 5f),
                DefaultAnimationId = Turning,
            },
            new Animation { Id = Turning, PartCount = 2, Frames = [.. frames] },
        ];
    }

    private static AnimFrame FrameAt(int degrees) => new([DatFrame.Identity, Joint.At(0, HubBefore, HubHeight).Roll(degrees).ToFrame()]);
}
