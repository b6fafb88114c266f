using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Held objects in the cells of a real world: specification 09, 5.11, and 05, 4.17.</summary>
public sealed class HeldShadowTests(FirstWorld files) : IClassFixture<FirstWorld>
{
    private const uint Block = 0xA9B40000;

    private static readonly SetupAsset Shape = new()
    {
        Id = 0x02FF0001,
        Spheres = [new Sphere(new Vector3(0, 0, 0.5f), 0.5f)],
        Height = 1,
        Radius = 0.5f,
        StepUpHeight = 0.6f,
        StepDownHeight = 0.6f,
        HoldingLocations = [new HoldingLocation(1, uint.MaxValue, new Frame(new Vector3(0, 2, 0), Quaternion.Identity))],
    };

    [Fact]
    [Behaviour("body.held.in-the-cells-of-its-holder", "spec/05, 4.17, add_shadows_to_cells @0x00514AE0")]
    public void It_is_listed_where_its_holder_is_and_goes_with_it()
    {
        (PhysicsEngine engine, PhysicsBody holder, PhysicsBody item) = Create();
        PhysicsWorld world = engine.World;
        Assert.Equal(Cells(holder), Cells(item));
        Strides.Walk(holder, new Vector3(0, -0.2f, 0));
        Assert.Equal(Cells(holder), Cells(item));
        Assert.All(Cells(item), id => Assert.Contains(item, LoadingTests.Listed(world.GetVisible(id)!)));
        holder.LeaveWorld();
        Assert.Equal((0, 0), (holder.ShadowCount, item.ShadowCount));
        Assert.DoesNotContain(item, world.Landblocks.SelectMany(b => b.Cells).SelectMany(LoadingTests.Listed));
    }

    [Fact]
    [Behaviour("body.held.no-obstacle", "spec/09, 5.11; spec/02, 4.21")]
    public void It_is_no_obstacle_until_it_is_let_go()
    {
        (PhysicsEngine engine, PhysicsBody holder, PhysicsBody item) = Create();
        WorldQuery query = engine.CreateQuery();
        PhysicsBody walker = engine.CreateBody(3, Shape);
        Position before = item.Position;
        before.Frame.Origin += new Vector3(-2, 0, 0);
        Assert.True(walker.EnterWorld(before));
        Position beyond = before;
        beyond.Frame.Origin += new Vector3(2, 0, 0);
        Position free = query.Sweep(walker, beyond).Position;
        Assert.Equal(beyond.Frame.Origin.X, free.Frame.Origin.X, 1e-4f);
        item.UnsetParent();
        Position stopped = query.Sweep(walker, beyond).Position;
        Assert.True(stopped.Frame.Origin.X < before.Frame.Origin.X + 1.01f, $"{stopped}");
    }

    [Fact]
    [Behaviour("body.held.waits-with-its-holder", "spec/02, 4.17, leave_visibility; spec/09, 5.11")]
    public void When_the_land_goes_its_holder_waits_for_it_and_both_come_back()
    {
        (PhysicsEngine engine, PhysicsBody holder, PhysicsBody item) = Create();
        PhysicsWorld world = engine.World;
        Position place = item.Position;
        world.UnloadLandblock(Block);
        Assert.Equal((true, false), (holder.IsLost, item.IsLost));
        Assert.Equal((null, null, 0), (holder.Cell, item.Cell, item.ShadowCount));
        world.LoadLandblock(Block);
        Assert.Equal((false, holder.Cell), (holder.IsLost, item.Cell));
        Assert.Equal(Cells(holder), Cells(item));
        Assert.True(Vector3.Distance(place.Frame.Origin, item.Position.Frame.Origin) < 0.01f);
    }

    private static uint[] Cells(PhysicsBody body) => [.. Enumerable.Range(0, body.ShadowCount).Select(i => body.ShadowAt(i).CellId)];

    /// <summary>A body that holds another one two metres before it.</summary>
    private (PhysicsEngine Engine, PhysicsBody Holder, PhysicsBody Item) Create()
    {
        PhysicsWorld world = files.Load(Block);
        PhysicsEngine engine = new(world);
        PhysicsBody holder = engine.CreateBody(1, Shape), item = engine.CreateBody(2, Shape);
        Position place = new(Block | 0x19, new Vector3(84, 12.3f, 0));
        Assert.True(world.FindLandblock(Block)!.Terrain.TryGetHeight(84, 12.3f, out float height));
        place.Frame.Origin.Z = height;
        Assert.True(holder.EnterWorld(place));
        Assert.True(item.SetParent(holder, 1));
        return (engine, holder, item);
    }
}
