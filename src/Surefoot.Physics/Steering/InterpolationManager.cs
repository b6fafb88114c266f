using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>
/// Follows the positions that a server told, oldest first, at twice the body's running speed. Every fifth quantum it looks whether it got
/// on; what it cannot reach it gives up, and after that it puts the body to the newest position: a blip.
/// </summary>
/// <remarks>
/// Retail: InterpolationManager; specification 09, 3.2. Its nodes of jumps and velocities are left out: nothing in the client makes one.
/// </remarks>
internal sealed class InterpolationManager(SteeredBody body)
{
    private const float Reached = 0.05f;
    private const float GiveUpQuietly = 0.2f;
    private const float SpeedFactor = 2f;
    private const float SpeedOfTheSpeedless = 7.5f;
    private const float LeastShareOfSpeed = 0.3f;
    private const float NoDistance = 999999f;
    private const int QuantaPerCheck = 5;
    private const int FailuresBeforeBlip = 3;
    private const int QueueLimit = 20;

    /// <summary>Positions too far to walk to are taken beyond the limit; so many of them that the oldest may go.</summary>
    private const int FarQueueLimit = 32;

    private readonly RingQueue<Position> queue = new(FarQueueLimit);
    private float progressTime;
    private float originalDistance = NoDistance;
    private Position blipTo = Position.Nowhere;

    /// <summary>There are positions to follow.</summary>
    internal bool IsInterpolating => queue.Count > 0;

    /// <summary>Number of positions to follow.</summary>
    internal int QueueLength => queue.Count;

    /// <summary>A position to follow, the oldest at 0.</summary>
    internal Position QueueAt(int index) => queue[index];

    /// <summary>Quanta since progress was last looked at.</summary>
    internal int FrameCounter { get; private set; }

    /// <summary>Simulated time of these quanta, seconds.</summary>
    internal float ProgressTime => progressTime;

    /// <summary>Distance to the position followed when counting began, metres.</summary>
    internal float OriginalDistance => originalDistance;

    /// <summary>Positions given up since the last success.</summary>
    internal int FailCount { get; private set; }

    /// <summary>How often the body was put somewhere, in all its life. Nothing hangs on it.</summary>
    internal long BlipCount { get; private set; }

    /// <summary>The last request that was near said to keep the heading.</summary>
    internal bool KeepsHeading { get; private set; }

    /// <summary>Follows one position more.</summary>
    /// <remarks>Retail: InterpolationManager::InterpolateTo @0x00555B20. A far request uses the stored flag and ignores its own.</remarks>
    internal void InterpolateTo(in Position place, bool keepHeading)
    {
        Position here = body.Position;
        Position reference = queue.Count > 0 ? queue.Newest : here;
        float distance = (float)reference.DistanceTo(place);
        if (CorrectionDistances.Blip(here.CellId, body.IsLocalPlayer) < distance)
        {
            Append(place, FarQueueLimit);
            FailCount = FailuresBeforeBlip + 1;
        }
        else if (here.DistanceTo(place) > Reached)
        {
            while (queue.Count > 0 && queue.Newest.DistanceTo(place) < Reached) queue.RemoveNewest();
            KeepsHeading = keepHeading;
            Append(place, QueueLimit);
        }
        else
        {
            if (!keepHeading) body.SetHeading((float)place.Frame.Heading);
            StopInterpolating();
        }
    }

    /// <summary>Replaces the motion of a quantum by the way to the position followed.</summary>
    /// <remarks>
    /// Retail: InterpolationManager::adjust_offset @0x00555D30. In the quantum in which a position is reached or given up the body's own
    /// motion stays.
    /// </remarks>
    internal void AdjustOffset(ref Frame offset, float quantum)
    {
        if (queue.Count == 0 || !body.HasContact) return;
        Position here = body.Position;
        ref Position head = ref queue[0];
        double exactDistance = here.DistanceTo(head);
        float distance = (float)exactDistance;
        if (exactDistance < Reached)
        {
            CompleteNode(success: true);
            return;
        }

        float speed = (float)((double)SpeedFactor * body.AdjustedMaxSpeed);
        if (speed < RetailMath.Epsilon) speed = SpeedOfTheSpeedless;
        progressTime = (float)((double)quantum + progressTime);
        FrameCounter++;
        if (FrameCounter >= QuantaPerCheck && !CheckProgress(distance, speed)) return;

        Frame way = here.RelativeFrame(head);
        double length = RetailMath.Length(way.Origin);
        float reach = (float)((double)speed * quantum);
        if (length <= Reached) CompleteNode(success: true);
        if ((float)length > reach) way.Origin = RetailMath.Scale(way.Origin, (float)((double)reach / (float)length));
        if (KeepsHeading) way.SetHeading(0);
        offset = way;
    }

    /// <summary>Puts the body to the newest position when the others could not be reached.</summary>
    /// <remarks>Retail: InterpolationManager::UseTime @0x00555F20. A refused placement is tried again after the next quantum.</remarks>
    internal void UseTime()
    {
        if (FailCount <= FailuresBeforeBlip && (queue.Count > 0 || FailCount == 0)) return;
        Position destination = queue.Count > 0 ? queue.Newest : blipTo;
        if (!body.Place(destination)) return;
        BlipCount++;
        StopInterpolating();
    }

    /// <summary>Forgets the positions and every count.</summary>
    /// <remarks>Retail: InterpolationManager::StopInterpolating @0x00555950.</remarks>
    internal void StopInterpolating()
    {
        queue.Clear();
        FrameCounter = 0;
        progressTime = 0;
        FailCount = 0;
        originalDistance = NoDistance;
    }

    /// <summary>A share of the speed is progress, and so is sticking to something. Close by, the rest is let be.</summary>
    private bool CheckProgress(float distance, float speed)
    {
        float made = (float)((double)originalDistance - distance);
        if (body.StickyObjectId != 0 || (made >= RetailMath.Epsilon && (double)made / progressTime / speed >= LeastShareOfSpeed))
        {
            FrameCounter = 0;
            progressTime = 0;
            originalDistance = distance;
            return true;
        }

        bool near = distance < GiveUpQuietly;
        if (!near) FailCount++;
        CompleteNode(near);
        return false;
    }

    /// <remarks>Retail: InterpolationManager::NodeCompleted @0x005559A0. A success clears the failures only when nothing follows.</remarks>
    private void CompleteNode(bool success)
    {
        FrameCounter = 0;
        progressTime = 0;
        Position done = queue.Dequeue();
        if (queue.Count > 0)
        {
            originalDistance = (float)body.Position.DistanceTo(queue[0]);
            return;
        }

        originalDistance = NoDistance;
        if (success) StopInterpolating();
        else blipTo = done;
    }

    private void Append(Position place, int limit)
    {
        while (queue.Count >= limit) queue.Dequeue();
        if (KeepsHeading) place.Frame.SetHeading((float)body.Position.Frame.Heading);
        queue.Enqueue(place);
    }

    internal void AddTo(ref StateHash hash)
    {
        hash.Add((ulong)queue.Count);
        for (int i = 0; i < queue.Count; i++) hash.Add(queue[i]);
        hash.Add((ulong)FrameCounter);
        hash.Add(progressTime);
        hash.Add(originalDistance);
        hash.Add((ulong)FailCount);
        hash.Add(KeepsHeading ? 1UL : 0UL);
        hash.Add(blipTo);
    }
}
