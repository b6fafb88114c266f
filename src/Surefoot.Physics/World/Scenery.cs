using System.Globalization;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Frame = Surefoot.Physics.Geometry.Frame;

namespace Surefoot.Physics.World;

/// <summary>Trees, rocks and bushes: worked out from the ground, the same everywhere and always.</summary>
/// <remarks>
/// Retail: CLandBlock::get_land_scenes @0x00530460, ObjectDesc::Place @0x005A5BB0; specification 05, 4.8. All integers wrap at 32 bits.
/// </remarks>
internal static class Scenery
{
    private const uint FrequencyQuestion = 23399, XQuestion = 45773, YQuestion = 72719, RotationQuestion = 63127, ScaleQuestion = 32593;

    /// <summary>The scenery of a block whose ground and buildings are there, in retail's order.</summary>
    internal static IEnumerable<SceneryItem> Of(Landblock block, RegionAsset region, AssetFinder assets, LandblockFaults faults)
    {
        for (int ix = 0; ix < TerrainSurface.VerticesPerSide; ix++)
        {
            for (int iy = 0; iy < TerrainSurface.VerticesPerSide; iy++)
            {
                ushort word = block.Terrain.WordOf(ix, iy);
                uint x = (8 * (block.Id >> 24)) + (uint)ix, y = (8 * ((block.Id >> 16) & 0xFF)) + (uint)iy;
                uint sceneId = PickScene(region.ScenesOn(TerrainSurface.TypeOf(word), TerrainSurface.SceneryOf(word)), x, y);
                (Scene? scene, Exception? fault) = region.FindScene(sceneId);
                if (fault is not null) faults.LeaveOut(LeftOutKind.Scene, sceneId, CellIds.LandblockRecord(block.Id), fault);
                for (int k = 0; k < scene?.Objects.Length; k++)
                {
                    if (TryPlace(block, scene, (uint)k, new Spot(ix, iy, x, y), assets, faults) is { } item) yield return item;
                }
            }
        }
    }

    /// <summary>A number in [0, 1) for one question about one object of a scene at one vertex.</summary>
    internal static double Share(uint x, uint y, uint k, uint question) => Share(unchecked(
        (1813693831u * y) - ((k + question) * ((1360117743u * x * y) + 1888038839u)) - (1109124029u * x)));

    /// <summary>The number that turns a scene about its vertex.</summary>
    internal static double QuadrantShare(uint x, uint y) => Share(unchecked(
        (1813693831u * y) - (x * ((1870387557u * y) + 1109124029u)) - 402451965u));

    /// <summary>The number that picks one of several scenes.</summary>
    internal static double SceneShare(uint x, uint y) => Share(unchecked(
        (y * ((712977289u * x) + 1813693831u)) - (1109124029u * x) + 2139937281u));

    private static double Share(uint hash) => hash * (1.0 / 4294967296.0);

    private static uint PickScene(ReadOnlySpan<uint> scenes, uint x, uint y)
    {
        if (scenes.IsEmpty) return 0;
        if (scenes.Length == 1) return scenes[0];
        int index = (int)Math.Floor(SceneShare(x, y) * scenes.Length);
        return scenes[index >= scenes.Length ? 0 : index];
    }

    private static SceneryItem? TryPlace(Landblock block, Scene scene, uint k, in Spot spot, AssetFinder assets, LandblockFaults faults)
    {
        SceneObject thing = scene.Objects[(int)k];
        if (!(Share(spot.X, spot.Y, k, FrequencyQuestion) < thing.Frequency) || thing.WeenieObject != 0) return null;

        Vector3 point = Displace(thing, k, spot);
        if (!(point.X >= 0 && point.Y >= 0 && point.X < CellIds.BlockSize && point.Y < CellIds.BlockSize) || block.Terrain.IsOnRoad(point))
            return null;
        LandCell cell = block.LandCells[TerrainSurface.CellUnder(point.X, point.Y)];
        int triangle = cell.FindTriangle(point);
        if (cell.Building is not null || triangle < 0) return null;
        Plane plane = block.Terrain.PlaneOf(triangle);
        if (!(plane.Normal.Z >= thing.MinSlope && plane.Normal.Z <= thing.MaxSlope) || !PlaneQueries.SetHeight(plane, ref point))
            return null;

        if (FaultOf(thing) is { } fault)
        {
            faults.LeaveOut(LeftOutKind.Scenery, thing.ObjectId, scene.Id, new RecordFlattener(scene).Error($"object {k} {fault}"));
            return null;
        }

        Frame frame = new(point, thing.BaseFrame.Rotation);
        if (thing.Align != 0)
        {
            Vector3 uphill = new(-plane.Normal.X, -plane.Normal.Y, 0);
            frame.SetHeading(RetailMath.NormalizeCheckSmall(ref uphill) ? 0f : (float)Frame.HeadingOf(uphill));
        }
        else if (thing.MaxRotation > 0)
        {
            frame.SetHeading((float)(Share(spot.X, spot.Y, k, RotationQuestion) * thing.MaxRotation));
        }

        if (assets.FindSetup(thing.ObjectId, LeftOutKind.Scenery, scene.Id, faults) is not { } setup) return null;
        return IsWithinBlock(setup, frame) ? new SceneryItem(setup, frame, Scale(thing, k, spot), cell) : null;
    }

    /// <summary>Why an object of a scene cannot stand anywhere; null when it can.</summary>
    private static string? FaultOf(in SceneObject thing)
    {
        Quaternion turn = thing.BaseFrame.Rotation;
        if (!float.IsFinite(turn.X + turn.Y + turn.Z + turn.W) || !float.IsFinite(thing.MaxRotation))
            return "has a rotation that is not finite";
        bool hasSize = thing.MinScale > 0 && thing.MaxScale > 0 && float.IsFinite(thing.MinScale) && float.IsFinite(thing.MaxScale);
        return hasSize ? null : string.Create(CultureInfo.InvariantCulture, $"is scaled by {thing.MinScale} to {thing.MaxScale}");
    }

    private static Vector3 Displace(in SceneObject thing, uint k, in Spot spot)
    {
        Vector3 origin = thing.BaseFrame.Origin;
        float x = thing.DisplaceX > 0 ? (float)((Share(spot.X, spot.Y, k, XQuestion) * thing.DisplaceX) + origin.X) : origin.X;
        double y = thing.DisplaceY > 0 ? (Share(spot.X, spot.Y, k, YQuestion) * thing.DisplaceY) + origin.Y : origin.Y;
        Vector2 place = QuadrantShare(spot.X, spot.Y) switch
        {
            < 0.25 => new Vector2(x, (float)y),
            < 0.5 => new Vector2((float)-y, x),
            < 0.75 => new Vector2(-x, (float)-y),
            _ => new Vector2((float)y, -x),
        };
        return new Vector3(place.X + (CellIds.CellSize * spot.Column), place.Y + (CellIds.CellSize * spot.Row), origin.Z);
    }

    private static float Scale(in SceneObject thing, uint k, in Spot spot) => thing.MinScale == thing.MaxScale
        ? thing.MaxScale
        : (float)(thing.MinScale * Math.Pow((double)thing.MaxScale / thing.MinScale, Share(spot.X, spot.Y, k, ScaleQuestion)));

    /// <summary>
    /// Scenery that reaches over the block's border is left out. Its scale is not known yet at this point, and not looked at.
    /// </summary>
    /// <remarks>Retail: CPhysicsObj::obj_within_block @0x00511030.</remarks>
    private static bool IsWithinBlock(SetupAsset setup, in Frame frame)
    {
        if (setup.HasPhysicsBsp) return Within(frame, setup.SortingSphere.Center, setup.SortingSphere.Radius);
        if (!setup.Cylinders.IsEmpty)
        {
            foreach (ref readonly CylSphere cylinder in setup.Cylinders)
            {
                if (!Within(frame, cylinder.LowPoint, cylinder.Radius)) return false;
            }

            return true;
        }

        return setup.Spheres.IsEmpty
            ? CellIds.IsWithinBlock(frame.Origin, 0)
            : Within(frame, setup.SortingSphere.Center, setup.SortingSphere.Radius);
    }

    private static bool Within(in Frame frame, in Vector3 center, float radius) =>
        CellIds.IsWithinBlock(frame.LocalToGlobal(center), radius);

    /// <summary>A vertex: its column and row in the block, and its global cell coordinates.</summary>
    private readonly record struct Spot(int Column, int Row, uint X, uint Y);
}

/// <summary>One thing that grows or lies on the ground.</summary>
/// <param name="Setup">Its shape.</param>
/// <param name="Frame">Where it is, block coordinates.</param>
/// <param name="Scale">Its scale.</param>
/// <param name="Cell">The square of land it stands in.</param>
internal readonly record struct SceneryItem(SetupAsset Setup, Frame Frame, float Scale, LandCell Cell);
