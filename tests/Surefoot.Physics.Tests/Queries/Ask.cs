using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>Movers, and worlds to ask.</summary>
internal static class Ask
{
    internal const uint Land = 0xA9B40001;

    /// <summary>The body of specification 03, 6.8.</summary>
    internal static Mover Walker { get; } = new(
        [new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)], 0.6f, 0.6f,
        PhysicsState.Gravity | PhysicsState.ReportCollisions);

    /// <summary>A ball of half a metre that lies on its origin.</summary>
    internal static Mover Ball { get; } = new([new Sphere(new Vector3(0, 0, 0.5f), 0.5f)], 0.6f, 0.6f);

    /// <summary>A ball of a quarter of a metre that lies on its origin, as in specification 03, 6.9.</summary>
    internal static Mover SmallBall { get; } = new([new Sphere(new Vector3(0, 0, 0.25f), 0.25f)], 0.6f, 0.6f);

    internal static Contact Flat { get; } = new(StubWorld.Flat(0), StubWorld.CellId);

    /// <summary>A world of landblocks at height 0.</summary>
    internal static PhysicsEngine Engine(params uint[] blocks) => new(World.CellListTests.Flat(blocks));

    internal static Position At(float x, float y, float z, uint cell = Land) => new(cell, new Vector3(x, y, z));

    internal static Position Stub(float x, float y, float z) => At(x, y, z, StubWorld.CellId);

    /// <summary>The unit cube of specification 04, 6.7.</summary>
    internal static GfxObjAsset Cube { get; } = new() { Id = 0x01000001, Physics = Tests.Assets.Trees.UnitCube() };
}
