using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>The unit cube of specification 04, 6.7: exact floats.</summary>
public class CubeTreeTests
{
    private const MoverFlags Standing = MoverFlags.Contact | MoverFlags.OnWalkable;
    private const int None = -1, PlusX = 0, PlusY = 2, PlusZ = 4;

    private static readonly PhysicsBsp Cube = Trees.UnitCube();

    private static Mover At(Vector3 check, MoverFlags flags = Standing) => new(flags, check, check, 0.1f);

    private static Mover Placed(Vector3 check) => At(check).With(p => p.InsertType = InsertType.InitialPlacement);

    [Theory, Behaviour("bsp.point.solid", "spec/04, 6.7, BSPNODE::point_intersects_solid @0x0053C310")]
    [InlineData(0, 0, 0, true)]
    [InlineData(0.49, 0, 0, true)]
    [InlineData(0.5, 0, 0, false)]
    [InlineData(0, 0, -0.5, false)]
    [InlineData(0, 0, -0.6, false)]
    public void A_point_is_solid_behind_every_face(float x, float y, float z, bool solid) =>
        Assert.Equal(solid, Cube.PointIntersectsSolid(new(x, y, z)));

    [Theory, Behaviour("bsp.sphere.solid", "spec/04, 6.7, BSPNODE::sphere_intersects_solid @0x0053CAF0")]
    [InlineData(0, 0, 0, 0.1, true, false)]
    [InlineData(0, 0, 0.55, 0.1, true, true)]
    [InlineData(0, 0, 0.5997, 0.1, true, true)]
    [InlineData(0, 0, 0.5999, 0.1, false, false)]
    [InlineData(0.55, 0.55, 0, 0.1, true, true)]
    [InlineData(0.58, 0.58, 0, 0.1, false, false)]
    [InlineData(0.56, 0.56, 0.55, 0.1, true, true)]
    [InlineData(0.45, 0, 0, 0.1, true, true)]
    [InlineData(0, 0, 1.4, 0.1, false, false)]
    [InlineData(0, 0, 0.7, 0.5, true, true)]
    [InlineData(0.45, 0, 0.55, 0.1, true, true)]
    public void A_sphere_is_in_solid_by_its_surface_or_when_asked_by_its_centre(
        float x, float y, float z, float r, bool withCenter, bool surfaceOnly)
    {
        Sphere sphere = new(new(x, y, z), r);
        Assert.Equal(withCenter, Cube.SphereIntersectsSolid(sphere, true));
        Assert.Equal(surfaceOnly, Cube.SphereIntersectsSolid(sphere, false));
    }

    [Theory, Behaviour("bsp.sphere.poly", "spec/04, 6.7, BSPNODE::sphere_intersects_poly @0x0053CA30")]
    [InlineData(0, 0, 0, 0.1, false, None, None)]
    [InlineData(0, 0, 0.55, 0.1, true, PlusZ, PlusZ)]
    [InlineData(0, 0, 0.5997, 0.1, true, PlusZ, PlusZ)]
    [InlineData(0, 0, 0.5999, 0.1, false, None, None)]
    [InlineData(0.55, 0.55, 0, 0.1, false, PlusY, PlusY)]
    [InlineData(0.58, 0.58, 0, 0.1, false, None, None)]
    [InlineData(0.56, 0.56, 0.55, 0.1, true, PlusZ, PlusZ)]
    [InlineData(0.45, 0, 0, 0.1, false, PlusX, PlusX)]
    [InlineData(0, 0, 1.4, 0.1, false, None, None)]
    [InlineData(0, 0, 0.7, 0.5, true, PlusZ, PlusZ)]
    [InlineData(0.45, 0, 0.55, 0.1, true, PlusZ, PlusZ)]
    public void A_sphere_hits_what_it_moves_against_and_remembers_the_last_overlap(
        float x, float y, float z, float r, bool hits, int down, int up)
    {
        PolygonContact contact = default;
        Assert.Equal(hits, Cube.SphereIntersectsPoly(new(new(x, y, z), r), new(0, 0, -1), ref contact));
        Assert.Equal(down, contact.Polygon);
        contact = default;
        Assert.False(Cube.SphereIntersectsPoly(new(new(x, y, z), r), new(0, 0, 1), ref contact));
        Assert.Equal(up, contact.Polygon);
    }

    [Fact, Behaviour("bsp.sphere.contact-point", "spec/04, 6.7")]
    public void The_contact_point_is_the_foot_of_the_perpendicular()
    {
        PolygonContact contact = default;
        Assert.True(Cube.SphereIntersectsPoly(new(new(0, 0, 0.55f), 0.1f), new(0, 0, -1), ref contact));
        Assert.Equal(new Vector3(0, 0, 0.5f), contact.Point);
    }

    [Theory, Behaviour("bsp.sphere.solid-poly", "spec/04, 6.7, BSPNODE::sphere_intersects_solid_poly @0x0053CD50")]
    [InlineData(0, 0, 0, 0.1, true, true, None)]
    [InlineData(0, 0, 0.55, 0.1, true, false, PlusZ)]
    [InlineData(0, 0, 0.5997, 0.1, true, false, PlusZ)]
    [InlineData(0, 0, 0.5999, 0.1, false, false, None)]
    [InlineData(0.55, 0.55, 0, 0.1, true, false, PlusX)]
    [InlineData(0.58, 0.58, 0, 0.1, false, false, None)]
    [InlineData(0.56, 0.56, 0.55, 0.1, true, false, PlusX)]
    [InlineData(0.45, 0, 0, 0.1, true, true, PlusX)]
    [InlineData(0, 0, 1.4, 0.1, false, false, None)]
    [InlineData(0, 0, 0.7, 0.5, true, false, PlusZ)]
    [InlineData(0.45, 0, 0.55, 0.1, false, false, PlusX)]
    public void The_placement_query_answers_like_retail_also_where_that_is_odd(
        float x, float y, float z, float r, bool result, bool centerSolid, int polygon)
    {
        bool solid = false;
        PolygonContact hit = default;
        Assert.Equal(result, Cube.SphereIntersectsSolidPoly(new(new(x, y, z), r), r, ref solid, ref hit, true));
        Assert.Equal((centerSolid, polygon), (solid, hit.Polygon));
    }

    [Fact, Behaviour("bsp.placement.straddle-from-behind", "spec/04, 6.7: the straddle consequence")]
    public void Placement_overlooks_an_overlap_when_the_nearer_side_named_a_polygon()
    {
        Mover mover = Placed(new(0.45f, 0, 0.55f));
        Assert.Equal(TransitionState.OK, mover.Ask(Cube));
        Assert.Equal(Vector3.Zero, mover.Moved);
    }

    [Theory, Behaviour("bsp.collisions.placement", "spec/04, 6.7")]
    [InlineData(0, false, false, TransitionState.Collided)]
    [InlineData(0, true, true, TransitionState.OK)]
    [InlineData(0, true, false, TransitionState.Collided)]
    [InlineData(0.55, true, true, TransitionState.Collided)]
    public void A_building_lets_a_centre_inside_when_a_room_of_it_is_reached(float z, bool building, bool room, TransitionState answer)
    {
        Mover mover = At(new(0, 0, z)).With(p => (p.InsertType, p.BuildingCheck) = (InsertType.Placement, building));
        mover.Transition.Cells.HitsInteriorCell = room;
        Assert.Equal(answer, mover.Ask(Cube));
        Assert.Equal(Vector3.Zero, mover.Moved);
    }

    [Fact, Behaviour("bsp.collisions.ethereal", "spec/04, 4.6 row 1")]
    public void Through_an_ethereal_obstacle_only_the_overlap_is_reported()
    {
        Mover mover = new(Standing, new(0.8f, 0, 0), new(0.55f, 0, 0), 0.1f);
        mover.Path.ObstructionEthereal = true;
        Assert.Equal(TransitionState.Collided, mover.Ask(Cube));
        Assert.False(mover.Collision.CollisionNormalValid);
    }

    [Theory, Behaviour("bsp.placement.push-out", "spec/04, 6.7, BSPTREE::placement_insert @0x00539960")]
    [InlineData(0, 0, 0.55, TransitionState.Adjusted, 0, 0, 0.0500000119)]
    [InlineData(0, 0, 0.45, TransitionState.Adjusted, 0, 0, 0.150000036)]
    [InlineData(0.45, 0.1, 0.2, TransitionState.Adjusted, 0.150000036, 0, 0)]
    [InlineData(0, 0, 2, TransitionState.OK, 0, 0, 0)]
    [InlineData(0, 0, 0.3, TransitionState.Adjusted, 0, 0, 0)]
    public void A_placed_body_is_pushed_out(float x, float y, float z, TransitionState answer, float ox, float oy, float oz)
    {
        Mover mover = Placed(new(x, y, z));
        Vector3 before = mover.At;
        Assert.Equal(answer, mover.Ask(Cube));
        Assert.Equal(before + new Vector3(ox, oy, oz), mover.At);
    }

    [Theory, Behaviour("bsp.step-down", "spec/04, 6.7, BSPTREE::step_sphere_down @0x0053A210")]
    [InlineData(0, 0.55, 0.2, 1, 0.0500000119, 0.75000006)]
    [InlineData(0, 0.55, 0.04, 1, 0.0500000119, -0.249999762)]
    [InlineData(0, 0.55, 0.2, 0.5, 0.0500000119, 0.25000006)]
    [InlineData(0.57, 0.57, 0.2, 1, 0.030000031, 0.849999964)]
    public void A_probe_lifts_the_foot_onto_the_top(float x, float z, float amount, float interp, float lift, float interpAfter)
    {
        Mover mover = At(new(x, 0, z)).With(p => (p.SteppingDown, p.StepDownAmount, p.WalkInterp) = (true, amount, interp));
        float before = mover.At.Z;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cube));
        Assert.Equal((before + lift, interpAfter), (mover.At.Z, mover.Path.WalkInterp));
        Assert.Equal(new Plane(0, 0, 1, -0.5f), mover.Collision.ContactPlane);
        Assert.True(mover.Collision.ContactPlaneValid);
        Assert.False(mover.Collision.ContactPlaneIsWater);
        Assert.Equal(Mover.CellId, mover.Collision.ContactPlaneCellId);
        Assert.Equal(PlusZ, mover.Path.Walkable.Index);
        Assert.Same(Cube.Polygons, mover.Path.Walkable.Set);
    }

    [Theory, Behaviour("bsp.step-down.refused", "spec/04, 6.7")]
    [InlineData(0, 0.55, 0.03)]
    [InlineData(0, 0.62, 0.2)]
    [InlineData(0.575, 0.575, 0.2)]
    public void A_probe_finds_nothing_out_of_reach(float x, float z, float amount)
    {
        Mover mover = At(new(x, 0, z)).With(p => (p.SteppingDown, p.StepDownAmount) = (true, amount));
        Assert.Equal(TransitionState.OK, mover.Ask(Cube));
        Assert.Equal((Vector3.Zero, 1f, false), (mover.Moved, mover.Path.WalkInterp, mover.Collision.ContactPlaneValid));
        Assert.True(mover.Path.Walkable.IsNone);
    }

    [Theory, Behaviour("bsp.footing", "spec/04, 6.7, BSPNODE::hits_walkable @0x0053CBD0")]
    [InlineData(0, TransitionState.Collided)]
    [InlineData(0.548, TransitionState.Collided)]
    [InlineData(0.56, TransitionState.OK)]
    public void Footing_is_a_walkable_polygon_within_half_the_radius(float x, TransitionState answer)
    {
        Mover mover = At(new(x, 0, 0.55f)).With(p => (p.CheckingWalkable, p.WalkableAllowance) = (true, RetailMath.LandingZ));
        Assert.Equal(answer, mover.Ask(Cube));
    }

    [Fact, Behaviour("bsp.landing", "spec/04, 6.7")]
    public void A_landing_body_is_pulled_back_along_its_way()
    {
        Mover mover = new Mover(MoverFlags.None, new(0.2f, 0, 1), new(0.1f, 0, 0.55f), 0.1f)
            .With(p => (p.Collide, p.WalkableAllowance) = (true, RetailMath.LandingZ));
        Vector3 before = mover.At;
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cube));
        Assert.Equal(before + new Vector3(0.0111111104f, 0, 0.0500000119f), mover.At);
        Assert.Equal(0.888888896f, mover.Path.WalkInterp);
    }

    [Theory, Behaviour("bsp.grounded.back-face-deferred", "spec/04, 6.7, SPHEREPATH::set_neg_poly_hit @0x005398E0")]
    [InlineData(0.7, -0.3, 0.58, 0, 0.6, -0.3, 0.5, 0, false)]
    [InlineData(0.58, 0, 0.75, 0.2, 0.5, 0, 0.6, 0.2, true)]
    public void A_grounded_body_of_two_spheres_defers_what_it_does_not_run_into(
        float x, float z, float headX, float headZ, float currX, float currZ, float headCurrX, float headCurrZ, bool stepUp)
    {
        Mover mover = new Mover(Standing, new(currX, 0, currZ), new(x, 0, z), 0.1f, Vector3.Zero)
            .WithHead(new(headCurrX, 0, headCurrZ), new(headX, 0, headZ));
        Assert.Equal(TransitionState.OK, mover.Ask(Cube));
        Assert.Equal((true, stepUp, new Vector3(-1, 0, 0)), (mover.Path.NegPolyHit, mover.Path.NegStepUp, mover.Path.NegCollisionNormal));
        Assert.Equal(Vector3.Zero, mover.Moved);
    }

    [Fact, Behaviour("bsp.airborne.back-face-lands", "spec/04, 6.7")]
    public void A_body_in_the_air_lands_on_what_it_moves_away_from_too()
    {
        Mover mover = new(MoverFlags.None, new(0, 0, 0.55f), new(0, 0, 0.58f), 0.1f);
        Assert.Equal(TransitionState.Adjusted, mover.Ask(Cube));
        Assert.Equal((true, Vector3.UnitZ, 0.0871556997f), (mover.Path.Collide, mover.Path.StepUpNormal, mover.Path.WalkableAllowance));
        Assert.Equal(Vector3.Zero, mover.Moved);
    }
}
