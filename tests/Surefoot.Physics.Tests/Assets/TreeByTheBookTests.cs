using System.Numerics;
using CsCheck;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Transitions.Obstacles;
using Surefoot.Physics.Transitions;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>
/// The questions about solid space, which answer oddly at straddled planes, against the specification's recursion written down word for
/// word (04, 4.5 and 4.6).
/// </summary>
public class TreeByTheBookTests
{
    private static readonly Gen<float> Unit = Gen.Float[-1f, 1f];
    private static readonly Gen<Vector3> Point = Gen.Select(Unit, Unit, Unit, (x, y, z) => new Vector3(x, y, z));
    private static readonly Gen<Sphere> Probe = Gen.Select(Point, Gen.Float[0.05f, 0.8f], (p, r) => new Sphere(p * 1.5f, r));

    private static readonly Gen<(PhysicsBsp Flat, Book Book)> Tree = Gen.Select(
        Gen.Select(Point, Point, Point, (a, b, c) => (Vector3[])[a, b, c])
            .Where(t => Vector3.Cross(t[1] - t[0], t[2] - t[0]).Length() > 0.1f).Array[1, 8],
        Gen.Int[0, int.MaxValue],
        Grow);

    private static (PhysicsBsp Flat, Book Book) Grow(Vector3[][] triangles, int seed)
    {
        PolygonSet polygons = Trees.Polygons(triangles);
        PhysicsBspBuilder builder = new(polygons);
        Random random = new(seed);
        Book book = Any(0, out int root);
        return (builder.Build(root, book.Bounds), book);

        // Any shape will do: empty leaves, bounds that cut, solid flags anywhere.
        Book Any(int depth, out int reference)
        {
            Sphere bounds = new(new(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f),
                0.7f + random.NextSingle());
            if (depth > 5 || random.Next(4) == 0)
            {
                int[] members = [.. Enumerable.Range(0, triangles.Length).Where(_ => random.Next(3) == 0)];
                bool solid = random.Next(2) == 0;
                reference = builder.AddLeaf(bounds, solid, members);
                return new Book(default, bounds, null, null, members, solid, polygons);
            }

            Plane plane = polygons.PlaneOf(random.Next(triangles.Length));
            plane.D += random.NextSingle() - 0.5f;
            int node = builder.AddNode(plane, bounds);
            Book positive = Any(depth + 1, out int front), negative = Any(depth + 1, out int back);
            builder.SetPositive(node, front);
            builder.SetNegative(node, back);
            reference = node;
            return new Book(plane, bounds, positive, negative, [], false, polygons);
        }
    }

    [Fact, Behaviour("bsp.sphere.solid-poly-by-the-book", "spec/04, 4.5")]
    public void The_placement_query_follows_the_recursion() =>
        Gen.Select(Tree, Probe, Gen.Float[0.5f, 4f], Gen.Bool, Gen.Bool).Sample(
            (tree, sphere, wider, check, known) =>
            {
                float reach = sphere.Radius * wider;
                PolygonContact hit = known ? new PolygonContact { Polygon = 0 } : default;
                int bookHit = hit.Polygon;
                bool solid = false, bookSolid = false;
                bool expected = tree.Book.SolidPoly(sphere, reach, ref bookSolid, ref bookHit, check);
                Assert.Equal(expected, tree.Flat.SphereIntersectsSolidPoly(sphere, reach, ref solid, ref hit, check));
                Assert.Equal((bookSolid, bookHit), (solid, hit.Polygon));
            },
            iter: Fuzz.Cases(10_000));

    [Fact, Behaviour("bsp.sphere.solid-by-the-book", "spec/04, 4.5")]
    public void The_solid_query_follows_the_recursion() =>
        Gen.Select(Tree, Probe, Gen.Bool).Sample(
            (tree, sphere, check) =>
            {
                Assert.Equal(tree.Book.Solid(sphere, check), tree.Flat.SphereIntersectsSolid(sphere, check));
                Assert.Equal(tree.Book.PointSolid(sphere.Center), tree.Flat.PointIntersectsSolid(sphere.Center));
            },
            iter: Fuzz.Cases(10_000));

    [Fact, Behaviour("bsp.placement.by-the-book", "spec/04, 4.6, BSPTREE::placement_insert @0x00539960")]
    public void Placement_follows_the_loop() =>
        Gen.Select(Tree, Probe, Point, Gen.Bool).Sample(
            (tree, sphere, above, two) =>
            {
                Mover mover = new Mover(MoverFlags.None, sphere.Center, sphere.Center, sphere.Radius, two ? above : null)
                    .With(p => p.InsertType = InsertType.InitialPlacement);
                Vector3 before = mover.At;
                (TransitionState state, Vector3 offset) = tree.Book.Place(mover.Path);
                Assert.Equal(state, mover.Ask(tree.Flat));
                Assert.Equal(before + offset, mover.At);
            },
            iter: Fuzz.Cases(10_000));

    private sealed record Book(Plane Plane, Sphere Bounds, Book? Positive, Book? Negative, int[] Members, bool IsSolid, PolygonSet Polygons)
    {
        internal bool PointSolid(Vector3 p) => Positive is null
            ? Members.Length != 0
            : RetailMath.Distance(Plane, p) < 0 ? Negative!.PointSolid(p) : Positive.PointSolid(p);

        internal bool Solid(Sphere s, bool check)
        {
            if (Positive is null)
            {
                if (Members.Length == 0) return false;
                if (check && IsSolid) return true;
                return CollisionPrimitives.SpheresIntersect(Bounds, s) && Members.Any(m => Polygons[m].HitsSphere(s));
            }

            if (!CollisionPrimitives.SpheresIntersect(Bounds, s)) return false;
            double distance = RetailMath.Distance(Plane, s.Center), r = (double)s.Radius - RetailMath.Epsilon;
            if (distance >= r) return Positive.Solid(s, check);
            if (distance <= -r) return Negative!.Solid(s, check);
            return distance < 0
                ? Positive.Solid(s, false) || Negative!.Solid(s, check)
                : Positive.Solid(s, check) || Negative!.Solid(s, false);
        }

        internal bool SolidPoly(Sphere s, float radius, ref bool centerSolid, ref int hit, bool check)
        {
            if (Positive is null)
            {
                if (Members.Length == 0) return false;
                if (check && IsSolid) centerSolid = true;
                if (CollisionPrimitives.SpheresIntersect(Bounds, s))
                {
                    foreach (int m in Members)
                    {
                        if (!Polygons[m].HitsSphere(s)) continue;
                        hit = m;
                        return true;
                    }
                }

                return centerSolid;
            }

            if (!CollisionPrimitives.SpheresIntersect(Bounds, s)) return false;
            double distance = RetailMath.Distance(Plane, s.Center), r = (double)radius - RetailMath.Epsilon;
            if (distance >= r) return Positive.SolidPoly(s, radius, ref centerSolid, ref hit, check);
            if (distance <= -r) return Negative!.SolidPoly(s, radius, ref centerSolid, ref hit, check);
            (Book near, Book far) = distance < 0 ? (Negative!, Positive) : (Positive, Negative!);
            near.SolidPoly(s, radius, ref centerSolid, ref hit, check);
            return hit < 0 ? far.SolidPoly(s, radius, ref centerSolid, ref hit, false) : centerSolid;
        }

        internal (TransitionState State, Vector3 Offset) Place(SpherePath path)
        {
            Sphere t0 = path.GlobalSpheres[0], t1 = path.GlobalSpheres[1];
            float radius = t0.Radius;
            int hit = -1;
            for (int i = 0; i < 20; i++)
            {
                bool solid = false;
                if (SolidPoly(t0, radius, ref solid, ref hit, true))
                {
                    if (hit >= 0) Polygons[hit].PushOut(ref t0, ref t1, radius, solid, true);
                }
                else if (path.SphereCount > 1 && SolidPoly(t1, radius, ref solid, ref hit, true))
                {
                    if (hit >= 0) Polygons[hit].PushOut(ref t1, ref t0, radius, solid, true);
                }
                else
                {
                    return i == 0 ? (TransitionState.OK, default) : (TransitionState.Adjusted, t0.Center - path.GlobalSpheres[0].Center);
                }

                radius = hit >= 0 ? t0.Radius : radius + radius;
                hit = -1;
            }

            return (TransitionState.Collided, default);
        }
    }
}
