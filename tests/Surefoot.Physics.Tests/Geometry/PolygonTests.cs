using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>The worked examples of specification 04, 6.1 to 6.6: exact floats.</summary>
public class PolygonTests
{
    private static readonly Vector3[] A1 = [new(0, 0, 0), new(4, 0, 0), new(0, 4, 0)];
    private static readonly Vector3[] A2 = [new(0, 0, 0), new(10, 0, 3), new(10, 10, 3), new(0, 10, 0)];
    private static readonly Vector3[] A3 = [new(0, 0, 0), new(1, 0, 0), new(1, 1, 0.1f), new(0, 1, 0)];
    private static readonly Vector3[] Wall = [new(2, -5, 0), new(2, -5, 5), new(2, 5, 5), new(2, 5, 0)];
    private static readonly Vector3[] Floor = [new(-5, -5, 0), new(5, -5, 0), new(5, 5, 0), new(-5, 5, 0)];

    private static ConvexPolygon Polygon(Vector3[] corners) => new(ConvexPolygon.MakePlane(corners), corners);

    private static Sphere Half(float x, float y, float z) => new(new Vector3(x, y, z), 0.5f);

    [Fact, Behaviour("polygon.plane.from-corners", "spec/04, 6.1, CPolygon::make_plane @0x005383D0")]
    public void The_plane_is_the_fan_s_normal_and_the_mean_of_the_corners()
    {
        Assert.Equal(new Plane(0, 0, 1, 0), ConvexPolygon.MakePlane(A1));
        Assert.Equal(new Plane(-0.287347883f, 0, 0.957826257f, 2.98023224e-08f), ConvexPolygon.MakePlane(A2));
        Assert.Equal(new Plane(-0.049875468f, -0.049875468f, 0.99750936f, 0.024937734f), ConvexPolygon.MakePlane(A3));
    }

    [Fact, Behaviour("polygon.plane.roundings", "spec/04, 4.4, make_plane; spec/05, 4.3")]
    public void Heights_stay_unrounded_and_the_mean_is_summed_term_by_term()
    {
        // With rounded heights −0.621411622 and d = 72.2015076; with sums corner by corner d = 3.21570219e−08.
        Assert.Equal(
            new Plane(-0.621411681f, 0.759856761f, 0.190958768f, 72.2015152f),
            ConvexPolygon.MakePlane([new(120, 0, 12.4f), new(144, 0, 90.5f), new(144, 24, -5)]));
        Assert.Equal(
            new Plane(-0.680224836f, 0.00195466704f, -0.733000875f, 3.21570184e-08f),
            ConvexPolygon.MakePlane([new(0, 0, 0), new(0.1f, -2.7f, -0.1f), new(-4.2f, 0.9f, 3.9f)]));
    }

    [Theory, Behaviour("polygon.sphere.overlap", "spec/04, 6.2, CPolygon::polygon_hits_sphere_slow_but_sure @0x00538A10")]
    [InlineData(1, 1, 0.3, true, 1, 1)]
    [InlineData(1, 1, 0.4998, true, 1, 1)]
    [InlineData(1, 1, -0.3, true, 1, 1)]
    [InlineData(1, -0.3, 0.2, true, 1, -0.300000012)]
    [InlineData(1, -0.458, 0.2, true, 1, -0.458000004)]
    [InlineData(1, -0.46, 0.2, false, 1, -0.460000008)]
    [InlineData(2.2, 2.2, 0.3, true, 2.20000005, 2.20000005)]
    [InlineData(2.4, 2.4, 0.3, false, 2.4000001, 2.4000001)]
    [InlineData(4.3, -0.1, 0.2, true, 4.30000019, -0.100000001)]
    [InlineData(4.4, -0.35, 0.2, false, 4.4000001, -0.349999994)]
    [InlineData(-0.2, -0.2, 0.3, true, -0.200000003, -0.200000003)]
    [InlineData(-0.3, -0.3, 0.3, false, -0.300000012, -0.300000012)]
    public void A_sphere_touches_face_edge_or_corner(float x, float y, float z, bool hit, float contactX, float contactY)
    {
        Vector3 contact = new(9, 9, 9);
        Assert.Equal(hit, Polygon(A1).HitsSphere(Half(x, y, z), ref contact));
        Assert.Equal(new Vector3(contactX, contactY, 0), contact);
    }

    [Fact, Behaviour("polygon.sphere.tolerance", "spec/04, 6.2 B3")]
    public void An_overlap_below_the_tolerance_is_none_and_leaves_the_contact_alone()
    {
        Vector3 contact = new(9, 9, 9);
        Assert.False(Polygon(A1).HitsSphere(Half(1, 1, 0.4999f), ref contact));
        Assert.Equal(new Vector3(9, 9, 9), contact);
    }

    [Theory, Behaviour("polygon.sphere.one-sided-with-memory", "spec/04, 6.2, CPolygon::pos_hits_sphere @0x005394F0")]
    [InlineData(0, 0, -1, true)]
    [InlineData(0, 0, 1, false)]
    [InlineData(1, 0, 0, false)]
    [InlineData(0.1, 0, -1e-8, true)]
    public void Only_movement_against_the_normal_hits_but_every_overlap_is_remembered(float x, float y, float z, bool hit)
    {
        Vector3 contact = default;
        Assert.Equal(hit, Polygon(A1).IsRunInto(Half(1, 1, 0.3f), new Vector3(x, y, z), ref contact, out bool overlaps));
        Assert.True(overlaps);
    }

    [Theory, Behaviour("polygon.footing.disc", "spec/04, 6.3, CPolygon::check_walkable @0x00538E60, check_small_walkable @0x005390B0")]
    [InlineData(1, 1, 2, true, true)]
    [InlineData(1, -0.3, 9, true, false)]
    [InlineData(1, -0.2, 9, true, true)]
    [InlineData(1, -0.6, 0, false, false)]
    [InlineData(4.3, -0.1, 0.2, true, false)]
    [InlineData(-0.2, -0.2, 0, true, false)]
    public void A_foot_is_supported_up_to_its_radius_beyond_edges_and_corners(float x, float y, float z, bool whole, bool small)
    {
        Assert.Equal(whole, Polygon(A1).SupportsFoot(Half(x, y, z), Vector3.UnitZ));
        Assert.Equal(small, Polygon(A1).SupportsSmallFoot(Half(x, y, z), Vector3.UnitZ));
    }

    [Fact, Behaviour("polygon.footing.faces-down", "spec/04, 6.3")]
    public void A_polygon_that_faces_down_supports_a_foot() =>
        Assert.True(Polygon([new(0, 0, 0), new(0, 4, 0), new(4, 0, 0)]).SupportsFoot(Half(1, 1, 0.2f), Vector3.UnitZ));

    [Fact, Behaviour("polygon.footing.vertical", "spec/04, 4.4")]
    public void A_vertical_polygon_supports_nothing_and_has_no_crossed_edge()
    {
        Vector3 normal = default;
        Assert.False(Polygon(Wall).SupportsFoot(Half(2, 0, 1), Vector3.UnitZ));
        Assert.False(Polygon(Wall).FindCrossedEdge(Half(2, 9, 1), Vector3.UnitZ, ref normal));
    }

    [Fact, Behaviour("polygon.edge.crossed", "spec/04, 6.3, CPolygon::find_crossed_edge @0x00539300")]
    public void The_first_edge_the_centre_is_beyond_answers_with_its_inward_normal()
    {
        Vector3 normal = new(7, 7, 7);
        Assert.False(Polygon(A1).FindCrossedEdge(Half(1, 1, 0.5f), Vector3.UnitZ, ref normal));
        Assert.Equal(new Vector3(7, 7, 7), normal);
        Assert.True(Polygon(A1).FindCrossedEdge(Half(1, -0.3f, 0.5f), Vector3.UnitZ, ref normal));
        Assert.Equal(new Vector3(0, 1, 0), normal);
        Assert.True(Polygon(A1).FindCrossedEdge(Half(3, 3, 0.5f), Vector3.UnitZ, ref normal));
        Assert.Equal(new Vector3(-0.707106769f, -0.707106769f, 0), normal);
        Assert.True(Polygon(A1).FindCrossedEdge(Half(-0.2f, -0.2f, 0), Vector3.UnitZ, ref normal));
        Assert.Equal(new Vector3(1, 0, 0), normal);
        Assert.True(Polygon(A2).FindCrossedEdge(Half(10.3f, 5, 3), Vector3.UnitZ, ref normal));
        Assert.Equal(new Vector3(-0.957826257f, 0, -0.287347913f), normal);
    }

    [Theory, Behaviour("polygon.rest.on-plane", "spec/04, 6.4, CPolygon::adjust_sphere_to_plane @0x00538210")]
    [InlineData(0.3, 0, -1, 1, 0, 0.5, 0.800000012)]
    [InlineData(0.3, 0.3, -0.6, 0.75, -0.099999994, 0.5, 0.5)]
    [InlineData(0.3, 0, -0.15, 1, 0, 0.5, -0.333333194)]
    [InlineData(-0.4, 0, -0.6, 1, 0, 0.5, -0.49999994)]
    public void A_sphere_is_pulled_back_until_it_rests(
        float z, float moveX, float moveZ, float interp, float x, float afterZ, float afterInterp)
    {
        Sphere sphere = Half(0, 0, z);
        Assert.True(Polygon(Floor).AdjustSphereToPlane(ref sphere, new Vector3(moveX, 0, moveZ), ref interp));
        Assert.Equal(new Vector3(x, 0, afterZ), sphere.Center);
        Assert.Equal(afterInterp, interp);
    }

    [Fact]
    [Behaviour("polygon.rest.before-the-begin",
        "spec/04, 4.4 adjust_sphere_to_plane step 4: (1 - t) is multiplied with what is left before it is compared")]
    public void A_sphere_that_an_earlier_polygon_adjusted_may_be_pulled_back_to_before_its_begin()
    {
        // 0.2 m too deep, at 0.1 m down a movement: t = 2, and (1 - 2) * 0.25 is above the floor of -0.5.
        float interp = 0.25f;
        Sphere sphere = Half(0, 0, 0.3f);
        Assert.True(Polygon(Floor).AdjustSphereToPlane(ref sphere, new Vector3(0.3f, 0, -0.1f), ref interp));
        Assert.Equal(-0.6f, sphere.Center.X, 1e-6f);
        Assert.Equal(0.5f, sphere.Center.Z, 1e-6f);
        Assert.Equal(-0.25f, interp, 1e-6f);
    }

    [Theory, Behaviour("polygon.rest.refused", "spec/04, 6.4 E4 to E8")]
    [InlineData(0.3, 0, -0.1)]
    [InlineData(0.3, 0, 1)]
    [InlineData(0.3, 1, 0)]
    [InlineData(0.6, 0, -1)]
    [InlineData(-0.4, 0, -0.59)]
    public void A_sphere_is_not_pulled_back_too_far_nor_from_a_plane_it_does_not_run_into(float z, float moveX, float moveZ)
    {
        float interp = 1;
        Sphere sphere = Half(0, 0, z);
        Assert.False(Polygon(Floor).AdjustSphereToPlane(ref sphere, new Vector3(moveX, 0, moveZ), ref interp));
        Assert.Equal((Half(0, 0, z), 1f), (sphere, interp));
    }

    [Fact, Behaviour("polygon.rest.on-slope", "spec/04, 6.4 E9")]
    public void A_sphere_rests_on_a_slope()
    {
        float interp = 1;
        Sphere sphere = Half(5, 5, 1.9f);
        Assert.True(Polygon(A2).AdjustSphereToPlane(ref sphere, new Vector3(0, 0, -0.75f), ref interp));
        Assert.Equal(new Vector3(5, 5, 2.02201533f), sphere.Center);
        Assert.Equal(0.837312818f, interp);
    }

    [Theory, Behaviour("polygon.touch.time", "spec/04, 6.5, CPolygon::adjust_sphere_to_poly @0x00538170")]
    [InlineData(0, 2, 0, 0.75)]
    [InlineData(4, -3, 0, 0.5)]
    [InlineData(0, 0, 1, 0)]
    [InlineData(1.7, 1, 0, 1)]
    [InlineData(0, -2, 0, -0.75)]
    [InlineData(1.5, 1, 0, 0)]
    public void The_time_of_touch_is_not_clamped(float currX, float moveX, float moveY, double time) =>
        Assert.Equal(time, Polygon(Wall).TimeOfTouch(0.5f, new Vector3(currX, 0, 1), new Vector3(moveX, moveY, 0)));

    [Theory, Behaviour("polygon.push-out", "spec/04, 6.6, CPolygon::adjust_to_placement_poly @0x00538CE0")]
    [InlineData(0.3, false, true, 0.5, 1.70000005)]
    [InlineData(-0.3, false, true, -0.5, 1.29999995)]
    [InlineData(0.3, true, true, -0.5, 0.699999988)]
    [InlineData(-0.3, true, true, 0.5, 2.29999995)]
    [InlineData(-0.3, false, false, 0.5, 2.29999995)]
    public void Both_spheres_are_pushed_along_the_normal(float z, bool centerSolid, bool solidCheck, float after, float other)
    {
        Sphere sphere = Half(0, 0, z), second = Half(0, 0, 1.5f);
        Polygon(Floor).PushOut(ref sphere, ref second, 0.5f, centerSolid, solidCheck);
        Assert.Equal((Half(0, 0, after), Half(0, 0, other)), (sphere, second));
    }

    [Fact, Behaviour("polygon.degenerate.answers-nothing", "spec/04, 4.4: make_plane has no degenerate check")]
    public void A_polygon_of_no_area_is_never_hit_and_never_rested_on()
    {
        Vector3[] line = [new(0, 0, 0), new(1, 0, 0), new(2, 0, 0)];
        ConvexPolygon polygon = Polygon(line);
        Assert.True(float.IsNaN(polygon.Plane.Normal.X));
        Sphere sphere = Half(1, 0, 0.1f);
        float interp = 1;
        Vector3 contact = default;
        Assert.False(polygon.HitsSphere(sphere));
        Assert.False(polygon.IsRunInto(sphere, new(0, 0, -1), ref contact, out bool overlaps));
        Assert.False(overlaps);
        Assert.False(polygon.IsWalkableAndHit(sphere, Vector3.UnitZ, 0));
        Assert.False(polygon.AdjustSphereToPlane(ref sphere, new(0, 0, -1), ref interp));
        Assert.Equal((Half(1, 0, 0.1f), 1f), (sphere, interp));
    }
}
