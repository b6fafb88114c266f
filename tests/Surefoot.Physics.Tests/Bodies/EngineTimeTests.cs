using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Queries;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>The engine's clock.</summary>
public sealed class EngineTimeTests
{
    [Fact, Behaviour("engine.time.backwards", "CPhysics::UseTime @0x00509950: time that has run backwards is begun anew")]
    public void A_clock_that_is_set_back_moves_nobody_and_goes_on_from_there()
    {
        PhysicsEngine engine = Ask.Engine(0xA9B40000);
        PhysicsBody body = engine.CreateBody(1, Ask.Walker.Setup);
        Assert.True(engine.Tick(100));
        body.Seat(new BodySeat(Ask.At(10, 10, 50), new Vector3(3, 0, 0), TransientState.None, default, 0, Vector3.Zero));
        body.SetActive(true);
        Assert.True(engine.Tick(100.05));
        Vector3 before = body.Position.Frame.Origin;
        Assert.False(engine.Tick(40));
        Assert.Equal((before, 40.0), (body.Position.Frame.Origin, engine.Now));
        Assert.True(engine.Tick(40.05));
        Assert.True(engine.Tick(40.1));
        Assert.InRange(body.Position.Frame.Origin.X - before.X, 0.1f, 0.35f);
    }
}
