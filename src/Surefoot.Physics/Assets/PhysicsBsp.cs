using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>
/// The collision tree of a mesh or room: interior nodes, leaves and polygons in flat arrays, addressed by index. Immutable and shared;
/// every query is a loop with a small stack of its own.
/// </summary>
/// <remarks>
/// Retail: BSPTREE, BSPNODE, BSPLEAF; specification 04, 4.5 and 4.6. This file is the shape of the tree, the others are what is asked of
/// it. A leaf without polygons answers nothing to every query, so all of them, and children that a file lacks, are one value:
/// <see cref="Nothing"/>.
/// </remarks>
internal sealed partial class PhysicsBsp
{
    /// <summary>Reference to an empty leaf. References from 0 up are nodes, those below −1 are leaves.</summary>
    internal const int Nothing = -1;

    /// <summary>No shipped tree comes near; a hostile one is refused before its queries could need a large stack.</summary>
    internal const int MaxPending = 16384;

    private const int SmallStack = 32;

    private readonly Node[] nodes;
    private readonly Leaf[] leaves;
    private readonly ushort[] leafPolygons;
    private readonly int root;
    private readonly int pendingSize;

    internal PhysicsBsp(
        Node[] nodes, Leaf[] leaves, ushort[] leafPolygons, int root, in Sphere bounds, int pendingSize, PolygonSet polygons)
    {
        this.nodes = nodes;
        this.leaves = leaves;
        this.leafPolygons = leafPolygons;
        this.root = root;
        this.pendingSize = pendingSize;
        Bounds = bounds;
        Polygons = polygons;
    }

    /// <summary>The root's bounding sphere: of everything in the tree, in its frame, metres.</summary>
    public Sphere Bounds { get; }

    /// <summary>The polygons that the leaves refer to.</summary>
    public PolygonSet Polygons { get; }

    /// <summary>Number of interior nodes.</summary>
    public int NodeCount => nodes.Length;

    /// <summary>Number of leaves that have polygons.</summary>
    public int LeafCount => leaves.Length;

    private static int LeafIndex(int reference) => -2 - reference;

    private ReadOnlySpan<ushort> PolygonsOf(in Leaf leaf) => leafPolygons.AsSpan(leaf.First, leaf.Count);

    /// <summary>An interior node: what is in front of the plane and what is behind it.</summary>
    internal struct Node
    {
        public Plane Plane;
        public Sphere Bounds;
        public int Positive;
        public int Negative;
    }

    /// <summary>A region at the bottom of the tree with the polygons that touch it.</summary>
    internal struct Leaf
    {
        public Sphere Bounds;
        public int First;
        public int Count;
        public bool Solid;
    }
}

/// <summary>Which polygon a query met, and where.</summary>
internal struct PolygonContact
{
    private int indexPlusOne;

    /// <summary>Index of the polygon in the tree's set, −1 for none.</summary>
    public int Polygon
    {
        readonly get => indexPlusOne - 1;
        set => indexPlusOne = value + 1;
    }

    /// <summary>A polygon was met.</summary>
    public readonly bool IsSome => indexPlusOne != 0;

    /// <summary>Foot of the perpendicular from the sphere's centre onto the last plane that was reached.</summary>
    public Vector3 Point;
}

/// <summary>A search for the surface a sphere comes to rest on; the sphere moves while it goes on.</summary>
/// <remarks>Retail: the arguments of BSPNODE::find_walkable @0x0053CC80.</remarks>
internal struct WalkableSearch
{
    /// <summary>The sphere, in the tree's frame; moved to rest on each surface found.</summary>
    public Sphere Sphere;

    /// <summary>The movement along which the sphere is pulled back, in the tree's frame.</summary>
    public Vector3 Movement;

    /// <summary>World up, in the tree's frame.</summary>
    public Vector3 Up;

    /// <summary>N·up of a walkable surface is above this.</summary>
    public float Allowance;

    /// <summary>Share of the movement not used up; shrinks.</summary>
    public float WalkInterp;

    /// <summary>Index of the last surface that moved the sphere; meaningless unless <see cref="Found"/>.</summary>
    public int Polygon;

    /// <summary>A surface moved the sphere.</summary>
    public bool Found;
}
