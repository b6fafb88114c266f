using System.Collections.Immutable;
using System.Numerics;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Generates any record that can be written: every flag and optional part, any bits in plain numbers.</summary>
internal static class RecordGen
{
    private const int Most = 4;

    private static readonly Gen<float> Number = Gen.Frequency(
        (3, Gen.Int[-1000, 1000].Select(i => i / 8f)),
        (1, Gen.UInt.Select(BitConverter.UInt32BitsToSingle)));

    private static readonly Gen<float> Real = Number.Select(value => float.IsNaN(value) ? 0 : value);

    private static readonly Gen<double> Long = Gen.ULong.Select(BitConverter.UInt64BitsToDouble);

    private static readonly Gen<Vector3> Point = Gen.Select(Number, Number, Number, (x, y, z) => new Vector3(x, y, z));

    private static readonly Gen<DatFrame> Frame = Gen.Select(
        Gen.Select(Real, Real, Real, (x, y, z) => new Vector3(x, y, z)),
        Gen.Select(Real, Real, Real, Real, (w, x, y, z) => new Quaternion(x, y, z, w)),
        (origin, rotation) => new DatFrame(origin, rotation));

    private static readonly Gen<DatSphere> Sphere = Gen.Select(Point, Number, (centre, radius) => new DatSphere(centre, radius));

    private static readonly Gen<Plane> AnyPlane = Gen.Select(Point, Number, (normal, d) => new Plane(normal, d));

    private static readonly Gen<DatColor> Color = Gen.Select(
        Gen.Byte, Gen.Byte, Gen.Byte, Gen.Byte, (r, g, b, a) => new DatColor(r, g, b, a));

    // Lengths 0 to 9 meet every alignment.
    private static readonly Gen<string> Text = Gen.Char["abc XYZ\0\u00E9\u20AC\u0081"].Array[0, 9].Select(
        characters => new string(characters));

    public static Gen<DatRecord> Any { get; } = Gen.OneOf<DatRecord>(
        GfxObj().AsRecord(),
        Setup().AsRecord(),
        Animation().AsRecord(),
        MotionTable().AsRecord(),
        CellEnvironment().AsRecord(),
        EnvCell().AsRecord(),
        LandBlock().AsRecord(),
        LandBlockInfo().AsRecord(),
        Scene().AsRecord(),
        RegionGen.Region().AsRecord(),
        Iteration().AsRecord(),
        TableGen.Vitals().AsRecord(),
        TableGen.Skills().AsRecord(),
        TableGen.Experience().AsRecord(),
        Raw().AsRecord());

    public static Gen<ImmutableArray<T>> List<T>(this Gen<T> element, int least = 0, int most = Most)
        => element.Array[least, most].Select(elements => ImmutableArray.Create(elements));

    public static Gen<T> Among<T>(params T[] values) => Gen.Int[0, values.Length - 1].Select(i => values[i]);

    public static Gen<float> Numbers => Number;

    public static Gen<double> Doubles => Long;

    public static Gen<string> Texts => Text;

    public static Gen<DatColor> Colors => Color;

    private static Gen<DatRecord> AsRecord<T>(this Gen<T> records)
        where T : DatRecord
        => records.Select(DatRecord (record) => record);

    private static Gen<uint> Id(uint baseId) => Gen.UInt[0, 0xFFFF].Select(low => baseId | low);

    private static Gen<ImmutableArray<T>> ListIf<T>(bool present, Gen<T> element, int count)
        => present ? element.List(count, count) : Gen.Const(ImmutableArray<T>.Empty);

    private static Gen<DatVertex> Vertex() => Gen.Select(
        Gen.UShort, Point, Point, Gen.Select(Number, Number, (u, v) => new DatUV(u, v)).List(),
        (key, position, normal, uvs) => new DatVertex(key, position, normal, uvs));

    private static Gen<DatVertexArray> Vertices() => Vertex().List().Select(vertices => new DatVertexArray(vertices));

    private static Gen<DatPolygon> Polygon() =>
        from points in Gen.Frequency((9, Gen.Int[0, 5]), (1, Gen.Int[126, 127]))
        from stippling in Gen.Byte[0, 31]
        from sides in Gen.OneOf(Gen.Int[0, 2], Gen.Int)
        from positive in ListIf((stippling & 4) == 0, Gen.Byte, points)
        from negative in ListIf(sides == 2 && (stippling & 8) == 0, Gen.Byte, points)
        from head in Gen.Select(Gen.UShort, Gen.Short, Gen.Short, Gen.UShort.List(points, points))
        select new DatPolygon
        {
            Key = head.Item1,
            Stippling = (DatStippling)stippling,
            Sides = sides,
            PositiveSurface = head.Item2,
            NegativeSurface = head.Item3,
            Vertices = head.Item4,
            PositiveUVs = positive,
            NegativeUVs = negative,
        };

    // A list of wanted tags becomes a tree in preorder; where it runs out, leaves close it.
    public static Gen<BspTree> Tree(BspKind kind) =>
        from tags in Gen.OneOf(
            Among(Enum.GetValues<BspTag>()), Gen.UInt.Select(tag => (BspTag)tag)).Array[0, 12]
        from leaves in Gen.Select(Gen.Int, Gen.Int, Sphere, Gen.Short.List()).Array[tags.Length + 1]
        from inner in Gen.Select(
            AnyPlane, Sphere, Gen.Short.List(),
            Gen.Select(Gen.Short, Gen.UShort, (p, i) => new BspPortal(p, i)).List()).Array[tags.Length + 1]
        select Build(kind, tags, leaves, inner);

    private static BspTree Build(
        BspKind kind,
        BspTag[] tags,
        (int Index, int Solid, DatSphere Sphere, ImmutableArray<short> Polygons)[] leaves,
        (Plane Plane, DatSphere Sphere, ImmutableArray<short> Polygons, ImmutableArray<BspPortal> Portals)[] inner)
    {
        var nodes = new List<BspNode>();
        int used = 0, leaf = 0;
        Add();
        return new() { Nodes = [.. nodes] };

        int Add()
        {
            int index = nodes.Count;
            BspTag tag = used < tags.Length ? tags[used] : BspTag.Leaf;
            int mine = used++ % inner.Length;
            if (tag == BspTag.Leaf)
            {
                var (number, solid, sphere, polygons) = leaves[leaf++ % leaves.Length];
                nodes.Add(kind == BspKind.Physics
                    ? new BspNode { LeafIndex = number, Solid = solid, Sphere = sphere, Polygons = polygons }
                    : new BspNode { LeafIndex = number });
                return index;
            }

            bool hasSphere = kind == BspKind.Drawing || (kind == BspKind.Physics && tag != BspTag.Port);
            nodes.Add(new BspNode
            {
                Tag = tag,
                Plane = inner[mine].Plane,
                Sphere = hasSphere ? inner[mine].Sphere : default,
                Polygons = kind == BspKind.Drawing ? inner[mine].Polygons : [],
                Portals = kind == BspKind.Drawing && tag == BspTag.Port ? inner[mine].Portals : [],
            });
            if (BspNode.HasPositive(tag))
                nodes[index] = nodes[index] with { Positive = Add() };
            if (BspNode.HasNegative(tag))
                nodes[index] = nodes[index] with { Negative = Add() };
            return index;
        }
    }

    private static Gen<GfxObj> GfxObj() =>
        from flags in Gen.UInt[0, 15]
        from physics in Gen.Select(Polygon().List(), Tree(BspKind.Physics))
        from drawing in Gen.Select(Polygon().List(), Tree(BspKind.Drawing))
        from rest in Gen.Select(Id(0x01000000), Gen.UInt.List(0, 200), Vertices(), Point, Gen.UInt)
        let hasPhysics = (flags & 1) != 0
        let hasDrawing = (flags & 2) != 0
        select new GfxObj
        {
            Id = rest.Item1,
            Flags = (GfxObjFlags)flags,
            SurfaceIds = rest.Item2,
            Vertices = rest.Item3,
            SortCentre = rest.Item4,
            PhysicsPolygons = hasPhysics ? physics.Item1 : [],
            PhysicsTree = hasPhysics ? physics.Item2 : null,
            DrawingPolygons = hasDrawing ? drawing.Item1 : [],
            DrawingTree = hasDrawing ? drawing.Item2 : null,
            DegradeId = (flags & 8) != 0 ? rest.Item5 : 0,
        };

    private static Gen<AnimationHook> Hook() => Gen.Select(
        Gen.OneOf<AnimationHook>(
            Among<AnimationHook>(new NoOperationHook(), new AnimationDoneHook(), new DefaultScriptHook()),
            Gen.Select(Gen.Int[0, 8], Gen.UInt).Select(AnimationHook (choice) => choice.Item1 switch
            {
                0 => new SoundHook(choice.Item2),
                1 => new SoundTableHook(choice.Item2),
                2 => new EtherealHook((int)choice.Item2),
                3 => new DestroyParticleHook(choice.Item2),
                4 => new StopParticleHook(choice.Item2),
                5 => new NoDrawHook(choice.Item2),
                6 => new DefaultScriptPartHook(choice.Item2),
                7 => new SetLightHook((int)choice.Item2),
                _ => new CallScriptHook(choice.Item2, 1.5f),
            }),
            Gen.Select(Gen.Byte, Gen.OneOf(Gen.UInt[0, 0x8000], Gen.UInt[0, 0x3FFFFFFF]))
                .Select(AnimationHook (p) => new ReplaceObjectHook(p.Item1, 0x01000000 + p.Item2)),
            Gen.Select(Gen.Int[0, 11], Gen.UInt, Number, Number, Number).Select(AnimationHook (v) => v.Item1 switch
            {
                0 => new AttackHook(v.Item2, v.Item3, v.Item4, v.Item5, 1, 2, 3),
                1 => new TransparentPartHook(v.Item2, v.Item3, v.Item4, v.Item5),
                2 => new LuminousHook(v.Item3, v.Item4, v.Item5),
                3 => new LuminousPartHook(v.Item2, v.Item3, v.Item4, v.Item5),
                4 => new DiffuseHook(v.Item3, v.Item4, v.Item5),
                5 => new DiffusePartHook(v.Item2, v.Item3, v.Item4, v.Item5),
                6 => new ScaleHook(v.Item3, v.Item4),
                7 => new TransparentHook(v.Item3, v.Item4, v.Item5),
                8 => new SoundTweakedHook(v.Item2, v.Item3, v.Item4, v.Item5),
                9 => new SetOmegaHook(new(v.Item3, v.Item4, v.Item5)),
                10 => new TextureVelocityHook(v.Item3, v.Item4),
                _ => new TextureVelocityPartHook(v.Item2, v.Item3, v.Item4),
            }),
            Gen.Select(Gen.Bool, Gen.UInt, Gen.UInt, Frame).Select(AnimationHook (p) => p.Item1
                ? new CreateParticleHook(p.Item2, p.Item3, p.Item4, 7)
                : new CreateBlockingParticleHook(p.Item2, p.Item3, p.Item4, 8))),
        Gen.Int,
        (hook, direction) => hook with { Direction = direction });

    private static Gen<AnimFrame> AnimFrame(int parts) =>
        Gen.Select(Frame.List(parts, parts), Hook().List(), (p, hooks) => new AnimFrame(p, hooks));

    private static Gen<SetupLocation> Location() =>
        Gen.Select(Gen.UInt, Gen.UInt, Frame, (location, part, frame) => new SetupLocation(location, part, frame));

    private static Gen<Setup> Setup() =>
        from parts in Gen.Int[0, 3]
        from flags in Gen.UInt[0, 15]
        from lists in Gen.Select(
            Gen.UInt.List(parts, parts),
            ListIf((flags & 1) != 0, Gen.UInt, parts),
            ListIf((flags & 2) != 0, Point, parts),
            Location().List(),
            Location().List(),
            Gen.Select(Gen.UInt, AnimFrame(parts), (placement, frame) => new PlacementFrame(placement, frame)).List())
        from shapes in Gen.Select(
            Gen.Select(Point, Number, Number, (low, radius, height) => new DatCylSphere(low, radius, height)).List(), Sphere.List(), Sphere,
            Sphere)
        from numbers in Number.Array[4]
        from lights in Gen.Select(Gen.UInt, Frame, Color, Number, Number, Number, (t, f, c, i, o, a) => new SetupLight(t, f, c, i, o, a))
            .List()
        from ids in Gen.UInt.Array[5]
        from id in Id(0x02000000)
        select new Setup
        {
            Id = id,
            Flags = (SetupFlags)flags,
            PartIds = lists.Item1,
            ParentParts = lists.Item2,
            DefaultScales = lists.Item3,
            HoldingLocations = lists.Item4,
            ConnectionPoints = lists.Item5,
            PlacementFrames = lists.Item6,
            CylSpheres = shapes.Item1,
            Spheres = shapes.Item2,
            SortingSphere = shapes.Item3,
            SelectionSphere = shapes.Item4,
            Height = numbers[0],
            Radius = numbers[1],
            StepUpHeight = numbers[2],
            StepDownHeight = numbers[3],
            Lights = lights,
            DefaultAnimationId = ids[0],
            DefaultScriptId = ids[1],
            DefaultMotionTableId = ids[2],
            DefaultSoundTableId = ids[3],
            DefaultScriptTableId = ids[4],
        };

    private static Gen<Animation> Animation() =>
        from parts in Gen.Int[0, 3]
        from flags in Gen.UInt[0, 3]
        from frames in AnimFrame(parts).List()
        from rootMotion in ListIf((flags & 1) != 0, Frame, frames.Length)
        from id in Id(0x03000000)
        select new Animation { Id = id, Flags = (AnimationFlags)flags, PartCount = (uint)parts, Frames = frames, RootMotion = rootMotion };

    private static Gen<MotionData> Motion() =>
        from flags in Gen.Byte
        from head in Gen.Select(
            Gen.Byte,
            Gen.Select(Gen.UInt, Gen.Int, Gen.Int, Number, (id, low, high, rate) => new MotionAnimation(id, low, high, rate)).List())
        from velocity in Point
        from omega in Point
        select new MotionData
        {
            Bitfield = head.Item1,
            Flags = (MotionDataFlags)flags,
            Animations = head.Item2,
            Velocity = (flags & 1) != 0 ? velocity : default,
            Omega = (flags & 2) != 0 ? omega : default,
        };

    private static Gen<KeyedMotion> Keyed() => Gen.Select(Gen.UInt, Motion(), (key, data) => new KeyedMotion(key, data));

    private static Gen<MotionTable> MotionTable() => Gen.Select(
        Id(0x09000000),
        Gen.UInt,
        Gen.Select(Gen.UInt, Gen.UInt, (style, substate) => new MotionStyle(style, substate)).List(),
        Keyed().List(),
        Keyed().List(),
        Gen.Select(Gen.UInt, Keyed().List(), (key, targets) => new MotionLinks(key, targets)).List(),
        (id, style, styles, cycles, modifiers, links) => new MotionTable
        {
            Id = id,
            DefaultStyle = style,
            Styles = styles,
            Cycles = cycles,
            Modifiers = modifiers,
            Links = links,
        });

    private static Gen<CellStruct> CellStruct() =>
        from drawing in Gen.OneOf(Gen.Const(0u), Gen.UInt)
        from shape in Gen.Select(Gen.UInt, Vertices(), Polygon().List(), Polygon().List(), Gen.UShort.List())
        from trees in Gen.Select(Tree(BspKind.Cell), Tree(BspKind.Physics), Tree(BspKind.Drawing))
        select new CellStruct
        {
            Key = shape.Item1,
            Vertices = shape.Item2,
            Polygons = shape.Item3,
            PhysicsPolygons = shape.Item4,
            PortalPolygons = shape.Item5,
            CellTree = trees.Item1,
            PhysicsTree = trees.Item2,
            DrawingTreeFlag = drawing,
            DrawingTree = drawing != 0 ? trees.Item3 : null,
        };

    private static Gen<CellEnvironment> CellEnvironment()
        => Gen.Select(Id(0x0D000000), CellStruct().List(0, 2), (id, cells) => new CellEnvironment { Id = id, Cells = cells });

    private static Gen<StaticObject> Static() => Gen.Select(Gen.UInt, Frame, (id, frame) => new StaticObject(id, frame));

    private static Gen<EnvCell> EnvCell() =>
        from id in Gen.UInt[0, 0xFDFD].Select(block => (block << 16) | 0x100)
        from flags in Gen.UInt[0, 15]
        from lists in Gen.Select(
            Id(0x08000000).List(),
            Gen.Select(
                Gen.UShort, Gen.UShort, Gen.UShort, Gen.UShort,
                (f, polygon, cell, portal) => new CellPortal((PortalFlags)f, polygon, cell, portal)).List(),
            Gen.UShort.List(),
            Static().List())
        from rest in Gen.Select(Gen.UInt, Id(0x0D000000), Gen.UShort, Frame, Gen.UInt)
        select new EnvCell
        {
            Id = id,
            Flags = (EnvCellFlags)flags,
            CellId = rest.Item1,
            EnvironmentId = rest.Item2,
            Structure = rest.Item3,
            Position = rest.Item4,
            SurfaceIds = lists.Item1,
            Portals = lists.Item2,
            VisibleCells = lists.Item3,
            StaticObjects = (flags & 2) != 0 ? lists.Item4 : [],
            RestrictionObjectId = (flags & 8) != 0 ? rest.Item5 : 0,
        };

    private static Gen<LandBlock> LandBlock() => Gen.Select(
        Gen.UInt[0, 0xFDFD],
        Gen.UInt,
        Gen.UShort.List(81, 81),
        Gen.Byte.List(81, 81),
        (block, info, terrain, heights) =>
            new LandBlock { Id = (block << 16) | 0xFFFF, InfoFlag = info, Terrain = terrain, Heights = heights });

    private static Gen<LandBlockInfo> LandBlockInfo() =>
        from flags in Gen.UShort
        from block in Gen.UInt[0, 0xFDFD]
        from cells in Gen.UInt
        from objects in Static().List()
        from buildings in Gen.Select(
            Gen.UInt,
            Frame,
            Gen.UInt,
            Gen.Select(
                Gen.UShort, Gen.UShort, Gen.UShort, Gen.UShort.List(),
                (f, cell, portal, stabs) => new BuildingPortal((PortalFlags)f, cell, portal, stabs)).List(),
            (model, frame, leaves, portals) => new Building(model, frame, leaves, portals)).List()
        from table in Gen.Select(
            Gen.UShort[1, 255], Gen.Select(Gen.UInt, Gen.UInt, (cell, thing) => new CellRestriction(cell, thing)).List())
        let restricted = (flags & 1) != 0
        select new LandBlockInfo
        {
            Id = (block << 16) | 0xFFFE,
            Flags = (LandBlockInfoFlags)flags,
            CellCount = cells,
            Objects = objects,
            Buildings = buildings,
            RestrictionBuckets = restricted ? table.Item1 : (ushort)0,
            Restrictions = restricted ? table.Item2 : [],
        };

    private static Gen<Scene> Scene() =>
        from id in Id(0x12000000)
        from objects in Gen.Select(Gen.UInt, Frame, Number.Array[8], Gen.UInt.Array[3]).List()
        select new Scene
        {
            Id = id,
            Objects =
            [
                .. objects.Select(o => new SceneObject
                {
                    ObjectId = o.Item1,
                    BaseFrame = o.Item2,
                    Frequency = o.Item3[0],
                    DisplaceX = o.Item3[1],
                    DisplaceY = o.Item3[2],
                    MinScale = o.Item3[3],
                    MaxScale = o.Item3[4],
                    MaxRotation = o.Item3[5],
                    MinSlope = o.Item3[6],
                    MaxSlope = o.Item3[7],
                    Align = o.Item4[0],
                    Orient = o.Item4[1],
                    WeenieObject = o.Item4[2],
                }),
            ],
        };

    private static Gen<IterationRecord> Iteration()
        => Gen.Int[1, 5].Array[1, 4].Select(runs => new IterationRecord
        {
            Id = DatIds.Iteration,
            Count = runs.Sum(),
            Words = [.. runs.SelectMany(run => run == 1 ? new[] { 7 } : [-run, 1])],
        });

    private static Gen<RawRecord> Raw()
        => Gen.Byte.List(1, 40).Select(bytes => new RawRecord(DatRecordType.RenderSurface) { Id = 0x06000001, Bytes = bytes });
}
