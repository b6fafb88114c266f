using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Decisions;

/// <summary>What a sweep tells of the floor, the walls and the edges of the one-cell worlds of specification 03, 6.8.</summary>
public class TraceTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const MoverFlags Careful = Standing | MoverFlags.EdgeSlide;

    private static readonly Func<Vector3, Plane?> FlatGround = _ => StubWorld.Flat(0);

    [Fact, Behaviour("trace.sub-steps", "design.md, decision 6; spec/03, 6.8 case 2")]
    public void A_walk_tells_its_sub_steps_and_whose_plane_it_rests_on_after_each()
    {
        TraceEntry[] told = Tell(new StubWorld(FlatGround), Vector3.Zero, new(1, 0, 0), Standing);
        Assert.Equal((TraceKind.SweepBegins, new Vector3(1, 0, 0)), (told[0].Kind, told[0].Offset));
        TraceEntry[] begins = [.. told.Where(e => e.Kind == TraceKind.SubStepBegins)],
            ends = [.. told.Where(e => e.Kind == TraceKind.SubStepEnds)];
        Assert.Equal([(0, 3), (1, 3), (2, 3)], begins.Select(e => (e.Index, e.Count)));
        Assert.All(begins, e => Assert.Equal(1f / 3, e.Offset.X, 1e-6f));
        // Before the first one the sweep knows only the plane it was given.
        Assert.Equal([TraceSubjectKind.AsBefore, TraceSubjectKind.Ground, TraceSubjectKind.Ground], begins.Select(e => e.Subject.Kind));
        Assert.All(ends, e => Assert.True(e is { Succeeded: true, Answer: TransitionState.OK, Subject.Kind: TraceSubjectKind.Ground }));
        TraceEntry end = told[^1];
        Assert.True(
            end is { Kind: TraceKind.SweepEnds, Succeeded: true, Subject: { Kind: TraceSubjectKind.Ground, CellId: StubWorld.CellId } });
        Assert.Equal((StubWorld.Flat(0), StubWorld.CellId), (end.Plane, end.PlaneCellId));
        Assert.Equal(1, end.Origin.X, 1e-6f);
    }

    [Fact, Behaviour("trace.cells", "design.md, decision 6")]
    public void Each_question_to_a_cell_is_told_with_its_answer()
    {
        TraceEntry[] told = Tell(new StubWorld(FlatGround), new(0, 0, 0.1f), new(0.02f, 0, -0.3f), MoverFlags.None);
        TraceEntry first = told.First(e => e.Kind == TraceKind.CellAnswered);
        Assert.Equal((SweepQuestion.Move, TransitionState.Adjusted, StubWorld.CellId),
            (first.Question, first.Answer, first.Subject.CellId));
        TraceEntry hit = told.First(e => e.Kind == TraceKind.Hit);
        Assert.Equal(-0.2f, hit.Gap, 1e-6f);
        Assert.Equal(StubWorld.Flat(0), hit.Plane);
    }

    [Fact, Behaviour("trace.slide", "design.md, decision 6; spec/03, 6.8 cases 6, 6b and 7")]
    public void A_slide_is_told_with_its_normal_and_the_next_sweep_says_that_it_is_bent_along_that_wall()
    {
        TraceEntry slide = Single(Tell(WallWorld(), Vector3.Zero, new(0.3f, 0.3f, 0), Standing), TransitionResponse.Slide);
        Assert.True(slide.Succeeded);
        Assert.Equal(new Vector3(-1, 0, 0), slide.Plane.Normal);

        TraceEntry[] next = Tell(WallWorld(), new(0, 0.3f, 0), new(0.3f, 0.3f, 0), Standing, sliding: new Vector3(-1, 0, 0));
        TraceEntry bent = Assert.Single(next, e => e.Kind == TraceKind.Bent);
        Assert.Equal((TraceReason.AlongCrease, new Vector3(-1, 0, 0)), (bent.Reason, bent.Plane.Normal));
        Assert.True(Vector3.Distance(new(0, 0.3f, 0), bent.Offset) < 1e-6f);
        Assert.DoesNotContain(next, e => e.Response == TransitionResponse.Slide);

        TraceEntry headOn = Single(Tell(WallWorld(), Vector3.Zero, new(0.3f, 0, 0), Standing), TransitionResponse.Slide);
        Assert.Equal((false, TraceReason.TooShort), (headOn.Succeeded, headOn.Reason));
    }

    [Fact, Behaviour("trace.nothing-left", "design.md, decision 6; spec/03, 6.8 case 3")]
    public void A_sub_step_of_which_nothing_is_left_says_so()
    {
        TraceEntry[] told = Tell(new StubWorld(FlatGround), Vector3.Zero, new(0, 0, -0.02f), Standing);
        Assert.Equal(TraceReason.TooShort, Assert.Single(told, e => e.Kind == TraceKind.SubStepEnds).Reason);
        Assert.False(told[^1].Succeeded);
    }

    [Fact, Behaviour("trace.step-up", "design.md, decision 6; spec/03, 4.7, step_up")]
    public void A_step_up_is_told_when_it_is_tried_and_why_it_is_refused()
    {
        // The wall of the stub has no top: a probe above it finds no footing but the floor before it, which is blocked by the wall again.
        TraceEntry[] told = Tell(WallWorld(), Vector3.Zero, new(0.3f, 0.3f, 0), Standing);
        int tried = Array.FindIndex(told, e => e is { Kind: TraceKind.Tried, Response: TransitionResponse.StepUp });
        int settled = Array.FindIndex(told, e => e is { Kind: TraceKind.Responded, Response: TransitionResponse.StepUp });
        Assert.True(tried >= 0 && settled > tried);
        Assert.False(told[settled].Succeeded);
        Assert.NotEqual(TraceReason.None, told[settled].Reason);
        Assert.Contains(told[tried..settled], e => e.Question == SweepQuestion.StepUp);
        // What follows the probe is about the wall again, not about what the probe asked last.
        Assert.Equal(told[tried].Subject, told[settled].Subject);
    }

    [Theory, Behaviour("trace.step-down", "design.md, decision 6; spec/03, 6.8 cases 10, 10b, 11")]
    [InlineData(-0.5f, true, TraceReason.None)]
    [InlineData(-0.7f, false, TraceReason.NoFooting)]
    public void A_step_down_is_told_and_why_it_finds_nothing(float floor, bool stands, TraceReason reason)
    {
        TraceEntry down = Single(Tell(LedgeWorld(StubWorld.Flat(floor)), new(0.9f, 0, 0), new(0.3f, 0, 0), Standing),
            TransitionResponse.StepDown);
        Assert.Equal((stands, reason), (down.Succeeded, down.Reason));
    }

    [Fact, Behaviour("trace.edges", "design.md, decision 6; spec/03, 4.7, edge_slide; 6.8 cases 9, 9b, 11b")]
    public void Walking_off_an_edge_sliding_along_a_cliff_and_stopping_at_a_brink_are_told()
    {
        TraceEntry off = Single(Tell(LedgeWorld(null), new(0.9f, 0, 0), new(0.3f, 0, 0), Standing), TransitionResponse.EdgeSlide);
        Assert.Equal((true, TraceReason.Careless), (off.Succeeded, off.Reason));
        TraceEntry stopped = Single(Tell(LedgeWorld(null), new(0.9f, 0, 0), new(0.3f, 0, 0), Careful), TransitionResponse.EdgeSlide);
        Assert.Equal((false, TraceReason.NothingBehind), (stopped.Succeeded, stopped.Reason));

        TraceEntry[] cliff = Tell(LedgeWorld(StubWorld.SlopeFromX1(60, rising: false)), new(0.9f, 0, 0), new(0.3f, 0.1f, 0), Careful);
        Assert.Contains(
            cliff, e => e is { Response: TransitionResponse.StepDown, Kind: TraceKind.Responded, Reason: TraceReason.TooSteep });
        TraceEntry slide = cliff.First(e => e.Response == TransitionResponse.CliffSlide);
        Assert.Equal(new Vector3(-1, 0, 0), slide.Plane.Normal);
        Assert.Equal(TraceSubjectKind.None, slide.Subject.Kind);
    }

    [Fact, Behaviour("trace.landing", "design.md, decision 6; spec/03, 6.8 case 8")]
    public void A_landing_on_a_wall_is_told_as_refused_and_the_sub_step_as_taken_back()
    {
        TraceEntry[] told = Tell(WallWorld(), new(0, 0, 1), new(0.3f, 0.1f, 0.05f), MoverFlags.None);
        TraceEntry landing = Single(told, TransitionResponse.Landing);
        Assert.Equal((false, TraceReason.NoFooting, new Vector3(-1, 0, 0)), (landing.Succeeded, landing.Reason, landing.Plane.Normal));
        TraceEntry end = Assert.Single(told, e => e.Kind == TraceKind.SubStepEnds);
        Assert.Equal((false, TransitionState.Collided, TraceSubjectKind.None), (end.Succeeded, end.Answer, end.Subject.Kind));
    }

    [Fact, Behaviour("trace.contact", "design.md, decision 6; spec/03, 4.6 validate_transition; 6.8 cases 13, 14")]
    public void A_plane_that_is_regained_and_one_that_is_made_up_are_told_as_such()
    {
        TraceEntry[] regained = Tell(new StubWorld(FlatGround) { Blocks = _ => true }, Vector3.Zero, new(0.1f, 0, 0), Standing);
        Assert.Equal(TraceReason.Regained, Assert.Single(regained, e => e.Kind == TraceKind.ContactPlane).Reason);
        Assert.Equal(TraceSubjectKind.AsBefore, regained[^1].Subject.Kind);

        TraceEntry[] stuck =
            Tell(new StubWorld(_ => null) { Blocks = _ => true }, new(0, 0, 5), new(0, 0, -0.1f), MoverFlags.None, stationary: 2);
        TraceEntry floor = Assert.Single(stuck, e => e.Kind == TraceKind.ContactPlane);
        Assert.Equal((TraceReason.MadeUp, Vector3.UnitZ), (floor.Reason, floor.Plane.Normal));
        Assert.Equal(TraceSubjectKind.None, stuck[^1].Subject.Kind);
    }

    [Fact, Behaviour("trace.limit", "design.md, decision 6")]
    public void A_full_buffer_counts_what_it_leaves_out_until_it_is_cleared()
    {
        TraceBuffer trace = new(limit: 3);
        Sweep(new StubWorld(FlatGround), trace, Vector3.Zero, new(1, 0, 0), Standing, 0, null);
        Assert.Equal(3, trace.Count);
        Assert.Equal(Tell(new StubWorld(FlatGround), Vector3.Zero, new(1, 0, 0), Standing).Length - 3, trace.Dropped);
        trace.Clear();
        Assert.Equal((0, 0L), (trace.Count, trace.Dropped));
        Assert.Throws<ArgumentOutOfRangeException>(() => new TraceBuffer(0));
    }

    private static StubWorld LedgeWorld(Plane? beyond) => new(p => p.X <= 1 ? StubWorld.Flat(0) : beyond);

    private static StubWorld WallWorld() => new(FlatGround) { Wall = (new Vector3(-1, 0, 0), 0.6f, _ => true) };

    /// <summary>The only response of a kind, when it was given and not only tried.</summary>
    private static TraceEntry Single(TraceEntry[] told, TransitionResponse response) =>
        Assert.Single(told, e => e.Kind == TraceKind.Responded && e.Response == response);

    private static TraceEntry[] Tell(
        StubWorld world, Vector3 start, Vector3 way, MoverFlags flags, int stationary = 0, Vector3? sliding = null)
    {
        TraceBuffer trace = new();
        Sweep(world, trace, start, way, flags, stationary, sliding);
        return trace.Entries.ToArray();
    }

    private static void Sweep(
        StubWorld world, TraceBuffer trace, Vector3 start, Vector3 way, MoverFlags flags, int stationary, Vector3? sliding)
    {
        Transition t = world.Sweep(start, way, flags, stationary, sliding);
        t.Trace = trace;
        t.FindValidPosition();
    }
}
