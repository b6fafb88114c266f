using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>Records for tests of the cache, well formed until a test changes them.</summary>
internal static class Records
{
    internal const uint SlabId = 0x01000010;

    /// <summary>A square 2 × 2 at z = 0, walkable from above, solid below.</summary>
    internal static GfxObj Slab(
        uint id = SlabId, ImmutableArray<short>? leaf = null, ImmutableArray<ushort>? corners = null, Vector3? firstVertex = null,
            uint degrade = 0) => new()
            {
                Id = id,
                Flags = GfxObjFlags.HasPhysics | (degrade == 0 ? 0 : GfxObjFlags.HasDegrade),
                DegradeId = degrade,
                Vertices = Vertices(firstVertex ?? new(-1, -1, 0), new(1, -1, 0), new(1, 1, 0), new(-1, 1, 0)),
                PhysicsPolygons = [new DatPolygon { Vertices = corners ?? [0, 1, 2, 3] }],
                PhysicsTree = new BspTree
                {
                    Nodes =
            [
                new BspNode { Tag = BspTag.BPnN, Plane = new(0, 0, 1, 0), Positive = 1, Negative = 2, Sphere = new(Vector3.Zero, 1.5f) },
                new BspNode(),
                new BspNode { Solid = 1, Sphere = new(Vector3.Zero, 1.5f), Polygons = leaf ?? [0] },
            ],
                },
            };

    internal static DatVertexArray Vertices(params Vector3[] points) =>
        new([.. points.Select((p, i) => new DatVertex((ushort)i, p, Vector3.UnitZ))]);

    /// <summary>A line of <paramref name="length"/> nodes, each one centimetre behind the last.</summary>
    /// <param name="length">Number of nodes.</param>
    /// <param name="downFront">The line goes on in front of each plane instead of behind it.</param>
    /// <param name="polygonsBeside">The leaf beside each node has the polygon too.</param>
    internal static GfxObj Line(int length, bool downFront, bool polygonsBeside)
    {
        DatSphere everything = new(Vector3.Zero, 1000);
        var nodes = ImmutableArray.CreateBuilder<BspNode>((2 * length) + 1);
        BspNode beside = polygonsBeside ? new BspNode { Sphere = everything, Polygons = [0] } : new BspNode { Sphere = everything };
        for (int i = 0; i < length; i++)
        {
            Plane plane = downFront ? new(0, 0, 1, i * 0.01f) : new(0, 0, -1, -i * 0.01f);
            // As a file has it: a node, its front, its back. The line in front comes first there, so its side leaves follow it all.
            nodes.Add(downFront
                ? new BspNode { Tag = BspTag.BPnN, Plane = plane, Positive = i + 1, Negative = (2 * length) - i, Sphere = everything }
                : new BspNode { Tag = BspTag.BPnN, Plane = plane, Positive = (2 * i) + 1, Negative = (2 * i) + 2, Sphere = everything });
            if (!downFront) nodes.Add(beside);
        }

        nodes.Add(new BspNode { Solid = 1, Sphere = everything, Polygons = [0] });
        if (downFront)
        {
            for (int i = 0; i < length; i++) nodes.Add(beside);
        }

        GfxObj slab = Slab();
        return new GfxObj
        {
            Id = 0x01000020,
            Flags = GfxObjFlags.HasPhysics,
            Vertices = slab.Vertices,
            PhysicsPolygons = slab.PhysicsPolygons,
            PhysicsTree = new BspTree { Nodes = nodes.MoveToImmutable() },
        };
    }

    internal static Frame FrameAt(Vector3 origin) => new(origin, Quaternion.Identity);

    internal static Sphere Near(float z) => new(new Vector3(0, 0, z), 0.5f);
}
