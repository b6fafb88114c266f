using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>What movement needs of a mesh, in its own frame and at scale 1. Immutable and shared.</summary>
/// <remarks>Retail: the collision side of CGfxObj.</remarks>
public sealed class GfxObjAsset
{
    internal GfxObjAsset()
    {
    }

    /// <summary>Id of the record, 0x01…</summary>
    public uint Id { get; internal init; }

    /// <summary>The collision tree; null for a mesh that stops nothing.</summary>
    internal PhysicsBsp? Physics { get; init; }

    /// <summary>The collision polygons, which trees find their way to; empty for a mesh that stops nothing.</summary>
    public PolygonSet Polygons => Physics is null ? PolygonSet.Empty : Physics.Polygons;

    /// <summary>Box of all vertices, drawn ones too, without any scale; empty without vertices.</summary>
    /// <remarks>Retail: CGfxObj's gfx_bound_box, CPhysicsPart::GetBoundingBox @0x0050D600.</remarks>
    internal BoundingBox BoundingBox { get; init; } = BoundingBox.Empty;

    /// <summary>Bounding sphere of the collision tree; null without one.</summary>
    internal Sphere? PhysicsSphere => Physics?.Bounds;

    /// <summary>No collision polygon is further than this from the mesh's origin, metres; 0 without a tree.</summary>
    internal double PhysicsReach => Physics is null ? 0 : RetailMath.Length(Physics.Bounds.Center) + Physics.Bounds.Radius;

    /// <summary>Bounding sphere of the drawing tree; null without one.</summary>
    internal Sphere? DrawingSphere { get; init; }

    /// <summary>The physics sphere, or the drawing sphere of a mesh without one, or none.</summary>
    internal Sphere? AnySphere => PhysicsSphere ?? DrawingSphere;

    /// <summary>The mesh is a picture that turns to the viewer: its place in cells follows its sphere instead of its box.</summary>
    /// <remarks>Retail: CPhysicsPart::Always2D @0x0050D8A0: the first level of its degrade record has a mode other than 1.</remarks>
    internal bool Always2D { get; init; }

    /// <summary>Flattens a record.</summary>
    /// <exception cref="Dats.DatFormatException">The record contradicts itself.</exception>
    internal static GfxObjAsset Build(GfxObj record, bool always2D)
    {
        RecordFlattener flattener = new(record);
        Vector3[] vertices = flattener.Vertices(record.Vertices);
        return new GfxObjAsset
        {
            Id = record.Id,
            Physics = record.PhysicsTree is { } tree
                ? flattener.PhysicsTree(tree, flattener.Polygons(record.PhysicsPolygons.AsSpan(), vertices, "physics"))
                : null,
            BoundingBox = BoundingBox.Of(vertices),
            DrawingSphere = record.DrawingTree is { } drawing
                ? new Sphere(drawing.Nodes[0].Sphere.Centre, drawing.Nodes[0].Sphere.Radius)
                : null,
            Always2D = always2D,
        };
    }
}
