using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>The camera's sweeps of specification 03, 6.8: one sphere of 0.3 m over flat ground, outdoors.</summary>
public class CameraTests
{
    private const MoverFlags Camera = MoverFlags.IsViewer | MoverFlags.PathClipped | MoverFlags.FreeRotate | MoverFlags.PerfectClip;

    private static Transition Sweep(Vector3 from, Vector3 to, TraceBuffer? trace = null)
    {
        StubWorld world = new(_ => StubWorld.Flat(0));
        Transition t = new(world) { Trace = trace };
        t.Reset();
        t.Object.Init(world.Walker(), Camera);
        t.Path.InitSpheres([new Sphere(Vector3.Zero, 0.3f)], 1);
        t.Path.InitPath(world.Cell, true, new Position(StubWorld.CellId, from), new Position(StubWorld.CellId, to));
        return t;
    }

    [Fact, Behaviour("transition.camera.stops-at-the-ground", "spec/03, 6.8 Camera")]
    public void The_camera_ends_its_sweep_in_the_sub_step_that_meets_the_ground()
    {
        TraceBuffer trace = new();
        Transition t = Sweep(new(0, 0, 1.5f), new(-1.2f, 0, 0.1f), trace);
        Assert.Equal(7, SubStepPlan.Of(t.Path, t.Object.Has(MoverFlags.IsViewer)).Count);
        Assert.True(t.FindValidPosition());
        Assert.Equal(6, trace.SubStepCount());
        Assert.True(Vector3.Distance(new(-1.02857137f, 0, 0.300000012f), t.Path.CurrPos.Frame.Origin) < 2e-7f,
            $"{t.Path.CurrPos.Frame.Origin:R}");
        Assert.Equal((true, Vector3.UnitZ), (t.Collision.CollisionNormalValid, t.Collision.CollisionNormal));
    }

    [Fact, Behaviour("transition.camera.level", "spec/03, 6.8 Camera")]
    public void The_camera_flies_level_to_the_very_end()
    {
        Transition t = Sweep(new(0, 0, 1.5f), new(-1, 0, 1.5f));
        Assert.Equal(4, SubStepPlan.Of(t.Path, t.Object.Has(MoverFlags.IsViewer)).Count);
        Assert.True(t.FindValidPosition());
        Assert.True(Vector3.Distance(new(-1, 0, 1.5f), t.Path.CurrPos.Frame.Origin) < 2e-7f, $"{t.Path.CurrPos.Frame.Origin:R}");
        Assert.False(t.Collision.CollisionNormalValid);
    }

    [Fact, Behaviour("transition.camera.no-distance", "spec/03, 6.8 Camera")]
    public void A_way_within_the_tolerance_is_no_way()
    {
        Transition t = Sweep(new(0, 0, 1.5f), new(-0.0001f, 0, 1.5f));
        Assert.Equal(0, SubStepPlan.Of(t.Path, t.Object.Has(MoverFlags.IsViewer)).Count);
        Assert.True(t.FindValidPosition());
        Assert.Equal(new Vector3(0, 0, 1.5f), t.Path.CurrPos.Frame.Origin);
    }

    [Fact]
    [Behaviour("transition.camera.level-inside-the-ground",
        "spec/03, 4.4: t = d / 0 moves the sphere infinitely far, which no attempt repairs and the sub-step undoes")]
    public void A_camera_that_begins_in_the_ground_and_moves_level_stays_where_it_is()
    {
        Vector3 from = new(0, 0, 0.1f);
        Transition t = Sweep(from, new(1, 0, 0.1f));
        Assert.True(t.FindValidPosition());
        Assert.Equal((from, Vector3.UnitZ), (t.Path.CurrPos.Frame.Origin, t.Collision.CollisionNormal));
    }
}
