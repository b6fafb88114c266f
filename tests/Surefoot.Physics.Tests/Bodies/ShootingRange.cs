using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Flat land at z = 0 with real cells, in which missiles of radius 0.1 fly and things stand in their way.</summary>
internal sealed class ShootingRange : ICollisionListener
{
    internal const uint MissileId = 1, TargetId = 2;
    internal const float Tick = 1f / 30, Radius = 0.1f;
    internal const WeenieTraits Creature = WeenieTraits.Present | WeenieTraits.Creature, Player = Creature | WeenieTraits.Player;

    /// <summary>A spell bolt: no weight, and its nose along its way.</summary>
    internal const PhysicsState Bolt =
        PhysicsState.ReportCollisions | PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.PathClipped;

    /// <summary>An arrow falls as well.</summary>
    internal const PhysicsState Arrow = Bolt | PhysicsState.Gravity;

    private static readonly SetupAsset Shape = SetupAsset.OfSpheres(0x02000009, [new Sphere(Vector3.Zero, Radius)]);

    internal PhysicsEngine Engine { get; } = new(new WorldRecords().Ground().World());

    /// <summary>All that was told, in order: to whom, of whom (0 for the environment), where and against what.</summary>
    internal List<Hit> Hits { get; } = [];

    internal PhysicsBody Missile => Engine.Find(MissileId)!;

    internal Vector3 At => Missile.Position.Frame.Origin;

    /// <summary>A missile on its way.</summary>
    internal PhysicsBody Shoot(Vector3 from, Vector3 velocity, PhysicsState state = Bolt, WeenieTraits weenie = WeenieTraits.Present)
    {
        PhysicsBody missile = Add(MissileId, Shape, from, state, weenie);
        missile.SetVelocity(velocity);
        return missile;
    }

    /// <summary>One who stands in the air, on a body of two spheres as a human has them.</summary>
    internal PhysicsBody Stand(Vector3 at, WeenieTraits weenie, PhysicsState state = PhysicsState.ReportCollisions) => Add(
        TargetId, new SetupAsset
        {
            Id = 0x02000001,
            Spheres = [new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)],
            SortingSphere = new Sphere(new Vector3(0, 0, 0.9f), 1.1f),
            Height = 1.83f,
            Radius = 0.48f,
        }, at, state, weenie);

    /// <summary>A box with a collision tree, turned about its middle; static unless said otherwise.</summary>
    internal PhysicsBody Build(
        Vector3 at, Vector3 half, Quaternion turn = default, PhysicsState state = PhysicsState.Static, uint id = TargetId)
    {
        GfxObjAsset mesh = new() { Id = 0x01000001, Physics = Trees.Box(-half, half), BoundingBox = new BoundingBox(-half, half) };
        SetupAsset setup = new SetupAsset { Id = 0x02000002, Parts = [new SetupPart(mesh, Vector3.One)] }.With(0, [Frame.Identity]);
        PhysicsBody body = Add(id, setup, at, state | PhysicsState.HasPhysicsBsp, WeenieTraits.None, turn);
        // A body is made without the static bit, whatever is asked for.
        body.SetState(state | PhysicsState.HasPhysicsBsp);
        return body;
    }

    internal void Fly(int quanta, float quantum = Tick)
    {
        for (int i = 0; i < quanta; i++) Missile.AdvanceQuantum(quantum);
    }

    private PhysicsBody Add(
        uint id, SetupAsset setup, Vector3 at, PhysicsState state, WeenieTraits weenie, Quaternion turn = default)
    {
        PhysicsBody body = Engine.CreateBody(id, setup, state, weenie);
        body.Listener = this;
        Frame frame = new(at, turn == default ? Quaternion.Identity : turn);
        Assert.True(body.EnterWorld(new Position((WorldRecords.Block & 0xFFFF0000) | 1, frame)));
        return body;
    }

    public void OnEnvironmentCollision(PhysicsBody body, in EnvironmentCollision collision) =>
        Hits.Add(new Hit(body.Id, 0, IsAttack: false, collision.Impact));

    public void OnObjectCollision(WorldObject body, in ObjectCollision collision) =>
        Hits.Add(new Hit(body.Id, collision.ObjectId, IsAttack: false, collision.Impact));

    public void OnAttackCollision(WorldObject body, in AttackCollision collision) =>
        Hits.Add(new Hit(body.Id, collision.ObjectId, IsAttack: true, collision.Impact));

    public void OnCollisionEnd(WorldObject body, uint objectId)
    {
    }

    /// <summary>Something that was told.</summary>
    internal readonly record struct Hit(uint Told, uint Of, bool IsAttack, Impact Impact);
}
