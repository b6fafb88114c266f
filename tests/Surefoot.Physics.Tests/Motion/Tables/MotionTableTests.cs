using System.Numerics;
using CsCheck;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

public class MotionTableTests
{
    private const MotionCommand Bow = HumanoidTable.Bow;
    private const MotionCommand Style = MotionCommand.NonCombat;
    private const MotionCommand Combat = MotionCommand.DualWieldCombat;
    private const float Tick = 1f / 30;

    private static MotionTableManager Ready(MotionTableAsset? table = null)
    {
        MotionTableManager manager = new(table ?? HumanoidTable.Create());
        manager.InitializeState();
        manager.CheckForCompletedMotions();
        return manager;
    }

    private static float Moved(MotionTableManager manager, int quanta)
    {
        double total = 0;
        for (int i = 0; i < quanta; i++)
        {
            Frame offset = Frame.Identity;
            manager.Update(Tick, ref offset);
            manager.ProcessHooks(null);
            total += offset.Origin.Y;
        }

        return (float)total;
    }

    [Fact]
    [Behaviour("motion.table.key-drops-the-styles-upper-half", "spec/07, 7.9")]
    public void Keys_have_the_low_half_of_the_style() => Assert.Equal(0x003D0003u, MotionTableAsset.Key(Style, MotionCommand.Ready));

    [Fact]
    [Behaviour("motion.table.default-state", "spec/01b, 2, SetDefaultState")]
    public void A_table_begins_in_its_default_substate()
    {
        MotionTableManager manager = Ready();
        Assert.Equal((Style, MotionCommand.Ready, 1f), (manager.Style, manager.Substate, manager.SubstateSpeed));
        Assert.Equal(0, manager.PendingCount);
    }

    [Fact]
    [Behaviour("motion.table.substate-sets-cycle-and-velocity", "spec/01b, 2.2 and 4")]
    public void A_substate_sets_cycle_and_velocity()
    {
        MotionTableManager manager = Ready();
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.RunForward, 2.6500001f));
        Assert.Equal(new Vector3(0, 10.6000004f, 0), manager.Sequence.Velocity);
        Assert.Equal(79.5f, manager.Sequence.CurrentFramerate);
        Assert.Equal(10.6f, Moved(manager, 30), 0.14f);
    }

    [Fact]
    [Behaviour("motion.table.change-cycle-speed", "spec/01b, 2, change_cycle_speed")]
    public void The_same_substate_at_another_speed_changes_framerate_and_velocity()
    {
        MotionTableManager manager = Ready();
        manager.DoMotion(MotionCommand.RunForward, 1f);
        Moved(manager, 3);
        double frame = manager.CurrentFrame;
        manager.DoMotion(MotionCommand.RunForward, 2.5f);
        Assert.Equal(75f, manager.Sequence.CurrentFramerate);
        Assert.Equal(new Vector3(0, 10, 0), manager.Sequence.Velocity);
        Assert.Equal(frame, manager.CurrentFrame);
        Assert.Equal(1, manager.Sequence.Count);

        // Speed 0 stops the cycle and no other speed starts it again: retail multiplies by a ratio.
        manager.DoMotion(MotionCommand.RunForward, 0f);
        manager.DoMotion(MotionCommand.RunForward, 2f);
        Assert.Equal(0f, manager.Sequence.CurrentFramerate);
        Assert.Equal(new Vector3(0, 8, 0), manager.Sequence.Velocity);
    }

    [Fact]
    [Behaviour("motion.table.turned-around-plays-backwards", "spec/01b, 2.2 and 4")]
    public void Another_sign_begins_the_cycle_anew()
    {
        MotionTableManager manager = Ready();
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        Moved(manager, 5);
        manager.DoMotion(MotionCommand.WalkForward, -0.65f);
        Assert.Equal(-19.5f, manager.Sequence.CurrentFramerate, 1e-5f);
        Assert.Equal(-2.028f, Moved(manager, 30), 0.11f);
    }

    [Fact]
    [Behaviour("motion.table.links-before-the-cycle", "spec/01b, 2.2")]
    public void Links_are_played_before_the_cycle_and_are_waited_for()
    {
        MotionTableManager manager = Ready(HumanoidTable.Create(links: true));
        List<MotionCommand> done = [];
        manager.MotionDone = (motion, success) =>
        {
            Assert.True(success);
            done.Add(motion);
        };
        manager.DoMotion(MotionCommand.WalkForward, 1f);

        // The Ready cycle that was playing stays in front as a link of its own until its next frame is passed.
        Assert.True(manager.Sequence.LinkCount >= 1);
        manager.CheckForCompletedMotions();
        Assert.Empty(done);
        Moved(manager, 30);
        Assert.Equal([MotionCommand.WalkForward], done);
        Assert.Equal(0, manager.PendingCount);
    }

    [Fact]
    [Behaviour("motion.table.turn-while-running-is-a-modifier", "spec/01b, 2, last paragraph")]
    public void Turning_while_running_adds_and_stops_again()
    {
        MotionTableManager manager = Ready();
        manager.DoMotion(MotionCommand.RunForward, 2f);
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.TurnRight, 1.5f));
        Assert.Equal(MotionCommand.RunForward, manager.Substate);
        Assert.Equal(new Vector3(0, 8, 0), manager.Sequence.Velocity);
        Assert.Equal(new Vector3(0, 0, -2.25f), manager.Sequence.Omega);

        // Turning the other way replaces it.
        manager.DoMotion(MotionCommand.TurnRight, -1f);
        Assert.Equal(new Vector3(0, 0, 1.5f), manager.Sequence.Omega);
        Assert.Equal(1, manager.State.ModifierCount);
        Assert.Equal(MotionError.None, manager.StopMotion(MotionCommand.TurnRight));
        Assert.Equal(Vector3.Zero, manager.Sequence.Omega);
        Assert.Equal(MotionError.NoMotionData, manager.StopMotion(MotionCommand.TurnRight));
    }

    [Fact]
    [Behaviour("motion.table.turn-while-standing-is-the-substate", "spec/01b, 2, last paragraph")]
    public void Turning_while_standing_is_the_substate_and_becomes_a_modifier_of_the_run()
    {
        MotionTableManager manager = Ready();
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        Assert.Equal((MotionCommand.TurnRight, 0), (manager.Substate, manager.State.ModifierCount));
        manager.DoMotion(MotionCommand.RunForward, 2f);
        Assert.Equal((MotionCommand.RunForward, 1), (manager.Substate, manager.State.ModifierCount));
        Assert.Equal((new Vector3(0, 8, 0), new Vector3(0, 0, -1.5f)), (manager.Sequence.Velocity, manager.Sequence.Omega));
    }

    [Fact]
    [Behaviour("motion.table.ready-does-not-end-a-turn", "spec/01b, 2.0")]
    public void Ready_does_not_end_a_turn_or_sidestep_that_is_the_substate()
    {
        MotionTableManager manager = Ready();
        manager.DoMotion(MotionCommand.SideStepRight, -1.248f);
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Ready, 1f));
        Assert.Equal(MotionCommand.SideStepRight, manager.Substate);
        Assert.Equal(MotionError.None, manager.StopMotion(MotionCommand.SideStepRight));
        Assert.Equal((MotionCommand.Ready, Vector3.Zero), (manager.Substate, manager.Sequence.Velocity));
    }

    [Fact]
    [Behaviour("motion.table.action-then-back-to-the-cycle", "spec/01b, 2.3")]
    public void An_action_is_played_once_and_the_cycle_goes_on()
    {
        MotionTableManager manager = Ready(HumanoidTable.Create(links: true));
        List<MotionCommand> done = [];
        manager.MotionDone = (motion, _) => done.Add(motion);
        Assert.Equal(MotionError.None, manager.DoMotion(Bow, 1f));
        Assert.Equal(1, manager.State.ActionCount);
        Assert.Equal(MotionCommand.Ready, manager.Substate);
        Moved(manager, 40);
        Assert.Equal([Bow], done);
        Assert.Equal(0, manager.State.ActionCount);
    }

    [Fact]
    [Behaviour("motion.table.action-by-way-of-the-default", "spec/01b, 2.3")]
    public void An_action_without_a_link_goes_by_way_of_the_default_substate()
    {
        MotionTableManager manager = Ready(HumanoidTable.Create(links: true));
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        int before = manager.Sequence.Count;
        Assert.Equal(MotionError.None, manager.DoMotion(Bow, 1f));
        Assert.Equal(MotionCommand.WalkForward, manager.Substate);
        Assert.Equal(before + 3, manager.Sequence.Count);
        Assert.Equal(new Vector3(0, 3.12f, 0), manager.Sequence.Velocity);
    }

    [Fact]
    [Behaviour("motion.table.action-way-back-at-speed-1",
        "spec/01b, 2.3: the way back is looked up with the substate's speed and added at speed 1")]
    public void The_way_back_of_an_action_is_played_at_its_own_speed()
    {
        AnimationAsset there = new(1, 3), action = new(2, 3), back = new(3, 3);
        static MotionAsset Data(AnimationAsset animation) => new([new AnimationSpan(animation, 0, -1, 30f)]);
        MotionTableManager manager = Ready(new MotionTableBuilder(1).Style(Style, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, Data(HumanoidTable.TenFrames)).Cycle(Style, MotionCommand.RunForward,
                Data(HumanoidTable.TenFrames))
            .Link(Style, MotionCommand.RunForward, MotionCommand.Ready, Data(there))
            .Link(Style, MotionCommand.Ready, Bow, Data(action))
            .Link(Style, MotionCommand.Ready, MotionCommand.RunForward, Data(back)).Build());
        manager.DoMotion(MotionCommand.RunForward, 2.5f);
        Assert.Equal(MotionError.None, manager.DoMotion(Bow, 2f));
        Dictionary<AnimationAsset, float> played = [];
        for (int i = 0; i < 40; i++)
        {
            played[manager.CurrentAnimation!] = manager.Sequence.CurrentFramerate;
            Moved(manager, 1);
        }

        Assert.Equal((30f, 60f, 30f, 75f), (played[there], played[action], played[back], played[HumanoidTable.TenFrames]));
    }

    [Fact]
    [Behaviour("motion.table.only-from-default", "spec/01b, 2, is_allowed")]
    public void A_cycle_only_from_the_default_substate_is_refused_elsewhere()
    {
        MotionAsset plain = new([new AnimationSpan(HumanoidTable.TenFrames, 0, -1, 30f)]);
        MotionAsset special = new([new AnimationSpan(HumanoidTable.TenFrames, 0, -1, 30f)], bitfield: 2);
        MotionTableAsset table = new MotionTableBuilder(1).Style(Style, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, plain).Cycle(Style, MotionCommand.WalkForward,
                plain).Cycle(Style, MotionCommand.Crouch, special).Build();
        MotionTableManager manager = Ready(table);
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        Assert.Equal(MotionError.NoMotionData, manager.DoMotion(MotionCommand.Crouch, 1f));
        manager.DoMotion(MotionCommand.Ready, 1f);
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Crouch, 1f));
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Crouch, 2f));
    }

    [Fact]
    [Behaviour("motion.table.style-goes-by-way-of-the-default-style", "spec/01b, 2.1")]
    public void A_style_without_a_link_goes_by_way_of_the_default_style()
    {
        AnimationAsset a = new(1, 2), b = new(2, 2), c = new(3, 2);
        MotionAsset Data(AnimationAsset animation) => new([new AnimationSpan(animation, 0, -1, 30f)]);
        const MotionCommand Bowing = (MotionCommand)0x8000003F;
        MotionTableAsset table = new MotionTableBuilder(1)
            .Style(Style, MotionCommand.Ready).Style(Combat, MotionCommand.Ready).Style(Bowing, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, Data(a)).Cycle(Combat, MotionCommand.Ready,
                Data(b)).Cycle(Bowing, MotionCommand.Ready, Data(c))
            .Link(Style, MotionCommand.Ready, Combat, Data(b)).Link(Combat, MotionCommand.Ready, Style, Data(a))
            .Link(Style, MotionCommand.Ready, Bowing, Data(c)).Build();
        MotionTableManager manager = Ready(table);
        Assert.Equal(MotionError.None, manager.DoMotion(Combat, 1f));
        Assert.Equal((Combat, MotionCommand.Ready), (manager.Style, manager.Substate));
        Assert.Equal(1, manager.Sequence.LinkCount);
        Assert.Equal(MotionError.None, manager.DoMotion(Bowing, 1f));
        Assert.Equal(MotionError.None, manager.DoMotion(Bowing, 1f));
        Assert.Equal(Bowing, manager.Style);
        Assert.Equal(3, manager.Sequence.LinkCount);
        Assert.Equal(MotionError.NoMotionData, manager.DoMotion((MotionCommand)0x80000049, 1f));
    }

    [Fact]
    [Behaviour("motion.table.entering-the-world-fails-what-is-pending", "spec/01b, 3")]
    public void Entering_the_world_drops_links_and_fails_what_is_pending()
    {
        MotionTableManager manager = Ready(HumanoidTable.Create(links: true));
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        List<bool> outcomes = [];
        manager.MotionDone = (_, success) => outcomes.Add(success);
        manager.HandleEnterWorld();
        Assert.Equal((0, 0), (manager.PendingCount, manager.Sequence.LinkCount));
        Assert.Equal([false], outcomes);
    }

    [Fact]
    [Behaviour("motion.table.backward-links-are-the-opposite-way", "spec/01b, 2, get_link")]
    public void A_negative_speed_takes_the_link_of_the_opposite_way()
    {
        MotionAsset there = new([new AnimationSpan(new AnimationAsset(1, 2), 0, -1, 30f)]);
        MotionAsset back = new([new AnimationSpan(new AnimationAsset(2, 2), 0, -1, 30f)]);
        MotionTableAsset table = new MotionTableBuilder(1).Style(Style, MotionCommand.Ready)
            .Link(Style, MotionCommand.Ready, MotionCommand.WalkForward, there)
            .Link(Style, MotionCommand.WalkForward, MotionCommand.Ready, back).Build();
        Assert.Same(there, table.Link(Style, MotionCommand.Ready, 1f, MotionCommand.WalkForward, 1f));
        Assert.Same(back, table.Link(Style, MotionCommand.Ready, 1f, MotionCommand.WalkForward, -1f));
        Assert.Same(back, table.Link(Style, MotionCommand.WalkForward, -1f, MotionCommand.Crouch, 1f));
    }

    [Fact]
    [Behaviour("motion.table.velocity-follows-the-state", "spec/01b, 2")]
    public void Whatever_was_done_before_the_velocity_is_that_of_the_state_now()
    {
        // One kind of modifier only: with two, re-doing them leaves velocities that no state explains
        // (motion.table.newest-modifier-is-re-done-for-all).
        MotionCommand[] commands = [MotionCommand.Ready, MotionCommand.WalkForward, MotionCommand.RunForward, MotionCommand.TurnRight,
            MotionCommand.Falling];
        Gen.Select(Gen.Int[0, commands.Length - 1], Gen.Float[-3, 3], Gen.Bool, Gen.Int[0, 3]).List[1, 60].Sample(orders =>
        {
            MotionTableManager manager = Ready();
            foreach ((int command, float speed, bool stop, int quanta) in orders)
            {
                if (stop) manager.StopMotion(commands[command]);
                else manager.DoMotion(commands[command], speed);
                Moved(manager, quanta);
                manager.CheckForCompletedMotions();
            }

            Vector3 velocity = manager.Table.Cycle(Style, manager.Substate)!.Velocity * manager.SubstateSpeed,
                omega = manager.Table.Cycle(Style, manager.Substate)!.Omega * manager.SubstateSpeed;
            for (int i = 0; i < manager.State.ModifierCount; i++)
            {
                MotionSpeed modifier = manager.State.GetModifier(i);
                MotionAsset data = manager.Table.Modifier(Style, modifier.Motion)!;
                velocity += data.Velocity * modifier.Speed;
                omega += data.Omega * modifier.Speed;
            }

            return (velocity - manager.Sequence.Velocity).Length() < 1e-3f && (omega - manager.Sequence.Omega).Length() < 1e-3f &&
                   manager.Sequence.Count < 200;
        });
    }
}
