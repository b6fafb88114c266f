using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Bodies in and at water: specification 05, 4.5, 4.16, 6.8.</summary>
public sealed class WaterTests
{
    private const uint Land = 0xA9B40000, Sea = 0xAAB40000;

    [Theory]
    [Behaviour("world.water.standing", "spec/05, 6.8: a body sinks by the depth")]
    [InlineData(12, 12, 9.1f, true)]
    [InlineData(56, 56, 9.55f, true)]
    [InlineData(62, 62, 9.9f, true)]
    [InlineData(132, 132, 10f, false)]
    public void A_body_stands_as_deep_as_the_water_is(float x, float y, float z, bool water)
    {
        PhysicsWorld world = new();
        TerrainSurface pond = Ground.Pond();
        world.Add(new Landblock(Ground.Of(Land, (_, _) => 10, (i, j) => pond.WordOf(i, j))));
        PhysicsBody body = CellListTests.Enter(world, new Position(Land | 1, new Vector3(x, y, z + 0.1f)));
        Assert.Equal(z, body.Position.Frame.Origin.Z, 1e-4f);
        Assert.True(body.OnWalkable);
        Assert.Equal(water, (body.Transient & TransientState.WaterContact) != 0);
    }

    [Theory]
    [Behaviour("world.water.open", "spec/05, 4.16, 6.8; @0x00532F20")]
    [InlineData(17, false)]
    [InlineData(0, true)]
    public void A_block_that_is_water_all_over_lets_nobody_walk_in(int type, bool enters)
    {
        PhysicsWorld world = new();
        world.Add(new Landblock(Ground.Flat(Land)));
        world.Add(new Landblock(Ground.Flat(Sea, 0, type)));
        PhysicsBody body = CellListTests.Enter(world, new Position(Land | 1, new Vector3(191, 100, 0)));
        for (int i = 0; i < 20; i++) Strides.Walk(body, new Vector3(0.2f, 0, 0));
        Assert.Equal(enters ? Sea : Land, CellIds.BlockOf(body.Position.CellId));
        Assert.False(body.IsLost);
    }

    [Theory]
    [Behaviour("world.water.open.others", "spec/05, 4.16, 6.8: a viewer or a missile is not stopped; @0x00532F20")]
    [InlineData(MoverFlags.None, PhysicsState.Default, TransitionState.Collided)]
    [InlineData(MoverFlags.IsViewer, PhysicsState.Default, TransitionState.OK)]
    [InlineData(MoverFlags.None, PhysicsState.Default | PhysicsState.Missile, TransitionState.OK)]
    public void Open_water_lets_cameras_and_missiles_over(object flags, PhysicsState state, TransitionState answer)
    {
        Transition transition = Over(Ground.Of(Sea, (_, _) => 0, (_, _) => 17 << 2), new Vector3(60, 60, 5), (MoverFlags)flags, state);
        Assert.Equal(answer, transition.Path.CheckCell!.FindCollisions(transition));
    }

    [Theory]
    [Behaviour("world.water.standing.by-the-book", "spec/05, 6.8: h = 0.17 and h = −0.1 at depth 0.45")]
    [InlineData(10.2f, TransitionState.OK, 10.2f)]
    [InlineData(9.93f, TransitionState.Adjusted, 10.03f)]
    public void A_foot_in_the_water_is_lifted_to_where_it_stands(float z, TransitionState answer, float rest)
    {
        TerrainSurface pond = Ground.Pond();
        Transition transition = Over(
            Ground.Of(Land, (_, _) => 10, (i, j) => pond.WordOf(i, j)), new Vector3(50, 50, z), MoverFlags.OnWalkable | MoverFlags.Contact,
            PhysicsState.Default);
        Assert.Equal(answer, transition.Path.CheckCell!.FindCollisions(transition));
        Assert.Equal(rest, transition.Path.GlobalSpheres[0].Center.Z, 2e-6f);
        Assert.Equal(answer == TransitionState.Adjusted, transition.Collision.ContactPlaneValid);
        Assert.Equal(answer == TransitionState.Adjusted, transition.Collision.ContactPlaneIsWater);
        Assert.False(transition.Collision.CollisionNormalValid);
    }

    /// <summary>A sphere of radius 0.48 about a point over some ground.</summary>
    private static Transition Over(TerrainSurface ground, Vector3 center, MoverFlags flags, PhysicsState state)
    {
        PhysicsWorld world = new();
        world.Add(new Landblock(ground));
        Position place = new(ground.BlockId | 1, center);
        Assert.True(place.AdjustToOutside());
        ObjCell cell = world.GetVisible(place.CellId)!;
        Transition transition = new(world);
        transition.Reset();
        transition.Object.Init(new WorldObject(1, null, state), flags);
        transition.Path.InitSpheres([new Sphere(Vector3.Zero, 0.48f)], 1);
        transition.Path.InitPath(cell, true, place, place);
        transition.Path.SetCheckPos(place, cell);
        return transition;
    }
}
