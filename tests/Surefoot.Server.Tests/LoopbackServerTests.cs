using System.Numerics;
using CsCheck;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests;

public class LoopbackServerTests
{
    private const uint Player = 0x50000001, RunKey = 2, WalkForward = 0x45000005, SideStepRight = 0x6500000F;
    private const ushort Run = 0x07, Wave = 0x87, Bow = 0x7D, Reload = 0x4A;

    private static readonly WirePosition Place = new(0xA9B40001, new Vector3(12, 12, 0), Quaternion.Identity);

    private static MoveToState Asks(in WireRawMotion motion, bool contact = true, bool longJump = false) =>
        new(motion, Place, new MovementStamps(1, 0, 0, 0), contact, longJump);

    /// <summary>A server whose login has been heard.</summary>
    private static LoopbackServer LoggedIn(CharacterStats stats, double latency = 0)
    {
        LoopbackServer server = new(Player, stats, 0, latency);
        server.Receive(0, new Listener());
        return server;
    }

    private static Listener Hear(LoopbackServer server, double now)
    {
        Listener heard = new();
        server.Receive(now, heard);
        return heard;
    }

    [Fact]
    [Behaviour("loopback.login-tells-the-character", "spec/08, 7.3 and 8.6")]
    public void The_login_tells_all_numbers_at_once_whatever_the_latency()
    {
        LoopbackServer server = new(Player, new CharacterStats(300, 250, Stamina: 80, Strength: 90, Augmentations: 2, Burden: 5000), now: 7,
            latency: 3);
        Listener heard = new();
        server.Receive(7, heard);
        PlayerDescription all = heard.Description!;
        Assert.Equal([new(5, 5000), new(134, 2), new(230, 2)], all.Ints!.Value.Span.ToArray());
        Assert.Equal((90u, 80u), (all.Attributes!.Strength!.Value.Start, all.Vitals!.Stamina!.Value.Current));
        Assert.Equal([(22u, 250u), (24u, 300u)], all.Skills!.Value.Span.ToArray().Select(skill => (skill.Id, skill.Value.Initial)));
        Assert.Equal(0, server.PendingCount);
    }

    [Fact]
    [Behaviour("loopback.answers-each-move-to-state", "spec/08, 5.7 and 4.3")]
    public void Each_MoveToState_is_told_to_everybody_as_the_players_own_after_the_latency()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300), latency: 0.5);
        server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward)), 1.0);
        server.Send(Asks(new WireRawMotion(RunKey)), 1.25);
        Assert.Empty(Hear(server, 1.49).Heard);
        UpdateMotion first = Assert.Single(Hear(server, 1.5).Motions);
        Assert.Equal((Player, (ushort)1, (ushort)1, (ushort)0, true),
            (first.Guid, first.Instance, first.MovementStamp, first.ServerControlledMove, first.Autonomous));
        Assert.Equal(MotionTranslation.Interpret(new WireRawMotion(RunKey, forwardCommand: WalkForward), 2.6500001f, false),
            first.Movement);
        UpdateMotion second = Assert.Single(Hear(server, 2).Motions);
        Assert.Equal((2, new WireInterpretedMotion()), (second.MovementStamp, second.Movement.State));
    }

    [Fact]
    [Behaviour("loopback.run-rate-change-is-an-order", "spec/08, 5.7 (run rate changed) and 8.8")]
    public void A_changed_run_rate_orders_a_runner_to_go_on_at_the_new_speed()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300));
        server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward)), 0);
        Hear(server, 0);
        server.SetStats(new CharacterStats(800, 300), 1);
        Listener heard = Hear(server, 1);
        Assert.Equal([new MessageId(Opcode.PrivateUpdateSkill), new MessageId(Opcode.UpdateMotion)], heard.Heard);
        UpdateMotion order = Assert.Single(heard.Motions);
        Assert.Equal((2, 1, false), (order.MovementStamp, order.ServerControlledMove, order.Autonomous));
        Assert.Equal(new WireInterpretedMotion(forwardCommand: Run, forwardSpeed: 4.5f), order.Movement.State);

        server.Send(Asks(new WireRawMotion(RunKey)), 2);
        UpdateMotion echo = Assert.Single(Hear(server, 2).Motions);
        Assert.Equal((3, 1, true), (echo.MovementStamp, echo.ServerControlledMove, echo.Autonomous));
    }

    [Fact]
    [Behaviour("loopback.run-rate-change-orders-nobody-else", "spec/08, 5.7 (run rate changed)")]
    public void A_changed_run_rate_orders_nothing_to_who_stands_walks_or_is_in_the_air()
    {
        Assert.Empty(Orders(_ => { }));
        Assert.Empty(Orders(server => server.Send(Asks(new WireRawMotion(RunKey)), 0)));
        Assert.Empty(Orders(server => server.Send(Asks(new WireRawMotion(forwardCommand: WalkForward)), 0)));
        Assert.Empty(Orders(server => server.Send(Asks(new WireRawMotion(RunKey, sidestepCommand: SideStepRight)), 0)));
        Assert.Empty(Orders(server => server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward), longJump: true), 0)));
        Assert.Empty(Orders(server => server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward), contact: false), 0)));
        Assert.Empty(Orders(server =>
        {
            server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward)), 0);
            server.Send(new Jump(1, new Vector3(0, 10, 9), Place, new MovementStamps(1, 0, 0, 0)), 0);
        }));
        Assert.Single(Orders(server =>
        {
            server.Send(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward), contact: false), 0);
            server.Send(new AutonomousPosition(Place, new MovementStamps(1, 0, 0, 0), Contact: true), 0);
        }));

        // 300 to 400: a sidestep is at its greatest speed at both.
        static List<UpdateMotion> Orders(Action<LoopbackServer> before)
        {
            LoopbackServer server = LoggedIn(new CharacterStats(300, 300));
            before(server);
            Hear(server, 0);
            server.SetStats(new CharacterStats(400, 300), 1);
            return Hear(server, 1).Motions;
        }
    }

    [Fact]
    [Behaviour("loopback.tells-what-changed", "spec/08, 7.1")]
    public void Only_numbers_that_changed_are_told_each_kind_counted_by_itself()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300));
        server.SetStats(new CharacterStats(300, 300), 1);
        Assert.Equal(0, server.PendingCount);
        server.SetStats(new CharacterStats(301, 302), 1);
        server.SetStats(new CharacterStats(303, 302), 1);
        List<PrivateUpdateSkill> skills = Hear(server, 1).Skills;
        Assert.Equal([(0, 24u, 301u), (0, 22u, 302u), (1, 24u, 303u)],
            skills.Select(skill => ((int)skill.Sequence, skill.Skill, skill.Record.Initial)));

        server.SetStats(new CharacterStats(303, 302, Stamina: 0, Strength: 10, Augmentations: 1, Burden: 6), 1);
        Assert.Equal(
            [Opcode.PrivateUpdateAttribute, Opcode.PrivateUpdateAttribute2ndLevel, Opcode.PrivateUpdatePropertyInt,
                Opcode.PrivateUpdatePropertyInt],
            Hear(server, 1).Heard.Select(id => id.Opcode));
    }

    [Fact]
    [Behaviour("loopback.actions", "spec/08, 5.7 (actions) and 5.3")]
    public void Emotes_at_the_usual_speed_are_passed_on_with_the_servers_stamps_and_without_any_nothing_is_told()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300));
        server.Send(Asks(new WireRawMotion(actions: new MotionActions([new(Reload, 9, true, 1f), new(Wave, 10, true, 1.5f)]))), 0);
        Assert.Empty(Hear(server, 0).Motions);
        MotionActions actions = new([new(Reload, 9, true, 1f), new(Wave, 10, true, 1f), new(Bow, 11, false, 1f)]);
        server.Send(Asks(new WireRawMotion(actions: actions)), 0);
        UpdateMotion told = Assert.Single(Hear(server, 0).Motions);
        Assert.Equal([new(Wave, 2, true, 1f), new(Bow, 3, false, 1f)], told.Movement.State.Actions.Span.ToArray());
    }

    [Fact]
    [Behaviour("loopback.burden-slows", "spec/01, 4.1 and 6")]
    public void Burden_slows_the_servers_rate() =>
        Assert.Equal(1.82500005f, new LoopbackServer(Player, new CharacterStats(300, 300, Burden: 22500), 0).RunRate);

    [Fact]
    [Behaviour("loopback.messages-in-order", "design.md, Who uses it")]
    public void Messages_arrive_in_order_and_none_too_early() =>
        Gen.Select(Gen.Int[1, 900], Gen.Double[0, 0.3], Gen.Double[0, 0.3]).List[1, 30].Sample(changes =>
        {
            LoopbackServer server = LoggedIn(new CharacterStats(0, 0));
            Listener heard = new();
            double now = 0, earliest = 0;
            List<(uint Skill, double Due)> expected = [];
            foreach ((int skill, double latency, double wait) in changes)
            {
                int before = server.Stats.RunSkill;
                server.Latency = latency;
                server.SetStats(new CharacterStats(skill, 0), now);
                if (skill != before) expected.Add(((uint)skill, earliest = Math.Max(earliest, now + latency)));
                now += wait;
                server.Receive(now, heard);
                if (heard.Skills.Count != expected.Count(one => one.Due <= now)) return false;
            }

            IEnumerable<uint> arrived = expected.Take(heard.Skills.Count).Select(one => one.Skill);
            return heard.Skills.Select(skill => skill.Record.Initial).SequenceEqual(arrived);
        });

    [Fact]
    [Behaviour("loopback.bad-input", "design, decision 7")]
    public void Bad_numbers_are_refused_and_change_nothing()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(100, 100));
        Assert.Throws<ArgumentOutOfRangeException>(() => server.SetStats(new CharacterStats(-1, 0), 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => server.SetStats(new CharacterStats(0, 0, Strength: -1), 0));
        Assert.Throws<ArgumentException>(() => server.SetStats(new CharacterStats(5, 5), double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => server.Latency = double.NaN);
        Assert.Throws<ArgumentException>(() => server.Send(Asks(new WireRawMotion(RunKey)), double.PositiveInfinity));
        Assert.Throws<ArgumentOutOfRangeException>(() => new LoopbackServer(0, default, 0));
        Assert.Equal((100, 0.0, 0), (server.Stats.RunSkill, server.Latency, server.PendingCount));
    }

    [Fact]
    [Behaviour("loopback.unreadable-is-counted", "design, decision 7")]
    public void Bytes_that_cannot_be_read_are_counted_and_change_nothing()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300));
        byte[] bytes = new byte[256];
        Assert.True(WireMessage.TryWrite(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward)), bytes, out int length, stamp: 1));
        int unreadable = 0;
        for (int cut = 0; cut < length; cut++)
        {
            // Up to three bytes at the end only fill it up; a wrapper that is cut short names no action.
            server.Take(bytes.AsSpan(0, cut), 0);
            if (cut is < 4 or >= 12) unreadable++;
        }

        Assert.Equal((unreadable, 0), (server.UnreadableCount, server.PendingCount));
        Gen.Byte.Array[0, 120].Sample(noise => server.Take(noise, 0));
        Gen.Select(Gen.Int[12, length - 1], Gen.Byte).Sample(change =>
        {
            byte[] damaged = bytes[..length];
            damaged[change.Item1] = change.Item2;
            server.Take(damaged, 0);
        });
    }

    [Fact]
    [Behaviour("loopback.allocates-nothing", "design, decision 4")]
    public void Told_again_and_again_it_allocates_nothing()
    {
        LoopbackServer server = LoggedIn(new CharacterStats(300, 300), latency: 1);
        Silent silent = new();
        MoveToState move = Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward));
        for (int i = 0; i < 100; i++) Advance(i);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 100; i < 300; i++) Advance(i);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        void Advance(int i)
        {
            server.Send(move, i * 0.1);
            server.Receive(i * 0.1, silent);
        }
    }

    private sealed class Silent : Protocol.Session.IMessageReceiver
    {
        public void OnMessage(in WireMessage message)
        {
        }
    }
}
