using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>Turns and sidesteps while running, and what becomes of them on a new cycle: specification 01b, 2, re_modify.</summary>
public class ModifierTests
{
    private const MotionCommand Style = MotionCommand.NonCombat;

    private static MotionTableManager Standing(MotionTableAsset table)
    {
        MotionTableManager manager = new(table);
        manager.InitializeState();
        manager.CheckForCompletedMotions();
        return manager;
    }

    private static MotionTableManager Walking()
    {
        MotionTableManager manager = Standing(HumanoidTable.Create());
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        return manager;
    }

    private static bool Near((Vector3 Velocity, Vector3 Omega) a, (Vector3 Velocity, Vector3 Omega) b) =>
        Vector3.Distance(a.Velocity, b.Velocity) < 1e-5f && Vector3.Distance(a.Omega, b.Omega) < 1e-5f;

    [Fact]
    [Behaviour("motion.table.modifier-survives-a-new-cycle", "spec/01b, 2, re_modify: with one modifier it does what one expects")]
    public void One_modifier_is_done_again_on_a_new_cycle()
    {
        MotionTableManager manager = Walking();
        manager.DoMotion(MotionCommand.SideStepRight, 1f);
        manager.DoMotion(MotionCommand.RunForward, 2f);
        Assert.Equal(1, manager.State.ModifierCount);
        Assert.Equal((new Vector3(1.25f, 8, 0), Vector3.Zero), (manager.Sequence.Velocity, manager.Sequence.Omega));
    }

    [Fact]
    [Behaviour("motion.table.newest-modifier-is-re-done-for-all", "spec/01b, 2, re_modify")]
    public void Of_several_modifiers_the_newest_is_done_again_once_for_each_that_there_was()
    {
        MotionTableManager manager = Walking();
        manager.DoMotion(MotionCommand.SideStepRight, 1f);
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        manager.DoMotion(MotionCommand.RunForward, 2f);
        Assert.Equal(
            [MotionCommand.TurnRight, MotionCommand.SideStepRight],
            [manager.State.GetModifier(0).Motion, manager.State.GetModifier(1).Motion]);
        Assert.Equal((new Vector3(0, 8, 0), new Vector3(0, 0, -3)), (manager.Sequence.Velocity, manager.Sequence.Omega));

        // Stopping what was not added takes it off all the same.
        Assert.Equal(MotionError.None, manager.StopMotion(MotionCommand.SideStepRight));
        Assert.Equal(MotionError.None, manager.StopMotion(MotionCommand.TurnRight));
        Assert.Equal((new Vector3(-1.25f, 8, 0), new Vector3(0, 0, -1.5f)), (manager.Sequence.Velocity, manager.Sequence.Omega));
        Assert.Equal(0, manager.State.ModifierCount);
    }

    [Fact]
    [Behaviour("motion.jump.run-sidestep-and-turn", "spec/01b, 2, re_modify; spec/01, 4.5 and 4.12")]
    public void After_a_jump_with_run_sidestep_and_turn_held_the_sidestep_is_gone_and_the_turn_is_twice_as_fast()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player());
        MovementParameters keys = new();
        MotionSequence sequence = interpreter.Animation!.Sequence;
        interpreter.SetHoldRun(true, false);
        interpreter.DoMotion(MotionCommand.WalkForward, keys);
        interpreter.DoMotion(MotionCommand.SideStepRight, keys);
        interpreter.DoMotion(MotionCommand.TurnRight, keys);
        Assert.Equal((new Vector3(3.75f, 10.6f, 0), new Vector3(0, 0, -2.25f)), (sequence.Velocity, sequence.Omega), Near);

        Assert.Equal(MotionError.None, interpreter.Jump(1f));
        Assert.Equal((Vector3.Zero, new Vector3(0, 0, -4.5f)), (sequence.Velocity, sequence.Omega), Near);
        body.SetOnWalkable(true);
        Assert.Equal((new Vector3(0, 10.6f, 0), new Vector3(0, 0, -4.5f)), (sequence.Velocity, sequence.Omega), Near);
        Assert.Equal(2, interpreter.Animation.State.ModifierCount);
    }

    [Fact]
    [Behaviour("motion.table.evicting-modifiers-end", "spec/01b, 2, re_modify")]
    public void A_table_whose_turns_evict_each_other_ends()
    {
        // Twenty modifiers that only wait: each would multiply the number of times that turn and sidestep replace each other.
        const uint FirstOther = 0x20000100, Others = 20;
        MotionAsset plain = new([new AnimationSpan(HumanoidTable.TenFrames, 0, -1, 30f)]);
        MotionTableBuilder table = new MotionTableBuilder(1).Style(Style, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, plain).Cycle(Style, MotionCommand.TurnRight, plain).Cycle(Style, MotionCommand.SideStepRight,
                plain);
        for (uint other = FirstOther; other < FirstOther + Others; other++) table.Modifier(other & MotionCommands.KeyMask, plain);
        MotionTableManager manager = Standing(table.Build());
        for (uint other = FirstOther; other < FirstOther + Others; other++)
            Assert.Equal(MotionError.None, manager.DoMotion((MotionCommand)other, 1f));
        manager.DoMotion(MotionCommand.TurnRight, 1f);
        manager.DoMotion(MotionCommand.SideStepRight, 1f);
        Assert.True(manager.Sequence.HasAnimations);
        Assert.InRange(manager.State.ModifierCount, (int)Others, (int)Others + 2);
    }
}
