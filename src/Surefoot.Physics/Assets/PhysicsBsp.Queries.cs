using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <content>Questions about a sphere, all in the tree's own frame. None of them writes to the tree.</content>
internal sealed partial class PhysicsBsp
{
    /// <summary>What happens at a leaf during a walk that looks in front of each plane first.</summary>
    private interface ILeafVisitor
    {
        /// <summary>The sphere asked about; it may move from leaf to leaf.</summary>
        Sphere Sphere { get; }

        /// <summary>True ends the walk.</summary>
        bool Visit(PhysicsBsp tree, in Leaf leaf);
    }

    /// <summary>Is the point in a region that has polygons? The solid flag is not asked, and no bounding sphere either.</summary>
    /// <remarks>Retail: BSPNODE::point_intersects_solid @0x0053C310, BSPLEAF @0x0053D3F0.</remarks>
    public bool PointIntersectsSolid(in Vector3 point)
    {
        int at = root;
        while (at >= 0)
        {
            ref readonly Node node = ref nodes[at];
            at = RetailMath.Distance(node.Plane, point) < 0 ? node.Negative : node.Positive;
        }

        return at != Nothing;
    }

    /// <summary>
    /// Does the sphere overlap a polygon that its movement runs against? <paramref name="contact"/> names the last polygon overlapped,
    /// which after false is one that the movement does not run against.
    /// </summary>
    /// <remarks>Retail: BSPNODE::sphere_intersects_poly @0x0053CA30, BSPLEAF @0x0053D580.</remarks>
    public bool SphereIntersectsPoly(in Sphere sphere, in Vector3 movement, ref PolygonContact contact)
    {
        PolyVisitor visitor = new() { Sphere = sphere, Movement = movement, Contact = contact };
        bool result = Walk(ref visitor);
        contact = visitor.Contact;
        return result;
    }

    /// <summary>Does the sphere overlap a walkable polygon that supports a foot of half its radius?</summary>
    /// <param name="sphere">The sphere.</param>
    /// <param name="up">World up in the tree's frame.</param>
    /// <param name="allowance">N·up of a walkable polygon is above this.</param>
    /// <remarks>Retail: BSPNODE::hits_walkable @0x0053CBD0, BSPLEAF @0x0053D670.</remarks>
    public bool HitsWalkable(in Sphere sphere, in Vector3 up, float allowance)
    {
        WalkableVisitor visitor = new() { Sphere = sphere, Up = up, Allowance = allowance };
        return Walk(ref visitor);
    }

    /// <summary>
    /// Rests the sphere on every walkable polygon it runs into, one after the other: later ones see it where earlier ones left it.
    /// </summary>
    /// <remarks>Retail: BSPNODE::find_walkable @0x0053CC80, BSPLEAF @0x0053D6F0.</remarks>
    public void FindWalkable(ref WalkableSearch search)
    {
        RestVisitor visitor = new() { Search = search };
        Walk(ref visitor);
        search = visitor.Search;
    }

    /// <summary>
    /// Does the sphere overlap a polygon or, with <paramref name="centerCheck"/>, is its centre inside matter?
    /// </summary>
    /// <remarks>Retail: BSPNODE::sphere_intersects_solid @0x0053CAF0, BSPLEAF @0x0053D5F0.</remarks>
    public bool SphereIntersectsSolid(in Sphere sphere, bool centerCheck)
    {
        Span<Branch> pending = pendingSize <= SmallStack ? stackalloc Branch[SmallStack] : stackalloc Branch[pendingSize];
        int count = 0;
        Branch at = new(root, centerCheck);
        double reach = (double)sphere.Radius - RetailMath.Epsilon;
        while (true)
        {
            if (at.Reference >= 0)
            {
                ref readonly Node node = ref nodes[at.Reference];
                if (CollisionPrimitives.SpheresIntersect(node.Bounds, sphere))
                {
                    double distance = RetailMath.Distance(node.Plane, sphere.Center);
                    if (distance >= reach)
                    {
                        at = at with { Reference = node.Positive };
                    }
                    else if (distance <= -reach)
                    {
                        at = at with { Reference = node.Negative };
                    }
                    else
                    {
                        // In front first, always; the centre is asked about on its own side only.
                        bool behind = distance < 0;
                        if (node.Negative != Nothing) pending[count++] = new Branch(node.Negative, at.CenterCheck && behind);
                        at = new Branch(node.Positive, at.CenterCheck && !behind);
                    }

                    continue;
                }
            }
            else if (at.Reference != Nothing)
            {
                ref readonly Leaf leaf = ref leaves[LeafIndex(at.Reference)];
                if (at.CenterCheck && leaf.Solid) return true;
                if (CollisionPrimitives.SpheresIntersect(leaf.Bounds, sphere) && FirstHit(leaf, sphere) >= 0) return true;
            }

            if (count == 0) return false;
            at = pending[--count];
        }
    }

    /// <summary>The question behind placement: a polygon to push out of, or the centre in matter.</summary>
    /// <param name="sphere">The sphere.</param>
    /// <param name="reachRadius">
    /// Radius with which planes are straddled; polygons and bounding spheres are tested with the sphere's own.
    /// </param>
    /// <param name="centerSolid">Set when the centre is in matter, never cleared.</param>
    /// <param name="hit">The polygon overlapped; one that is there already ends the search at the first plane straddled.</param>
    /// <param name="centerCheck">Ask about the centre.</param>
    /// <returns>
    /// At a straddled plane whose nearer side named a polygon: <paramref name="centerSolid"/>, so possibly false with a polygon named. That
    /// is retail's answer.
    /// </returns>
    /// <remarks>Retail: BSPNODE::sphere_intersects_solid_poly @0x0053CD50, BSPLEAF @0x0053D780.</remarks>
    public bool SphereIntersectsSolidPoly(
        in Sphere sphere, float reachRadius, ref bool centerSolid, ref PolygonContact hit, bool centerCheck)
    {
        Span<int> far = pendingSize <= SmallStack ? stackalloc int[SmallStack] : stackalloc int[pendingSize];
        int count = 0, at = root;
        double reach = (double)reachRadius - RetailMath.Epsilon;
        while (true)
        {
            bool result = false;
            if (at >= 0)
            {
                ref readonly Node node = ref nodes[at];
                if (CollisionPrimitives.SpheresIntersect(node.Bounds, sphere))
                {
                    double distance = RetailMath.Distance(node.Plane, sphere.Center);
                    if (distance >= reach)
                    {
                        at = node.Positive;
                    }
                    else if (distance <= -reach)
                    {
                        at = node.Negative;
                    }
                    else
                    {
                        bool behind = distance < 0;
                        int farther = behind ? node.Positive : node.Negative;
                        // An empty branch matters here: its "nothing" replaces the near answer. Two in a row are as good as one.
                        if (farther != Nothing || count == 0 || far[count - 1] != Nothing) far[count++] = farther;
                        at = behind ? node.Negative : node.Positive;
                    }

                    continue;
                }
            }
            else if (at != Nothing)
            {
                ref readonly Leaf leaf = ref leaves[LeafIndex(at)];
                if (centerCheck && leaf.Solid) centerSolid = true;
                int polygon = CollisionPrimitives.SpheresIntersect(leaf.Bounds, sphere) ? FirstHit(leaf, sphere) : -1;
                if (polygon >= 0) hit.Polygon = polygon;
                result = polygon >= 0 || centerSolid;
            }

            if (count == 0) return result;
            if (hit.IsSome) return centerSolid;
            at = far[--count];
            centerCheck = false;
        }
    }

    private int FirstHit(in Leaf leaf, in Sphere sphere)
    {
        foreach (ushort polygon in PolygonsOf(leaf))
        {
            if (Polygons[polygon].HitsSphere(sphere)) return polygon;
        }

        return -1;
    }

    /// <summary>
    /// Goes to every leaf the sphere reaches, in front of a straddled plane before behind it. Whether the far side is reached is decided
    /// before the near one is visited; its bounding sphere is asked afterwards, when the sphere may have moved.
    /// </summary>
    private bool Walk<TVisitor>(ref TVisitor visitor)
        where TVisitor : struct, ILeafVisitor
    {
        Span<int> pending = pendingSize <= SmallStack ? stackalloc int[SmallStack] : stackalloc int[pendingSize];
        int count = 0, at = root;
        while (true)
        {
            if (at >= 0)
            {
                ref readonly Node node = ref nodes[at];
                Sphere sphere = visitor.Sphere;
                if (CollisionPrimitives.SpheresIntersect(node.Bounds, sphere))
                {
                    double distance = RetailMath.Distance(node.Plane, sphere.Center);
                    double reach = (double)sphere.Radius - RetailMath.Epsilon;
                    if (distance >= reach)
                    {
                        at = node.Positive;
                    }
                    else if (distance <= -reach)
                    {
                        at = node.Negative;
                    }
                    else
                    {
                        if (node.Negative != Nothing) pending[count++] = node.Negative;
                        at = node.Positive;
                    }

                    continue;
                }
            }
            else if (at != Nothing)
            {
                ref readonly Leaf leaf = ref leaves[LeafIndex(at)];
                if (CollisionPrimitives.SpheresIntersect(leaf.Bounds, visitor.Sphere) && visitor.Visit(this, leaf)) return true;
            }

            if (count == 0) return false;
            at = pending[--count];
        }
    }

    private readonly record struct Branch(int Reference, bool CenterCheck);

    private struct PolyVisitor : ILeafVisitor
    {
        public Vector3 Movement;
        public PolygonContact Contact;

        public Sphere Sphere { get; init; }

        public bool Visit(PhysicsBsp tree, in Leaf leaf)
        {
            foreach (ushort polygon in tree.PolygonsOf(leaf))
            {
                bool runInto = tree.Polygons[polygon].IsRunInto(Sphere, Movement, ref Contact.Point, out bool overlaps);
                if (overlaps) Contact.Polygon = polygon;
                if (runInto) return true;
            }

            return false;
        }
    }

    private struct WalkableVisitor : ILeafVisitor
    {
        public Vector3 Up;
        public float Allowance;

        public Sphere Sphere { get; init; }

        public readonly bool Visit(PhysicsBsp tree, in Leaf leaf)
        {
            foreach (ushort index in tree.PolygonsOf(leaf))
            {
                ConvexPolygon polygon = tree.Polygons[index];
                if (polygon.IsWalkableAndHit(Sphere, Up, Allowance) && polygon.SupportsSmallFoot(Sphere, Up)) return true;
            }

            return false;
        }
    }

    private struct RestVisitor : ILeafVisitor
    {
        public WalkableSearch Search;

        public readonly Sphere Sphere => Search.Sphere;

        public bool Visit(PhysicsBsp tree, in Leaf leaf)
        {
            foreach (ushort index in tree.PolygonsOf(leaf))
            {
                ConvexPolygon polygon = tree.Polygons[index];
                if (!polygon.IsWalkableAndHit(Search.Sphere, Search.Up, Search.Allowance)) continue;
                if (!polygon.AdjustSphereToPlane(ref Search.Sphere, Search.Movement, ref Search.WalkInterp)) continue;
                Search.Found = true;
                Search.Polygon = index;
            }

            return false;
        }
    }
}
