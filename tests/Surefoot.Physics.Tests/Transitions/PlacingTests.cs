using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions;

/// <summary>Specification 03, 6.3 and 6.9: turning on the way, and putting a body somewhere.</summary>
public class PlacingTests
{
    private static readonly Sphere[] Human = [new(new Vector3(0, 0, 0.48f), 0.48f), new(new Vector3(0, 0, 1.35f), 0.48f)];

    private static Transition Place(StubWorld world, Vector3 at, bool slide, params Sphere[] spheres)
    {
        Transition t = new(world);
        t.Reset();
        PhysicsBody body = new PhysicsEngine(world).CreateBody(1, StubWorld.Setup(spheres), PhysicsState.Gravity);
        t.Object.Init(body, MoverFlags.None);
        t.Path.InitSpheres(spheres, 1);
        t.Path.InitPath(world.Cell, hasBegin: false, default, new Position(StubWorld.CellId, at));
        t.Path.PlacementAllowsSliding = slide;
        return t;
    }

    [Theory, Behaviour("placement.sets-on-the-floor", "spec/03, 6.9")]
    [InlineData(0.3f, 0f, true)]
    [InlineData(1.0f, 1.0f, false)]
    [InlineData(-0.2f, 0f, true)]
    public void A_body_is_set_on_the_floor_within_its_step_down_height(float z, float endZ, bool contact)
    {
        Transition t = Place(new StubWorld(_ => StubWorld.Flat(0)), new Vector3(0, 0, z), slide: true, Human);
        Assert.True(t.FindValidPosition());
        Assert.True(Math.Abs(t.Path.CurrPos.Frame.Origin.Z - endZ) < 1e-6, $"{t.Path.CurrPos.Frame.Origin.Z:R}");
        Assert.Equal(contact, t.Collision.ContactPlaneValid);
    }

    [Theory, Behaviour("placement.one-sphere-probes-half", "spec/03, 6.9")]
    [InlineData(0.1f, 0f, true)]
    [InlineData(0.3f, 0.3f, false)]
    public void A_body_of_one_small_sphere_probes_half_its_radius(float z, float endZ, bool contact)
    {
        Sphere ball = new(new Vector3(0, 0, 0.25f), 0.25f);
        Transition t = Place(new StubWorld(_ => StubWorld.Flat(0)), new Vector3(0, 0, z), slide: true, ball);
        Assert.True(t.FindValidPosition());
        Assert.True(Math.Abs(t.Path.CurrPos.Frame.Origin.Z - endZ) < 1e-6, $"{t.Path.CurrPos.Frame.Origin.Z:R}");
        Assert.Equal(contact, t.Collision.ContactPlaneValid);
    }

    [Theory, Behaviour("placement.searches-rings", "spec/03, 6.9")]
    [InlineData(true)]
    [InlineData(false)]
    public void A_taken_place_is_left_for_the_first_free_one_of_the_rings(bool slide)
    {
        int tries = 0;
        StubWorld world = new(_ => StubWorld.Flat(0))
        {
            Blocks = t =>
            {
                if (t.Path.InsertType != InsertType.Placement) return false;
                tries++;
                return (t.Path.GlobalSpheres[0].Center - new Vector3(0, 0, 0.48f)).Length() <= 0.96f - RetailMath.Epsilon;
            },
        };
        Transition transition = Place(world, Vector3.Zero, slide, Human);
        Assert.Equal(slide, transition.FindValidPosition());
        if (!slide) return;
        Assert.True(Vector3.Distance(new Vector3(0, 1.33333337f, 0), transition.Path.CurrPos.Frame.Origin) < 1e-6f);
        // The place itself and eighteen of the rings are refused; the nineteenth of the rings succeeds.
        Assert.True(tries >= 20, $"{tries} tries");
    }

    [Theory, Behaviour("placement.rings.count", "spec/03, 6.9")]
    [InlineData(0.1f, 1338)]
    [InlineData(0.124f, 918)]
    [InlineData(0.125f, 270)]
    [InlineData(0.48f, 270)]
    [InlineData(0.5f, 234)]
    [InlineData(1f, 68)]
    [InlineData(3.9f, 12)]
    [InlineData(4f, 0)]
    [InlineData(5f, 0)]
    public void The_rings_follow_from_the_radius_of_the_foot(float radius, int samples)
    {
        List<Vector3> tried = [];
        StubWorld world = new(_ => null)
        {
            Blocks = t =>
            {
                if (t.Path.InsertType != InsertType.Placement) return false;
                tried.Add(t.Path.CheckPos.Frame.Origin);
                return true;
            },
        };
        Assert.False(Place(world, Vector3.Zero, slide: true, new Sphere(new Vector3(0, 0, radius), radius)).FindValidPosition());
        Assert.Equal(1 + samples, tried.Count);
        if (samples != 270) return;
        Assert.True(Vector3.Distance(new Vector3(0, 0.444444448f, 0), tried[1]) < 1e-7f, $"{tried[1]:R}");
        Assert.True(Vector3.Distance(new Vector3(0.384900182f, 0.222222224f, 0), tried[2]) < 1e-7f, $"{tried[2]:R}");
    }

    [Fact, Behaviour("geometry.rotation.slerp", "spec/03, 6.3")]
    public void A_turn_is_interpolated_on_the_sphere_the_short_way()
    {
        Frame from = Frame.Identity;
        float half = (float)Math.Sqrt(0.5);
        Frame to = new(Vector3.Zero, new Quaternion(0, 0, half, half)), negated = new(Vector3.Zero, new Quaternion(0, 0, -half, -half));
        AssertTurn(to, (float)(1 / 3.0), 0.258819044f, 0.965925813f);
        AssertTurn(to, (float)(2 / 3.0), 0.5f, 0.866025388f);
        AssertTurn(negated, 0.5f, 0.382683426f, 0.923879504f);

        void AssertTurn(Frame target, float t, float z, float w)
        {
            Frame turned = Frame.Identity;
            turned.InterpolateRotation(from, target, t);
            Assert.True(Math.Abs(turned.Rotation.Z - z) < 1e-7 && Math.Abs(turned.Rotation.W - w) < 1e-7, $"{turned.Rotation}");
        }
    }
}
