using System.Text;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

public sealed class LoadingTests(FirstWorld files) : IClassFixture<FirstWorld>
{
    private static readonly uint[] Town = [
        0xA8B30000, 0xA8B40000, 0xA8B50000, 0xA9B30000, 0xA9B40000, 0xA9B50000, 0xAAB30000, 0xAAB40000, 0xAAB50000];

    [Fact]
    [Behaviour("world.loading.blocks", "spec/05, 4.7; spec/07, 7.12")]
    public void Every_block_of_the_test_world_loads_with_its_rooms_and_buildings()
    {
        PhysicsWorld world = files.Load([.. FirstWorld.Blocks, FirstWorld.DungeonBlock]);
        Assert.Equal(26, world.Landblocks.Count);
        Assert.Equal(world.Landblocks.OrderBy(b => b.Id), world.Landblocks);
        Landblock house = world.FindLandblock(0xA9B40000)!;
        Assert.Equal(3, house.Rooms.Length);
        Assert.Single(house.Buildings);
        Assert.Same(house.Buildings[0], ((LandCell)house.Buildings[0].Shell.Cell!).Building);
        Assert.NotEqual(0, house.Buildings[0].Portals.Length);
        Assert.Equal(5, world.FindLandblock(FirstWorld.DungeonBlock)!.Rooms.Length);
        Assert.All(world.Landblocks, block => Assert.All(block.StaticObjects, item => Assert.True(item.ShadowCount > 0)));
    }

    [Fact]
    [Behaviour("world.loading.absent", "spec/05, 4.11")]
    public void What_the_files_lack_is_not_loaded_and_is_no_error()
    {
        PhysicsWorld world = files.Empty();
        Assert.False(world.LoadLandblock(0x10100000));
        Assert.False(world.LoadLandblock(0xFF000000));
        Assert.False(world.LoadLandblock(0x00FF0000));
        Assert.Null(world.GetVisible(0x10100001));
        Assert.Null(world.GetVisible(0));
        Assert.Null(world.GetVisible(0xFFFFFFFF));
        Assert.Null(world.GetVisible(0xFFFF0001));
        Assert.False(world.UnloadLandblock(0x10100000));
        world.EnsureLoadedAround(new Position(0xA9B40001, default), 1);
        Assert.Equal(Town, world.Landblocks.Select(b => b.Id));
    }

    [Fact]
    [Behaviour("world.loading.order-independent", "spec/05, 4.7, 4.17")]
    public void Lists_of_objects_do_not_depend_on_the_order_of_loading()
    {
        string expected = Describe(files.Load(Town));
        Assert.Contains("A9B40014", expected, StringComparison.Ordinal);
        Gen.Select(Gen.Shuffle(Town), Gen.Shuffle(Town), Gen.Int[0, Town.Length]).Sample(
            (order, again, drop) =>
            {
                PhysicsWorld world = files.Load(order);
                foreach (uint id in again.Take(drop)) Assert.True(world.UnloadLandblock(id));
                foreach (uint id in again.Take(drop).Reverse()) Assert.True(world.LoadLandblock(id));
                Assert.Equal(expected, Describe(world));
            },
            iter: Fuzz.Cases(10));
    }

    [Fact]
    [Behaviour("world.loading.unload-equals-never-loaded", "spec/05, 4.11")]
    public void Unloading_leaves_what_was_there_before()
    {
        uint[] fewer = [.. Town.Skip(3)];
        PhysicsWorld world = files.Load(Town);
        foreach (uint id in Town.Take(3)) world.UnloadLandblock(id);
        Assert.Equal(Describe(files.Load(fewer)), Describe(world));
    }

    [Fact]
    [Behaviour("world.loading.bodies-wait", "spec/05, 4.11, 4.17; @0x005302C0")]
    public void Bodies_of_an_unloaded_block_wait_and_come_back_where_they_were()
    {
        PhysicsWorld world = files.Load(Town);
        PhysicsEngine engine = new(world);
        PhysicsBody body = engine.CreateBody(7, files.Cache.GetSetup(0x02000001), weenie: WeenieTraits.Present | WeenieTraits.Creature);
        Assert.True(body.EnterWorld(new Position(0xA9B40001, new System.Numerics.Vector3(30, 191.7f, 60))));
        Position place = body.Position;
        Assert.Contains(Enumerable.Range(0, body.ShadowCount), i => CellIds.BlockOf(body.ShadowAt(i).CellId) == 0xA9B50000);

        world.UnloadLandblock(0xA9B50000);
        Assert.False(body.IsLost);
        Assert.Contains(Enumerable.Range(0, body.ShadowCount), i => body.ShadowAt(i).Cell is null);
        world.LoadLandblock(0xA9B50000);
        for (int i = 0; i < body.ShadowCount; i++)
        {
            ObjCell cell = body.ShadowAt(i).Cell!;
            Assert.Equal(body.ShadowAt(i).CellId, cell.Id);
            Assert.Contains(body, Listed(cell));
        }

        world.UnloadLandblock(0xA9B40000);
        Assert.True(body.IsLost);
        Assert.Equal(0, body.ShadowCount);
        world.LoadLandblock(0xA9B40000);
        Assert.False(body.IsLost);
        Assert.Equal(place.CellId, body.Position.CellId);
        Assert.Same(world.GetVisible(place.CellId), body.Cell);
    }

    internal static IEnumerable<WorldObject> Listed(ObjCell cell) => Enumerable.Range(0, cell.ShadowCount).Select(cell.ShadowAt);

    /// <summary>Every cell with the statics it lists, in order.</summary>
    private static string Describe(PhysicsWorld world)
    {
        StringBuilder text = new();
        foreach (ObjCell cell in world.Landblocks.SelectMany(block => block.Cells))
        {
            text.Append(FormattableString.Invariant($"{cell.Id:X8}:"));
            foreach (WorldObject item in Listed(cell))
                text.Append(
                    FormattableString.Invariant(
                        $" {item.Setup!.Id:X}@{item.Position.CellId:X8}{item.Position.Frame.Origin}x{item.Scale}/{item.ShadowCount}"));
            text.AppendLine();
        }

        return text.ToString();
    }
}
