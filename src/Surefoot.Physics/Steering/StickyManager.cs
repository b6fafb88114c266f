using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>Keeps a body next to an object and facing it, for one second.</summary>
/// <remarks>Retail: StickyManager; specification 09, 3.3.</remarks>
internal sealed class StickyManager(SteeredBody body)
{
    private const float Gap = 0.3f;
    private const float SpeedFactor = 5f;
    private const float SpeedOfTheSpeedless = 15f;
    private const double Seconds = 1.0;
    private const float ReportRadius = 0.5f;
    private const double ReportQuantum = 0.5;

    private float targetRadius;
    private Position targetPosition = Position.Nowhere;

    /// <summary>Id of the object stuck to, 0 for none.</summary>
    internal uint TargetId { get; private set; }

    /// <summary>The object has reported where it is.</summary>
    internal bool IsInitialised { get; private set; }

    /// <summary>Time after which it lets go, seconds of the frame's clock.</summary>
    internal double Until { get; private set; }

    /// <summary>Sticks to an object; what was stuck to so far is let go first, and a move-to with it.</summary>
    /// <remarks>Retail: StickyManager::StickTo @0x00555710.</remarks>
    internal void StickTo(uint id, float radius)
    {
        if (TargetId != 0) Release();
        TargetId = id;
        targetRadius = radius;
        Until = body.Now + Seconds;
        IsInitialised = false;
        body.SetTarget(0, id, ReportRadius, ReportQuantum);
    }

    /// <summary>Lets go, if it holds.</summary>
    /// <remarks>Retail: StickyManager::HandleExitWorld @0x00555400, which is also "unstick".</remarks>
    internal void Unstick()
    {
        if (TargetId != 0) Release();
    }

    /// <remarks>Retail: StickyManager::HandleUpdateTarget @0x00555780. A report does not renew the second.</remarks>
    internal void HandleUpdateTarget(in TargetInfo info)
    {
        if (info.ObjectId != TargetId) return;
        if (info.Status == TargetStatus.OK)
        {
            targetPosition = info.TargetPosition;
            IsInitialised = true;
        }
        else
        {
            Release();
        }
    }

    /// <remarks>Retail: StickyManager::UseTime @0x00555610.</remarks>
    internal void UseTime()
    {
        if (TargetId != 0 && body.Now > Until) Release();
    }

    /// <summary>Replaces place and heading of a quantum's motion.</summary>
    /// <remarks>
    /// Retail: StickyManager::adjust_offset @0x00555430. A body deep inside its target first moves further in: the way back is taken only
    /// when one quantum is enough for it.
    /// </remarks>
    internal void AdjustOffset(ref Frame offset, float quantum)
    {
        if (TargetId == 0 || !IsInitialised) return;
        Position here = body.Position;
        Position target = body.Find(TargetId)?.Position ?? targetPosition;
        Vector3 way = here.Frame.GlobalToLocalVector(here.OffsetTo(target));
        way.Z = 0;
        float gap = (float)(here.CylinderDistanceIgnoringHeight(body.Radius, target, targetRadius) - Gap);
        if (RetailMath.NormalizeCheckSmall(ref way)) way = Vector3.Zero;

        float maxSpeed = body.MaxSpeed;
        double speed = (double)SpeedFactor * maxSpeed;
        if (speed < RetailMath.Epsilon) speed = SpeedOfTheSpeedless;
        double reach = speed * quantum;
        offset.Origin = RetailMath.Scale(way, reach >= Math.Abs(gap) ? gap : reach);

        float turn = (float)(here.HeadingTo(target) - here.Frame.Heading);
        if (Math.Abs(turn) < RetailMath.Epsilon) turn = 0;
        if (turn < -RetailMath.Epsilon) turn = (float)(turn + 360.0);
        offset.SetHeading(turn);
    }

    private void Release()
    {
        TargetId = 0;
        IsInitialised = false;
        body.ClearTarget();
        body.CancelMoveTo();
    }

    internal void AddTo(ref StateHash hash)
    {
        hash.Add(TargetId);
        hash.Add(targetRadius);
        hash.Add(targetPosition);
        hash.Add(IsInitialised ? 1UL : 0UL);
        hash.Add(Until);
    }
}
