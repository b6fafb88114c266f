using System.Numerics;
using Surefoot.Physics.Bodies;
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
        for (int i = 0; i < 20; i++) Strides.Step(body, new Vector3(0.2f, 0, 0));
        Assert.Equal(enters ? Sea : Land, CellIds.BlockOf(body.Position.CellId));
        Assert.False(body.IsLost);
    }
}
