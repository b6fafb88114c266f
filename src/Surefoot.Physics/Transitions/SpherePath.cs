using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>
/// The one or two spheres of a body on their way: where they were accepted last, where they are being tried, and what the
/// attempt is for.
/// </summary>
/// <remarks>Retail: SPHEREPATH. Fields keep retail's meaning; specification 03, 2.4, has the table.</remarks>
internal sealed class SpherePath
{
    /// <summary>A body has at most this many spheres.</summary>
    public const int MaxSpheres = 2;

    internal readonly Sphere[] LocalSpheres = new Sphere[MaxSpheres];

    /// <summary>
    /// How far from the body's origin its spheres reach however it is turned, metres. Each counts with the foot's radius if that is the
    /// larger one: balls and cylinders meet the head with it.
    /// </summary>
    internal double LocalReach;
    internal readonly Sphere[] GlobalSpheres = new Sphere[MaxSpheres];
    internal readonly Vector3[] GlobalCurrCenters = new Vector3[MaxSpheres];
    internal readonly Sphere[] LocalSpaceSpheres = new Sphere[MaxSpheres];
    internal readonly Vector3[] LocalSpaceCurrCenters = new Vector3[MaxSpheres];

    internal int SphereCount;
    internal Vector3 LocalLowPoint;
    internal Vector3 GlobalLowPoint;
    internal Vector3 LocalSpaceZ;
    internal Position LocalSpacePos;

    internal ObjCell? BeginCell;
    internal Position BeginPos;
    internal bool HasBegin;
    internal Position EndPos;

    internal ObjCell? CurrCell;
    internal Position CurrPos;
    internal ObjCell? CheckCell;
    internal Position CheckPos;

    /// <summary>The one saved check position (a slot, not a stack).</summary>
    internal ObjCell? BackupCell;
    internal Position BackupCheckPos;

    /// <summary>The one saved insert type (a slot, not a stack).</summary>
    internal InsertType BackupInsertType;
    internal InsertType InsertType;

    internal Vector3 GlobalOffset;

    internal bool SteppingUp;
    internal Vector3 StepUpNormal;
    internal bool SteppingDown;
    internal float StepDownAmount;
    internal float WalkInterp;
    internal float WalkableAllowance;

    internal PolygonRef Walkable;
    internal Sphere WalkableCheckPos;
    internal Vector3 WalkableUp;
    internal Position WalkablePos;
    internal float WalkableScale;

    internal bool CheckingWalkable;
    internal bool Collide;

    internal bool NegPolyHit;
    internal bool NegStepUp;
    internal Vector3 NegCollisionNormal;

    internal bool ObstructionEthereal;
    internal bool BuildingCheck;
    internal bool PlacementAllowsSliding;

    /// <summary>Spheres at the position under test, in the block frame of its cell.</summary>
    public ReadOnlySpan<Sphere> CheckSpheres => GlobalSpheres.AsSpan(0, SphereCount);

    internal void Reset()
    {
        SphereCount = 0;
        BeginCell = CurrCell = CheckCell = BackupCell = null;
        HasBegin = false;
        InsertType = InsertType.Transition;
        SteppingDown = SteppingUp = Collide = BuildingCheck = ObstructionEthereal = false;
        CheckingWalkable = NegStepUp = NegPolyHit = false;
        WalkableAllowance = 0;
        Walkable = default;
        PlacementAllowsSliding = true;
        StepUpNormal = NegCollisionNormal = GlobalOffset = default;
    }

    /// <summary>Takes at most two spheres of the body, scaled.</summary>
    /// <remarks>Retail: SPHEREPATH::init_sphere @0x0050C670.</remarks>
    internal void InitSpheres(ReadOnlySpan<Sphere> spheres, float scale)
    {
        SphereCount = Math.Min(spheres.Length, MaxSpheres);
        for (int i = 0; i < SphereCount; i++)
            LocalSpheres[i] = new Sphere(RetailMath.Scale(spheres[i].Center, scale), (float)((double)spheres[i].Radius * scale));
        LocalLowPoint = LocalSpheres[0].Center;
        LocalLowPoint.Z -= LocalSpheres[0].Radius;
        LocalReach = 0;
        foreach (ref readonly Sphere sphere in LocalSpheres.AsSpan(0, SphereCount))
            LocalReach = Math.Max(LocalReach,
                RetailMath.Length(sphere.Center) + Math.Max(Math.Abs(sphere.Radius), Math.Abs(LocalSpheres[0].Radius)));
    }

    /// <summary>Sets where the path begins and ends; without a begin the body is placed at the end.</summary>
    /// <remarks>Retail: SPHEREPATH::init_path @0x0050CE20.</remarks>
    internal void InitPath(ObjCell? cell, bool hasBegin, in Position begin, in Position end)
    {
        BeginCell = cell;
        HasBegin = hasBegin;
        BeginPos = hasBegin ? begin : end;
        EndPos = end;
        CurrPos = BeginPos;
        CurrCell = cell;
        CacheGlobalCurrCenter();
        InsertType = hasBegin ? InsertType.Transition : InsertType.Placement;
    }

    /// <remarks>Retail: SPHEREPATH::cache_global_curr_center @0x0050C740.</remarks>
    internal void CacheGlobalCurrCenter()
    {
        for (int i = 0; i < SphereCount; i++) GlobalCurrCenters[i] = CurrPos.Frame.LocalToGlobal(LocalSpheres[i].Center);
    }

    /// <summary>Recomputes the spheres from the check position.</summary>
    /// <remarks>Retail: SPHEREPATH::cache_global_sphere @0x0050C810 without an offset.</remarks>
    internal void CacheGlobalSpheres()
    {
        for (int i = 0; i < SphereCount; i++)
            GlobalSpheres[i] = new Sphere(CheckPos.Frame.LocalToGlobal(LocalSpheres[i].Center), LocalSpheres[i].Radius);
        GlobalLowPoint = CheckPos.Frame.LocalToGlobal(LocalLowPoint);
    }

    /// <summary>Translates the spheres; they do not see a rotation of the check position since they were last recomputed.</summary>
    private void TranslateGlobalSpheres(in Vector3 offset)
    {
        for (int i = 0; i < SphereCount; i++) GlobalSpheres[i].Center += offset;
        GlobalLowPoint += offset;
    }

    /// <summary>Expresses the spheres in an obstacle's frame, divided by its scale.</summary>
    /// <remarks>Retail: SPHEREPATH::cache_localspace_sphere @0x0050C9D0.</remarks>
    internal void CacheLocalSpaceSpheres(in Position obstacle, float scale)
    {
        float k = (float)(1.0 / scale);
        for (int i = 0; i < SphereCount; i++)
        {
            Vector3 local = LocalSpheres[i].Center;
            LocalSpaceSpheres[i] = new Sphere(
                RetailMath.Scale(obstacle.LocalToLocal(CheckPos, local), k), (float)((double)k * LocalSpheres[i].Radius));
            LocalSpaceCurrCenters[i] = RetailMath.Scale(obstacle.LocalToLocal(CurrPos, local), k);
        }

        LocalSpacePos = obstacle;
        LocalSpaceZ = obstacle.Frame.LocalUp;
    }

    /// <summary>Moves the position under test and its spheres, metres.</summary>
    /// <remarks>Retail: SPHEREPATH::add_offset_to_check_pos @0x00509D10.</remarks>
    internal void AddOffsetToCheckPos(in Vector3 offset)
    {
        CheckPos.Frame.Origin += offset;
        TranslateGlobalSpheres(offset);
    }

    /// <remarks>Retail: SPHEREPATH::set_check_pos @0x0050A8B0.</remarks>
    internal void SetCheckPos(in Position position, ObjCell? cell)
    {
        CheckPos = position;
        CheckCell = cell;
        CacheGlobalSpheres();
    }

    /// <remarks>Retail: SPHEREPATH::save_check_pos @0x0050A880.</remarks>
    internal void SaveCheckPos()
    {
        BackupCell = CheckCell;
        BackupCheckPos = CheckPos;
    }

    /// <remarks>Retail: SPHEREPATH::restore_check_pos @0x0050B100.</remarks>
    internal void RestoreCheckPos() => SetCheckPos(BackupCheckPos, BackupCell);

    /// <summary>Re-bases the check position to another cell; coordinates change only towards an outdoor cell.</summary>
    /// <remarks>Retail: SPHEREPATH::adjust_check_pos @0x0050CC00.</remarks>
    internal void AdjustCheckPos(uint cellId)
    {
        if (CellIds.IsOutdoor(cellId))
        {
            Vector3 offset = CellIds.BlockOffset(cellId, CheckPos.CellId);
            TranslateGlobalSpheres(offset);
            CheckPos.Frame.Origin += offset;
        }

        CheckPos.CellId = cellId;
    }

    /// <summary>An airborne body touched something: the landing must be confirmed.</summary>
    /// <remarks>Retail: SPHEREPATH::set_collide @0x005378A0.</remarks>
    internal void SetCollide(in Vector3 normal)
    {
        Collide = true;
        SaveCheckPos();
        StepUpNormal = normal;
        WalkInterp = 1f;
    }

    /// <summary>Remembers an overlapped polygon that the movement does not run against; it is answered when all cells are free.</summary>
    /// <remarks>Retail: SPHEREPATH::set_neg_poly_hit @0x005398E0.</remarks>
    internal void SetNegPolyHit(bool stepUp, in Vector3 normal)
    {
        NegStepUp = stepUp;
        NegPolyHit = true;
        NegCollisionNormal = -normal;
    }

    /// <remarks>Retail: SPHEREPATH::set_walkable @0x00539FC0.</remarks>
    internal void SetWalkable(in Sphere sphere, PolygonRef polygon, in Vector3 up, in Position frame, float scale)
    {
        Walkable = polygon;
        WalkableCheckPos = sphere;
        WalkableUp = up;
        WalkablePos = frame;
        WalkableScale = scale;
    }

    /// <summary>Is a plane with this N·up footing for the present attempt?</summary>
    /// <remarks>Retail: SPHEREPATH::is_walkable_allowable @0x005368D0.</remarks>
    internal bool IsWalkableAllowable(double z) => z > WalkableAllowance;

    /// <summary>
    /// Does the walkable polygon support the foot? The radius is halved in place, so that repeated probes give up narrow footing.
    /// </summary>
    /// <remarks>Retail: SPHEREPATH::check_walkables @0x0050C3E0.</remarks>
    internal bool CheckWalkables()
    {
        if (Walkable.IsNone) return true;
        WalkableCheckPos.Radius = (float)(WalkableCheckPos.Radius * 0.5);
        return Walkable.CheckWalkable(WalkableCheckPos, WalkableUp);
    }

    /// <summary>Offset between the block frames of the accepted position and the position under test.</summary>
    /// <remarks>Retail: SPHEREPATH::get_curr_pos_check_pos_block_offset @0x00509FD0.</remarks>
    internal Vector3 CurrToCheckBlockOffset => CellIds.BlockOffset(CurrPos.CellId, CheckPos.CellId);

    /// <summary>Displacement between two centres given in the block frames of the accepted and of the check position.</summary>
    internal Vector3 Displacement(in Vector3 center, in Vector3 curr)
    {
        Vector3 block = CurrToCheckBlockOffset;
        return new Vector3(
            (float)(block.X + ((double)center.X - curr.X)),
            (float)(block.Y + ((double)center.Y - curr.Y)),
            (float)(block.Z + ((double)center.Z - curr.Z)));
    }

    /// <summary>Displacement of a sphere from the accepted position to the position under test.</summary>
    internal Vector3 CurrToCheckDisplacement(int sphere) => Displacement(GlobalSpheres[sphere].Center, GlobalCurrCenters[sphere]);
}
