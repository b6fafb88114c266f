using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>Stances with their links, substates, and actions with their way back: specification 01b, 2, rule by rule.</summary>
public class StanceTests
{
    private const MotionCommand Peace = MotionCommand.NonCombat, Combat = MotionCommand.DualWieldCombat;
    private const MotionCommand Bow = HumanoidTable.Bow, Nod = (MotionCommand)0x10000083, Limp = (MotionCommand)0x20000050;
    private const uint Cycle = 0x03000100, ReadyToCrouch = 1, CrouchToReady = 2, ReadyToSit = 3, SitToReady = 4, ReadyToWalk = 5,
        WalkToReady = 6, PeaceToCombat = 7, CombatToPeace = 8, Bowing = 9, Nodding = 10;

    private static MotionAsset Data(uint id, int frames = 4, Vector3 velocity = default, Vector3 omega = default, byte bits = 0) =>
        new([new AnimationSpan(new AnimationAsset(id, frames), 0, -1, 30f)], velocity, omega, bits);

    private static MotionTableManager Standing()
    {
        MotionTableManager manager = new(new MotionTableBuilder(1)
            .Style(Peace, MotionCommand.Ready).Style(Combat, MotionCommand.Ready)
            .Cycle(Peace, MotionCommand.Ready, Data(Cycle, 10))
            .Cycle(Peace, MotionCommand.WalkForward, Data(Cycle + 1, 10, new Vector3(0, 3.12f, 0)))
            .Cycle(Peace, MotionCommand.Crouch, Data(Cycle + 2, bits: 1))
            .Cycle(Peace, MotionCommand.Sitting, Data(Cycle + 3, bits: 1))
            .Cycle(Peace, MotionCommand.TurnRight, Data(Cycle + 4, omega: new Vector3(0, 0, -1.5f), bits: 2))
            .Cycle(Combat, MotionCommand.Ready, Data(Cycle + 5, bits: 1))
            .Modifier(Peace, MotionCommand.TurnRight, new MotionAsset([], default, new Vector3(0, 0, -1.5f)))
            .Modifier((uint)Limp & MotionCommands.KeyMask, new MotionAsset([], new Vector3(0.1f, 0, 0)))
            .Link(Peace, MotionCommand.Ready, MotionCommand.Crouch, Data(ReadyToCrouch))
            .Link(Peace, MotionCommand.Crouch, MotionCommand.Ready, Data(CrouchToReady))
            .Link(Peace, MotionCommand.Ready, MotionCommand.Sitting, Data(ReadyToSit))
            .Link(Peace, MotionCommand.Sitting, MotionCommand.Ready, Data(SitToReady))
            .Link(Peace, MotionCommand.Ready, MotionCommand.WalkForward, Data(ReadyToWalk))
            .Link(Peace, MotionCommand.WalkForward, MotionCommand.Ready, Data(WalkToReady))
            .Link(Peace, MotionCommand.Ready, Combat, Data(PeaceToCombat))
            .Link(Combat, MotionCommand.Ready, Peace, Data(CombatToPeace))
            .Link(Peace, MotionCommand.Ready, Bow, Data(Bowing))
            .Link(Peace, MotionCommand.Ready, Nod, Data(Nodding)).Build());
        manager.InitializeState();
        manager.CheckForCompletedMotions();
        return manager;
    }

    /// <summary>The animations played in a time, in order, each with its framerate.</summary>
    private static List<(uint Id, float Framerate)> Play(MotionTableManager manager, int quanta = 60)
    {
        List<(uint Id, float Framerate)> played = [];
        for (int i = 0; i < quanta; i++)
        {
            (uint, float) now = (manager.CurrentAnimation!.Id, manager.Sequence.CurrentFramerate);
            if (played.Count == 0 || played[^1] != now) played.Add(now);
            Frame offset = Frame.Identity;
            manager.Update(1f / 30, ref offset);
            manager.ProcessHooks(null);
            manager.CheckForCompletedMotions();
        }

        return played;
    }

    [Fact]
    [Behaviour("motion.table.substate-by-way-of-the-default", "spec/01b, 2, rule 2: no link: to the default, then to the motion")]
    public void From_posture_to_posture_it_goes_by_way_of_standing()
    {
        MotionTableManager manager = Standing();
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Crouch, 1f));
        Assert.Equal([ReadyToCrouch, Cycle + 2], Play(manager).Select(one => one.Id).Where(id => id != Cycle));
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Sitting, 1f));
        Assert.Equal([CrouchToReady, ReadyToSit, Cycle + 3], Play(manager).Select(one => one.Id).Where(id => id != Cycle + 2));
        Assert.Equal((MotionCommand.Sitting, 0), (manager.Substate, manager.PendingCount));
    }

    [Fact]
    [Behaviour("motion.table.cycle-of-the-default-style", "spec/01b, 2, rule 2: cycles of the style, else of the default style")]
    public void A_style_without_a_cycle_of_its_own_has_that_of_the_default_style()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(Combat, 1f);
        Play(manager);
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.WalkForward, 1f));
        Assert.Equal((Combat, MotionCommand.WalkForward), (manager.Style, manager.Substate));
        Assert.Equal(new Vector3(0, 3.12f, 0), manager.Sequence.Velocity);
    }

    [Fact]
    [Behaviour("motion.table.posture-clears-modifiers", "spec/01b, 2, rule 2: bitfield & 1; rule 4: no modifier on such a cycle")]
    public void A_posture_takes_a_turn_off_and_takes_none_up()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        Assert.Equal((1, new Vector3(0, 0, -1.5f)), (manager.State.ModifierCount, manager.Sequence.Omega));
        manager.DoMotion(MotionCommand.Crouch, 1f);
        Assert.Equal((0, Vector3.Zero), (manager.State.ModifierCount, manager.Sequence.Omega));
        Assert.Equal(MotionError.NoMotionData, manager.DoMotion(MotionCommand.TurnRight, 1f));
        Assert.Equal(MotionCommand.Crouch, manager.Substate);
    }

    [Fact]
    [Behaviour("motion.table.style-clears-modifiers", "spec/01b, 2, rule 1: cycle.bitfield & 1")]
    public void A_style_whose_stance_clears_modifiers_ends_a_turn()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        Assert.Equal(MotionError.None, manager.DoMotion(Combat, 1f));
        Assert.Equal((0, Vector3.Zero, Vector3.Zero), (manager.State.ModifierCount, manager.Sequence.Velocity, manager.Sequence.Omega));
    }

    [Fact]
    [Behaviour("motion.table.style-from-a-posture", "spec/01b, 2, rule 1: substate → default, default → style, cycle")]
    public void Who_sits_and_is_to_fight_gets_up_first_and_puts_the_fists_down_over_the_way_back()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.Sitting, 1f);
        Play(manager);
        Assert.Equal(MotionError.None, manager.DoMotion(Combat, 1f));
        Assert.Equal([SitToReady, PeaceToCombat, Cycle + 5], Play(manager).Select(one => one.Id).Where(id => id != Cycle + 3));
        Assert.Equal((Combat, MotionCommand.Ready, 0), (manager.Style, manager.Substate, manager.PendingCount));
        Assert.Equal(MotionError.None, manager.DoMotion(Peace, 1f));
        Assert.Equal([CombatToPeace, Cycle], Play(manager).Select(one => one.Id).Where(id => id != Cycle + 5));
    }

    [Fact]
    [Behaviour("motion.table.same-style", "spec/01b, 2, rule 1: same style → done; 3: what waits for no animation is done at once")]
    public void The_style_that_one_is_in_already_changes_nothing()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.Sitting, 1f);
        Play(manager);
        Assert.Equal(MotionError.None, manager.DoMotion(Peace, 1f));
        manager.CheckForCompletedMotions();
        Assert.Equal((MotionCommand.Sitting, 0), (manager.Substate, manager.PendingCount));
        Assert.Equal([Cycle + 3], Play(manager).Select(one => one.Id));
    }

    [Fact]
    [Behaviour("motion.table.links-played-backwards", "spec/01b, 2, get_link: any negative: the link of the opposite way")]
    public void Going_backwards_begins_and_ends_with_links_played_backwards()
    {
        MotionTableManager manager = Standing();
        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.WalkForward, -0.65f));
        // What leads from walking to standing leads, backwards, from standing to walking backwards.
        List<(uint Id, float Framerate)> played = Play(manager);
        Assert.Equal([WalkToReady, Cycle + 1], played.Select(one => one.Id).Where(id => id != Cycle));
        Assert.All(played.Where(one => one.Id != Cycle), one => Assert.Equal(-19.5f, one.Framerate, 1e-5f));

        Assert.Equal(MotionError.None, manager.DoMotion(MotionCommand.Ready, 1f));
        played = Play(manager);
        Assert.Equal([(ReadyToWalk, -30f), (Cycle, 30f)], played.Where(one => one.Id != Cycle + 1));
    }

    [Fact]
    [Behaviour("motion.table.actions-in-order", "spec/01b, 2, rule 3; 3: an action at the head is removed from the state")]
    public void Actions_asked_for_at_once_are_played_in_order_and_the_cycle_goes_on()
    {
        MotionTableManager manager = Standing();
        List<MotionCommand> done = [];
        manager.MotionDone = (motion, success) =>
        {
            Assert.True(success);
            done.Add(motion);
        };
        Assert.Equal((MotionError.None, MotionError.None), (manager.DoMotion(Bow, 1f), manager.DoMotion(Nod, 1f)));
        Assert.Equal(2, manager.State.ActionCount);
        Assert.Equal([Bowing, Nodding, Cycle], Play(manager).Select(one => one.Id).SkipWhile(id => id == Cycle));
        Assert.Equal([Bow, Nod], done);
        Assert.Equal((0, MotionCommand.Ready), (manager.State.ActionCount, manager.Substate));
    }

    [Fact]
    [Behaviour("motion.table.action-without-a-way", "spec/01b, 2, rule 3: no link from here and none by way of the default: fail")]
    public void An_action_to_which_nothing_leads_is_refused_and_changes_nothing()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(Combat, 1f);
        Play(manager);
        Assert.Equal(MotionError.NoMotionData, manager.DoMotion(Bow, 1f));
        Assert.Equal((0, 0), (manager.State.ActionCount, manager.PendingCount));
        Assert.Equal([Cycle + 5], Play(manager).Select(one => one.Id));
    }

    [Fact]
    [Behaviour("motion.table.modifier-of-every-style", "spec/01b, 2, rule 4: of the style, else without a style; twice is once")]
    public void A_modifier_without_a_style_is_there_in_every_style_and_counts_once()
    {
        MotionTableManager manager = Standing();
        Assert.Equal(MotionError.None, manager.DoMotion(Limp, 1f));
        Assert.Equal(MotionError.None, manager.DoMotion(Limp, 3f));
        Assert.Equal((1, 0.3f), (manager.State.ModifierCount, MathF.Round(manager.Sequence.Velocity.X, 5)));
        Assert.Equal(MotionError.None, manager.StopMotion(Limp));
        Assert.Equal(0, manager.Sequence.Velocity.X, 1e-6f);
        Assert.Equal(MotionError.NoMotionData, manager.StopMotion(Limp));
    }

    [Fact]
    [Behaviour("motion.table.stop-completely", "spec/01b, 2, StopObjectCompletely: all modifiers, then the substate; 3: queued as Ready")]
    public void Stopping_completely_ends_what_was_added_and_then_the_substate()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        manager.DoMotion(Limp, 1f);
        Assert.Equal(MotionError.None, manager.StopCompletely());
        Assert.Equal((MotionCommand.Ready, 0), (manager.Substate, manager.State.ModifierCount));
        Assert.Equal((Vector3.Zero, Vector3.Zero), (manager.Sequence.Velocity, manager.Sequence.Omega));
        Play(manager);
        Assert.Equal(0, manager.PendingCount);
    }
}
