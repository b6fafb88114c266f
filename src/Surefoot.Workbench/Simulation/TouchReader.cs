using System.Numerics;
using Surefoot.Physics.Decisions;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// What a body stands on and touches, as its own sweeps tell: it stands on what its contact plane came from, and it touches what it slid
/// along or was stopped by. A body that does not move is not swept, and a sweep that is bent along the wall of the one before does not meet
/// that wall again: both keep what was told last.
/// </summary>
/// <param name="nameOf">Names a body by its id.</param>
internal sealed class TouchReader(Func<uint, (TouchKind Kind, string Name)> nameOf)
{
    private readonly List<Touch> touched = [];
    private readonly List<Touch> before = [];
    private Touch? footing;

    /// <summary>Takes in what was told since the last time, and clears it.</summary>
    public void Read(TraceBuffer trace)
    {
        foreach (ref readonly TraceEntry entry in trace.Entries)
        {
            switch (entry.Kind)
            {
                case TraceKind.SweepBegins:
                    before.Clear();
                    before.AddRange(touched);
                    if (entry.Question == SweepQuestion.Place) touched.Clear();
                    break;
                case TraceKind.SubStepBegins when entry.Index == 0:
                    touched.Clear();
                    break;
                case TraceKind.Bent when entry.Reason is TraceReason.AlongWall or TraceReason.AlongCrease:
                    foreach (Touch one in before) Add(one);
                    break;
                case TraceKind.Responded when IsTouch(entry):
                    Add(ToTouch(entry, isFooting: false));
                    break;
                case TraceKind.SweepEnds when entry.Succeeded:
                    Stand(entry);
                    break;
                case TraceKind.SweepEnds:
                    // The body stays where it was.
                    touched.Clear();
                    touched.AddRange(before);
                    break;
            }
        }

        trace.Clear();
    }

    /// <summary>Lists what the body stands on, first, and what it touches.</summary>
    /// <param name="into">Is filled anew.</param>
    public void CopyTo(List<Touch> into)
    {
        into.Clear();
        if (footing is { } under) into.Add(under);
        into.AddRange(touched);
    }

    /// <summary>Slid along it, was stopped by it, or could not land on it.</summary>
    private static bool IsTouch(in TraceEntry entry) =>
        entry.Subject.Kind is not (TraceSubjectKind.None or TraceSubjectKind.AsBefore) && entry.Plane.Normal != Vector3.Zero &&
        (entry.Response is TransitionResponse.Slide or TransitionResponse.Stop ||
            entry is { Response: TransitionResponse.Landing, Succeeded: false });

    private void Stand(in TraceEntry end)
    {
        if (end.Subject.Kind == TraceSubjectKind.None) footing = null;
        else if (end.Subject.Kind != TraceSubjectKind.AsBefore) footing = ToTouch(end, isFooting: true);
    }

    private void Add(Touch one)
    {
        touched.RemoveAll(other => other.Kind == one.Kind && other.Id == one.Id);
        touched.Add(one);
    }

    private Touch ToTouch(in TraceEntry entry, bool isFooting)
    {
        TraceSubject subject = entry.Subject;
        (TouchKind kind, uint id, string name) = subject.Kind switch
        {
            TraceSubjectKind.Ground => (TouchKind.Ground, subject.CellId, ""),
            TraceSubjectKind.Room => (TouchKind.Room, subject.CellId, ""),
            TraceSubjectKind.Building => (TouchKind.Building, subject.SetupId, ""),
            TraceSubjectKind.Scenery => (TouchKind.Scenery, subject.SetupId, ""),
            TraceSubjectKind.Body => Named(subject.ObjectId),
            _ => (TouchKind.Object, subject.SetupId, ""),
        };
        return new Touch(isFooting, kind, id, entry.Plane.Normal, name);
    }

    private (TouchKind Kind, uint Id, string Name) Named(uint id)
    {
        (TouchKind kind, string name) = nameOf(id);
        return (kind, id, name);
    }
}
