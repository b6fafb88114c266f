using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>The tables of specification 03, 6.2 and 6.4.</summary>
public class SubStepTests
{
    private static readonly Plane Slope30 = new(-0.5f, 0, 0.866025388f, 0);
    private static readonly Plane Level = new(0, 0, 1, 0);

    private static Transition WithSphere(float radius, Vector3 center = default, MoverFlags flags = MoverFlags.None)
    {
        StubWorld world = new(_ => null);
        Transition t = new(world);
        t.Reset();
        t.Object.Init(world.Walker(), flags);
        t.Path.InitSpheres([new Sphere(center, radius)], 1);
        return t;
    }

    [Theory, Behaviour("transition.sub-steps.count", "spec/03, 6.2")]
    [InlineData(0.48f, 0, 0, 0, false, 0, 0, 0, 0)]
    [InlineData(0.48f, 1e-7f, 0, 0, false, 1, 1.00000001e-7f, 0, 0)]
    [InlineData(0.48f, 0.48f, 0, 0, false, 1, 0.479999989f, 0, 0)]
    [InlineData(0.48f, 0.480001f, 0, 0, false, 2, 0.240000501f, 0, 0)]
    [InlineData(0.48f, 0.96f, 0, 0, false, 2, 0.479999989f, 0, 0)]
    [InlineData(0.48f, 1, 0, 0, false, 3, 0.333333343f, 0, 0)]
    [InlineData(0.48f, 0.3f, 0.4f, 0, false, 2, 0.150000006f, 0.200000003f, 0)]
    [InlineData(0.48f, 3, 4, 0, false, 11, 0.272727281f, 0.363636374f, 0)]
    [InlineData(0.1f, 1, 0, 0, false, 10, 0.100000001f, 0, 0)]
    [InlineData(0.3f, 1, 0, 0, true, 4, 0.300000012f, 0, 0)]
    [InlineData(0.3f, 0.9f, 0, 0, true, 3, 0.300000012f, 0, 0)]
    [InlineData(0.3f, 0.2f, 0, 0, true, 1, 0.300000012f, 0, 0)]
    [InlineData(0.3f, 0.0002f, 0, 0, true, 0, 0, 0, 0)]
    public void A_sweep_is_cut_into_steps_of_at_most_one_radius(
        float radius, float x, float y, float z, bool viewer, int count, float px, float py, float pz)
    {
        Transition t = WithSphere(radius, flags: viewer ? MoverFlags.IsViewer : MoverFlags.None);
        t.Path.InitPath(null, true, new Position(StubWorld.CellId, Vector3.Zero), new Position(StubWorld.CellId, new Vector3(x, y, z)));
        SubStepPlan plan = SubStepPlan.Of(t.Path, t.Object.Has(MoverFlags.IsViewer));
        Assert.Equal(count, plan.Count);
        Assert.Equal(new Vector3(px, py, pz), plan.PerSubStep);
    }

    [Fact, Behaviour("transition.sub-steps.across-a-block-border", "spec/03, 6.2")]
    public void A_sweep_across_a_block_border_is_cut_alike()
    {
        Transition t = WithSphere(0.48f);
        t.Path.InitPath(null, true, new Position(0xA9B40001, new Vector3(191, 10, 0)), new Position(0xAAB40001, new Vector3(1, 10, 0)));
        SubStepPlan plan = SubStepPlan.Of(t.Path, t.Object.Has(MoverFlags.IsViewer));
        Assert.Equal(new Vector3(2, 0, 0), plan.Offset);
        Assert.Equal(5, plan.Count);
        Assert.Equal(new Vector3(0.400000006f, 0, 0), plan.PerSubStep);
    }

    [Fact, Behaviour("transition.offset.bends", "spec/03, 6.4")]
    public void A_step_is_bent_along_floor_wall_and_crease()
    {
        Vector3 wall = new(-1, 0, 0), diagonal = Vector3.Normalize(new Vector3(-1, -1, 0));
        (int Row, Vector3 Offset, Plane? Floor, Vector3? Wall, Vector3 Result, bool WallHolds)[] rows =
        [
            (1, new(0.1f, 0, 0), null, null, new(0.1f, 0, 0), false),
            (2, new(0.1f, 0, 0), Slope30, null, new(0.075000003f, 0, 0.0433012694f), false),
            (3, new(-0.1f, 0, 0), Slope30, null, new(-0.100000001f, 0, -0.0577350296f), false),
            (3, new(-0.1f, 0, 0), Slope30 with { D = -200 }, null, new(-0.100000001f, 0, -0.0577350296f), false),
            (4, new(0, 0.1f, 0), Slope30, null, new(0, 0.100000001f, 0), false),
            (5, new(0.1f, 0.1f, 0), Slope30, null, new(0.075000003f, 0.100000001f, 0.0433012694f), false),
            (6, new(0.1f, 0.1f, 0), null, wall, new(0, 0.100000001f, 0), true),
            (7, new(-0.1f, 0.1f, 0), null, wall, new(-0.1f, 0.1f, 0), false),
            (8, new(0, 0.1f, 0), null, wall, new(0, 0.1f, 0), false),
            (9, new(0.1f, 0.1f, -0.02f), Level, wall, new(0, 0.100000001f, 0), true),
            (10, new(0.1f, 0.1f, 0), Slope30, new(0, -1, 0), new(0.0749999955f, 0, 0.0433012694f), true),
            (11, new(0.1f, 0, 0), new Plane(1, 0, 0, 0), wall, Vector3.Zero, true),
            (12, new(0, 0, -0.02f), Level, null, Vector3.Zero, false),
            (13, new(0.1f, 0, 0.05f), Level, null, new(0.100000001f, 0, 0), false),
            (14, new(0.1f, 0, 0), null, diagonal, new(0.0500000007f, -0.0500000007f, 0), true),
            (14, new(0.1f, 0, 0), Level, diagonal, new(0.0500000007f, -0.0500000007f, 0), true),
        ];
        foreach (var row in rows)
        {
            Transition t = WithSphere(0.48f);
            t.Path.SetCheckPos(new Position(StubWorld.CellId, Vector3.Zero), null);
            if (row.Floor is { } floor) t.Collision.SetContactPlane(floor, false);
            if (row.Wall is { } normal) t.Collision.SetSlidingNormal(normal);
            Vector3 bent = t.AdjustOffset(row.Offset);
            Assert.True(Vector3.Distance(row.Result, bent) < 1e-8f, $"row {row.Row}: {bent:R}, expected {row.Result:R}");
            Assert.Equal((row.Row, row.WallHolds), (row.Row, t.Collision.SlidingNormalValid));
        }
    }

    [Theory, Behaviour("transition.offset.unsinks", "spec/03, 6.4")]
    [InlineData(0.47f, false, 0xA9B40001, 0.00999999046f)]
    [InlineData(0.4799f, false, 0xA9B40001, 0f)]
    [InlineData(-0.01f, false, 0xA9B40001, 0f)]
    [InlineData(0.47f, true, 0xA9B40001, 0f)]
    [InlineData(0.47f, false, 0u, 0f)]
    public void A_foot_sunk_into_its_contact_plane_is_lifted(float centerZ, bool water, uint planeCell, float lift)
    {
        Transition t = WithSphere(0.48f, new Vector3(0, 0, centerZ));
        t.Path.SetCheckPos(new Position(0xA9B40001, Vector3.Zero), null);
        t.Collision.SetContactPlane(Level, water, planeCell);
        t.AdjustOffset(new Vector3(0.1f, 0, 0));
        Assert.Equal(lift, t.Path.CheckPos.Frame.Origin.Z);
    }

    [Fact, Behaviour("transition.offset.unsinks-on-a-slope", "spec/03, 6.4")]
    public void On_a_slope_the_lift_is_measured_along_the_normal_and_made_straight_up()
    {
        Transition t = WithSphere(0.48f, new Vector3(0, 0, 0.5f));
        t.Path.SetCheckPos(new Position(0xA9B40001, Vector3.Zero), null);
        t.Collision.SetContactPlane(Slope30, false, 0xA9B40001);
        t.AdjustOffset(new Vector3(0.1f, 0, 0));
        Assert.Equal(0.0542562567f, t.Path.CheckPos.Frame.Origin.Z, 7);
    }
}
