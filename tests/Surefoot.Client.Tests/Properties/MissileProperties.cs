using System.Numerics;
using CsCheck;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using EnvCell = Surefoot.Dats.Records.EnvCell;
using Frame = Surefoot.Physics.Geometry.Frame;

namespace Surefoot.Client.Tests.Properties;

/// <summary>
/// Missiles at the greatest speed in and around a house of the demo world. Whether a way leads through a wall is worked out from the
/// polygons of the records alone.
/// </summary>
public sealed class MissileProperties(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const float Radius = 0.1f, Tick = 1f / 30;

    /// <summary>A way past the edge of a wall nearer than this is not judged, metres: the sphere turns around it.</summary>
    private const double EdgeMargin = 0.02;

    private static readonly SetupAsset Arrow = SetupAsset.OfSpheres(0x02FF0002, [new Sphere(Vector3.Zero, Radius)]);

    private static Gen<Vector3> Directions =>
        from z in Gen.Double[-1, 1]
        from turn in Gen.Double[0, Math.Tau]
        select new Vector3(
            (float)(Math.Sqrt(1 - (z * z)) * Math.Cos(turn)), (float)(Math.Sqrt(1 - (z * z)) * Math.Sin(turn)), (float)z);

    private static Gen<Vector3> Inside => Gen.Select(
        Gen.Float[-2, 2], Gen.Float[-1, 2], Gen.Float[0.3f, 2.4f], (x, y, z) => new Vector3(x, y, z));

    [Fact]
    [Behaviour("missile.walls-of-a-house.from-inside", "spec/03, 4.6: sub-steps of at most a radius; spec/05: rooms and their portals")]
    public void What_is_shot_in_a_hall_leaves_it_through_its_doors_only()
    {
        Assert.True(DemoPlaces.TryFind("house-hall", out NamedPlace hall));
        Face[] faces = FacesOf(hall.CellId);
        PhysicsEngine engine = Around(hall);
        int shots = 0, hits = 0;
        Gen.Select(Inside, Directions).Sample(
            (offset, direction) =>
            {
                shots++;
                if (Fly(engine, new Position(hall.CellId, hall.Origin + offset), direction, faces)) hits++;
            },
            iter: 500, threads: 1);
        // All but those out of the open door, and upwards through the hole of the stairs.
        Assert.True(hits > 0.9 * shots, $"{hits} of {shots} hit something");
    }

    [Fact]
    [Behaviour("missile.walls-of-a-house.from-outside", "spec/03, 4.6: sub-steps of at most a radius; spec/05, 4.13: buildings")]
    public void What_is_shot_at_a_house_comes_in_through_its_doors_only()
    {
        Assert.True(DemoPlaces.TryFind("house-hall", out NamedPlace hall));
        Face[] faces = FacesOf(hall.CellId);
        PhysicsEngine engine = Around(hall);
        int shots = 0, hits = 0;
        Gen.Select(Inside, Gen.Double[0, Math.Tau], Gen.Float[0, 6]).Sample(
            (offset, turn, height) =>
            {
                Vector3 start = hall.Origin + new Vector3(18 * (float)Math.Cos(turn), 18 * (float)Math.Sin(turn), height + 0.5f);
                Position place = new((hall.CellId & 0xFFFF0000) | 1, start);
                place.AdjustToOutside();
                shots++;
                if (Fly(engine, place, Vector3.Normalize(hall.Origin + offset - start), faces)) hits++;
            },
            iter: 500, threads: 1);
        Assert.True(hits > 0.9 * shots, $"{hits} of {shots} hit something");
    }

    [Fact]
    [Behaviour("missile.ground-never-passed", "spec/03, 4.4, validate_walkable: the low point is put onto the plane")]
    public void Over_hills_and_at_cliffs_no_missile_goes_under_the_ground()
    {
        foreach (string name in (string[])["hills", "cliff-foot", "foot-of-the-mountain", "lake-shore"])
        {
            Assert.True(DemoPlaces.TryFind(name, out NamedPlace place));
            PhysicsEngine engine = Around(place);
            int shots = 0, hits = 0;
            Gen.Select(Inside, Directions, Gen.Float[0.5f, 6]).Sample(
                (offset, direction, height) =>
                {
                    shots++;
                    // Downwards and ahead more than upwards, so that most hit something.
                    direction = Vector3.Normalize(direction - new Vector3(0, 0, 0.6f));
                    Position start = new(place.CellId, place.Origin + offset + new Vector3(0, 0, height));
                    start.AdjustToOutside();
                    if (Fly(engine, start, direction, [], arrow => AssertOverGround(engine, arrow))) hits++;
                },
                iter: 150, threads: 1);
            Assert.True(hits > 0.5 * shots, $"{name}: {hits} of {shots} hit something");
        }
    }

    private static void AssertOverGround(PhysicsEngine engine, PhysicsBody arrow)
    {
        Position at = arrow.Position;
        Landblock? block = engine.World.FindLandblock(at.CellId);
        if (block is null || !block.Terrain.TryGetHeight(at.Frame.Origin.X, at.Frame.Origin.Y, out float ground)) return;
        // In water it flies as deep as whoever wades stands, and at a shore it may touch the water beside its cell.
        Assert.True(at.Frame.Origin.Z > ground - 0.91f, $"{at.Frame.Origin} is under the ground, {ground}");
        bool isWet = arrow.Transient.HasFlag(TransientState.WaterContact);
        if (!isWet && engine.World.GetVisible(at.CellId) is LandCell { Water: WaterType.None })
            Assert.True(at.Frame.Origin.Z > ground, $"{at.Frame.Origin} is under the ground, {ground}");
    }

    private PhysicsEngine Around(NamedPlace place)
    {
        PhysicsEngine engine = files.CreateEngine();
        engine.World.EnsureLoadedAround(new Position(place.CellId, place.Origin), 1);
        return engine;
    }

    /// <summary>Two thirds of a second of a missile's life; true when it has hit something.</summary>
    private static bool Fly(
        PhysicsEngine engine, in Position place, Vector3 direction, Face[] faces, Action<PhysicsBody>? afterQuantum = null)
    {
        PhysicsBody arrow = engine.CreateBody(1, Arrow,
            PhysicsState.ReportCollisions | PhysicsState.Missile | PhysicsState.PathClipped | PhysicsState.AlignPath, WeenieTraits.Present);
        try
        {
            if (!arrow.EnterWorld(place, slide: false)) return false;
            arrow.SetVelocity(direction * PhysicsBody.MaxVelocity);
            Vector3 before = arrow.Position.Frame.Origin;
            for (int i = 0; i < 20 && arrow.Cell is not null && arrow.Position.CellId >> 16 == place.CellId >> 16; i++)
            {
                arrow.AdvanceQuantum(Tick);
                Vector3 after = arrow.Position.Frame.Origin;
                afterQuantum?.Invoke(arrow);
                foreach (Face face in faces)
                    Assert.False(GoesThrough(face, before, after), $"from {before} to {after} through the wall at {face.Corners[0]}");
                before = after;
            }

            return (arrow.State & PhysicsState.Missile) == 0;
        }
        finally
        {
            engine.RemoveBody(arrow);
        }
    }

    /// <summary>What stops somebody: polygons of the block's rooms and of its buildings' shells, in the block's coordinates.</summary>
    private Face[] FacesOf(uint cellId)
    {
        IDatSource source = files.Cache.Source;
        uint block = cellId & 0xFFFF0000;
        LandBlockInfo info = source.Read<LandBlockInfo>(block | 0xFFFE);
        List<Face> faces = [];
        foreach (Building building in info.Buildings)
        {
            GfxObj shell = source.Read<GfxObj>(building.ModelId);
            Add(shell.Vertices, shell.PhysicsPolygons, building.Frame);
        }

        for (uint id = block | 0x100; id < (block | 0x100) + info.CellCount; id++)
        {
            EnvCell cell = source.Read<EnvCell>(id);
            CellStruct room = source.Read<CellEnvironment>(cell.EnvironmentId).Cells[cell.Structure];
            Add(room.Vertices, room.PhysicsPolygons, cell.Position);
        }

        Assert.True(faces.Count > 100);
        return [.. faces];

        void Add(DatVertexArray vertices, IEnumerable<DatPolygon> polygons, DatFrame at)
        {
            Frame frame = new(at.Origin, at.Rotation);
            foreach (DatPolygon polygon in polygons)
                faces.Add(new Face([.. polygon.Vertices.Select(index => frame.LocalToGlobal(vertices.Vertices[index].Position))]));
        }
    }

    /// <summary>Whether a way meets the front of a face, well inside its edges.</summary>
    private static bool GoesThrough(Face face, Vector3 from, Vector3 to)
    {
        float start = Vector3.Dot(from - face.Corners[0], face.Normal), end = Vector3.Dot(to - face.Corners[0], face.Normal);
        if (start <= 0 || end >= 0) return false;
        Vector3 point = from + ((to - from) * (start / (start - end)));
        for (int i = 0; i < face.Corners.Length; i++)
        {
            Vector3 edge = face.Corners[(i + 1) % face.Corners.Length] - face.Corners[i];
            if (Vector3.Dot(Vector3.Cross(face.Normal, Vector3.Normalize(edge)), point - face.Corners[i]) < EdgeMargin) return false;
        }

        return true;
    }

    /// <summary>A convex polygon, counter-clockwise seen from its front.</summary>
    private sealed class Face(Vector3[] corners)
    {
        public Vector3[] Corners => corners;

        public Vector3 Normal { get; } = Vector3.Normalize(Vector3.Cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
}
