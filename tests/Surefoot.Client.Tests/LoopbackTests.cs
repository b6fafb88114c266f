using CsCheck;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

/// <summary>A client and a server in the same process.</summary>
public class LoopbackTests
{
    private static (KeyFixture Client, LoopbackServer Server) Connected(CharacterStats stats, double latency)
    {
        LoopbackServer server = new(KeyFixture.Id, stats, 0, latency);
        KeyFixture client = new(table: HumanoidTable.Create(links: true), server: server);
        client.Hear();
        return (client, server);
    }

    [Fact]
    [Behaviour("loopback.old-rate-until-the-answer", "design.md, Who uses it; spec/08, 5.7")]
    public void Until_the_answer_arrives_the_player_keeps_the_old_rate()
    {
        (KeyFixture f, LoopbackServer server) = Connected(new CharacterStats(0, 0), latency: 0.5);
        f.Press(MovementKeys.Forward, 30);
        f.Hear();
        Assert.Equal((MotionCommand.RunForward, 1f), f.Forward);

        server.SetStats(new CharacterStats(300, 300), f.Now);
        f.Now += 0.49;
        f.Hear();
        Assert.Equal(1f, f.Forward.Speed);
        Assert.True(f.Interpreter.Weenie!.InqJumpVelocity(1f, out float before));
        Assert.Equal(2.61916018f, before);

        f.Now += 0.02;
        f.Hear();
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        Assert.True(f.Interpreter.Weenie!.InqJumpVelocity(1f, out float after));
        Assert.Equal(9.08652878f, after);
        Assert.Equal(0, server.PendingCount);
    }

    [Fact]
    [Behaviour("loopback.motion-begun-before-the-answer-keeps-its-rate", "spec/08, 5.7 and 4.3 (own echo); spec/01, 4.1")]
    public void A_motion_begun_while_a_new_skill_is_on_its_way_keeps_the_old_rate_until_it_is_begun_anew()
    {
        (KeyFixture f, LoopbackServer server) = Connected(new CharacterStats(300, 300), latency: 0.5);
        server.SetStats(new CharacterStats(800, 300), f.Now);
        f.Press(MovementKeys.Forward);
        f.Now += 1;
        f.Hear();
        Assert.Equal(0, server.PendingCount);
        f.Press(MovementKeys.Forward, 30);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        Assert.False(f.Controller.IsControlledByServer);

        f.Press(MovementKeys.None);
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 4.5f), f.Forward);
    }

    [Fact]
    [Behaviour("loopback.new-rate-takes-control-and-held-keys-take-it-back", "spec/08, 5.7 (run rate changed) and 5.6")]
    public void A_new_rate_takes_control_and_held_keys_take_it_back_untold()
    {
        (KeyFixture f, LoopbackServer server) = Connected(new CharacterStats(300, 300), latency: 0);
        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft, 30);
        f.Hear();
        int sent = f.Sent.Moves.Count;
        server.SetStats(new CharacterStats(800, 300), f.Now);
        f.Hear();
        Assert.True(f.Controller.IsControlledByServer);
        Assert.Equal((MotionCommand.RunForward, 4.5f), f.Forward);

        f.Press(MovementKeys.Forward | MovementKeys.TurnLeft, 30);
        Assert.False(f.Controller.IsControlledByServer);
        Assert.Equal(((MotionCommand.RunForward, 4.5f), (MotionCommand.TurnRight, -1.5f)), (f.Forward, f.Turn));
        Assert.Equal(sent, f.Sent.Moves.Count);
    }

    [Fact]
    [Behaviour("loopback.says-what-the-player-does", "spec/08, 8.8; spec/01, 4.2 and 4.3")]
    public void What_everybody_is_told_is_what_the_players_own_body_does() =>
        Gen.Select(Gen.Int[0, 0x7F], Gen.Int[0, 900]).Sample(
            hands =>
            {
                (KeyFixture f, LoopbackServer server) = Connected(new CharacterStats(hands.Item2, 0), latency: 0);
                f.Press((MovementKeys)hands.Item1);
                if (f.Sent.Moves.Count == 0) return;
                InterpretedMotionState told = new(), does = f.Interpreter.Interpreted;
                MovementData said = MotionTranslation.Interpret(f.LastSent.Message.Motion, server.RunRate, standingLongJump: false);
                Assert.True(WireForms.TryRead(said.State, CommandTable.Retail, told));
                Assert.Equal((does.ForwardCommand, does.ForwardSpeed), (told.ForwardCommand, told.ForwardSpeed));
                Assert.Equal((does.SidestepCommand, does.SidestepCommand == 0 ? 1 : does.SidestepSpeed),
                    (told.SidestepCommand, told.SidestepSpeed));
                Assert.Equal((does.TurnCommand, does.TurnCommand == 0 ? 1 : does.TurnSpeed), (told.TurnCommand, told.TurnSpeed));
            },
            iter: Fuzz.Cases(500), threads: 1);
}
