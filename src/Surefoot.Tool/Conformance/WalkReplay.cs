using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance;

/// <summary>How the state after a replayed quantum differs from the recorded one.</summary>
internal enum StateDifference
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
/// <param name="Index">Which quantum, datagram or message, from 0; negative where there are none.</param>
/// <param name="Difference">What differs.</param>
/// <param name="Detail">How.</param>
/// <param name="Reason">Why it does not count; null when it does.</param>
internal sealed record Divergence(string CaseId, string Scene, int Index, StateDifference Difference, string Detail, string? Reason = null)
{
    /// <summary>The reason of those that rounding decides.</summary>
    internal const string LastBit = "hangs on a last bit";

    /// <summary>In one line.</summary>
    public override string ToString() =>
        $"{CaseId} {Scene} {(Index < 0 ? "" : $"#{Index} ")}{Difference}: {Detail}{(Reason is null ? "" : $" ({Reason})")}";
}

/// <summary>What a replay of a walk came to.</summary>
/// <param name="Quanta">Quanta recorded.</param>
/// <param name="Equal">Quanta equal.</param>
/// <param name="LastBit">Quanta that differ and hang on a last bit; known when re-seated.</param>
/// <param name="First">First difference.</param>
internal readonly record struct WalkOutcome(int Quanta, int Equal, int LastBit, Divergence? First);

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
    /// Replays one case. Re-seated, each quantum begins from the recorded state; free-running, from where the replay is.
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
            Divergence placed = new(walk.Id, walk.Scene, -1, StateDifference.Placement, $"placed {result}, recorded {walk.Placed}");
            return new WalkOutcome(walk.Quanta?.Length ?? 0, 0, 0, placed);
        }

        if (walk.Start is null || walk.Quanta is null) return default;
        Divergence? first = null;
        StateDifference start = Compare(body, walk.Start);
        if (start != StateDifference.None) first = new Divergence(walk.Id, walk.Scene, -1, start, Describe(body, walk.Start));

        // The recorded start has no more than the state; the orientation is that of the placement.
        Frame facing = place.Frame;
        WalkQuantum before = walk.Start;
        int equal = 0, lastBit = 0;
        for (int i = 0; i < walk.Quanta.Length; i++)
        {
            WalkQuantum quantum = walk.Quanta[i], from = before;
            if (reseat) Seat(body, from, facing, from.Pos);
            StateDifference difference = Advance(body, motion, quantum);
            before = quantum;
            if (difference == StateDifference.None)
            {
                equal++;
                continue;
            }

            string detail = Describe(body, quantum);
            string? reason = null;
            if (reseat && LastBit.Decides(from.Pos, at =>
                {
                    Seat(body, from, facing, at);
                    return Advance(body, motion, quantum) == StateDifference.None;
                }))
            {
                lastBit++;
                reason = Divergence.LastBit;
            }

            first ??= new Divergence(walk.Id, walk.Scene, i, difference, detail, reason);
        }

        return new WalkOutcome(walk.Quanta.Length, equal, lastBit, first);
    }

    private static StateDifference Advance(PhysicsBody body, RecordedMotion motion, WalkQuantum quantum)
    {
        body.SetActive(true);
        if (quantum.Jump is { } jump)
        {
            body.SetOnWalkable(false);
            body.SetVelocity(jump);
        }

        motion.Offset = quantum.Off;
        body.AdvanceQuantum(quantum.Q, sweepWithoutSpheres: true);
        return Compare(body, quantum);
    }

    private static void Seat(PhysicsBody body, WalkQuantum state, Frame facing, Vector3 at)
    {
        facing.Origin = at;
        body.Seat(new BodySeat(
            new Position(state.Cell, facing), state.Vel, (TransientState)state.Ts, state.Plane, state.Pcell, state.Slide));
    }

    private static StateDifference Compare(PhysicsBody body, WalkQuantum quantum)
    {
        if (body.Position.CellId != quantum.Cell) return StateDifference.Cell;
        if (!((body.Position.Frame.Origin - quantum.Pos).Length() <= PositionTolerance)) return StateDifference.Position;
        if (((body.Transient ^ (TransientState)quantum.Ts) & Compared) != 0) return StateDifference.Flags;
        return (body.Velocity - quantum.Vel).Length() <= VelocityTolerance ? StateDifference.None : StateDifference.Velocity;
    }

    private static string Describe(PhysicsBody body, WalkQuantum quantum) =>
        $"{Describe(body.Position.CellId, body.Position.Frame.Origin, body.Velocity, (uint)body.Transient)}, " +
        $"recorded {Describe(quantum.Cell, quantum.Pos, quantum.Vel, quantum.Ts)}";

    private static string Describe(uint cell, Vector3 at, Vector3 velocity, uint bits) => FormattableString.Invariant(
        $"at {cell:X8} ({at.X:0.####}, {at.Y:0.####}, {at.Z:0.####}) bits {bits & (uint)Compared:X2} velocity {velocity:0.##}");
}
