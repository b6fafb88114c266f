using CsCheck;
using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

public class LoopbackServerTests
{
    private static RawMotionState Raw(Action<RawMotionState>? change = null)
    {
        RawMotionState raw = new() { CurrentHoldKey = HoldKey.Run };
        change?.Invoke(raw);
        return raw;
    }

    [Fact]
    [Behaviour("loopback.interprets-like-a-server", "spec/08, section 8")]
    public void A_raw_state_is_normalised_with_the_servers_run_rate()
    {
        InterpretedMotionState run = LoopbackServer.Interpret(Raw(r => r.ForwardCommand = MotionCommand.WalkForward), 2.65f, false);
        Assert.Equal((MotionCommand.RunForward, 2.65f), (run.ForwardCommand, run.ForwardSpeed));
        InterpretedMotionState walk = LoopbackServer.Interpret(Raw(r => (r.CurrentHoldKey, r.ForwardCommand) = (HoldKey.None, MotionCommand.WalkForward)), 2.65f, false);
        Assert.Equal((MotionCommand.WalkForward, 1f), (walk.ForwardCommand, walk.ForwardSpeed));
        InterpretedMotionState back = LoopbackServer.Interpret(Raw(r => r.ForwardCommand = MotionCommand.WalkBackwards), 2.65f, false);
        Assert.Equal((MotionCommand.WalkForward, -0.65f), (back.ForwardCommand, back.ForwardSpeed));
        InterpretedMotionState left = LoopbackServer.Interpret(
            Raw(r => (r.SidestepCommand, r.TurnCommand) = (MotionCommand.SideStepLeft, MotionCommand.TurnLeft)), 2.65f, false);
        Assert.Equal((MotionCommand.SideStepRight, -1.248f, MotionCommand.TurnRight, -1.5f), (left.SidestepCommand, left.SidestepSpeed, left.TurnCommand, left.TurnSpeed));
        InterpretedMotionState held = LoopbackServer.Interpret(Raw(r => r.ForwardCommand = MotionCommand.WalkForward), 2.65f, true);
        Assert.Equal(MotionCommand.Ready, held.ForwardCommand);
    }

    [Fact]
    [Behaviour("loopback.old-rate-until-the-answer", "design.md, Who uses it")]
    public void Until_the_answer_arrives_the_player_keeps_the_old_rate()
    {
        KeyFixture f = new(new PlayerWeenie(new CharacterStats(0, 0), RunRateSource.Server));
        LoopbackServer server = new(new CharacterStats(0, 0), f.Now);
        server.Deliver(f.Controller, f.Now);
        f.Press(MovementKeys.Forward, 3);
        Assert.Equal((MotionCommand.RunForward, 1f), f.Forward);

        server.Latency = 0.5;
        server.OnMoveToState(f.Sent.Moves[^1]);
        server.SetStats(new CharacterStats(300, 300), f.Now);
        double changed = f.Now;
        server.Deliver(f.Controller, changed + 0.49);
        Assert.Equal(1f, f.Forward.Speed);
        Assert.True(f.Interpreter.Weenie!.InqJumpVelocity(1f, out float before));
        Assert.Equal(2.61916018f, before);

        server.Deliver(f.Controller, changed + 0.5);
        Assert.Equal(2.6500001f, f.Forward.Speed);
        Assert.True(f.Interpreter.Weenie!.InqJumpVelocity(1f, out float after));
        Assert.Equal(9.08652878f, after);
        Assert.Equal(0, server.PendingCount);
    }

    [Fact]
    [Behaviour("loopback.update-motion-alone-carries-the-rate", "design.md")]
    public void The_forward_speed_of_the_answer_is_adopted()
    {
        KeyFixture f = new(new PlayerWeenie(new CharacterStats(0, 0), RunRateSource.Server));
        f.Press(MovementKeys.Forward);
        LoopbackServer server = new(new CharacterStats(800, 0), f.Now);
        server.OnMoveToState(f.Sent.Moves[^1]);
        MotionOnly handler = new(f.Controller);
        server.Deliver(handler, f.Now);
        Assert.Equal((MotionCommand.RunForward, 4.5f), f.Forward);
    }

    [Fact]
    [Behaviour("loopback.burden-slows", "spec/01, 4.1 and 6")]
    public void Burden_slows_the_servers_rate()
    {
        LoopbackServer server = new(new CharacterStats(300, 300, Burden: 22500), 0);
        Assert.Equal(1.82500005f, server.RunRate);
    }

    [Fact]
    [Behaviour("loopback.messages-in-order", "design.md, Who uses it")]
    public void Messages_arrive_in_order_and_none_too_early() =>
        Gen.Select(Gen.Int[0, 900], Gen.Double[0, 0.3]).List[1, 30].Sample(changes =>
        {
            LoopbackServer server = new(new CharacterStats(0, 0), 0);
            Skills handler = new();
            double now = 0;
            List<int> expected = [0];
            foreach ((int skill, double wait) in changes)
            {
                server.SetStats(new CharacterStats(skill, 0), now);
                expected.Add(skill);
                now += wait;
                server.Deliver(handler, now);
            }

            return handler.Seen.SequenceEqual(expected);
        });

    [Fact]
    [Behaviour("loopback.bad-input", "design, decision 7")]
    public void Bad_numbers_are_refused()
    {
        LoopbackServer server = new(new CharacterStats(100, 100), 0);
        Assert.Throws<ArgumentOutOfRangeException>(() => server.SetStats(new CharacterStats(-1, 0), 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => server.Latency = double.NaN);
        Assert.Equal((100, 0.0), (server.Stats.RunSkill, server.Latency));
    }

    private sealed class MotionOnly(IServerMessageHandler inner) : IServerMessageHandler
    {
        public void HandleUpdateMotion(in UpdateMotionEvent message) => inner.HandleUpdateMotion(message);

        public void HandleCharacterUpdate(in CharacterUpdateEvent message)
        {
        }
    }

    private sealed class Skills : IServerMessageHandler
    {
        internal List<int> Seen { get; } = [];

        public void HandleUpdateMotion(in UpdateMotionEvent message)
        {
        }

        public void HandleCharacterUpdate(in CharacterUpdateEvent message) => Seen.Add(message.Stats.RunSkill);
    }
}
