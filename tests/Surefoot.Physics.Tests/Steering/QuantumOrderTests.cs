using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Queries;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>What a body of an engine does at the end of a quantum, and in which order (specification 02, 4.4; 09, 4.2; 09b, 2).</summary>
public sealed class QuantumOrderTests
{
    private const uint Block = 0xA9B40000, Watched = 1, Watcher = 2;
    private const double Quantum = 0.04;

    private readonly PhysicsEngine engine = Ask.Engine(Block);
    private double now;

    [Fact, Behaviour("body.quantum.targets-before-move-to", "spec/09, 4.2; spec/09b, 2; CPhysicsObj::UpdateObjectInternal @0x005156B0")]
    public void Who_tracks_a_body_is_told_where_it_is_before_its_own_move_to_goes_on()
    {
        (PhysicsBody body, Spy spy) = Spied(Watched, 10);
        PhysicsBody watcher = Body(Watcher, 20);
        SteeredPhysicsBody.Of(watcher).SetTarget(7, Watched, radius: 0.5f, quantum: 0);
        int reports = 0;
        for (int tick = 0; tick < 60; tick++)
        {
            float before = ReportedX(watcher);
            Tick();
            if (ReportedX(watcher) == before) continue;
            reports++;
            // The report of this quantum is out when the motion side has its turn, and tells where the body is now.
            Assert.Equal(body.Position.Frame.Origin.X, ReportedX(watcher));
            Assert.Equal(ReportedX(watcher), spy.ReportedX);
        }

        Assert.InRange(reports, 2, 5);

        float ReportedX(PhysicsBody tracker) => SteeredPhysicsBody.Of(tracker).TargetManager!.Target.TargetPosition.Frame.Origin.X;
    }

    [Fact, Behaviour("body.quantum.position-manager-last", "spec/09, 3.1 and 4.2; PositionManager::UseTime @0x00555160")]
    public void A_body_sticks_until_its_move_to_had_its_turn_and_lets_go_in_the_same_quantum()
    {
        (PhysicsBody body, Spy spy) = Spied(Watched, 10);
        Body(Watcher, 14);
        body.StickToObject(Watcher);
        int releases = 0;
        for (int tick = 0; tick < 40; tick++)
        {
            bool stuck = body.StickyObjectId != 0;
            Tick();
            if (!stuck || body.StickyObjectId != 0) continue;
            releases++;
            Assert.Equal(Watcher, spy.StickyId);
        }

        Assert.Equal(1, releases);
    }

    [Fact, Behaviour("body.quantum.pending-after-move-to", "spec/09b, 2 and 6.4; MovementManager::UseTime @0x005242F0")]
    public void What_a_move_to_begins_is_looked_at_in_the_same_quantum()
    {
        // Without animations a motion is done as soon as somebody looks: the end of the turn and the walk, begun by the move-to.
        PhysicsBody body = Body(Watched, 10);
        MovementManager movement = engine.MovementOf(body)!;
        movement.MoveToPosition(Ask.At(20, 10, 0), new MovementParameters());
        Assert.Equal((MotionCommand.TurnRight, true), (movement.MoveTo!.CurrentCommand, movement.MotionsPending));
        int ticks = 0;
        for (; movement.MoveTo.CurrentCommand != MotionCommand.WalkForward; ticks++) Tick();
        // A quarter of a turn at 1.5 rad/s takes more than a second.
        Assert.InRange(ticks, 1.04 / Quantum, 1.2 / Quantum);
        Assert.False(movement.MotionsPending);
    }

    private void Tick() => Assert.True(engine.Tick(now += Quantum));

    private PhysicsBody Body(uint id, float x)
    {
        PhysicsBody made = engine.CreateBody(id, Ask.Walker.Setup, motions: new BodyMotions(HumanoidTable.Create(), new OtherWeenie()));
        Assert.True(made.EnterWorld(Ask.At(x, 10, 0.005f)));
        return made;
    }

    /// <summary>A body whose motion side walks it and looks what the managers have done by then.</summary>
    private (PhysicsBody Body, Spy Spy) Spied(uint id, float x)
    {
        PhysicsBody made = Body(id, x);
        for (int tick = 0; tick < 5; tick++) Tick();
        Spy spy = new(made);
        SteeredPhysicsBody.Of(made).Attach(spy);
        return (made, spy);
    }

    private sealed class Spy(PhysicsBody body) : IBodyMovement
    {
        private const float Speed = 2;

        /// <summary>Where the watcher had been told that the body is.</summary>
        public float ReportedX { get; private set; }

        /// <summary>What the body stuck to.</summary>
        public uint StickyId { get; private set; }

        public void UseTime()
        {
            ReportedX = SteeredPhysicsBody.Of(body).Find(Watcher)?.TargetManager?.Target.TargetPosition.Frame.Origin.X ?? float.NaN;
            StickyId = body.StickyObjectId;
        }

        public void AccumulateRootMotion(float quantum, ref Frame offset) =>
            offset.Origin = new System.Numerics.Vector3(Speed * quantum, 0, 0);

        public void HitGround()
        {
        }

        public void LeaveGround()
        {
        }

        public void HandleEnterWorld()
        {
        }

        public void HandleExitWorld()
        {
        }
    }
}
