using System.Collections.Immutable;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Records;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Things;

/// <summary>
/// Trees and shrubs that collide by a cylinder or a sphere, rocks that collide by their shape, and the scenes that strew them.
/// </summary>
internal static class NatureShapes
{
    public const uint Rock = 0x01000160, Boulder = 0x01000161;

    private const uint TreeShape = 0x01000162, PineShape = 0x01000163, ShrubShape = 0x01000164;

    // Scenery keeps off ground that is steeper than 40 degrees.
    private const float LeastNormalZ = 0.766f;

    /// <summary>Shapes, setups and scenes.</summary>
    public static IEnumerable<DatRecord> All() =>
    [
        Meshes.Solid(Rock, Stump(6, 1.0, 0.6, 0.8)),
        Meshes.Solid(Boulder, Stump(7, 2.2, 1.4, 2.6)),
        Meshes.Drawn(TreeShape, [.. Trunk(0.22, 2.4), .. Crown(1.8, 2.2, 5.2, Surfaces.Leaves)]),
        Meshes.Drawn(PineShape, [.. Trunk(0.18, 1.4), .. Crown(1.5, 1.2, 6.6, Surfaces.Needles)]),
        Meshes.Drawn(ShrubShape, Crown(0.6, 0, 0.9, Surfaces.Leaves)),
        Standing(DemoIds.TreeSetup, TreeShape, 5.2f, cylinder: new(default, 0.35f, 4f)),
        Standing(DemoIds.PineSetup, PineShape, 6.6f, cylinder: new(default, 0.3f, 5f)),
        Standing(DemoIds.ShrubSetup, ShrubShape, 0.9f, sphere: new(new(0, 0, 0.4f), 0.5f)),
        new Scene
        {
            Id = DemoIds.WoodScene,
            Objects =
            [
                Strewn(DemoIds.TreeSetup, 0.8f, 0.8f, 1.5f), Strewn(DemoIds.PineSetup, 0.7f, 0.7f, 1.4f),
                Strewn(DemoIds.TreeSetup, 0.6f, 0.7f, 1.2f),
                Strewn(DemoIds.ShrubSetup, 0.6f, 0.7f, 1.3f), Strewn(DemoIds.PineSetup, 0.5f, 0.9f, 1.6f), Strewn(Rock, 0.15f, 0.6f, 1.4f),
            ],
        },
        new Scene
        {
            Id = DemoIds.RockScene,
            Objects = [Strewn(Boulder, 0.5f, 0.5f, 1.2f), Strewn(Rock, 0.7f, 0.6f, 1.8f), Strewn(Rock, 0.5f, 0.5f, 1.2f)],
        },
        new Scene
        {
            Id = DemoIds.ShrubScene,
            Objects = [Strewn(DemoIds.ShrubSetup, 0.5f, 0.7f, 1.6f), Strewn(DemoIds.TreeSetup, 0.12f, 0.9f, 1.6f)],
        },
    ];

    private static SceneObject Strewn(uint id, float frequency, float least, float greatest) => new()
    {
        ObjectId = id,
        BaseFrame = DatFrame.Identity,
        Frequency = frequency,
        DisplaceX = 22f,
        DisplaceY = 22f,
        MinScale = least,
        MaxScale = greatest,
        MaxRotation = 360f,
        MinSlope = LeastNormalZ,
        MaxSlope = 1f,
    };

    private static Setup Standing(uint id, uint shape, float height, DatCylSphere? cylinder = null, DatSphere? sphere = null) => new()
    {
        Id = id,
        PartIds = [shape],
        PlacementFrames = [new(0, new([DatFrame.Identity]))],
        CylSpheres = cylinder is { } upright ? [upright] : [],
        Spheres = sphere is { } round ? [round] : [],
        Height = height,
        Radius = cylinder?.Radius ?? sphere?.Radius ?? 0f,
        SortingSphere = new(new(0, 0, height / 2), (height / 2) + 0.5f),
        SelectionSphere = new(new(0, 0, height / 2), height / 2),
    };

    private static ImmutableArray<Face> Trunk(double half, double height)
        => new BoxGrid().Fill(new(-half, -half, 0, half, half, height), Surfaces.Bark).Faces();

    // A pyramid of six sides.
    private static ImmutableArray<Face> Crown(double radius, double low, double high, uint surface)
    {
        var ring = Ring(6, radius, low);
        return
        [
            .. Enumerable.Range(0, 6).Select(i => new Face([ring[i], ring[(i + 1) % 6], new(0, 0, high)], surface)),
            new([.. ring.Reverse()], surface),
        ];
    }

    // A convex stump: wide below, narrow above.
    private static ImmutableArray<Face> Stump(int sides, double wide, double narrow, double height)
    {
        ImmutableArray<Point3> low = Ring(sides, wide, -0.3), high = Ring(sides, narrow, height);
        return
        [
            new(high, Surfaces.Rock),
            new([.. low.Reverse()], Surfaces.Rock),
            .. Enumerable.Range(0, sides)
                .Select(i => new Face([low[i], low[(i + 1) % sides], high[(i + 1) % sides], high[i]], Surfaces.Rock)),
        ];
    }

    private static ImmutableArray<Point3> Ring(int sides, double radius, double height)
        => [
            .. Enumerable.Range(0, sides)
                .Select(i => new Point3(radius * Math.Cos(2 * Math.PI * i / sides), radius * Math.Sin(2 * Math.PI * i / sides), height))];
}
