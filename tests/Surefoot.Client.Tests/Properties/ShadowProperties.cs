using System.Globalization;
using System.Numerics;
using System.Text;
using CsCheck;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>The lists of who is in which cell, after whatever happened.</summary>
public sealed class ShadowProperties(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint TownBlock = 0xA8B50000;

    private static readonly Sphere[] WithoutSpheres = [new(new Vector3(0, 0, 0.1f), 0.1f)];
    private static readonly SetupAsset Ball =
        new() { Id = 0x02FF0001, Spheres = [new Sphere(Vector3.Zero, 0.25f)], StepUpHeight = 0.3f, StepDownHeight = 0.3f };

    /// <summary>The town's block, its neighbours, and that of the dungeon.</summary>
    private static readonly uint[] Blocks =
    [
        .. Enumerable.Range(0, 9).Select(i => TownBlock + (uint)(((i / 3) - 1) << 24) + (uint)(((i % 3) - 1) << 16)),
        CellIds.BlockOf(PlaceOf("dungeon").CellId),
    ];

    private static readonly NamedPlace[] Places = [.. DemoPlaces.All.Where(p => Blocks.Contains(CellIds.BlockOf(p.CellId)))];

    private enum What
    {
        Stride,
        Push,
        Teleport,
        Turn,
        OpenOrClose,
        Remove,
        Unload,
    }

    [Fact]
    [Behaviour("properties.shadows-as-if-afresh", "design.md, decision 1; spec/05, 4.17; @0x00514AE0, @0x00511230")]
    public void Shadows_after_any_history_are_those_of_a_fresh_world()
    {
        Gen<Deed> deed = Gen.Select(
            Gen.Frequency((4, Gen.Const(What.Stride)), (6, Gen.Enum<What>())), Gen.Int[0, 5], Gen.Int[0, 999], Gen.Float[-6, 6],
            Gen.Float[-6, 6],
            (what, who, which, x, y) => new Deed(what, who, which, x, y));
        deed.Array[1, 40].Sample(
            deeds =>
            {
                PhysicsEngine engine = files.CreateEngine();
                PhysicsWorld world = engine.World;
                foreach (uint block in Blocks) world.LoadLandblock(block);
                foreach (Deed d in deeds) Do(d, world, engine);
                HashSet<uint> walkedOff = Settle(engine);
                Assert.Equal(Afresh(world, engine, walkedOff), Describe(world, walkedOff));
            },
            print: deeds => string.Join("; ", deeds),
            iter: Fuzz.Cases(150));
    }

    [Fact]
    [Behaviour("properties.exception.turned-where-it-stands",
        "spec/02, 4.13 step 11: shadows are renewed by a commit, and turning commits nothing")]
    public void Parts_that_turn_keep_the_shadows_of_the_last_commit()
    {
        PhysicsEngine engine = files.CreateEngine();
        PhysicsWorld world = engine.World;
        foreach (uint block in Blocks) world.LoadLandblock(block);
        // A door of 1.2 m whose middle is 0.3 m east of a border between two squares of land, along the border and then across it.
        Position place = new(TownBlock | 0x1C, new Vector3(96.3f, 60, 0));
        Assert.True(place.AdjustToOutside());
        Assert.True(((LandCell)world.GetVisible(place.CellId)!).Landblock.Terrain.TryGetHeight(96.3f, 60, out float ground));
        place.Frame.Origin.Z = ground;
        place.Frame.SetHeading(90);
        PhysicsBody door = Create(engine, 5, 1);
        Assert.True(door.EnterWorld(place));
        Assert.Equal(1, door.ShadowCount);
        door.SetHeading(0);
        Assert.Equal(1, door.ShadowCount);
        Assert.Equal(PlacementResult.OK, door.SetPositionSimple(door.Position, sliding: false));
        Assert.Equal(2, door.ShadowCount);
    }

    [Fact]
    [Behaviour("properties.exception.refused-while-lost",
        "spec/02, 4.16 steps 1 and 6, 4.17 prepare_to_enter_world: the lost cell is left before the place is tried")]
    public void A_lost_body_that_is_refused_somewhere_is_nowhere_until_it_is_put_where_it_fits()
    {
        PhysicsEngine engine = files.CreateEngine();
        PhysicsWorld world = engine.World;
        foreach (uint block in Blocks) world.LoadLandblock(block);
        NamedPlace bridge = PlaceOf("footbridge"), town = PlaceOf("town");
        Position taken = new(town.CellId, town.Origin), free = new(town.CellId, town.Origin + new Vector3(0, 3, 0));
        PhysicsBody body = Create(engine, 0, 1), other = Create(engine, 1, 2);
        Assert.True(body.EnterWorld(new Position(bridge.CellId, bridge.Origin)));
        Assert.True(other.EnterWorld(taken));

        Assert.True(world.UnloadLandblock(bridge.CellId));
        Assert.True(body.IsLost);
        Assert.NotEqual(PlacementResult.OK, body.SetPositionSimple(taken, sliding: false));
        Assert.True(world.LoadLandblock(bridge.CellId));
        Assert.Null(body.Cell);
        Assert.False(body.IsLost);
        Assert.Equal(0, body.ShadowCount);

        Assert.Equal(PlacementResult.OK, body.SetPositionSimple(free, sliding: true));
        Assert.NotNull(body.Cell);
        Assert.NotEqual(0, body.ShadowCount);
    }

    private static NamedPlace PlaceOf(string name) => DemoPlaces.All.First(p => p.Name == name);

    private void Do(Deed deed, PhysicsWorld world, PhysicsEngine engine)
    {
        uint id = 0x50000001 + (uint)deed.Who;
        PhysicsBody? body = engine.Find(id);
        NamedPlace place = Places[deed.Which % Places.Length];
        if (deed.What == What.Unload)
        {
            uint block = Blocks[deed.Which % Blocks.Length];
            if (!world.UnloadLandblock(block)) world.LoadLandblock(block);
            return;
        }

        if (body is null)
        {
            body = Create(engine, deed.Who, id);
            if (!body.EnterWorld(Somewhere(place, deed))) engine.RemoveBody(body);
            return;
        }

        switch (deed.What)
        {
            case What.Remove:
                engine.RemoveBody(body);
                break;
            case What.Teleport:
                body.SetPositionSimple(Somewhere(place, deed), sliding: true);
                break;
            case What.OpenOrClose:
                body.SetEthereal(!body.State.Has(PhysicsState.Ethereal));
                break;
            case What.Turn:
                body.SetHeading(deed.X * 60);
                // Turning renews no shadows (specification 02, 4.4 and 4.13 step 11); those of parts would be the old ones until the next
                // commit.
                if (body.State.Has(PhysicsState.HasPhysicsBsp)) body.SetPositionSimple(body.Position, sliding: true);
                break;
            case What.Push:
                body.SetVelocity(new Vector3(deed.X * 3, deed.Y * 3, 4));
                break;
        }

        for (int i = 0; i < deed.Which % 25; i++)
            Strides.Walk(body, deed.What == What.Stride ? new Vector3(deed.X, deed.Y, 0) / 12 : default);
    }

    private PhysicsBody Create(PhysicsEngine engine, int who, uint id)
    {
        const WeenieTraits beast = WeenieTraits.Present | WeenieTraits.Creature;
        SetupAsset SetupOf(DemoSpawnKind kind, string name) =>
            files.Cache.GetSetup(DemoSpawns.All.First(s => s.Kind == kind && s.Name == name).SetupId);
        return who switch
        {
            0 or 1 => engine.CreateBody(id, files.Cache.GetSetup(0x02000001), weenie: beast),
            2 =>
                engine.CreateBody(id, SetupOf(DemoSpawnKind.Wanderer, "creature-1"), PhysicsState.Gravity | PhysicsState.ReportCollisions,
                    beast, 1.5f),
            3 => engine.CreateBody(id, Ball, weenie: WeenieTraits.Present),
            4 => engine.CreateBody(id, SetupOf(DemoSpawnKind.Wanderer, "creature-3"), weenie: beast),
            _ => engine.CreateBody(id, SetupOf(DemoSpawnKind.Door, "door"), PhysicsState.ReportCollisions, WeenieTraits.Present),
        };
    }

    private static Position Somewhere(NamedPlace place, Deed deed)
    {
        Position position = new(place.CellId, new Frame(place.Origin + new Vector3(deed.X, deed.Y, 0), place.Orientation));
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        return position;
    }

    /// <summary>
    /// Gives everybody two quanta more. A body put into the air keeps the list of the probe that found no footing (specification 03, 4.9,
    /// step 5), and so does one that lost the ground (4.7, edge_slide case A), until its next quantum: those who lost it in the second are
    /// named.
    /// </summary>
    private static HashSet<uint> Settle(PhysicsEngine engine)
    {
        HashSet<uint> walkedOff = [];
        foreach (PhysicsBody body in engine.Bodies)
        {
            Strides.Walk(body, default);
            bool stood = body.HasContact;
            Strides.Walk(body, default);
            if (stood && !body.HasContact) walkedOff.Add(body.Id);
        }

        return walkedOff;
    }

    /// <summary>The lists of a world into which the same blocks were loaded, and the same bodies put where they are.</summary>
    private string Afresh(PhysicsWorld world, PhysicsEngine engine, HashSet<uint> leftOut)
    {
        PhysicsEngine another = files.CreateEngine();
        PhysicsWorld fresh = another.World;
        foreach (Landblock block in world.Landblocks) fresh.LoadLandblock(block.Id);
        Transition path = new(fresh);
        foreach (PhysicsBody body in engine.Bodies.OrderBy(b => b.Id))
        {
            if (body.Cell is null)
            {
                // It waits for its cell, or is nowhere since it was refused where it would have come back: see the exception below.
                Assert.Equal(0, body.ShadowCount);
                continue;
            }

            Assert.False(body.IsLost);
            Assert.Same(world.GetVisible(body.Position.CellId), body.Cell);
            PhysicsBody twin = another.CreateBody(body.Id, body.Setup, body.State, body.Weenie, body.Scale);
            twin.Seat(new BodySeat(body.Position, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
            if (twin.State.Has(PhysicsState.HasPhysicsBsp))
            {
                fresh.CalcCrossCells(twin);
                continue;
            }

            path.Reset();
            path.Path.InitSpheres(twin.Setup!.Spheres.IsEmpty ? WithoutSpheres : twin.Setup.Spheres,
                twin.Setup.Spheres.IsEmpty ? 1 : twin.Scale);
            path.Path.SetCheckPos(twin.Position, twin.Cell);
            ObjCell? home = null;
            fresh.FindCellList(path.Cells, twin.Position, path.Path.CheckSpheres, wantHome: true, ref home);
            fresh.PlaceShadows(twin, path.Cells);
        }

        return Describe(fresh, leftOut);
    }

    /// <summary>Every cell with whom it lists: statics in their order, bodies by id.</summary>
    private static string Describe(PhysicsWorld world, HashSet<uint> leftOut)
    {
        StringBuilder text = new();
        foreach (ObjCell cell in world.Landblocks.SelectMany(block => block.Cells))
        {
            List<WorldObject> listed = [.. Enumerable.Range(0, cell.ShadowCount).Select(cell.ShadowAt)];
            if (listed.Count == 0) continue;
            text.Append(CultureInfo.InvariantCulture, $"{cell.Id:X8}:");
            foreach (WorldObject item in listed.Where(o => o is StaticObject))
                text.Append(CultureInfo.InvariantCulture, $" {item.Setup!.Id:X}@{item.Position}");
            foreach (uint id in listed.OfType<PhysicsBody>().Select(b => b.Id).Order())
            {
                if (!leftOut.Contains(id)) text.Append(CultureInfo.InvariantCulture, $" body {id:X}");
            }

            text.AppendLine();
        }

        return text.ToString();
    }

    private sealed record Deed(What What, int Who, int Which, float X, float Y);
}
