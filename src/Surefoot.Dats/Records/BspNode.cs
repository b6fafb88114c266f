using System.Collections.Immutable;
using System.Numerics;
using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>The three kinds of trees; they share the tags and differ in what a node stores (spec 07, 7.2).</summary>
public enum BspKind
{
    /// <summary>For drawing.</summary>
    Drawing,

    /// <summary>For collision.</summary>
    Physics,

    /// <summary>The space of an indoor cell.</summary>
    Cell,
}

/// <summary>Tag of a node: four letters as a big-endian number. It says which children follow (spec 07, 7.2). Tags not named
/// here occur and have no children.</summary>
public enum BspTag : uint
{
    /// <summary>'LEAF'.</summary>
    Leaf = 0x4C454146,

    /// <summary>'PORT': both children, with portals in drawing trees.</summary>
    Port = 0x504F5254,

    /// <summary>'BPnn': positive child.</summary>
    BPnn = 0x42506E6E,

    /// <summary>'BPIn': positive child, own polygons.</summary>
    BPIn = 0x4250496E,

    /// <summary>'BpIN': negative child, own polygons.</summary>
    BpIN = 0x4270494E,

    /// <summary>'BpnN': negative child.</summary>
    BpnN = 0x42706E4E,

    /// <summary>'BPIN': both children, own polygons.</summary>
    BPIN = 0x4250494E,

    /// <summary>'BPnN': both children.</summary>
    BPnN = 0x42506E4E,

    /// <summary>'Bpnn': no child.</summary>
    Bpnn = 0x42706E6E,

    /// <summary>'BpIn': no child, own polygons.</summary>
    BpIn = 0x4270496E,

    /// <summary>'BPOL': no child; occurs in shipped drawing trees.</summary>
    BPOL = 0x42504F4C,

    /// <summary>'BPFL': no child.</summary>
    BPFL = 0x4250464C,
}

/// <summary>A portal of a drawing tree's PORT node.</summary>
/// <param name="Polygon">Position of its polygon among the drawing polygons.</param>
/// <param name="Portal">Index into the building's portals.</param>
public readonly record struct BspPortal(short Polygon, ushort Portal);

/// <summary>One node of a <see cref="BspTree"/>. Which members a node stores depends on tree kind and tag (spec 07, 7.2); the
/// others keep their defaults.</summary>
public readonly record struct BspNode
{
    /// <summary>Value of <see cref="Positive"/> and <see cref="Negative"/> where there is no child.</summary>
    public const int None = -1;

    private readonly ImmutableArray<short> polygons;
    private readonly ImmutableArray<BspPortal> portals;

    /// <summary>A leaf without polygons.</summary>
    public BspNode()
    {
    }

    /// <summary>The tag.</summary>
    public BspTag Tag { get; init; } = BspTag.Leaf;

    /// <summary>The splitting plane of an inner node; a point p is in front when n·p + d > 0. Metres.</summary>
    public Plane Plane { get; init; }

    /// <summary>Index in <see cref="BspTree.Nodes"/> of the child in front of the plane; −1 none.</summary>
    public int Positive { get; init; } = None;

    /// <summary>Index in <see cref="BspTree.Nodes"/> of the child behind the plane; −1 none.</summary>
    public int Negative { get; init; } = None;

    /// <summary>Encloses the polygons of the subtree (drawing and physics trees).</summary>
    public DatSphere Sphere { get; init; }

    /// <summary>Number of a leaf; nothing reads it.</summary>
    public int LeafIndex { get; init; }

    /// <summary>Physics leaf: non-zero when its region is solid.</summary>
    public int Solid { get; init; }

    /// <summary>Positions of polygons: those of a physics leaf, or a drawing node's own.</summary>
    public ImmutableArray<short> Polygons
    {
        get => polygons.IsDefault ? [] : polygons;
        init => polygons = value;
    }

    /// <summary>Portals of a drawing tree's PORT node.</summary>
    public ImmutableArray<BspPortal> Portals
    {
        get => portals.IsDefault ? [] : portals;
        init => portals = value;
    }

    /// <summary>True for a leaf.</summary>
    [JsonIgnore]
    public bool IsLeaf => Tag == BspTag.Leaf;

    /// <summary>Whether nodes of this tag have a child in front.</summary>
    public static bool HasPositive(BspTag tag)
        => tag is BspTag.Port or BspTag.BPnn or BspTag.BPIn or BspTag.BPIN or BspTag.BPnN;

    /// <summary>Whether nodes of this tag have a child behind.</summary>
    public static bool HasNegative(BspTag tag)
        => tag is BspTag.Port or BspTag.BpIN or BspTag.BpnN or BspTag.BPIN or BspTag.BPnN;
}
