using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Geometry;

/// <summary>
/// Polygons that lie aslant and off the origin, and the comparisons that decide when a number is exactly the limit: specification 04, 4.4.
/// The expected values are worked by hand with numbers that floats hold exactly, or to a rounding.
/// </summary>
public sealed class PolygonLimitTests
{
    private const float Epsilon = RetailMath.Epsilon;

    private static readonly Vector3[] Triangle = [new(0, 0, 0), new(4, 0, 0), new(0, 4, 0)];
    private static readonly Vector3[] Floor = [new(-5, -5, 0), new(5, -5, 0), new(5, 5, 0), new(-5, 5, 0)];

    /// <summary>In the plane x + 2y + 2z = 0, whose normal is (1, 2, 2) / 3.</summary>
    private static readonly Vector3[] Aslant = [new(0, 0, 0), new(2, -1, 0), new(2, 0, -1)];

    private static ConvexPolygon Polygon(Vector3[] corners, Vector3 by = default)
    {
        Vector3[] moved = [.. corners.Select(corner => corner + by)];
        return new(ConvexPolygon.MakePlane(moved), moved);
    }

    [Fact, Behaviour("polygon.sphere.tolerance-is-enough", "spec/04, 4.4, polygon_hits_sphere_slow_but_sure: r - EPS < |d| misses")]
    public void An_overlap_of_exactly_the_tolerance_counts() =>
        Assert.True(Polygon(Triangle).HitsSphere(new Sphere(new Vector3(1, 1, Epsilon), 2 * Epsilon)));

    [Fact, Behaviour("polygon.sphere.contact-aslant", "spec/04, 4.4, polygon_hits_sphere_slow_but_sure: the foot of the perpendicular")]
    public void A_sphere_touches_a_slanted_polygon_straight_below_it()
    {
        Vector3 middle = (Aslant[0] + Aslant[1] + Aslant[2]) / 3, contact = default;
        Assert.True(Polygon(Aslant).HitsSphere(new Sphere(middle + (new Vector3(0.1f, 0.2f, 0.2f) * 0.9f), 0.5f), ref contact));
        Assert.True(Vector3.Distance(middle, contact) < 1e-6f, $"{contact}, expected {middle}");
    }

    [Theory, Behaviour("polygon.sphere.level-enough", "spec/04, 4.4, CPolygon::walkable_hits_sphere @0x00539560: strictly more")]
    [InlineData(1f, 0.25f, false)]
    [InlineData(0.75f, 0.25f, true)]
    [InlineData(0.75f, 2f, false)]
    public void A_walkable_overlap_is_steeper_than_no_limit_and_an_overlap(float allowance, float z, bool counts) =>
        Assert.Equal(counts, Polygon(Triangle).IsWalkableAndHit(new Sphere(new Vector3(1, 1, z), 0.5f), Vector3.UnitZ, allowance));

    [Theory, Behaviour("polygon.footing.at-the-radius", "spec/04, 4.4, check_walkable: outside by more than the radius ends it")]
    [InlineData(2f, -0.5f, 0.5f, true)]
    [InlineData(2f, -0.75f, 0.5f, false)]
    [InlineData(-3f, -4f, 5f, true)]
    [InlineData(-3f, -4.25f, 5f, false)]
    public void A_foot_is_supported_by_an_edge_or_a_corner_exactly_its_radius_away(float x, float y, float radius, bool supported) =>
        Assert.Equal(supported, Polygon(Triangle).SupportsFoot(new Sphere(new Vector3(x, y, 1), radius), Vector3.UnitZ));

    [Fact, Behaviour("polygon.edge.on-it", "spec/04, 4.4, find_crossed_edge: s < 0")]
    public void A_centre_on_an_edge_has_not_crossed_it()
    {
        Vector3 normal = default;
        Assert.False(Polygon(Triangle).FindCrossedEdge(new Sphere(new Vector3(1, 0, 3), 0.5f), Vector3.UnitZ, ref normal));
    }

    /// <summary>N × edge: (1,2,2) × (2,−1,0) = (2,4,−5) and (1,2,2) × (−2,0,1) = (2,−5,4), each of length √45.</summary>
    [Theory, Behaviour("polygon.edge.crossed-aslant", "spec/04, 4.4, CPolygon::find_crossed_edge @0x00539300")]
    [InlineData(0.8f, -0.9f, 0.5f, 2, 4, -5)]
    [InlineData(0.8f, 0.5f, -0.9f, 2, -5, 4)]
    public void An_edge_of_a_slanted_polygon_is_crossed_from_wherever_the_centre_is_carried_back(
        float x, float y, float z, float mx, float my, float mz)
    {
        Vector3 outside = new(x, y, z), inward = new Vector3(mx, my, mz) / MathF.Sqrt(45), facing = new Vector3(1, 2, 2) / 3;
        Vector3 inside = outside + (inward * 0.8f);
        foreach (Vector3 by in (Vector3[])[default, new(7, 11, 13)])
        {
            foreach (Vector3 up in (Vector3[])[facing, Vector3.UnitZ, -facing])
            {
                Vector3 normal = default;
                Assert.True(Polygon(Aslant, by).FindCrossedEdge(new Sphere(outside + by + (3 * up), 0.5f), up, ref normal));
                Assert.True(Vector3.Distance(inward, normal) < 1e-5f, $"{normal}, expected {inward}");
                Assert.False(Polygon(Aslant, by).FindCrossedEdge(new Sphere(inside + by + (3 * up), 0.5f), up, ref normal));
            }
        }
    }

    [Theory, Behaviour("polygon.rest.moves-along-it", "spec/04, 4.4 adjust_sphere_to_plane, step 2: only more than EPS against the normal")]
    [InlineData(0.49998f, -Epsilon)]
    [InlineData(-0.50002f, Epsilon)]
    [InlineData(0.5f, -1f)]
    public void A_movement_of_at_most_the_tolerance_against_the_plane_and_a_sphere_that_just_touches_are_left_alone(float z, float moveZ)
    {
        float interp = 1;
        Sphere sphere = new(new Vector3(0, 0, z), 0.5f), before = sphere;
        Assert.False(Polygon(Floor).AdjustSphereToPlane(ref sphere, new Vector3(0, 0, moveZ), ref interp));
        Assert.Equal((before, 1f), (sphere, interp));
    }

    /// <summary>0.75 m too deep at 0.5 m a movement: one and a half of it. Rising from below the plane: a quarter of it.</summary>
    [Theory, Behaviour("polygon.rest.down-to-half-a-movement", "spec/04, 4.4 adjust_sphere_to_plane, steps 2 to 5")]
    [InlineData(-0.25f, 0.5f, -0.5f, -0.75f, 0.5f, -0.5f)]
    [InlineData(-0.75f, 0.5f, 1f, -0.125f, -1f, 0.75f)]
    public void A_sphere_is_pulled_back_along_all_of_its_movement(
        float z, float moveY, float moveZ, float y, float afterZ, float afterInterp)
    {
        float interp = 1;
        Sphere sphere = new(new Vector3(0, 0, z), 0.5f);
        Assert.True(Polygon(Floor).AdjustSphereToPlane(ref sphere, new Vector3(0, moveY, moveZ), ref interp));
        Assert.Equal((new Vector3(0, y, afterZ), afterInterp), (sphere.Center, interp));
    }

    [Fact, Behaviour("polygon.touch.slowly", "spec/04, 4.4 adjust_sphere_to_poly: |m| < EPS")]
    public void A_movement_of_exactly_the_tolerance_takes_its_time_to_the_plane() =>
        Assert.Equal(-0.5 / Epsilon, Polygon(Floor).TimeOfTouch(0.5f, new Vector3(0, 0, 1), new Vector3(0, 0, Epsilon)));

    [Theory, Behaviour("polygon.push-out.aslant", "spec/04, 6.6 and 4.4, CPolygon::adjust_to_placement_poly @0x00538CE0")]
    [InlineData(false, 1f)]
    [InlineData(true, -1f)]
    public void Both_spheres_are_pushed_along_every_axis_and_a_centre_in_the_plane_counts_as_behind_it(bool solidCheck, float way)
    {
        ConvexPolygon polygon = new(new Plane(0.5f, 0.25f, 0.75f, 0), Triangle);
        Sphere sphere = new(Vector3.Zero, 0.5f), second = new(new Vector3(1, 2, 4), 0.5f);
        polygon.PushOut(ref sphere, ref second, 0.5f, centerSolid: false, solidCheck);
        Vector3 push = way * new Vector3(0.25f, 0.125f, 0.375f);
        Assert.Equal((push, new Vector3(1, 2, 4) + push), (sphere.Center, second.Center));
    }
}
