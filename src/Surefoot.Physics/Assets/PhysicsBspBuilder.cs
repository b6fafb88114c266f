using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>
/// Puts a tree together from the bottom or the top, in any order, and checks it: every reference must exist and the queries' stacks must
/// stay small.
/// </summary>
internal sealed class PhysicsBspBuilder(PolygonSet polygons)
{
    private readonly List<PhysicsBsp.Node> nodes = [];
    private readonly List<PhysicsBsp.Leaf> leaves = [];
    private readonly List<ushort> leafPolygons = [];

    /// <summary>Adds a node whose children are set later; until then both are nothing.</summary>
    /// <returns>A reference to it.</returns>
    public int AddNode(in Plane plane, in Sphere bounds)
    {
        nodes.Add(new PhysicsBsp.Node { Plane = plane, Bounds = bounds, Positive = PhysicsBsp.Nothing, Negative = PhysicsBsp.Nothing });
        return nodes.Count - 1;
    }

    public void SetPositive(int node, int child) => nodes[node] = nodes[node] with { Positive = child };

    public void SetNegative(int node, int child) => nodes[node] = nodes[node] with { Negative = child };

    /// <summary>Adds a leaf.</summary>
    /// <returns>A reference to it; nothing for a leaf without polygons, which no query answers.</returns>
    /// <exception cref="FormatException">A polygon does not exist.</exception>
    public int AddLeaf(in Sphere bounds, bool solid, ReadOnlySpan<int> indices)
    {
        if (indices.IsEmpty) return PhysicsBsp.Nothing;
        leaves.Add(new PhysicsBsp.Leaf { Bounds = bounds, First = leafPolygons.Count, Count = indices.Length, Solid = solid });
        foreach (int index in indices)
        {
            if ((uint)index >= (uint)polygons.Count)
                throw new FormatException($"a leaf of the physics tree names polygon {index} of {polygons.Count}");
            leafPolygons.Add((ushort)index);
        }

        return -1 - leaves.Count;
    }

    /// <summary>The finished tree.</summary>
    /// <param name="root">Reference to the root.</param>
    /// <param name="bounds">Bounding sphere of the root; needed apart because an empty leaf has left no other trace.</param>
    /// <exception cref="FormatException">Too many branches would have to be remembered on the way down.</exception>
    public PhysicsBsp Build(int root, in Sphere bounds)
    {
        // Twice, because the placement query may remember an empty branch above each other one.
        int pendingSize = (2 * MostPending(root)) + 2;
        return new PhysicsBsp([.. nodes], [.. leaves], [.. leafPolygons], root, bounds, pendingSize, polygons);
    }

    /// <summary>
    /// How many untaken branches with polygons a way from the root to a leaf can pass. A chain of planes, however long, passes none when
    /// one side of each is empty.
    /// </summary>
    private int MostPending(int root)
    {
        int most = 0, visited = 0;
        Stack<(int Reference, int Pending)> rest = new([(root, 0)]);
        while (rest.TryPop(out (int Reference, int Pending) item))
        {
            if (++visited > (2 * nodes.Count) + 1) throw new FormatException("the physics tree is not a tree");
            most = Math.Max(most, item.Pending);
            if (most > PhysicsBsp.MaxPending)
                throw new FormatException($"the physics tree branches more than {PhysicsBsp.MaxPending} times on one way down");
            if (item.Reference < 0) continue;
            PhysicsBsp.Node node = nodes[item.Reference];
            rest.Push((node.Positive, item.Pending + (node.Negative == PhysicsBsp.Nothing ? 0 : 1)));
            rest.Push((node.Negative, item.Pending + (node.Positive == PhysicsBsp.Nothing ? 0 : 1)));
        }

        return most;
    }
}
