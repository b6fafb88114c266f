using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>
/// The body of specification 02, 6: one sphere of radius 0.5 on flat dry ground at z = 0, without movement side or weenie.
/// </summary>
internal sealed class BodyFixture
{
    internal const float Tick = 1f / 30;
    internal const TransientState Standing = TransientState.Contact | TransientState.OnWalkable;

    internal BodyFixture(PhysicsState state = PhysicsState.Default)
    {
        World = new StubWorld(_ => StubWorld.Flat(0));
        Engine = new PhysicsEngine(World);
        Body = Engine.CreateBody(1, StubWorld.Setup(new Sphere(new Vector3(0, 0, 0.5f), 0.5f)), state);
    }

    internal StubWorld World { get; }

    internal PhysicsEngine Engine { get; }

    internal PhysicsBody Body { get; }

    internal WorldQuery Query => field ??= Engine.CreateQuery();

    internal float Z => Body.Position.Frame.Origin.Z;

    internal float Y => Body.Position.Frame.Origin.Y;

    internal void Seat(Vector3 origin, Vector3 velocity, TransientState transient, Plane? plane = null)
    {
        Body.Seat(new BodySeat(
            new Position(StubWorld.CellId, origin), velocity, transient, plane ?? StubWorld.Flat(0), StubWorld.CellId, Vector3.Zero));
        Body.SetActive(true);
    }
}
