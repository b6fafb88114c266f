using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Steering;

/// <summary>What a server makes of a body, asked of the body itself on flat ground.</summary>
public sealed class SteeredDoorTests
{
    private const uint Block = 0xA9B40000;
    private const double Quantum = 0.04;

    private readonly PhysicsEngine engine = Ask.Engine(Block, 0xAAB40000);
    private readonly PhysicsBody body;
    private double now;

    public SteeredDoorTests()
    {
        body = Walker(1, 10);
        Walker(2, 14);
        Run(0.2);
    }

    /// <summary>All it is asked to do, by name.</summary>
    public static TheoryData<string> Requests =>
        ["interpolate", "interpolate, keeping the heading", "leash", "longer leash", "stick", "move", "turn", "follow", "face"];

    [Theory, MemberData(nameof(Requests))]
    [Behaviour("engine.hash.managers", "design, decision 5: the hash is of all that decides what comes")]
    public void The_hash_of_the_state_tells_what_a_body_was_asked_to_do(string request)
    {
        ulong before = engine.HashState();
        SteeredDoorTests same = new(), other = new();
        Assert.Equal(before, same.engine.HashState());
        Request(request);
        same.Request(request);
        Assert.NotEqual(before, engine.HashState());
        Assert.Equal(engine.HashState(), same.engine.HashState());
        foreach (string one in Requests)
        {
            if (one == request) continue;
            other = new();
            other.Request(one);
            Assert.NotEqual(engine.HashState(), other.engine.HashState());
        }
    }

    [Fact, Behaviour("body.interpolates", "spec/09, 3.2: twice the running speed, here of run rate 1")]
    public void A_body_follows_a_position_at_twice_its_running_speed_and_is_done_when_it_is_there()
    {
        body.InterpolateTo(Ask.At(16, 10, 0));
        Assert.True(body.IsInterpolating);
        Run(3 * Quantum);
        float before = body.Position.Frame.Origin.X;
        Run(Quantum);
        Assert.Equal(8 * Quantum, body.Position.Frame.Origin.X - before, 1e-4);
        Run(1);
        Assert.False(body.IsInterpolating);
        Assert.Equal(16, body.Position.Frame.Origin.X, 0.06);

        body.InterpolateTo(Ask.At(10, 10, 0));
        body.StopInterpolating();
        Run(0.5);
        Assert.Equal(16, body.Position.Frame.Origin.X, 0.06);
    }

    [Fact, Behaviour("body.interpolates.blip", "spec/09, 3.2 and 3.5: more than 100 m outdoors")]
    public void A_position_too_far_to_walk_to_is_jumped_to()
    {
        body.InterpolateTo(Ask.At(10, 150, 0));
        Run(2 * Quantum);
        Assert.Equal((10f, 150f), (body.Position.Frame.Origin.X, body.Position.Frame.Origin.Y));
    }

    [Fact, Behaviour("body.move-or-teleport", "spec/09, 5.3; CPhysicsObj::MoveOrTeleport @0x00516330")]
    public void A_servers_position_is_followed_and_after_a_teleport_it_is_where_the_body_is()
    {
        Position place = Ask.At(12, 12, 0);
        engine.Player = engine.Find(2);
        Run(0.2);
        Assert.Equal(PositionUpdate.Ignored, body.MoveOrTeleport(place, teleported: false, contact: false));
        Assert.Equal(PositionUpdate.Interpolated, body.MoveOrTeleport(place, teleported: false, contact: true));
        Assert.True(body.IsInterpolating);
        Assert.Equal(PositionUpdate.Teleported, body.MoveOrTeleport(Ask.At(60, 60, 0), teleported: true, contact: true));
        Assert.False(body.IsInterpolating);
        Assert.Equal((60f, 60f), (body.Position.Frame.Origin.X, body.Position.Frame.Origin.Y));
    }

    [Fact, Behaviour("body.leash", "spec/09, 3.4: held after the longest path, while it has contact")]
    public void A_leash_holds_until_it_is_untied()
    {
        MovementManager manager = engine.MovementOf(body)!;
        body.ConstrainTo(body.Position, 1, 2);
        manager.DoMotion(MotionCommand.WalkForward, new MovementParameters());
        Run(4);
        float held = body.Position.Frame.Origin.Y;
        Assert.InRange(held, 10.5f, 12.5f);
        Run(1);
        Assert.Equal(held, body.Position.Frame.Origin.Y, 0.05);
        body.Unconstrain();
        Run(2);
        Assert.True(body.Position.Frame.Origin.Y > held + 3);
    }

    [Fact, Behaviour("body.moves-by-itself", "spec/09b, 5")]
    public void A_body_that_is_sent_somewhere_says_so_until_it_is_there_or_told_otherwise()
    {
        MovementManager manager = engine.MovementOf(body)!;
        Assert.False(body.IsMovingTo);
        manager.MoveToPosition(Ask.At(10, 20, 0), new MovementParameters());
        Assert.True(body.IsMovingTo);
        body.CancelMoveTo();
        Assert.False(body.IsMovingTo);
        manager.TurnToHeading(new MovementParameters { DesiredHeading = 90 });
        Run(3);
        Assert.False(body.IsMovingTo);
        Assert.Equal(90, body.Position.Frame.Heading, 0.5);
    }

    [Theory, Behaviour("body.steering.bad-input", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Numbers_that_are_not_finite_are_refused_and_nothing_changes(float bad)
    {
        ulong before = engine.HashState();
        Position nowhere = Ask.At(bad, 10, 0), noCell = Ask.At(10, 10, 0, 0xA9B40041);
        foreach (Position place in (Position[])[nowhere, noCell])
        {
            Assert.ThrowsAny<ArgumentException>(() => body.InterpolateTo(place));
            Assert.ThrowsAny<ArgumentException>(() => body.ConstrainTo(place, 1, 2));
            Assert.ThrowsAny<ArgumentException>(() => body.MoveOrTeleport(place, false, true));
        }

        Assert.ThrowsAny<ArgumentException>(() => body.ConstrainTo(body.Position, bad, 2));
        Assert.ThrowsAny<ArgumentException>(() => body.ConstrainTo(body.Position, 1, bad));
        Assert.ThrowsAny<ArgumentException>(() => engine.MovementOf(body)!.TurnToHeading(new MovementParameters { DesiredHeading = bad }));
        Assert.Equal(before, engine.HashState());
    }

    private PhysicsBody Walker(uint id, float x)
    {
        PhysicsBody made = engine.CreateBody(id, Ask.Walker.Setup, motions: new BodyMotions(HumanoidTable.Create(), new OtherWeenie()));
        Assert.True(made.EnterWorld(Ask.At(x, 10, 0.005f)));
        return made;
    }

    private void Run(double seconds)
    {
        for (int left = (int)Math.Round(seconds / Quantum); left > 0; left--) Assert.True(engine.Tick(now += Quantum));
    }

    private void Request(string request)
    {
        MovementManager manager = engine.MovementOf(body)!;
        Position place = Ask.At(13, 17, 0);
        switch (request)
        {
            case "interpolate": body.InterpolateTo(place); break;
            case "interpolate, keeping the heading": body.InterpolateTo(place, keepHeading: true); break;
            case "leash": body.ConstrainTo(place, 5, 10); break;
            case "longer leash": body.ConstrainTo(place, 5, 11); break;
            case "stick": body.StickToObject(2); break;
            case "move": manager.MoveToPosition(place, new MovementParameters()); break;
            case "turn": manager.TurnToHeading(new MovementParameters { DesiredHeading = 123 }); break;
            case "follow": Assert.True(manager.MoveToObject(2, new MovementParameters())); break;
            case "face": Assert.True(manager.TurnToObject(2, new MovementParameters())); break;
        }
    }
}
