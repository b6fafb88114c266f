using System.Numerics;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests;

public class PlayerBroadcastTests
{
    private const uint Player = 0x50000001, Setup = 0x02000001, Motions = 0x09000001, RunKey = 2;
    private const uint WalkForward = 0x45000005, TurnRight = 0x6500000D;
    private const ushort RunForward = 0x07, Wave = 0x87, Reload = 0x4A;

    private static readonly MovementStamps NoStamps = new(1, 0, 0, 0);
    private static readonly WireRawMotion Runs = new(RunKey, forwardCommand: WalkForward);

    private readonly Audience audience = new();
    private readonly PlayerBroadcast broadcast;

    public PlayerBroadcastTests() => broadcast = new PlayerBroadcast(Player, At(12), audience, runRate: 2.5f);

    private PlayerBroadcast Full() => new(Player, At(12), audience, runRate: 2.5f) { Detail = BroadcastDetail.Full };

    /// <summary>Updates 32 times a second, the end left out.</summary>
    private static void Pass(PlayerBroadcast broadcast, double from, double to)
    {
        for (double now = from; now < to; now += 1 / 32.0) broadcast.Update(now);
    }

    private static WirePosition At(float y) => new(0xA9B40001, new Vector3(12, y, 0), Quaternion.Identity);

    private static MoveToState Asks(in WireRawMotion motion, float y = 12, bool contact = true) =>
        new(motion, At(y), NoStamps, contact, StandingLongJump: false);

    [Fact]
    [Behaviour("broadcast.move-to-state", "spec/08, 5.7 and 8.8")]
    public void Keys_are_told_as_the_players_own_motion_at_the_servers_speed_with_its_place()
    {
        broadcast.Take(Asks(Runs, y: 13), now: 5);
        UpdateMotion motion = Assert.IsType<UpdateMotion>(audience.Told[0]);
        Assert.Equal((Player, (ushort)1, (ushort)1, (ushort)0, true),
            (motion.Guid, motion.Instance, motion.MovementStamp, motion.ServerControlledMove, motion.Autonomous));
        Assert.Equal(new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 2.5f), motion.Movement.State);
        UpdatePosition position = Assert.IsType<UpdatePosition>(audience.Told[1]);
        Assert.Equal(new UpdatePosition(Player, new PositionPack(At(13), true, 1, 1, 0, 0)), position);
        Assert.Equal(2, audience.Told.Count);
    }

    [Fact]
    [Behaviour("broadcast.positions-of-motions-once-a-second", "spec/08, 5.7 and 8.7")]
    public void Places_of_motions_are_told_once_a_second_and_those_that_come_alone_always()
    {
        broadcast.Take(Asks(Runs, y: 1), now: 0);
        broadcast.Take(Asks(new WireRawMotion(RunKey), y: 2), now: 0.5);
        broadcast.Take(new AutonomousPosition(At(3), NoStamps, Contact: true), now: 0.625);
        broadcast.Take(new AutonomousPosition(At(4), NoStamps, Contact: true), now: 0.75);
        broadcast.Take(Asks(Runs, y: 5), now: 1.75);
        broadcast.Take(Asks(Runs, y: 6), now: 1.875);
        Assert.Equal([1f, 3f, 4f, 5f], audience.Positions.Select(item => item.Pack.Position.Origin.Y));
        Assert.Equal([1, 2, 3, 4], audience.Positions.Select(item => (int)item.Pack.PositionStamp));
        Assert.Equal([1, 2, 3, 4], audience.Motions.Select(item => (int)item.MovementStamp));
    }

    [Fact]
    [Behaviour("broadcast.jump", "spec/08, 5.7 (Jump); 09, 4.4")]
    public void A_jump_is_told_as_standing_and_then_the_velocity_in_the_axes_of_the_world()
    {
        broadcast.Take(Asks(Runs), now: 0);
        audience.Told.Clear();
        Quaternion left = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, MathF.PI / 2);
        broadcast.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12) with { Orientation = left }, NoStamps));
        UpdateMotion motion = Assert.IsType<UpdateMotion>(audience.Told[0]);
        Assert.Equal((new WireInterpretedMotion(), (ushort)0, true), (motion.Movement.State, motion.Movement.Style, motion.Autonomous));
        VectorUpdate vector = Assert.IsType<VectorUpdate>(audience.Told[1]);
        Assert.Equal((Player, (ushort)1, (ushort)1), (vector.Guid, vector.Instance, vector.VectorStamp));
        Assert.True(Vector3.Distance(new Vector3(-4, 0, 5), vector.Velocity) < 1e-5);
        Assert.Equal(2, audience.Told.Count);
    }

    [Fact]
    [Behaviour("broadcast.after-a-jump", "spec/08, 5.7 (Jump): nothing follows it")]
    public void Whoever_lands_is_seen_standing_until_its_keys_change()
    {
        broadcast.Take(Asks(Runs), now: 0);
        broadcast.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12), NoStamps));
        audience.Told.Clear();
        broadcast.Take(new AutonomousPosition(At(20), NoStamps, Contact: true), now: 1);
        Assert.IsType<UpdatePosition>(Assert.Single(audience.Told));
    }

    [Fact]
    [Behaviour("broadcast.full.jump", "BroadcastDetail.Full; spec/09, 4.4: a turn has no velocity")]
    public void In_full_a_jumper_turns_in_the_air_and_runs_on_where_it_lands()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward, turnCommand: TurnRight)), now: 0);
        full.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12), NoStamps));
        Assert.Equal(new WireInterpretedMotion(turnCommand: 0x0D, turnSpeed: 1.5f), audience.Motions.Last().Movement.State);
        full.Take(new AutonomousPosition(At(20), NoStamps, Contact: true), now: 1);
        Assert.Equal(
            new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 2.5f, turnCommand: 0x0D, turnSpeed: 1.5f),
            audience.Motions.Last().Movement.State);
        full.Take(new AutonomousPosition(At(21), NoStamps, Contact: true), now: 2);
        Assert.Equal(3, audience.Motions.Count());
    }

    [Fact]
    [Behaviour("broadcast.full.air", "BroadcastDetail.Full; spec/09, 4.4: LeaveGround puts the motion's velocity for the jump's")]
    public void In_full_a_jumper_whose_keys_change_in_the_air_has_no_motion_that_would_take_its_velocity()
    {
        PlayerBroadcast full = Full();
        full.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12), NoStamps));
        full.Take(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward, turnCommand: TurnRight), y: 14, contact: false), now: 0.5);
        Assert.Equal(new WireInterpretedMotion(turnCommand: 0x0D, turnSpeed: 1.5f), audience.Motions.Last().Movement.State);
        full.Take(Asks(Runs, y: 20), now: 1);
        Assert.Equal(new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 2.5f), audience.Motions.Last().Movement.State);
    }

    [Fact]
    [Behaviour("broadcast.full.falls", "BroadcastDetail.Full; spec/09, 5.4: it does what the message says")]
    public void In_full_who_runs_over_an_edge_without_a_jump_is_told_running_on()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(Runs, y: 14, contact: false), now: 0.5);
        Assert.Equal(new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 2.5f), audience.Motions.Last().Movement.State);
    }

    [Theory]
    [Behaviour("broadcast.full.landing", "BroadcastDetail.Full; spec/09, 5.2: a velocity acts when its VECTOR stamp is newer")]
    [InlineData(true)]
    [InlineData(false)]
    public void In_full_who_landed_has_no_velocity_any_more_by_a_newer_stamp_than_the_take_off(bool byKeys)
    {
        PlayerBroadcast full = Full();
        full.Take(new AutonomousPosition(At(12), NoStamps, Contact: true), now: 0);
        Pass(full, from: 0, to: 0.5);
        Assert.Empty(audience.Told.OfType<VectorUpdate>());
        full.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12), NoStamps));
        full.Take(new AutonomousPosition(At(15), NoStamps, Contact: false), now: 0.5);
        Pass(full, from: 0.5, to: 1);
        if (byKeys) full.Take(Asks(Runs, y: 20), now: 1);
        else full.Take(new AutonomousPosition(At(20), NoStamps, Contact: true), now: 1);
        Pass(full, from: 1, to: 1.375);
        VectorUpdate takeOff = new(Player, new Vector3(0, 4, 5), default, 1, 1), landed = new(Player, default, default, 1, 2);
        Assert.Equal([takeOff], audience.Told.OfType<VectorUpdate>().Distinct());
        Pass(full, from: 1.375, to: 3);
        Assert.Equal([takeOff, landed], audience.Told.OfType<VectorUpdate>().Distinct());
    }

    [Fact]
    [Behaviour("broadcast.full.places", "BroadcastDetail.Full")]
    public void In_full_each_motion_comes_with_its_place()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(Runs, y: 1), now: 0);
        full.Update(0);
        full.Take(Asks(new WireRawMotion(RunKey), y: 2), now: 0.0625);
        full.Update(0.0625);
        Assert.Equal([1f, 2f], audience.Positions.Select(item => item.Pack.Position.Origin.Y));
        Assert.All(audience.Positions, item => Assert.True(item.Pack.Contact));
    }

    [Fact]
    [Behaviour("broadcast.full.take-off", "BroadcastDetail.Full; spec/09, 3.2, 4.4 and 5.3")]
    public void In_full_a_take_off_leaves_no_place_to_go_back_to()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(Runs, y: 1), now: 0);
        full.Update(0);
        full.Take(Asks(Runs, y: 4), now: 0.5);
        full.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(4), NoStamps));
        Pass(full, from: 0.5, to: 1);
        UpdatePosition[] places = [.. audience.Positions.Distinct()];
        Assert.Equal([(1f, true, 1), (4f, false, 2)],
            places.Select(item => (item.Pack.Position.Origin.Y, item.Pack.Contact, (int)item.Pack.PositionStamp)));
    }

    [Fact]
    [Behaviour("broadcast.full.stairs", "BroadcastDetail.Full")]
    public void In_full_places_that_come_alone_are_told_five_times_a_second_and_the_last_of_them_always()
    {
        PlayerBroadcast full = Full();
        for (int frame = 0; frame <= 10; frame++)
        {
            double now = frame / 32.0;
            full.Take(new AutonomousPosition(At(frame), NoStamps, Contact: true), now);
            full.Update(now);
        }

        Pass(full, from: 11 / 32.0, to: 0.5);
        // 0.2 s are 6.4 frames: the first, the one that is seven later, and the last, when as much time has passed again.
        Assert.Equal([0f, 7f, 10f], audience.Positions.Distinct().Select(item => item.Pack.Position.Origin.Y));
    }

    [Fact]
    [Behaviour("broadcast.full.again", "BroadcastDetail.Full; spec/09, 5.2: a duplicate is dropped")]
    public void In_full_what_was_told_is_told_twice_more_with_the_same_stamps_and_only_what_is_newest()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(Runs, y: 1), now: 0);
        full.Update(0);
        object[] first = [.. audience.Told];
        Assert.Equal([typeof(UpdateMotion), typeof(UpdatePosition)], first.Select(item => item.GetType()));
        Pass(full, from: 0.03125, to: 2);
        Assert.Equal([.. first, .. first, .. first], audience.Told);

        audience.Told.Clear();
        full.Take(Asks(new WireRawMotion(RunKey, turnCommand: TurnRight), y: 2), now: 2);
        full.Update(2);
        full.Take(Asks(new WireRawMotion(RunKey), y: 2), now: 2.0625);
        Pass(full, from: 2.0625, to: 2.5);
        Assert.Equal([2, 3, 3, 3], audience.Motions.Select(item => (int)item.MovementStamp));
    }

    [Fact]
    [Behaviour("broadcast.full.repeats", "BroadcastDetail.Full")]
    public void In_full_the_place_of_one_who_stands_is_told_three_times_more()
    {
        PlayerBroadcast full = Full();
        full.Take(Asks(Runs, y: 1), now: 0);
        Pass(full, from: 0, to: 5);
        Assert.Single(audience.Positions.Distinct());

        full.Take(Asks(new WireRawMotion(RunKey), y: 2), now: 5);
        Pass(full, from: 5, to: 20);
        UpdatePosition[] places = [.. audience.Positions.Distinct()];
        Assert.Equal([1f, 2f, 2f, 2f, 2f], places.Select(item => item.Pack.Position.Origin.Y));
        Assert.Equal([1, 2, 3, 4, 5], places.Select(item => (int)item.Pack.PositionStamp));
    }

    [Fact]
    [Behaviour("broadcast.live.no-repeats", "spec/08, 8.7: nothing from one that stands")]
    public void Live_servers_say_nothing_of_one_who_stands()
    {
        broadcast.Take(Asks(new WireRawMotion(RunKey)), now: 0);
        audience.Told.Clear();
        broadcast.Update(10);
        Assert.Empty(audience.Told);
    }

    [Fact]
    [Behaviour("broadcast.actions", "spec/08, 5.7 (Actions)")]
    public void Of_actions_only_emotes_are_passed_on_and_without_one_there_is_no_motion_but_the_place()
    {
        MotionAction[] both = [new(Wave, 7, true, 1f), new(Reload, 8, true, 1f)];
        broadcast.Take(Asks(new WireRawMotion(actions: new MotionActions(both))), now: 0);
        MotionAction passed = Assert.Single(audience.Motions.Single().Movement.State.Actions.Span.ToArray());
        Assert.Equal((Wave, (ushort)2), (passed.Command, passed.Stamp));

        broadcast.Take(Asks(new WireRawMotion(actions: new MotionActions([new(Reload, 9, true, 1f)]))), now: 5);
        Assert.Single(audience.Motions);
        Assert.Equal(2, audience.Positions.Count());
    }

    [Fact]
    [Behaviour("broadcast.run-rate", "spec/08, 5.7 (run rate changed)")]
    public void A_changed_run_rate_orders_a_runner_on_the_ground_and_nobody_else()
    {
        broadcast.ChangeRunRate(3);
        broadcast.Take(Asks(Runs), now: 0);
        broadcast.ChangeRunRate(4);
        broadcast.Take(new Jump(0.5f, new Vector3(0, 4, 5), At(12), NoStamps));
        broadcast.ChangeRunRate(4.5f);
        UpdateMotion[] motions = [.. audience.Motions];
        Assert.Equal([true, false, true], motions.Select(motion => motion.Autonomous));
        Assert.Equal([0, 1, 1], motions.Select(motion => (int)motion.ServerControlledMove));
        Assert.Equal(new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 4f), motions[1].Movement.State);
        Assert.Throws<ArgumentOutOfRangeException>(() => broadcast.ChangeRunRate(float.NaN));
        Assert.Equal(4.5f, broadcast.RunRate);
    }

    [Fact]
    [Behaviour("broadcast.teleport", "spec/08, 5.7 (Teleport)")]
    public void A_teleport_is_two_places_around_a_hidden_state_and_places_count_again_when_it_ends()
    {
        broadcast.Teleport(At(99), now: 3);
        broadcast.Take(new AutonomousPosition(At(13), NoStamps, Contact: true), now: 4);
        Assert.True(broadcast.IsTeleporting);
        broadcast.EndTeleport();
        broadcast.EndTeleport();
        Assert.Equal(
            [
                new UpdatePosition(Player, new PositionPack(At(99), true, 1, 1, 1, 0)), new SetState(Player, 0x604410, 1, 1),
                new UpdatePosition(Player, new PositionPack(At(99), true, 1, 2, 1, 0)), new SetState(Player, 0x600408, 1, 2),
            ],
            audience.Told);
    }

    [Fact]
    [Behaviour("broadcast.describe", "spec/08, 8.6 (smallest CreateObject of a player)")]
    public void Who_comes_later_is_told_where_the_player_is_what_it_does_and_from_which_stamps_on()
    {
        broadcast.Take(Asks(Runs, y: 40), now: 1);
        MotionActions wave = new([new(Wave, 7, true, 1f)]);
        broadcast.Take(Asks(new WireRawMotion(RunKey, forwardCommand: WalkForward, actions: wave), y: 41), now: 1.5);
        ObjectDescription told = broadcast.Describe(Setup, Motions, "Somebody").Object;
        Assert.Equal((Player, "Somebody", 0x10u, 0x1Cu), (told.Guid, told.Weenie.Name, told.Weenie.ItemType, told.Weenie.Description));
        Assert.Equal((Setup, Motions, 0x600408u), (told.Physics.Setup, told.Physics.MotionTable, told.Physics.State));
        Assert.Equal(At(41), told.Physics.Position);
        Assert.Equal(new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 2.5f), told.Physics.Movement!.Value.State);
        Assert.Equal(new ObjectStamps(1, 2, 0, 0, 0, 0, 0, 0, 1), told.Physics.Stamps);
    }

    [Fact]
    [Behaviour("broadcast.stamps-wrap", "spec/08, 4.3")]
    public void Stamps_go_on_from_zero_after_the_last_number()
    {
        for (int i = 0; i < 65536; i++) broadcast.Take(new AutonomousPosition(At(i % 100), NoStamps, Contact: true), now: i);
        Assert.Equal([65535, 0], audience.Positions.TakeLast(2).Select(item => (int)item.Pack.PositionStamp));
    }

    /// <summary>Keeps what is told.</summary>
    private sealed class Audience : IAudience
    {
        internal List<object> Told { get; } = [];

        internal IEnumerable<UpdateMotion> Motions => Told.OfType<UpdateMotion>();

        internal IEnumerable<UpdatePosition> Positions => Told.OfType<UpdatePosition>();

        public void Tell<T>(in T message)
            where T : IMessage<T> => Told.Add(message);
    }
}
