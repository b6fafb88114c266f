using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>
/// Both sides of tracking: as a tracker, the one object this body wants to know about; as a target, the bodies that want to know about this
/// one, its voyeurs.
/// All bodies live in one engine, so a report is a call.
/// </summary>
/// <remarks>Retail: TargetManager; specification 09b, 7.</remarks>
internal sealed class TargetManager(SteeredBody body)
{
    private const double CheckInterval = 0.5;
    private const double TimeOut = 10.0;

    private readonly VoyeurList voyeurs = new();
    private TargetInfo target;
    private bool hasTarget;
    private double lastCheck;

    /// <summary>Bodies that track this one, in the order in which they are told.</summary>
    internal VoyeurList Voyeurs => voyeurs;

    /// <summary>This body tracks something.</summary>
    internal bool HasTarget => hasTarget;

    /// <summary>What it tracks; without meaning when it does not.</summary>
    internal ref readonly TargetInfo Target => ref target;

    /// <summary>How far ahead the place of the tracked object is foretold, seconds; 0 without one.</summary>
    internal double Quantum => hasTarget ? target.Quantum : 0;

    /// <summary>
    /// Tracks an object instead of what was tracked so far. An object that is known reports at once, from inside this call.
    /// </summary>
    /// <remarks>Retail: TargetManager::SetTarget @0x0051AC30.</remarks>
    internal void SetTarget(uint context, uint id, float radius, double quantum)
    {
        ClearTarget();
        if (id == 0)
        {
            body.HandleUpdateTarget(new TargetInfo { ContextId = context, Status = TargetStatus.TimedOut });
            return;
        }

        target = new TargetInfo
        {
            ContextId = context,
            ObjectId = id,
            Radius = radius,
            Quantum = quantum,
            TargetPosition = Position.Nowhere,
            InterpolatedPosition = Position.Nowhere,
            LastUpdate = body.Now,
        };
        hasTarget = true;
        body.Find(id)?.MakeTargetManager().AddVoyeur(body.Id, radius, (float)quantum);
    }

    /// <summary>Tracks nothing any more.</summary>
    /// <remarks>Retail: TargetManager::ClearTarget @0x0051A7E0.</remarks>
    internal void ClearTarget()
    {
        if (!hasTarget) return;
        body.Find(target.ObjectId)?.TargetManager?.voyeurs.Remove(body.Id);
        hasTarget = false;
    }

    /// <summary>Has the tracked object's place foretold further ahead; it does not report for that.</summary>
    /// <remarks>Retail: TargetManager::SetTargetQuantum @0x0051A4A0.</remarks>
    internal void SetQuantum(double quantum)
    {
        if (!hasTarget) return;
        target.Quantum = quantum;
        body.Find(target.ObjectId)?.MakeTargetManager().AddVoyeur(body.Id, target.Radius, (float)quantum);
    }

    /// <summary>What is tracked and what tracks, every half second of simulated time.</summary>
    /// <remarks>Retail: TargetManager::HandleTargetting @0x0051AA90.</remarks>
    internal void HandleTargetting(double physicsTime)
    {
        if (physicsTime - lastCheck < CheckInterval) return;
        if (hasTarget && target.Status == TargetStatus.Undefined && target.LastUpdate + TimeOut < body.Now)
        {
            target.Status = TargetStatus.TimedOut;
            TargetInfo copy = target;
            body.HandleUpdateTarget(copy);
        }

        for (int i = voyeurs.BeginWalk(); i >= 0; i = voyeurs.Next()) CheckVoyeur(ref voyeurs[i]);
        lastCheck = physicsTime;
    }

    /// <summary>The body is no longer where it was: it tracks nothing more, and whoever tracks it is told why.</summary>
    /// <remarks>Retail: TargetManager::NotifyVoyeurOfEvent @0x0051A6F0, after ClearTarget as both its callers do.</remarks>
    internal void EndTracking(TargetStatus status)
    {
        ClearTarget();
        Position here = body.Position;
        for (int i = voyeurs.BeginWalk(); i >= 0; i = voyeurs.Next()) Report(ref voyeurs[i], here, status);
    }

    /// <remarks>Retail: TargetManager::AddVoyeur @0x0051A830. Only a new one is told at once.</remarks>
    private void AddVoyeur(uint id, float radius, float quantum)
    {
        int index = voyeurs.Find(id);
        bool isNew = index < 0;
        if (isNew) index = voyeurs.Add(id);
        ref Voyeur voyeur = ref voyeurs[index];
        voyeur.Radius = radius;
        voyeur.Quantum = quantum;
        if (isNew) Report(ref voyeur, body.Position, TargetStatus.OK);
    }

    /// <summary>Reports when the foretold place is far enough from the one told last.</summary>
    /// <remarks>Retail: TargetManager::CheckAndUpdateVoyeur @0x0051A650, GetInterpolatedPosition @0x0051A5E0.</remarks>
    private void CheckVoyeur(ref Voyeur voyeur)
    {
        Position foretold = body.Position;
        Vector3 velocity = body.AchievedVelocity, here = foretold.Frame.Origin;
        double quantum = (float)voyeur.Quantum;
        foretold.Frame.Origin = new Vector3(
            (float)((quantum * velocity.X) + here.X), (float)((quantum * velocity.Y) + here.Y),
            (float)((float)(quantum * velocity.Z) + (double)here.Z));
        if (foretold.DistanceTo(voyeur.LastSent) > voyeur.Radius) Report(ref voyeur, foretold, TargetStatus.OK);
    }

    /// <remarks>Retail: TargetManager::SendVoyeurUpdate @0x0051A4F0. What is told may take the voyeur off the list.</remarks>
    private void Report(ref Voyeur voyeur, in Position foretold, TargetStatus status)
    {
        voyeur.LastSent = foretold;
        TargetInfo report = new()
        {
            ObjectId = body.Id,
            Radius = voyeur.Radius,
            Quantum = voyeur.Quantum,
            TargetPosition = body.Position,
            InterpolatedPosition = foretold,
            Velocity = body.AchievedVelocity,
            Status = status,
        };
        body.Find(voyeur.Id)?.TargetManager?.ReceiveUpdate(report);
    }

    /// <remarks>Retail: TargetManager::ReceiveUpdate @0x0051A930. The record keeps its context.</remarks>
    private void ReceiveUpdate(in TargetInfo report)
    {
        if (!hasTarget || report.ObjectId != target.ObjectId) return;
        Vector3 towards = body.Position.OffsetTo(report.InterpolatedPosition);
        if (RetailMath.NormalizeCheckSmall(ref towards)) towards = Vector3.UnitZ;
        target = report with { ContextId = target.ContextId, LastUpdate = body.Now, InterpolatedHeading = towards };
        TargetInfo copy = target;
        body.HandleUpdateTarget(copy);
        if (copy.Status == TargetStatus.LeftWorld) ClearTarget();
    }

    internal void AddTo(ref StateHash hash)
    {
        hash.Add(lastCheck);
        hash.Add(hasTarget ? target.ObjectId : 0);
        if (hasTarget)
        {
            hash.Add(target.ContextId);
            hash.Add((ulong)target.Status);
            hash.Add(target.Quantum);
            hash.Add(target.TargetPosition);
            hash.Add(target.LastUpdate);
        }

        voyeurs.AddTo(ref hash);
    }
}
