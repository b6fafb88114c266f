using System.Numerics;
using CsCheck;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>What holds for every tree, sphere and way.</summary>
public class TreePropertyTests
{
    private static readonly Gen<float> Unit = Gen.Float[-1f, 1f];
    private static readonly Gen<Vector3> Point = Gen.Select(Unit, Unit, Unit, (x, y, z) => new Vector3(x, y, z));

    private static readonly Gen<Vector3[]> Triangle = Gen.Select(
        Point, Point, Point, (center, a, b) => (Vector3[])[center * 3, (center * 3) + a, (center * 3) + b])
        .Where(t => Vector3.Cross(t[1] - t[0], t[2] - t[0]).Length() > 0.05f);

    /// <summary>A soup of triangles under a tree that splits it by the planes of its own triangles.</summary>
    private static readonly Gen<PhysicsBsp> Soup = Triangle.Array[1, 30].Select(Split);

    private static readonly Gen<Sphere> Probe = Gen.Select(Point, Gen.Float[0.1f, 1.2f], (p, r) => new Sphere(p * 4, r));

    private static PhysicsBsp Split(Vector3[][] triangles)
    {
        PolygonSet polygons = Trees.Polygons(triangles);
        PhysicsBspBuilder builder = new(polygons);
        Sphere everything = new(Vector3.Zero, 20);
        int root = Add([.. Enumerable.Range(0, triangles.Length)], 0);
        return builder.Build(root, everything);

        int Add(int[] members, int depth)
        {
            if (members.Length <= 2 || depth > 12) return builder.AddLeaf(everything, depth % 2 == 0, members);
            Plane plane = polygons.PlaneOf(members[depth % members.Length]);
            int node = builder.AddNode(plane, everything);
            // A triangle in the plane belongs behind it; one that the plane cuts belongs to both sides.
            builder.SetPositive(node, Add([.. members.Where(m => triangles[m].Any(c => RetailMath.Distance(plane, c) > 1e-4))], depth + 1));
            builder.SetNegative(
                node, Add([.. members.Where(m => triangles[m].Any(c => RetailMath.Distance(plane, c) <= 1e-4))], depth + 1));
            return node;
        }
    }

    private static IEnumerable<int> All(PhysicsBsp tree) => Enumerable.Range(0, tree.Polygons.Count);

    [Fact, Behaviour("bsp.property.poly", "spec/04, 4.5: the tree only saves work")]
    public void A_tree_meets_what_its_polygons_meet_one_by_one() =>
        Gen.Select(Soup, Probe, Point).Sample(
            (tree, sphere, movement) =>
            {
                PolygonContact contact = default;
                bool hit = tree.SphereIntersectsPoly(sphere, movement, ref contact);
                Vector3 scratch = default;
                Assert.Equal(All(tree).Any(i => tree.Polygons[i].IsRunInto(sphere, movement, ref scratch, out _)), hit);
                Assert.Equal(All(tree).Any(i => tree.Polygons[i].HitsSphere(sphere)), contact.IsSome);
                if (contact.IsSome) Assert.True(tree.Polygons[contact.Polygon].HitsSphere(sphere));
                Assert.Equal(contact.IsSome, tree.SphereIntersectsSolid(sphere, false));
            },
            iter: Fuzz.Cases(3000));

    [Fact, Behaviour("bsp.property.walkable", "spec/04, 4.5")]
    public void A_tree_has_the_footing_its_polygons_have_one_by_one() =>
        Gen.Select(Soup, Probe).Sample(
            (tree, sphere) => Assert.Equal(
                All(tree).Any(
                    i =>
                        tree.Polygons[i].IsWalkableAndHit(sphere, Vector3.UnitZ, RetailMath.FloorZ) &&
                            tree.Polygons[i].SupportsSmallFoot(sphere, Vector3.UnitZ)),
                tree.HitsWalkable(sphere, Vector3.UnitZ, RetailMath.FloorZ)),
            iter: Fuzz.Cases(3000));

    [Fact, Behaviour("bsp.property.rest", "spec/04, 4.4 and 4.13")]
    public void A_search_for_footing_moves_back_along_the_movement_and_uses_it_up() =>
        Gen.Select(Soup, Probe, Gen.Float[0.05f, 2f]).Sample(
            (tree, sphere, down) =>
            {
                WalkableSearch search = new()
                {
                    Sphere = sphere,
                    Movement = new Vector3(0, 0, -down),
                    Up = Vector3.UnitZ,
                    Allowance = RetailMath.LandingZ,
                    WalkInterp = 1,
                };
                tree.FindWalkable(ref search);
                if (!search.Found)
                {
                    Assert.Equal((sphere, 1f), (search.Sphere, search.WalkInterp));
                    return;
                }

                Assert.InRange(search.WalkInterp, -0.5f, 1);
                Assert.Equal((sphere.Center.X, sphere.Center.Y), (search.Sphere.Center.X, search.Sphere.Center.Y));
                // The last surface left the sphere tangent, and no surface pushes it down.
                Assert.Equal(sphere.Radius, RetailMath.Distance(tree.Polygons.PlaneOf(search.Polygon), search.Sphere.Center), 1e-4);
                Assert.True(search.Sphere.Center.Z >= sphere.Center.Z);
            },
            iter: Fuzz.Cases(3000));

    [Fact, Behaviour("bsp.property.answers", "spec/03, 2.1: OK and Collided leave the position, the others move it")]
    public void Whatever_the_mode_the_answer_says_whether_the_position_was_moved() =>
        Gen.Select(Soup, Point, Point, Gen.Int[0, 5], Gen.Int[0, 4], Gen.Bool).Sample(
            (tree, at, way, mode, kind, two) =>
            {
                MoverFlags flags = ((MoverFlags[])[
                    MoverFlags.None, MoverFlags.Contact | MoverFlags.OnWalkable, MoverFlags.PathClipped,
                    MoverFlags.PathClipped | MoverFlags.PerfectClip,
                    MoverFlags.OnWalkable])[kind];
                Mover mover = new Mover(flags, at * 4, (at * 4) + (way * 0.5f), 0.48f,
                    two ? new Vector3(0, 0, 0.87f) : null).LastStoodOn(Vector3.UnitZ);
                mover.Path.StepDownAmount = 0.6f;
                mover.Path.SteppingDown = mode == 1;
                mover.Path.Collide = mode == 2;
                mover.Path.CheckingWalkable = mode == 3;
                if (mode == 4) mover.Path.InsertType = InsertType.Placement;
                if (mode == 5) mover.Path.InsertType = InsertType.InitialPlacement;
                TransitionState state = mover.Ask(tree);
                Assert.True(RetailMath.IsFinite(mover.At));
                Assert.NotEqual(TransitionState.Invalid, state);
                if (state is TransitionState.OK or TransitionState.Collided) Assert.Equal(Vector3.Zero, mover.Moved);
                if (state == TransitionState.Collided && mode is 3 or 4) Assert.False(mover.Collision.CollisionNormalValid);
                if (mover.Collision.ContactPlaneValid) Assert.True(mover.Collision.ContactPlane.Normal.Z > mover.Path.WalkableAllowance);
            },
            iter: Fuzz.Cases(5000));

    [Fact, Behaviour("obstacle.property.answers", "spec/04, 4.8 and 4.9")]
    public void Balls_and_cylinders_never_move_a_body_to_nowhere() =>
        Gen.Select(Point, Point, Gen.Int[0, 4], Gen.Int[0, 4], Gen.Bool, Gen.Bool, Gen.Float[0f, 2f]).Sample(
            (at, way, mode, kind, two, ball, size) =>
            {
                MoverFlags flags = ((MoverFlags[])[
                    MoverFlags.None, MoverFlags.Contact | MoverFlags.OnWalkable, MoverFlags.PathClipped,
                    MoverFlags.PathClipped | MoverFlags.PerfectClip,
                    MoverFlags.OnWalkable])[kind];
                Mover mover = new Mover(flags, at * 2, (at * 2) + (way * 0.5f), 0.48f,
                    two ? new Vector3(0, 0, 0.87f) : null).LastStoodOn(Vector3.UnitZ);
                mover.Path.StepDownAmount = 0.6f;
                mover.Path.SteppingDown = mode == 1;
                mover.Path.Collide = mode == 2;
                mover.Path.CheckingWalkable = mode == 3;
                if (mode == 4) mover.Path.InsertType = InsertType.Placement;
                TransitionState state = ball
                    ? mover.Ask(new Sphere(Vector3.Zero, size))
                    : mover.Ask(new CylSphere(Vector3.Zero, size, 1.5f * size));
                Assert.True(RetailMath.IsFinite(mover.At));
                if (state is TransitionState.OK or TransitionState.Collided) Assert.Equal(Vector3.Zero, mover.Moved);
                Vector3 n = mover.Collision.CollisionNormal;
                if (mover.Collision.CollisionNormalValid && n != Vector3.Zero) Assert.Equal(1, n.Length(), 1e-5f);
            },
            iter: Fuzz.Cases(5000));

    [Fact, Behaviour("object.property.far-parts", "spec/06, 4: skipping what is far away changes no answer")]
    public void An_object_answers_as_its_part_does_wherever_it_stands() =>
        Gen.Select(Soup, Point, Point, Point, Gen.Float[0.2f, 3f], Gen.Bool).Sample(
            (tree, at, way, turn, scale, near) =>
            {
                GfxObjAsset mesh = new() { Physics = tree };
                Frame pose = new(turn, Quaternion.Normalize(new Quaternion(turn.Z, turn.X, turn.Y, 0.5f)));
                SetupAsset setup = new SetupAsset { Parts = [new SetupPart(mesh, new(1, 1, 0.7f))] }.With(0, [pose]);
                WorldObject target = new(2, setup, PhysicsState.Static) { Scale = scale };
                target.SeatAt(
                    new Position(Mover.CellId, new Frame(at * (near ? 5 : 150), Quaternion.Normalize(new Quaternion(turn, 0.3f)))), null);

                Mover Fresh() =>
                    new Mover(MoverFlags.None, way * 5, (way * 5) + (at * 0.4f), 0.48f,
                        new Vector3(0, 0, 0.87f)).LastStoodOn(Vector3.UnitZ);
                Mover through = Fresh(), direct = Fresh();
                Position part = new(Mover.CellId, SetupAsset.PlacePart(target.Position.Frame, pose, scale));
                TransitionState expected = mesh.FindCollisions(direct.Transition, part, (float)((double)0.7f * scale));
                Assert.Equal(expected, setup.FindCollisions(through.Transition, target, false));
                Assert.Equal(direct.At, through.At);
                Assert.Equal(direct.Path.Collide, through.Path.Collide);
            },
            iter: Fuzz.Cases(3000));

    [Fact, Behaviour("cell.property.point-in-sphere-in", "spec/04, 4.5")]
    public void A_sphere_around_a_point_inside_a_room_is_not_outside() =>
        Gen.Select(Triangle.Array[0, 8], Point, Gen.Float[0.1f, 2f]).Sample(
            (walls, p, radius) =>
            {
                CellBsp room = new([.. walls.Select(w => ConvexPolygon.MakePlane(w))]);
                CellOverlap overlap = room.SphereIntersects(new Sphere(p * 4, radius));
                if (room.PointInside(p * 4)) Assert.NotEqual(CellOverlap.Outside, overlap);
                if (overlap == CellOverlap.Inside) Assert.True(room.PointInside(p * 4));
                Vector3 half = new(radius);
                if (room.PointInside(p * 4)) Assert.True(room.BoxIntersects(new BoundingBox((p * 4) - half, (p * 4) + half)));
            },
            iter: Fuzz.Cases(3000));

    [Fact, Behaviour("bsp.allocates-nothing", "design, decision 4")]
    public void No_question_allocates()
    {
        PhysicsBsp tree = Trees.Box(Vector3.Zero, new(2));
        PhysicsBsp deep = Split([.. Enumerable.Range(0, 64).Select(i => Trees.Corners(Trees.Face.PlusZ, new(0, 0, i), new(1, 1, i)))]);
        Mover mover = new Mover(MoverFlags.None, new(1, 1, 2.6f), new(1, 1, 2.3f), 0.48f).LastStoodOn(Vector3.UnitZ);

        void AskAll()
        {
            for (int mode = 0; mode < 5; mode++)
            {
                mover.Path.SteppingDown = mode == 1;
                mover.Path.Collide = mode == 2;
                mover.Path.CheckingWalkable = mode == 3;
                mover.Path.InsertType = mode == 4 ? InsertType.Placement : InsertType.Transition;
                mover.Ask(tree);
                mover.Ask(deep);
                mover.Ask(new Sphere(new(1, 1, 1), 1));
                mover.Ask(new CylSphere(new(1, 1, 0), 1, 2));
                mover.Path.InsertType = InsertType.InitialPlacement;
                mover.Ask(tree);
            }
        }

        AskAll();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++) AskAll();
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }
}
