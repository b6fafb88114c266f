using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>One thing to do on the way: a turn to a heading, or the move itself.</summary>
/// <param name="IsMove">The move; else a turn.</param>
/// <param name="Heading">Where the turn leads, degrees.</param>
internal readonly record struct MoveToNode(bool IsMove, float Heading);

/// <summary>
/// Walks a body to a place or an object, or turns it to one, by the motions that a key would give. The orders are here; what is done of
/// them each quantum is in
/// <c>Progress</c>, the queue of turns and moves in <c>Nodes</c>.
/// </summary>
/// <remarks>Retail: MoveToManager; specification 09b, 6.</remarks>
internal sealed partial class MoveToManager
{
    private const float ReportRadius = 0.5f;
    private const double FirstReportQuantum = 0.0;

    private readonly SteeredBody body;
    private readonly RingQueue<MoveToNode> nodes = new(4);
    private MovementParameters mp = new();
    private Position sought;
    private Position currentTarget;
    private Position start = Position.Nowhere;
    private uint topLevelId;
    private float soughtRadius;
    private float soughtHeight;

    internal MoveToManager(SteeredBody body)
    {
        this.body = body;
        Initialise();
    }

    /// <summary>The order under way, one of the last four kinds; 0 for none.</summary>
    internal MovementKind Kind { get; private set; }

    /// <summary>An order is under way.</summary>
    /// <remarks>Retail: MoveToManager::is_moving_to @0x00529220.</remarks>
    internal bool IsMovingTo => Kind != 0;

    /// <summary>Number of turns and moves that are left.</summary>
    internal int NodeCount => nodes.Count;

    /// <summary>A turn or move that is left, the next at 0.</summary>
    internal MoveToNode NodeAt(int index) => nodes[index];

    /// <summary>The object has reported and the way is planned.</summary>
    internal bool IsInitialised { get; private set; }

    /// <summary>What every new order ends: the one under way, and sticking.</summary>
    /// <remarks>Retail: the beginning of MoveToManager::PerformMovement @0x0052A900.</remarks>
    internal void Interrupt()
    {
        Cancel(MotionError.Cancelled);
        body.Unstick();
    }

    /// <summary>Moves to an object.</summary>
    /// <param name="topLevel">Whoever holds it, or the object itself: its place is what counts.</param>
    /// <param name="radius">Radius of the object itself, metres.</param>
    /// <param name="height">Height of the object itself, metres.</param>
    /// <param name="parameters">How.</param>
    /// <remarks>
    /// Retail: MoveToManager::MoveToObject @0x00529680. The object's first report plans the way; when it exists that is inside this call.
    /// </remarks>
    internal void MoveToObject(uint topLevel, float radius, float height, in MovementParameters parameters)
    {
        body.StopCompletely();
        start = body.Position;
        soughtRadius = radius;
        soughtHeight = height;
        BeginWithTarget(MovementKind.MoveToObject, topLevel, parameters);
    }

    /// <summary>Moves to a place.</summary>
    /// <remarks>
    /// Retail: MoveToManager::MoveToPosition @0x0052A240. The first look at the distance goes from centre to centre whatever the parameters
    /// say: they are taken over only after it.
    /// </remarks>
    internal void MoveToPosition(in Position place, in MovementParameters parameters)
    {
        body.StopCompletely();
        currentTarget = place;
        soughtRadius = 0;
        float distance = (float)GetCurrentDistance();
        if (MoveToChoice.Of(parameters, distance).Command != MotionCommand.None)
        {
            AddTurn(body.Position.HeadingTo(place));
            AddMove();
        }

        if (parameters.Has(MovementFlags.UseFinalHeading)) AddTurn(parameters.DesiredHeading);
        sought = place;
        start = body.Position;
        Kind = MovementKind.MoveToPosition;
        TakeWithoutSticky(parameters);
        BeginNextNode();
    }

    /// <summary>Turns to face an object. The heading in the parameters has no effect.</summary>
    /// <remarks>Retail: MoveToManager::TurnToObject @0x005297D0.</remarks>
    internal void TurnToObject(uint topLevel, in MovementParameters parameters)
    {
        if (parameters.Has(MovementFlags.StopCompletely)) body.StopCompletely();
        BeginWithTarget(MovementKind.TurnToObject, topLevel, parameters);
    }

    /// <summary>Turns to a heading.</summary>
    /// <remarks>Retail: MoveToManager::TurnToHeading @0x0052A630.</remarks>
    internal void TurnToHeading(in MovementParameters parameters)
    {
        if (parameters.Has(MovementFlags.StopCompletely)) body.StopCompletely();
        TakeWithoutSticky(parameters);
        Kind = MovementKind.TurnToHeading;
        AddTurn(parameters.DesiredHeading);
        BeginNextNode();
    }

    /// <summary>The body stands again: what it was doing is begun anew. An order that still waits for its object is over.</summary>
    /// <remarks>Retail: MoveToManager::HitGround @0x00529D70.</remarks>
    internal void HitGround()
    {
        if (IsMovingTo) BeginNextNode();
    }

    /// <summary>A report of the tracked object.</summary>
    /// <remarks>Retail: MoveToManager::HandleUpdateTarget @0x0052A7D0.</remarks>
    internal void HandleUpdateTarget(in TargetInfo info)
    {
        if (info.ObjectId != topLevelId) return;
        if (IsInitialised)
        {
            if (info.Status != TargetStatus.OK) Cancel(MotionError.TargetGone);
            else if (Kind == MovementKind.MoveToObject) FollowTarget(info);
        }
        else if (info.Status != TargetStatus.OK)
        {
            Cancel(MotionError.NoTarget);
        }
        else if (Kind == MovementKind.MoveToObject)
        {
            PlanMoveToObject(info);
        }
        else if (Kind == MovementKind.TurnToObject)
        {
            PlanTurnToObject(info);
        }
    }

    /// <summary>Ends an order under way: everything stops.</summary>
    /// <remarks>Retail: MoveToManager::CancelMoveTo @0x00529930. Retail has no use for the error.</remarks>
    internal void Cancel(MotionError error)
    {
        if (!IsMovingTo) return;
        nodes.Clear();
        body.OnMoveToEnded(error);
        CleanUp();
        body.StopCompletely();
    }

    internal void AddTo(ref StateHash hash)
    {
        hash.Add((ulong)Kind);
        hash.Add((ulong)nodes.Count);
        for (int i = 0; i < nodes.Count; i++) hash.Add(nodes[i].IsMove ? -1f : nodes[i].Heading);
        hash.Add((uint)mp.Flags);
        hash.Add(topLevelId);
        hash.Add(sought);
        hash.Add(currentTarget);
        hash.Add(start);
        AddProgressTo(ref hash);
    }

    private void BeginWithTarget(MovementKind kind, uint topLevel, in MovementParameters parameters)
    {
        Kind = kind;
        topLevelId = topLevel;
        mp = parameters;
        IsInitialised = false;
        if (topLevel == body.Id) Finish();
        else body.SetTarget(0, topLevel, ReportRadius, FirstReportQuantum);
    }

    /// <remarks>
    /// Retail: MoveToManager::MoveToObject_Internal @0x0052A400. The last heading counts from the first direction to the object.
    /// </remarks>
    private void PlanMoveToObject(in TargetInfo info)
    {
        sought = info.InterpolatedPosition;
        currentTarget = info.TargetPosition;
        float heading = body.Position.HeadingTo(info.InterpolatedPosition);
        float distance = (float)GetCurrentDistance();
        if (MoveToChoice.Of(mp, distance).Command != MotionCommand.None)
        {
            AddTurn(heading);
            AddMove();
        }

        if (mp.Has(MovementFlags.UseFinalHeading)) AddTurn(Headings.Add(heading, mp.DesiredHeading));
        IsInitialised = true;
        BeginNextNode();
    }

    /// <remarks>Retail: MoveToManager::TurnToObject_Internal @0x0052A550.</remarks>
    private void PlanTurnToObject(in TargetInfo info)
    {
        currentTarget = info.TargetPosition;
        float goal = (float)((body.Position.HeadingTo(currentTarget) + sought.Frame.Heading) % 360.0);
        sought.Frame.SetHeading(goal);
        AddTurn(goal);
        IsInitialised = true;
        BeginNextNode();
    }

    /// <summary>
    /// The references of progress become infinitely far. Moving away that looks like no progress from the second second on: load-bearing,
    /// it is what makes a fleeing body overshoot.
    /// </summary>
    private void FollowTarget(in TargetInfo info)
    {
        sought = info.InterpolatedPosition;
        currentTarget = info.TargetPosition;
        ResetProgress(float.MaxValue);
    }

    private void TakeWithoutSticky(in MovementParameters parameters)
    {
        mp = parameters;
        mp.Flags &= ~MovementFlags.Sticky;
    }

    /// <remarks>Retail: MoveToManager::CleanUpAndCallWeenie @0x00529650.</remarks>
    private void Finish()
    {
        body.OnMoveToEnded(MotionError.None);
        CleanUp();
        body.StopCompletely();
    }

    /// <remarks>Retail: MoveToManager::CleanUp @0x005295C0.</remarks>
    private void CleanUp()
    {
        MovementParameters p = ParametersOfStops();
        if (CurrentCommand != MotionCommand.None) body.StopMotion(CurrentCommand, ref p);
        if (AuxCommand != MotionCommand.None) body.StopMotion(AuxCommand, ref p);
        if (topLevelId != 0 && IsMovingTo) body.ClearTarget();
        Initialise();
    }

    /// <remarks>
    /// Retail: MoveToManager::InitializeLocalVariables @0x00529250. Distances and speed of the last order stay; its flags do not.
    /// </remarks>
    private void Initialise()
    {
        Kind = 0;
        mp.Flags = MovementFlags.None;
        mp.ContextId = 0;
        ResetProgress(float.MaxValue);
        PreviousHeading = 0;
        StallCount = 0;
        CurrentCommand = AuxCommand = MotionCommand.None;
        IsMovingAway = false;
        IsInitialised = false;
        topLevelId = 0;
        soughtRadius = soughtHeight = 0;
        sought = currentTarget = Position.Nowhere;
    }
}
