using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// Turns what bodies collide with into triangles to draw: the collision polygons of objects, buildings and rooms, and the cylinders and
/// spheres of objects without polygons. What is not solid is not shown, and what is shown is where it stops a body. Parts that an animation
/// moves are apart, each in its own frame: where they are is told from tick to tick.
/// </summary>
internal static class ShapeCollector
{
    private const int CylinderSides = 12;
    private const int SphereRings = 6;

    /// <summary>The shapes of a block, in its coordinates.</summary>
    public static BlockShapes Collect(Landblock block)
    {
        List<Vector3> objects = [], rocks = [];
        List<NamedShape> shells = [], rooms = [];
        List<Plant> plants = [];
        List<MovingShape> moving = [];
        ILookup<uint, StaticObject> indoors = block.StaticObjects.Where(item => !CellIds.IsOutdoor(item.Position.CellId))
            .ToLookup(item => item.Position.CellId);
        foreach (StaticObject item in block.StaticObjects)
        {
            if (!CellIds.IsOutdoor(item.Position.CellId)) continue;
            if (!item.IsScenery) AddObject(objects, item);
            else if (HasTrees(item)) AddObject(rocks, item);
            else AddPlant(plants, item);
        }

        foreach (BuildingObject building in block.Buildings)
        {
            List<Vector3> triangles = [];
            AddObject(triangles, building.Shell);
            shells.Add(new NamedShape(building.Shell.Setup?.Id ?? 0, [.. triangles]));
        }

        foreach (EnvCell room in block.Rooms)
        {
            List<Vector3> triangles = [];
            AddPolygons(triangles, room.Polygons, room.Position.Frame, 1f);
            foreach (StaticObject item in indoors[room.Id]) AddObject(triangles, item);
            rooms.Add(new NamedShape(room.Id, [.. triangles]));
        }

        for (int i = 0; i < block.AnimatedStatics.Count; i++)
        {
            if (!MovesSolidParts(block.AnimatedStatics[i])) continue;
            foreach (SolidPart part in SolidParts.Of(block.AnimatedStatics[i]))
            {
                List<Vector3> triangles = [];
                AddPolygons(triangles, part.Polygons, Frame.Identity, 1f);
                moving.Add(new MovingShape((ushort)i, (ushort)part.Index, [.. triangles]));
            }
        }

        return new BlockShapes([.. objects], [.. rocks], shells, rooms, plants, moving);
    }

    /// <summary>Does an animation move parts of an object that stop bodies?</summary>
    public static bool MovesSolidParts(StaticObject item) => item.Animation is not null && HasTrees(item);

    private static bool HasTrees(StaticObject item) => (item.State & PhysicsState.HasPhysicsBsp) != 0;

    private static void AddPlant(List<Plant> to, StaticObject item)
    {
        if (item.Setup is not { } setup) return;
        foreach (CylSphere cylinder in setup.Cylinders)
            to.Add(
                new Plant(item.Position.Frame.LocalToGlobal(cylinder.LowPoint * item.Scale), cylinder.Radius * item.Scale,
                    cylinder.Height * item.Scale, IsRound: false));
        if (setup.Cylinders.Length > 0) return;
        foreach (Sphere sphere in setup.Spheres)
        {
            float radius = sphere.Radius * item.Scale;
            Vector3 low = item.Position.Frame.LocalToGlobal(sphere.Center * item.Scale) - new Vector3(0, 0, radius);
            to.Add(new Plant(low, radius, 2 * radius, IsRound: true));
        }
    }

    private static void AddObject(List<Vector3> to, StaticObject item)
    {
        if (item.Setup is not { } setup || MovesSolidParts(item)) return;
        if (HasTrees(item))
        {
            foreach (SolidPart part in SolidParts.Of(item)) AddPolygons(to, part.Polygons, part.Frame, part.Scale);
            return;
        }

        foreach (CylSphere cylinder in setup.Cylinders)
            AddCylinder(to, item.Position.Frame.LocalToGlobal(cylinder.LowPoint * item.Scale), cylinder.Radius * item.Scale,
                cylinder.Height * item.Scale);
        if (setup.Cylinders.Length > 0) return;
        foreach (Sphere sphere in setup.Spheres)
            AddSphere(to, item.Position.Frame.LocalToGlobal(sphere.Center * item.Scale), sphere.Radius * item.Scale);
    }

    private static void AddPolygons(List<Vector3> to, PolygonSet polygons, in Frame frame, float scale)
    {
        for (int i = 0; i < polygons.Count; i++)
        {
            ReadOnlySpan<Vector3> corners = polygons.CornersOf(i);
            for (int k = 2; k < corners.Length; k++)
            {
                to.Add(frame.LocalToGlobal(corners[0] * scale));
                to.Add(frame.LocalToGlobal(corners[k - 1] * scale));
                to.Add(frame.LocalToGlobal(corners[k] * scale));
            }
        }
    }

    private static void AddCylinder(List<Vector3> to, Vector3 low, float radius, float height)
    {
        Vector3 up = new(0, 0, height);
        for (int i = 0; i < CylinderSides; i++)
        {
            Vector3 a = low + OnCircle(i, radius), b = low + OnCircle(i + 1, radius);
            to.AddRange([a, b, b + up, a, b + up, a + up, low + up, a + up, b + up]);
        }

        static Vector3 OnCircle(int side, float radius)
        {
            (float sin, float cos) = MathF.SinCos(side * MathF.Tau / CylinderSides);
            return new Vector3(cos * radius, sin * radius, 0);
        }
    }

    private static void AddSphere(List<Vector3> to, Vector3 center, float radius)
    {
        for (int ring = 0; ring < SphereRings; ring++)
        {
            for (int side = 0; side < CylinderSides; side++)
            {
                Vector3 a = On(ring, side), b = On(ring, side + 1), c = On(ring + 1, side + 1), d = On(ring + 1, side);
                to.AddRange([a, b, c, a, c, d]);
            }
        }

        Vector3 On(int ring, int side)
        {
            (float sinUp, float cosUp) = MathF.SinCos((ring * MathF.PI / SphereRings) - (MathF.PI / 2));
            (float sin, float cos) = MathF.SinCos(side * MathF.Tau / CylinderSides);
            return center + (radius * new Vector3(cosUp * cos, cosUp * sin, sinUp));
        }
    }
}
