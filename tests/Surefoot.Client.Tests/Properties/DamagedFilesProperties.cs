using System.Buffers;
using System.Globalization;
using System.Numerics;
using System.Text;
using CsCheck;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.World;
using BuildingPortal = Surefoot.Physics.World.BuildingPortal;
using EnvCell = Surefoot.Physics.World.EnvCell;
using StaticObject = Surefoot.Physics.World.StaticObject;

namespace Surefoot.Client.Tests.Properties;

/// <summary>
/// Bytes of the demo world's files flipped anywhere: what cannot be read costs only itself, and nothing goes missing without being listed.
/// </summary>
public sealed class DamagedFilesProperties : IDisposable
{
    private const int Radius = 2;
    private static readonly Position Middle = new(0xA9B40001, new Vector3(12, 12, 60));

    private readonly string folder = Directory.CreateTempSubdirectory("surefoot-flipped").FullName;
    private readonly Dictionary<uint, byte[]?> records = [];
    private readonly Dictionary<uint, HashSet<uint>> needs = [];
    private readonly Dictionary<uint, string> sound = [];

    public DamagedFilesProperties()
    {
        DemoWorldBuilder.Write(folder);
        using DatSet dats = DatSet.Open(folder);
        PhysicsWorld world = new(new PhysicsDataCache(dats));
        world.EnsureLoadedAround(Middle, Radius);
        foreach (Landblock block in world.Landblocks)
        {
            sound[block.Id] = Describe(block);
            WatchedSource watched = new(dats);
            Assert.True(new PhysicsWorld(new PhysicsDataCache(watched)).LoadLandblock(block.Id));
            needs[block.Id] = watched.Asked;
            foreach (uint id in watched.Asked) records[id] = BytesOf(dats, id);
        }
    }

    public void Dispose() => Directory.Delete(folder, recursive: true);

    [Fact, Behaviour("world.left-out.flipped-bytes", "spec/07, 9.1; design.md, decision 7")]
    public void Whatever_bytes_are_flipped_sound_blocks_load_as_in_a_sound_world_and_the_rest_is_listed()
    {
        Assert.Equal(25, sound.Count);
        int spoiled = 0, beside = 0;
        Gen<Flip> flip = Gen.Select(Gen.Bool, Gen.Double.Unit, Gen.Byte[1, 255],
            (cells, place, bits) => new Flip(cells ? DatSet.CellName : DatSet.PortalName, place, bits));
        flip.Array[1, 40].Sample(
            flips =>
            {
                Apply(flips);
                try
                {
                    Check(ref spoiled, ref beside);
                }
                finally
                {
                    Apply(flips);
                }
            },
            iter: Fuzz.Cases(150),
            threads: 1);
        Assert.True(spoiled > 0 && beside > 0, "No flip has spoiled a block beside a sound one.");
    }

    private void Check(ref int spoiled, ref int beside)
    {
        DatSet dats;
        try
        {
            dats = DatSet.Open(folder);
        }
        catch (DatFormatException)
        {
            return;
        }

        using (dats)
        {
            PhysicsEngine engine;
            try
            {
                engine = new PhysicsEngine(new PhysicsDataCache(dats));
            }
            catch (Exception e) when (e is DatFormatException or DatRecordMissingException)
            {
                return;
            }

            PhysicsWorld world = engine.World;
            world.EnsureLoadedAround(Middle, Radius);
            HashSet<uint> changed = [.. records.Keys.Where(id => !IsSame(BytesOf(dats, id), records[id]))];
            foreach ((uint id, string expected) in sound)
            {
                if (needs[id].Overlaps(changed)) spoiled++;
                else Assert.Equal(expected, world.FindLandblock(id) is { } block ? Describe(block) : "not loaded");
            }

            if (changed.Count > 0 && needs.Values.Any(ids => !ids.Overlaps(changed))) beside++;
            foreach (uint id in sound.Keys) AssertAllIsAccountedFor(dats, world, id);
            Assert.Equal(world.LeftOut.Total, world.LeftOut.Sum(item => item.Count) + world.LeftOut.Unlisted);
            WalkAbout(engine);
        }
    }

    /// <summary>A block is loaded, or in no file, or listed; so is each of its rooms.</summary>
    private static void AssertAllIsAccountedFor(DatSet dats, PhysicsWorld world, uint blockId)
    {
        if (world.FindLandblock(blockId) is not { } block)
        {
            bool listed = world.LeftOut.Any(item => item.Kind == LeftOutKind.Landblock && item.Id == (blockId | 0xFFFF));
            Assert.True(listed || !dats.Cell.TryGetEntry(blockId | 0xFFFF, out _), $"Block {blockId:X8} has gone missing.");
            return;
        }

        if (!dats.TryRead(blockId | 0xFFFF, out LandBlock? record) || !record.HasInfo) return;
        uint promised = dats.Read<LandBlockInfo>(blockId | 0xFFFE).CellCount;
        long without = world.LeftOut
            .Where(item => item.Kind == LeftOutKind.Room && CellIds.BlockOf(item.Id) == blockId)
            .Sum(item => item.Count);
        if (world.LeftOut.Unlisted == 0) Assert.Equal(promised, block.Rooms.Length + without);
    }

    /// <summary>
    /// A body walks, jumps up and turns about in what is left of the world; whatever it meets, it stays a body with a place.
    /// </summary>
    private static void WalkAbout(PhysicsEngine engine)
    {
        if (!engine.World.LoadLandblock(Middle.CellId)) return;
        PhysicsBody body = engine.CreateBody(7,
            StubWorld.Setup(new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)));
        SteeredPhysicsBody.Of(body).Attach(new Strides { Next = new Vector3(0, 0.5f, 0) });
        if (!body.EnterWorld(Middle)) return;
        for (int i = 1; i <= 60; i++)
        {
            body.SetActive(true);
            engine.Tick(i / 30.0);
        }

        Assert.True(RetailMath.IsFinite(body.Position.Frame.Origin), $"{body.Position}");
    }

    /// <summary>Flips bytes of the files on the disk; doing it again undoes it.</summary>
    private void Apply(Flip[] flips)
    {
        foreach (IGrouping<string, Flip> ofFile in flips.GroupBy(flip => flip.File))
        {
            using FileStream file = File.Open(Path.Combine(folder, ofFile.Key), FileMode.Open);
            foreach (Flip flip in ofFile)
            {
                long place = Math.Min((long)(flip.Place * file.Length), file.Length - 1);
                file.Position = place;
                byte value = (byte)file.ReadByte();
                file.Position = place;
                file.WriteByte((byte)(value ^ flip.Bits));
            }
        }
    }

    private static byte[]? BytesOf(DatSet dats, uint id)
    {
        try
        {
            return dats.TryRead(id, out ReadOnlySequence<byte> bytes) ? bytes.ToArray() : null;
        }
        catch (DatFormatException)
        {
            return [];
        }
    }

    private static bool IsSame(byte[]? bytes, byte[]? before) =>
        bytes is null ? before is null : before is not null && bytes.AsSpan().SequenceEqual(before);

    /// <summary>
    /// Ground, rooms, buildings and objects of a block with their places and shapes, and which of its own objects each of its cells lists.
    /// </summary>
    private static string Describe(Landblock block)
    {
        StringBuilder text = new();
        for (int i = 0; i < TerrainSurface.TriangleCount; i++) text.Append(CultureInfo.InvariantCulture, $"{block.Terrain.PlaneOf(i)} ");
        foreach (EnvCell room in block.Rooms)
        {
            text.Append(CultureInfo.InvariantCulture,
                $"\n{room.Position} {room.SeenOutside} {ShapeOf(room.Shape.Physics.Polygons)} {room.Shape.Cell.Planes.Length}");
            foreach (PortalPlane portal in room.Portals) text.Append(CultureInfo.InvariantCulture, $" {portal}");
            foreach (uint seen in room.StabList) text.Append(CultureInfo.InvariantCulture, $" {seen:X8}");
        }

        foreach (BuildingObject building in block.Buildings)
        {
            text.Append(CultureInfo.InvariantCulture, $"\n{Describe(building.Shell)}");
            foreach (BuildingPortal portal in building.Portals) text.Append(CultureInfo.InvariantCulture, $" {portal}");
        }

        foreach (StaticObject item in block.StaticObjects) text.Append(CultureInfo.InvariantCulture, $"\n{Describe(item)}");
        HashSet<WorldObject> own = [.. block.StaticObjects];
        foreach (ObjCell cell in block.Cells)
        {
            text.Append(CultureInfo.InvariantCulture, $"\n{cell.Id:X8}:");
            for (int i = 0; i < cell.ShadowCount; i++)
                if (own.Contains(cell.ShadowAt(i)))
                    text.Append(CultureInfo.InvariantCulture, $" {cell.ShadowAt(i).Setup!.Id:X8}@{cell.ShadowAt(i).Position}");
        }

        return text.ToString();
    }

    private static string Describe(StaticObject item)
    {
        StringBuilder text = new();
        text.Append(CultureInfo.InvariantCulture,
            $"{item.Setup!.Id:X8} {item.Position} x{item.Scale} {item.Setup.Cylinders.Length} {item.Setup.Spheres.Length}");
        foreach (SetupPart part in item.Setup.Parts)
            text.Append(' ').Append(part.Mesh.Physics is { } tree ? ShapeOf(tree.Polygons) : "hollow");
        return text.ToString();
    }

    private static string ShapeOf(PolygonSet polygons)
    {
        HashCode hash = default;
        foreach (Vector3 corner in polygons.Corners) hash.Add(corner);
        return $"{polygons.Count}:{hash.ToHashCode():X8}";
    }

    /// <summary>A byte of a file to be flipped.</summary>
    /// <param name="File">Name of the file.</param>
    /// <param name="Place">Where, as a share of the file.</param>
    /// <param name="Bits">The bits that change.</param>
    private readonly record struct Flip(string File, double Place, byte Bits);

    /// <summary>Remembers which records were asked for.</summary>
    private sealed class WatchedSource(DatSet dats) : IDatSource
    {
        public HashSet<uint> Asked { get; } = [];

        public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
        {
            Asked.Add(id);
            return dats.TryRead(id, out bytes);
        }
    }
}
