using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>Orders that take each other back before they are played: specification 01b, 3. Every link has one animation.</summary>
public class RedundantLinkTests
{
    private const MotionCommand Style = MotionCommand.NonCombat, Combat = MotionCommand.DualWieldCombat;
    private const MotionCommand Bow = HumanoidTable.Bow;

    private static MotionTableManager Standing(MotionTableAsset? table = null)
    {
        MotionTableManager manager = new(table ?? HumanoidTable.Create(links: true));
        manager.InitializeState();
        manager.CheckForCompletedMotions();
        return manager;
    }

    /// <summary>A substate as the interpreter orders it: the style first, which is on already and has no animations.</summary>
    private static void Order(MotionTableManager manager, MotionCommand motion)
    {
        Assert.Equal(MotionError.None, manager.DoMotion(Style, 1f));
        Assert.Equal(MotionError.None, manager.DoMotion(motion, 1f));
    }

    private static int Do(MotionTableManager manager, params ReadOnlySpan<MotionCommand> motions)
    {
        foreach (MotionCommand motion in motions) Assert.Equal(MotionError.None, manager.DoMotion(motion, 1f));
        return manager.Sequence.LinkCount;
    }

    [Fact]
    [Behaviour("motion.table.redundant-links-are-dropped", "spec/01b, 3, remove_redundant_links")]
    public void Going_back_and_forth_drops_the_links_between()
    {
        MotionTableManager manager = Standing();
        manager.DoMotion(MotionCommand.WalkForward, 1f);
        int links = manager.Sequence.LinkCount;
        for (int i = 0; i < 5; i++)
        {
            manager.StopMotion(MotionCommand.WalkForward);
            manager.DoMotion(MotionCommand.WalkForward, 1f);
        }

        Assert.Equal(links, manager.Sequence.LinkCount);
        Assert.Equal(MotionCommand.WalkForward, manager.Substate);
    }

    [Fact]
    [Behaviour("motion.table.redundant-links.no-animations-no-obstacle", "spec/01b, 3: entries without animations never stop the search")]
    public void Five_orders_to_stand_and_walk_again_leave_one_link()
    {
        MotionTableManager manager = Standing();
        Order(manager, MotionCommand.WalkForward);
        for (int i = 0; i < 5; i++)
        {
            Order(manager, MotionCommand.Ready);
            Order(manager, MotionCommand.WalkForward);
        }

        Assert.Equal((1, MotionCommand.WalkForward), (manager.Sequence.LinkCount, manager.Substate));
    }

    [Fact]
    [Behaviour("motion.table.redundant-links.action-between",
        "spec/01b, 3: an action with animations ends the search, and is no candidate itself")]
    public void An_action_between_keeps_the_links()
    {
        Assert.Equal(1, Do(Standing(), MotionCommand.WalkForward, MotionCommand.Ready, MotionCommand.WalkForward));
        Assert.Equal(4, Do(Standing(), MotionCommand.WalkForward, MotionCommand.Ready, Bow, MotionCommand.WalkForward));
        Assert.Equal(2, Do(Standing(), Bow, Bow));
    }

    [Fact]
    [Behaviour("motion.table.redundant-links.styles", "spec/01b, 3: the nearest same style, with animations or not")]
    public void A_style_goes_back_to_the_same_style_over_other_styles_only()
    {
        MotionAsset one = new([new AnimationSpan(HumanoidTable.TenFrames, 0, -1, 30f)]);
        MotionTableAsset table = new MotionTableBuilder(1)
            .Style(Style, MotionCommand.Ready).Style(Combat, MotionCommand.Ready)
            .Cycle(Style, MotionCommand.Ready, one).Cycle(Combat, MotionCommand.Ready, one).Cycle(Combat, MotionCommand.WalkForward, one)
            .Link(Style, MotionCommand.Ready, Combat, one).Link(Combat, MotionCommand.Ready, Style, one)
            .Link(Combat, MotionCommand.Ready, MotionCommand.WalkForward,
                one).Link(Combat, MotionCommand.WalkForward, MotionCommand.Ready, one).Build();
        Assert.Equal(1, Do(Standing(table), Combat, Style, Combat));
        // The style that is on has no animations, and is gone back to.
        Assert.Equal(0, Do(Standing(table), Style, Combat, Style));
        // A substate with animations in between ends the search.
        Assert.Equal(4, Do(Standing(table), Combat, MotionCommand.WalkForward, Style));
        Assert.Equal(5, Do(Standing(table), Combat, MotionCommand.WalkForward, Style, Combat));
    }
}
