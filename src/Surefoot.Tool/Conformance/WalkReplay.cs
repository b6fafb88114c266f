using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance;

/// <summary>How a replayed step differs from the recorded one.</summary>
internal enum StepDifference
{
    /// <summary>Not at all.</summary>
    None,

    /// <summary>Placed where the record was not, or the other way round.</summary>
    Placement,

    /// <summary>Another cell.</summary>
    Cell,

    /// <summary>More than a millimetre away.</summary>
    Position,

    /// <summary>Other contact, walkable, sliding, water or stationary bits.</summary>
    Flags,

    /// <summary>More than a centimetre a second faster, slower or elsewhere.</summary>
    Velocity,

    /// <summary>Another result of a recording of another kind.</summary>
    Result,
}

/// <summary>A divergence, for people.</summary>
/// <param name="CaseId">The case.</param>
/// <param name="Scene">What it was aimed at.</param>
/// <param name="Step">Step, datagram or message; negative where there are none.</param>
/// <param name="Difference">What differs.</param>
/// <param name="Detail">How.</param>
/// <param name="Reason">Why it does not count; null when it does.</param>
internal sealed record Divergence(string CaseId, string Scene, int Step, StepDifference Difference, string Detail, string? Reason = null)
{
    /// <summary>The reason of those that rounding decides.</summary>
    internal const string LastBit = "hangs on a last bit";

    /// <summary>In one line.</summary>
    public override string ToString() =>
        $"{CaseId} {Scene} {(Step < 0 ? "" : $"step {Step} ")}{Difference}: {Detail}{(Reason is null ? "" : $" ({Reason})")}";
}

/// <summary>What a replay of a walk came to.</summary>
/// <param name="Steps">Steps recorded.</param>
/// <param name="Equal">Steps equal.</param>
/// <param name="LastBit">Steps that differ and hang on a last bit; known when re-seated.</param>
/// <param name="First">First difference.</param>
internal readonly record struct WalkOutcome(int Steps, int Equal, int LastBit, Divergence? First);

/// <summary>Replays recorded walks in an engine that nobody else uses; each leaves it as it was.</summary>
internal sealed class WalkReplay(PhysicsEngine engine, Func<uint, SetupAsset> setups)
{
    private const double PositionTolerance = 0.001;
    private const double VelocityTolerance = 0.01;
    private const uint MoverId = 0x50000001;
    private const uint FirstOtherId = 0x60000001;
    private const TransientState Compared = (TransientState)0x7F;
    private const PhysicsState BodyState = PhysicsState.Gravity | PhysicsState.ReportCollisions | PhysicsState.EdgeSlide;

    /// <summary>
    /// Replays one case. Re-seated, each step begins from the recorded state; free-running, from where the replay is.
    /// </summary>
    internal WalkOutcome Run(WalkCase walk, bool reseat)
    {
        // The recorder keeps a body that would leave its cells where it is (specification 02, 5, UpdateObjectInternal).
        engine.RefuseLeavingCells = true;
        List<PhysicsBody> all = [];
        try
        {
            foreach (WalkOther other in walk.Others ?? [])
            {
                PhysicsBody creature = engine.CreateBody(
                    FirstOtherId + (uint)all.Count, setups(other.Setup), BodyState, WeenieTraits.Present | WeenieTraits.Creature);
                all.Add(creature);
                creature.SetPosition(new PlacementRequest(new Position(other.Cell, other.Pos), PlacementFlags.Slide));
            }

            PhysicsBody body = engine.CreateBody(
                MoverId, setups(walk.Setup), BodyState, WeenieTraits.Present | WeenieTraits.Player | WeenieTraits.Creature);
            all.Add(body);
            RecordedMotion motion = new();
            SteeredPhysicsBody.Of(body).Attach(motion);
            return Replay(walk, body, motion, reseat);
        }
        finally
        {
            foreach (PhysicsBody b in all) engine.RemoveBody(b);
        }
    }

    private static WalkOutcome Replay(WalkCase walk, PhysicsBody body, RecordedMotion motion, bool reseat)
    {
        Position place = new(walk.Place.Cell, new Frame(walk.Place.Pos, Quaternion.CreateFromAxisAngle(Vector3.UnitZ, walk.Place.Yaw)));
        PlacementResult result = body.SetPosition(new PlacementRequest(place, PlacementFlags.Slide));
        if (result == PlacementResult.OK != (walk.Placed == "OK"))
        {
            Divergence placed = new(walk.Id, walk.Scene, -1, StepDifference.Placement, $"placed {result}, recorded {walk.Placed}");
            return new WalkOutcome(walk.Steps?.Length ?? 0, 0, 0, placed);
        }

        if (walk.Start is null || walk.Steps is null) return default;
        Divergence? first = null;
        StepDifference start = Compare(body, walk.Start);
        if (start != StepDifference.None) first = new Divergence(walk.Id, walk.Scene, -1, start, Describe(body, walk.Start));

        // The recorded start has no more than the state; the orientation is that of the placement.
        Frame facing = place.Frame;
        WalkStep before = walk.Start;
        int equal = 0, lastBit = 0;
        for (int i = 0; i < walk.Steps.Length; i++)
        {
            WalkStep step = walk.Steps[i], from = before;
            if (reseat) Seat(body, from, facing, from.Pos);
            StepDifference difference = Advance(body, motion, step);
            before = step;
            if (difference == StepDifference.None)
            {
                equal++;
                continue;
            }

            string detail = Describe(body, step);
            string? reason = null;
            if (reseat && LastBit.Decides(from.Pos, at =>
                {
                    Seat(body, from, facing, at);
                    return Advance(body, motion, step) == StepDifference.None;
                }))
            {
                lastBit++;
                reason = Divergence.LastBit;
            }

            first ??= new Divergence(walk.Id, walk.Scene, i, difference, detail, reason);
        }

        return new WalkOutcome(walk.Steps.Length, equal, lastBit, first);
    }

    private static StepDifference Advance(PhysicsBody body, RecordedMotion motion, WalkStep step)
    {
        body.SetActive(true);
        if (step.Jump is { } jump)
        {
            body.SetOnWalkable(false);
            body.SetVelocity(jump);
        }

        motion.Offset = step.Off;
        body.AdvanceQuantum(step.Q, sweepWithoutSpheres: true);
        return Compare(body, step);
    }

    private static void Seat(PhysicsBody body, WalkStep state, Frame facing, Vector3 at)
    {
        facing.Origin = at;
        body.Seat(new BodySeat(
            new Position(state.Cell, facing), state.Vel, (TransientState)state.Ts, state.Plane, state.Pcell, state.Slide));
    }

    private static StepDifference Compare(PhysicsBody body, WalkStep step)
    {
        if (body.Position.CellId != step.Cell) return StepDifference.Cell;
        if (!((body.Position.Frame.Origin - step.Pos).Length() <= PositionTolerance)) return StepDifference.Position;
        if (((body.Transient ^ (TransientState)step.Ts) & Compared) != 0) return StepDifference.Flags;
        return (body.Velocity - step.Vel).Length() <= VelocityTolerance ? StepDifference.None : StepDifference.Velocity;
    }

    private static string Describe(PhysicsBody body, WalkStep step) =>
        $"{Describe(body.Position.CellId, body.Position.Frame.Origin, body.Velocity, (uint)body.Transient)}, " +
        $"recorded {Describe(step.Cell, step.Pos, step.Vel, step.Ts)}";

    private static string Describe(uint cell, Vector3 at, Vector3 velocity, uint bits) => FormattableString.Invariant(
        $"at {cell:X8} ({at.X:0.####}, {at.Y:0.####}, {at.Z:0.####}) bits {bits & (uint)Compared:X2} velocity {velocity:0.##}");
}
