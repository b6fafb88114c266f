using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Transitions;

/// <summary>How a transition tells its decisions to whoever listens. Nothing here decides or moves anything.</summary>
internal static class TransitionTrace
{
    internal static void SweepBegins(this TraceBuffer trace, Transition t)
    {
        trace.Restart();
        if (!t.Collision.ContactPlaneValid) trace.Contact = TraceSubject.None;
        if (!t.Collision.LastKnownContactPlaneValid) trace.LastContact = TraceSubject.None;
        trace.Add(Accepted(t, TraceKind.SweepBegins, TraceSubject.None) with { Offset = t.Path.BeginPos.OffsetTo(t.Path.EndPos) });
    }

    internal static void SweepEnds(this TraceBuffer trace, Transition t, bool found) =>
        trace.Add(Resting(trace, t, TraceKind.SweepEnds) with
        {
            Succeeded = found,
            Reason = t.Path.CurrCell is null ? TraceReason.NotLoaded : TraceReason.None,
        });

    internal static void SubStepBegins(this TraceBuffer trace, Transition t, int index, int count, in Vector3 offset) =>
        trace.Add(Resting(trace, t, TraceKind.SubStepBegins) with { Index = index, Count = count, Offset = offset });

    /// <summary>A sub-step was accepted, or refused and taken back.</summary>
    internal static void SubStepEnds(this TraceBuffer trace, Transition t, TransitionState answer, TraceReason reason = TraceReason.None)
    {
        if (t.Collision.ContactPlaneValid) trace.LastContact = trace.Contact;
        trace.Add(
            Resting(trace, t, TraceKind.SubStepEnds) with { Answer = answer, Succeeded = answer == TransitionState.OK, Reason = reason });
    }

    internal static void Bent(this TraceBuffer trace, Transition t, TraceReason reason, in Vector3 normal, in Vector3 offset) =>
        trace.Add(Tried(t, TraceKind.Bent, TraceSubject.None) with { Reason = reason, Plane = new Plane(normal, 0), Offset = offset });

    internal static void Lifted(this TraceBuffer trace, Transition t, float lift) =>
        trace.Add(Tried(t, TraceKind.Lifted, trace.Contact) with { Offset = new Vector3(0, 0, lift) });

    /// <summary>A cell is about to be asked.</summary>
    internal static void Asks(this TraceBuffer trace, ObjCell cell) => trace.Subject = SubjectOf(cell);

    internal static void CellAnswered(this TraceBuffer trace, Transition t, ObjCell cell, TransitionState answer) =>
        trace.Add(Tried(t, TraceKind.CellAnswered, SubjectOf(cell)) with { Answer = answer });

    /// <summary>The centre of the foot came to be in another cell, or in none that is loaded.</summary>
    internal static void CellEntered(this TraceBuffer trace, Transition t, ObjCell? cell) => trace.Add(cell is null
        ? Tried(t, TraceKind.CellEntered, TraceSubject.None) with { Reason = TraceReason.NotLoaded }
        : Tried(t, TraceKind.CellEntered, SubjectOf(cell)));

    /// <summary>An object of the cell is about to be asked.</summary>
    internal static void Asks(this TraceBuffer trace, WorldObject target) => trace.Subject = SubjectOf(trace, target);

    /// <summary>The shell of a building is about to be asked.</summary>
    internal static void AsksBuilding(this TraceBuffer trace, StaticObject shell) =>
        trace.Subject = SubjectOf(trace, shell) with { Kind = TraceSubjectKind.Building };

    /// <summary>A part of the object is about to be asked.</summary>
    internal static void AsksPart(this TraceBuffer trace, int part) =>
        trace.Subject = trace.Subject with { Part = (short)part, Polygon = -1, Sphere = -1 };

    /// <summary>The triangle of the ground that is about to be asked.</summary>
    internal static void AsksTriangle(this TraceBuffer trace, int triangle) => trace.Subject = trace.Subject with { Polygon = triangle };

    /// <summary>What follows is about nothing in particular.</summary>
    internal static void AsksNobody(this TraceBuffer trace) => trace.Subject = TraceSubject.None;

    /// <summary>What follows answers the hit that was put off.</summary>
    internal static void TakesUpDeferred(this TraceBuffer trace) => trace.Subject = trace.Deferred;

    /// <summary>What follows is about what a landing was asked for on.</summary>
    internal static void TakesUpLanding(this TraceBuffer trace) => trace.Subject = trace.Landing;

    internal static void Skipped(this TraceBuffer trace, Transition t, WorldObject target, TraceReason reason) =>
        trace.Add(Tried(t, TraceKind.Skipped, SubjectOf(trace, target)) with { Reason = reason });

    /// <summary>A part of the object that is being asked is left out.</summary>
    internal static void SkippedPart(this TraceBuffer trace, Transition t, int part) =>
        trace.Add(Tried(t, TraceKind.Skipped, trace.Subject with { Part = (short)part }) with { Reason = TraceReason.TooFar });

    internal static void ObjectAnswered(
        this TraceBuffer trace, Transition t, WorldObject target, TransitionState answer, TraceReason reason) =>
        trace.Add(Tried(t, TraceKind.ObjectAnswered, SubjectOf(trace, target)) with { Answer = answer, Reason = reason });

    /// <summary>A sphere met a polygon of the tree whose frame the local-space spheres are in.</summary>
    internal static void HitPolygon(this TraceBuffer trace, Transition t, PhysicsBsp tree, int polygon, int sphere, TraceReason reason)
    {
        SpherePath path = t.Path;
        trace.Subject = trace.Subject with { Polygon = polygon, Sphere = (sbyte)sphere };
        Sphere local = path.LocalSpaceSpheres[sphere];
        Plane plane = tree.Polygons.PlaneOf(polygon);
        double scale = path.LocalSpheres[sphere].Radius / (double)local.Radius;
        Plane placed = path.CheckPos.LocalToGlobal(path.LocalSpacePos, new Plane(plane.Normal, (float)(plane.D * scale)));
        Remember(trace, reason);
        trace.Add(Met(t, trace.Subject, placed, (float)((RetailMath.Distance(plane, local.Center) - local.Radius) * scale), reason));
    }

    /// <summary>A sphere is in the way of a tree, which does not say with which polygon.</summary>
    internal static void HitTree(this TraceBuffer trace, Transition t, TraceReason reason) =>
        trace.Add(Met(t, trace.Subject, default, 0, reason));

    /// <summary>The foot met the ground.</summary>
    internal static void HitGround(this TraceBuffer trace, Transition t, in Plane plane, uint cellId, double gap, TraceReason reason) =>
        trace.Add(Met(t, trace.Subject with { Sphere = 0 }, plane, (float)gap, reason) with { PlaneCellId = cellId });

    /// <summary>A sphere met a ball, given in the block frame of the check position.</summary>
    internal static void HitShape(this TraceBuffer trace, Transition t, int sphere, in Sphere ball)
    {
        // Retail meets the head with the radius of the foot.
        double reach = (double)ball.Radius + t.Path.GlobalSpheres[0].Radius;
        trace.HitShape(t, sphere, RetailMath.Length(t.Path.GlobalSpheres[sphere].Center - ball.Center) - reach);
    }

    /// <summary>A sphere met a ball or a cylinder.</summary>
    /// <param name="trace">Who is told.</param>
    /// <param name="t">The transition.</param>
    /// <param name="sphere">Which sphere of the mover.</param>
    /// <param name="gap">Metres, negative inside; 0 for cylinders, which only say that they are met.</param>
    internal static void HitShape(this TraceBuffer trace, Transition t, int sphere, double gap)
    {
        SpherePath path = t.Path;
        trace.Subject = trace.Subject with { Sphere = (sbyte)sphere };
        TraceReason reason = path.InsertType == InsertType.Placement || path.ObstructionEthereal ? TraceReason.Overlaps
            : path.CheckingWalkable ? TraceReason.Supports : TraceReason.RunInto;
        trace.Add(Met(t, trace.Subject, default, (float)gap, reason));
    }

    /// <summary>A landing is asked for on what was just met.</summary>
    internal static void AsksToLand(this TraceBuffer trace) => trace.Landing = trace.Subject;

    /// <summary>The body rests on the contact plane that was just taken, which is the subject's.</summary>
    internal static void ContactTaken(this TraceBuffer trace, Transition t) => TakeContact(trace, t, trace.Subject, TraceReason.None);

    /// <summary>The body rests on the plane of the last accepted sub-step again.</summary>
    internal static void ContactRegained(this TraceBuffer trace, Transition t) =>
        TakeContact(trace, t, trace.LastContact, TraceReason.Regained);

    /// <summary>The body rests on a plane that nothing has.</summary>
    internal static void ContactMadeUp(this TraceBuffer trace, Transition t) =>
        TakeContact(trace, t, TraceSubject.None, TraceReason.MadeUp);

    /// <summary>A response asks further questions; <see cref="Settles"/> says what came of it.</summary>
    internal static void Tries(this TraceBuffer trace, Transition t, TransitionResponse response, in Vector3 normal)
    {
        trace.Add(Answering(t, TraceKind.Tried, trace.Subject, response, normal));
        trace.Hold();
    }

    /// <summary>What came of a response that asked further questions.</summary>
    internal static void Settles(
        this TraceBuffer trace, Transition t, TransitionResponse response, in Vector3 normal, bool succeeded,
        TraceReason reason = TraceReason.None)
    {
        trace.Resume();
        trace.Responded(t, response, normal, succeeded, reason);
    }

    internal static void Responded(
        this TraceBuffer trace, Transition t, TransitionResponse response, in Vector3 normal, bool succeeded,
        TraceReason reason = TraceReason.None) =>
        trace.Add(
            Answering(t, TraceKind.Responded, trace.Subject, response, normal) with
            {
                Succeeded = succeeded,
                Reason = succeeded ? TraceReason.None : reason,
            });

    /// <summary>The body leaves the edge behind.</summary>
    internal static void WalkedOff(this TraceBuffer trace, Transition t, TraceReason reason) =>
        trace.Add(Answering(t, TraceKind.Responded, trace.Subject, TransitionResponse.EdgeSlide, Vector3.Zero) with
        {
            Succeeded = true,
            Reason = reason,
        });

    private static void Remember(TraceBuffer trace, TraceReason reason)
    {
        if (reason == TraceReason.Deferred) trace.Deferred = trace.Subject;
        else if (reason == TraceReason.LandingAsked) trace.Landing = trace.Subject;
    }

    private static void TakeContact(TraceBuffer trace, Transition t, in TraceSubject subject, TraceReason reason)
    {
        trace.Contact = subject;
        trace.Add(
            Tried(t, TraceKind.ContactPlane, subject) with
            {
                Reason = reason,
                Plane = t.Collision.ContactPlane,
                PlaneCellId = t.Collision.ContactPlaneCellId,
            });
    }

    private static TraceEntry Resting(TraceBuffer trace, Transition t, TraceKind kind) => !t.Collision.ContactPlaneValid
        ? Accepted(t, kind, TraceSubject.None)
        : Accepted(t, kind, trace.Contact) with { Plane = t.Collision.ContactPlane, PlaneCellId = t.Collision.ContactPlaneCellId };

    private static TraceEntry Met(Transition t, in TraceSubject subject, in Plane plane, float gap, TraceReason reason) =>
        Tried(t, TraceKind.Hit, subject) with { Plane = plane, PlaneCellId = t.Path.CheckPos.CellId, Gap = gap, Reason = reason };

    private static TraceEntry Answering(
        Transition t, TraceKind kind, in TraceSubject subject, TransitionResponse response, Vector3 normal) =>
        Tried(t, kind, subject) with
        {
            Response = response,
            Plane = new Plane(RetailMath.NormalizeCheckSmall(ref normal) ? Vector3.Zero : normal, 0),
        };

    private static TraceEntry Tried(Transition t, TraceKind kind, in TraceSubject subject) => At(t, kind, subject, t.Path.CheckPos);

    private static TraceEntry Accepted(Transition t, TraceKind kind, in TraceSubject subject) => At(t, kind, subject, t.Path.CurrPos);

    private static TraceEntry At(Transition t, TraceKind kind, in TraceSubject subject, in Position place) =>
        new() { Kind = kind, Question = QuestionOf(t.Path), Subject = subject, Origin = place.Frame.Origin, CellId = place.CellId };

    private static SweepQuestion QuestionOf(SpherePath path)
    {
        if (path.InsertType == InsertType.InitialPlacement) return SweepQuestion.FirstPlace;
        if (path.InsertType == InsertType.Placement) return SweepQuestion.Place;
        if (path.CheckingWalkable) return SweepQuestion.Footing;
        if (path.SteppingDown) return path.SteppingUp ? SweepQuestion.StepUp : SweepQuestion.StepDown;
        return path.Collide ? SweepQuestion.Land : SweepQuestion.Move;
    }

    internal static TraceSubject SubjectOf(ObjCell cell) =>
        TraceSubject.None with { Kind = CellIds.IsOutdoor(cell.Id) ? TraceSubjectKind.Ground : TraceSubjectKind.Room, CellId = cell.Id };

    private static TraceSubject SubjectOf(TraceBuffer trace, WorldObject target) => SubjectOf(target, trace.Subject.CellId);

    internal static TraceSubject SubjectOf(WorldObject target, uint cellId) => TraceSubject.None with
    {
        Kind = target is StaticObject item ? item.IsScenery ? TraceSubjectKind.Scenery : TraceSubjectKind.Object : TraceSubjectKind.Body,
        CellId = cellId,
        ObjectId = target.Id,
        SetupId = target.Setup?.Id ?? 0,
    };
}
