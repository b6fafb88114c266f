using System.Numerics;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>The tables of specification 03, 6.1, 6.5, 6.6 and 6.7.</summary>
public class ContactTests
{
    private const uint Cell = 0xA9B40001;
    private static readonly Plane Level = new(0, 0, 1, 0);

    private static Plane Slope(double degrees)
    {
        double a = degrees * Math.PI / 180;
        return new Plane((float)-Math.Sin(a), 0, (float)Math.Cos(a), 0);
    }

    private static Transition At(
        Vector3 check, Vector3 curr, MoverFlags flags = MoverFlags.None, float radius = 0.48f, uint beginCell = Cell)
    {
        StubWorld world = new(_ => null);
        Transition t = new(world);
        t.Reset();
        t.Object.Init(world.Walker(), flags);
        t.Path.InitSpheres([new Sphere(Vector3.Zero, radius)], 1);
        t.Path.InitPath(null, true, new Position(beginCell, curr), new Position(Cell, check));
        t.Path.SetCheckPos(new Position(Cell, check), null);
        return t;
    }

    [Fact, Behaviour("geometry.constants.bits", "spec/03, 6.1")]
    public void Slope_limits_have_the_bits_of_retail()
    {
        Assert.Equal(0x3F2A0751u, BitConverter.SingleToUInt32Bits(RetailMath.FloorZ));
        Assert.Equal(0x3DB27EB0u, BitConverter.SingleToUInt32Bits(RetailMath.LandingZ));
        Assert.Equal(0x3951B717u, BitConverter.SingleToUInt32Bits(RetailMath.Epsilon));
        Assert.True(ObjectInfo.IsValidWalkable(new Vector3(0, 0, BitConverter.UInt32BitsToSingle(0x3F2A0751))));
        Assert.False(ObjectInfo.IsValidWalkable(new Vector3(0, 0, BitConverter.UInt32BitsToSingle(0x3F2A0750))));
    }

    [Fact, Behaviour("transition.normals.stored-unit", "spec/03, 6.5")]
    public void Collision_and_sliding_normals_are_stored_as_unit_vectors()
    {
        CollisionInfo c = new();
        c.SetCollisionNormal(new Vector3(0, 0, 2));
        Assert.Equal(Vector3.UnitZ, c.CollisionNormal);
        c.SetSlidingNormal(new Vector3(0.6f, 0, 0.8f));
        Assert.Equal(Vector3.UnitX, c.SlidingNormal);
        c.SetSlidingNormal(new Vector3(0.0001f, 0, 1));
        Assert.True(c.SlidingNormalValid);
        Assert.Equal(Vector3.Zero, c.SlidingNormal);
        c.SetCollisionNormal(new Vector3(0.0001f, 0, 0));
        Assert.True(c.CollisionNormalValid);
        Assert.Equal(Vector3.Zero, c.CollisionNormal);
    }

    [Fact, Behaviour("transition.normals.nan-is-no-direction", "spec/03, 4.1.1 and 4.3; spec/04, 1.2: NaN is not at least EPS long")]
    public void A_normal_of_NaN_is_stored_as_no_direction()
    {
        CollisionInfo c = new();
        c.SetCollisionNormal(new Vector3(float.NaN, 0, 1));
        c.SetSlidingNormal(new Vector3(1, float.NaN, 0));
        Assert.Equal((true, Vector3.Zero), (c.CollisionNormalValid, c.CollisionNormal));
        Assert.Equal((true, Vector3.Zero), (c.SlidingNormalValid, c.SlidingNormal));
    }

    [Fact, Behaviour("transition.terrain-contact.table", "spec/03, 6.6")]
    public void Terrain_answers_the_lowest_point_of_the_sphere()
    {
        const MoverFlags stands = MoverFlags.Contact | MoverFlags.OnWalkable;
        (int Row, float Cz, Plane Plane, MoverFlags Flags, bool Probe, bool Check, float Interp, float Water, TransitionState Result,
            float Moved, bool Contact, bool Hit, float InterpAfter)[] rows =
        [
            (1, 0.481f, Level, 0, false, false, 1, 0, TransitionState.OK, 0, false, false, 1),
            (2, 0.4801f, Level, 0, false, false, 1, 0, TransitionState.OK, 0, true, true, 1),
            (3, 0.4799f, Level, 0, false, false, 1, 0, TransitionState.OK, 0, true, true, 1),
            (4, 0.46f, Level, 0, false, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, true, 1),
            (5, 0.46f, Level, stands, false, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, false, 1),
            (6, 0.46f, Level, stands, false, true, 1, 0, TransitionState.Collided, 0, false, false, 1),
            (7, 0.48f, Level, stands, true, false, 1, 0, TransitionState.OK, 0, true, false, 1),
            (8, 0.28f, Level, stands, true, false, 1, 0, TransitionState.Adjusted, 0.199999988f, true, false, 0.666666687f),
            (9, -0.18f, Level, stands, true, false, 1, 0, TransitionState.Adjusted, 0.659999967f, true, false, -0.0999998972f),
            (10, -0.22f, Level, stands, true, false, 1, 0, TransitionState.Collided, 0, true, false, 1),
            (11, 0.13f, Level, stands, true, false, 0.5f, 0, TransitionState.Adjusted, 0.349999994f, true, false, -0.0833332986f),
            (12, 0.11f, Level, stands, true, false, 0.5f, 0, TransitionState.Collided, 0, true, false, 0.5f),
            (13, 0.46f, Slope(48.381), stands, false, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, false, 1),
            (14, 0.46f, Slope(48.39), stands, false, false, 1, 0, TransitionState.OK, 0, false, false, 1),
            (14, 0.46f, Slope(50), stands, false, false, 1, 0, TransitionState.OK, 0, false, false, 1),
            (14, 0.46f, Slope(60), stands, false, false, 1, 0, TransitionState.OK, 0, false, false, 1),
            (15, 0.46f, Slope(50), MoverFlags.Contact, false, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, false, 1),
            (16, 0.46f, Slope(50), 0, false, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, true, 1),
            (17, 0.46f, Slope(50), stands, true, false, 1, 0, TransitionState.Adjusted, 0.0199999809f, true, false, 0.966666698f),
            (18, 0.1f, Level, 0, false, false, 1, 0.45f, TransitionState.OK, 0, false, false, 1),
            (19, 0.02f, Level, 0, false, false, 1, 0.45f, TransitionState.Adjusted, 0.0100000016f, true, true, 1),
        ];
        foreach (var row in rows)
        {
            Vector3 center = new(0, 0, row.Cz);
            Transition t = At(center, center, row.Flags);
            t.Path.SteppingDown = row.Probe;
            t.Path.CheckingWalkable = row.Check;
            t.Path.StepDownAmount = 0.6f;
            t.Path.WalkInterp = row.Interp;
            TransitionState state = t.ValidateWalkable(t.Path.GlobalSpheres[0], row.Plane, false, row.Water, Cell);
            float moved = t.Path.CheckPos.Frame.Origin.Z - row.Cz;
            Assert.Equal((row.Row, row.Result), (row.Row, state));
            Assert.True(Math.Abs(row.Moved - moved) < 1e-7, $"row {row.Row}: moved {moved:R}, expected {row.Moved:R}");
            Assert.Equal((row.Row, row.Contact), (row.Row, t.Collision.ContactPlaneValid));
            Assert.Equal((row.Row, row.Hit, row.Hit), (row.Row, t.Collision.CollisionNormalValid, t.Collision.CollidedWithEnvironment));
            Assert.True(Math.Abs(row.InterpAfter - t.Path.WalkInterp) < 1e-7,
                $"row {row.Row}: interp {t.Path.WalkInterp:R}, expected {row.InterpAfter:R}");
        }
    }

    [Theory, Behaviour("transition.terrain-contact.camera", "spec/03, 6.6")]
    [InlineData(0, 0, 0.5f, 0, 0, 1, Cell, TransitionState.OK, 0, 0)]
    [InlineData(0, 0, 0.1f, -1, 0, 1, Cell, TransitionState.Adjusted, -0.222222239f, 0.200000018f)]
    [InlineData(0, 0, 0.1f, 0, 0, 0.15f, 0xA9B40100, TransitionState.OK, 0, 0)]
    [InlineData(0, 0, 0.1f, 0, 0, 0.15f, Cell, TransitionState.Adjusted, 0, 0.200000018f)]
    public void The_camera_stops_where_its_sphere_touches_the_ground(
        float x, float y, float z, float cx, float cy, float cz, uint beginCell, TransitionState expected, float movedX, float movedZ)
    {
        Transition t = At(new Vector3(x, y, z), new Vector3(cx, cy, cz), MoverFlags.IsViewer, 0.3f, beginCell);
        Assert.Equal(expected, t.ValidateWalkable(t.Path.GlobalSpheres[0], Level, false, 0, Cell));
        Vector3 moved = t.Path.CheckPos.Frame.Origin - new Vector3(x, y, z);
        Assert.Equal(movedX, moved.X, 6);
        Assert.Equal(movedZ, moved.Z, 6);
    }

    [Fact, Behaviour("transition.slide.table", "spec/03, 6.7")]
    public void A_slide_keeps_the_movement_along_the_crease()
    {
        Vector3 curr = new(0, 0, 0.48f);
        (int Row, Vector3 Check, Vector3 Normal, TransitionState Result, Vector3 Moved, Vector3? Recorded)[] rows =
        [
            (1, new(0.1f, 0.1f, 0.48f), new(-1, 0, 0), TransitionState.Slid, new(-0.100000001f, 0, 0), new(-1, 0, 0)),
            (2, new(0.1f, 0, 0.48f), new(-1, 0, 0), TransitionState.Collided, Vector3.Zero, new(-1, 0, 0)),
            (3, new(0.1f, 0.01f, 0.48f), new(-1, 0, 0), TransitionState.Collided, Vector3.Zero, new(-1, 0, 0)),
            (4, new(0.1f, 0.0142f, 0.48f), new(-1, 0, 0), TransitionState.Slid, new(-0.100000001f, 0, 0), new(-1, 0, 0)),
            (5, new(0, 0, 0.38f), new(0, 0, 1), TransitionState.Slid, new(0, 0, 0.099999994f), new(0, 0, 1)),
            (6, new(0, 0, 0.58f), new(0, 0, -1), TransitionState.Collided, Vector3.Zero, new(0, 0, -1)),
            (7, new(0.1f, 0, 0.48f), Vector3.Zero, TransitionState.Adjusted, new(-0.0500000007f, 0, 0), null),
            (8, new(0.1f, 0.1f, 0.48f), new(-2, 0, 0), TransitionState.Slid, new(-0.100000001f, 0, 0), new(-1, 0, 0)),
        ];
        foreach (var row in rows)
        {
            Transition t = At(row.Check, curr);
            t.Collision.SetContactPlane(Level, false);
            Vector3 normal = row.Normal;
            TransitionState state = t.SlideSphere(0, ref normal, t.Path.GlobalCurrCenters[0]);
            Vector3 moved = t.Path.CheckPos.Frame.Origin - row.Check;
            Assert.Equal((row.Row, row.Result), (row.Row, state));
            Assert.True(Vector3.Distance(row.Moved, moved) < 1e-7, $"row {row.Row}: moved {moved:R}");
            Assert.Equal((row.Row, row.Recorded ?? Vector3.Zero), (row.Row, t.Collision.CollisionNormal));
        }
    }

    [Fact]
    [Behaviour("transition.slide.roundings", "spec/03, 4.8.1, 4: in the square of the crease z counts once stored and once unrounded")]
    public void A_slide_squares_the_crease_with_one_unrounded_factor()
    {
        // Stored in both factors: (0.199867383, 0.25253883, −0.387605041); in none: (0.199867412, 0.25253889, −0.387605131).
        Vector3 normal = new(0.96f, -0.99f, -0.15f);
        Transition t = At(new Vector3(0.4f, 0.29f, -0.26f), Vector3.Zero);
        t.Collision.SetContactPlane(new Plane(0.59f, 0.5f, 0.63f, 0), false);
        Assert.Equal(TransitionState.Slid, t.SlideSphere(0, ref normal, t.Path.GlobalCurrCenters[0]));
        Assert.Equal(new Vector3(0.199867398f, 0.25253886f, -0.387605101f), t.Path.CheckPos.Frame.Origin);
    }

    [Fact, Behaviour("transition.slide.across-a-block-border", "spec/03, 6.7 row 9")]
    public void A_slide_across_a_border_takes_the_blocks_into_account()
    {
        const uint east = 0xAAB40001;
        Vector3 check = new(1, 0.1f, 0.48f), normal = new(-1, 0, 0);
        Transition t = At(check, new Vector3(191.9f, 0, 0.48f));
        t.Path.SetCheckPos(new Position(east, check), null);
        t.Collision.SetContactPlane(Level, false);
        Assert.Equal(TransitionState.Slid, t.SlideSphere(0, ref normal, t.Path.GlobalCurrCenters[0]));
        Assert.Equal(check + new Vector3(-1.1000061f, 0, 0), t.Path.CheckPos.Frame.Origin);
        Assert.Equal((east, new Vector3(-1, 0, 0)), (t.Path.CheckPos.CellId, t.Collision.CollisionNormal));
    }

    [Theory, Behaviour("transition.path.re-based", "spec/03, 6.3 and 4.2 adjust_check_pos")]
    [InlineData(0xAAB40001, 1.5f)]
    [InlineData(0xAAB40100, 193.5f)]
    public void Only_an_outdoor_cell_takes_the_position_into_its_own_block(uint cellId, float x)
    {
        Transition t = At(new Vector3(193.5f, 10, 0), Vector3.Zero);
        t.Path.SetCheckPos(new Position(0xA9B40039, new Vector3(193.5f, 10, 0)), null);
        t.Path.AdjustCheckPos(cellId);
        Vector3 expected = new(x, 10, 0);
        Assert.Equal((cellId, expected, expected), (t.Path.CheckPos.CellId, t.Path.CheckPos.Frame.Origin, t.Path.GlobalSpheres[0].Center));
    }

    [Theory, Behaviour("transition.cliff-slide.table", "spec/03, 6.7")]
    [InlineData(0.866025388f, 0, 0.5f, 0.2f, 0.1f, TransitionState.Adjusted, -0.200000003f, 0, -1, 0)]
    [InlineData(-0.866025388f, 0, 0.5f, 0.2f, 0.1f, TransitionState.Adjusted, 0.200000003f, 0, -1, 0)]
    [InlineData(0, 0, 1, 0.2f, 0.1f, TransitionState.OK, 0, 0, 0, 0)]
    [InlineData(0.6123724f, 0.6123724f, 0.5f, 0.2f, 0, TransitionState.Adjusted, -0.1f, -0.1f, -0.707106769f, -0.707106769f)]
    public void A_cliff_pushes_along_its_foot_or_brink(
        float nx, float ny, float nz, float x, float y, TransitionState expected, float mx, float my, float hx, float hy)
    {
        Transition t = At(new Vector3(x, y, 0.48f), new Vector3(0, 0, 0.48f));
        t.Collision.LastKnownContactPlane = Level;
        Assert.Equal(expected, t.CliffSlide(new Plane(nx, ny, nz, 0)));
        Vector3 moved = t.Path.CheckPos.Frame.Origin - new Vector3(x, y, 0.48f);
        Assert.True(Vector3.Distance(new(mx, my, 0), moved) < 1e-6, $"{moved:R}");
        Assert.True(Vector3.Distance(new(hx, hy, 0), t.Collision.CollisionNormal) < 1e-6);
    }
}
