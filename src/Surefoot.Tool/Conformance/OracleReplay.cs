using System.Numerics;
using Surefoot.Dats;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance;

/// <summary>One compared result of a peer as it is.</summary>
/// <param name="Id">Case.</param>
/// <param name="Quantum">Which quantum of a walk, from 0; null for the others.</param>
/// <param name="Family">Kind of case.</param>
/// <param name="Tag">Where it was aimed at.</param>
/// <param name="Difference">What differs; null when nothing does.</param>
/// <param name="Departure">Why a difference is expected although the result is not listed; null when none is.</param>
/// <param name="HangsOnLastBit">The difference is one of rounding.</param>
internal sealed record OracleResult(
    string Id, int? Quantum, string Family, string Tag, string? Difference, string? Departure = null, bool HangsOnLastBit = false);

/// <summary>
/// Replays cases recorded from a peer as it is: single sweeps, placements, and walks re-seated before each quantum. Results that known
/// departures of the peer change are listed beside them; the lists leave out two departures that the mover's state word tells
/// (<see cref="DepartureOf"/>).
/// </summary>
internal sealed class OracleReplay(PhysicsEngine engine, Func<uint, SetupAsset> setups)
{
    private const double Tolerance = 0.001;
    private const double NormalTolerance = 1e-4;
    private const double VelocityTolerance = 0.01;
    private const TransientState Compared = (TransientState)0x7F;

    private readonly WorldQuery query = engine.CreateQuery();

    /// <summary>The kinds of cases.</summary>
    internal static readonly string[] Families = ["placement", "transition", "walk"];

    /// <summary>A replay over a world of these landblocks, with its rooms read as the peer reads them.</summary>
    internal static OracleReplay Over(IDatSource source, IEnumerable<uint> blocks)
    {
        PhysicsDataCache cache = new(new PeerPortals(source));
        PhysicsEngine engine = new(cache) { RefuseLeavingCells = true };
        foreach (uint id in blocks) engine.World.LoadLandblock(id);
        return new OracleReplay(engine, cache.GetSetup);
    }

    /// <summary>Replays a case.</summary>
    internal List<OracleResult> Run(OracleCase one)
    {
        List<PhysicsBody> bodies = [];
        try
        {
            foreach (OracleBody other in one.Others ?? [])
            {
                PhysicsBody body = Create(other);
                bodies.Add(body);
                body.SetPosition(new PlacementRequest(PositionOf(other.Request!, Quaternion.Identity), PlacementFlags.None));
            }

            PhysicsBody mover = Create(one.Mover);
            bodies.Add(mover);
            return one.Family switch
            {
                "transition" => [Sweep(mover, one)],
                "placement" => [Place(mover, one)],
                _ => Walk(mover, one),
            };
        }
        finally
        {
            foreach (PhysicsBody body in bodies) engine.RemoveBody(body);
        }
    }

    /// <summary>How a list of departures names a result.</summary>
    internal static string KeyOf(string id, int? quantum) => quantum is { } number ? $"{id}/{number}" : id;

    /// <summary>
    /// The results of a file of cases that known departures change: <c>departures-201.jsonl.gz</c> lists those of <c>walk-201.jsonl.gz</c>.
    /// </summary>
    /// <returns>Their keys; empty when there is no list beside the file.</returns>
    internal static HashSet<string> DeparturesBeside(string path)
    {
        string name = Path.GetFileName(path), folder = Path.GetDirectoryName(Path.GetFullPath(path))!;
        string list = Path.Combine(folder, "departures" + name[Math.Max(0, name.IndexOf('-', StringComparison.Ordinal))..]);
        if (!File.Exists(list)) return [];
        using VectorFile file = VectorFile.Open(list);
        return [.. file.Read(OracleDeparture.Parse).Select(departure => departure.Key)];
    }

    /// <summary>
    /// What the peer does differently in every quantum of such a mover. A missile that follows its path is pitched about y instead of x
    /// (specification 03, 4.1.4), so that its sphere is elsewhere; a sled is not accelerated, slips where retail grips, and pitches (02,
    /// section 5).
    /// </summary>
    private static string? DepartureOf(PhysicsState state) =>
        (state & PhysicsState.AlignPath) != 0 ? "heading of a missile" : (state & PhysicsState.Sledding) != 0 ? "sled" : null;

    private OracleResult Sweep(PhysicsBody mover, OracleCase one)
    {
        OracleState begin = one.Begin!;
        Position end = PositionOf(one.End!, Quaternion.Identity);
        string? difference = SweepFrom(begin.Pos);
        bool hangs = difference is not null && LastBit.Decides(begin.Pos, at => SweepFrom(at) is null);
        return new OracleResult(one.Id, null, one.Family, one.Tag, difference, null, hangs);

        string? SweepFrom(Vector3 at)
        {
            Seat(mover, begin with { Pos = at }, Quaternion.Identity);
            return CompareSweep(query.Sweep(mover, end), one.Out!);
        }
    }

    private static OracleResult Place(PhysicsBody mover, OracleCase one)
    {
        PlacementFlags flags = one.Slide ? PlacementFlags.Slide : PlacementFlags.None;
        PlacementResult placed = mover.SetPosition(new PlacementRequest(PositionOf(one.Request!, Quaternion.Identity), flags));
        OracleOutcome recorded = one.Out!;
        string? difference = placed.ToString() != recorded.Result ? $"{placed}, recorded {recorded.Result}"
            : placed == PlacementResult.OK && mover.HasCell && recorded is { Cell: { } cell, Pos: { } pos }
                ? CompareBody(mover, cell, pos, recorded.Ts, recorded.Sliding)
                : null;
        return new OracleResult(one.Id, null, one.Family, one.Tag, difference);
    }

    private static List<OracleResult> Walk(PhysicsBody mover, OracleCase walk)
    {
        List<OracleResult> results = [];
        RecordedMotion motion = new();
        SteeredPhysicsBody.Of(mover).Attach(motion);
        OracleState before = walk.Start!;
        Quaternion facing = Quaternion.Identity;
        foreach (OracleQuantum quantum in walk.Quanta!)
        {
            OracleState seat = before;
            Quaternion faced = facing;
            PhysicsState state = mover.State;
            string? departure = DepartureOf(state);
            if (quantum.Root is { } root) motion.Offset = RetailMath.Scale(root, walk.Q);
            string? difference = DifferenceFrom(seat.Pos);
            bool hangs = difference is not null && departure is null && LastBit.Decides(seat.Pos, at =>
            {
                mover.SetState(state);
                return DifferenceFrom(at) is null;
            });
            if (difference is null) departure = null;
            results.Add(new OracleResult(walk.Id, results.Count, walk.Family, walk.Tag, difference, departure, hangs));
            if (hangs) mover.SetState(state);
            if (quantum.State is { } changed) mover.SetState((PhysicsState)changed.Value);
            facing = seat.Quat ?? faced;
            before = quantum;

            string? DifferenceFrom(Vector3 at)
            {
                Seat(mover, seat with { Pos = at }, faced);
                if (quantum.Leave) mover.SetOnWalkable(false);
                if (quantum.SetVelocity is { } velocity) mover.SetVelocity(velocity);
                mover.SetActive(true);
                mover.AdvanceQuantum(walk.Q, sweepWithoutSpheres: true);
                string? difference = CompareBody(mover, quantum.Cell, quantum.Pos, quantum.Ts, quantum.Sliding);
                return difference ?? (departure is null ? CompareVelocity(mover, quantum) : null);
            }
        }

        return results;
    }

    private static string? CompareSweep(in SweepResult swept, OracleOutcome recorded)
    {
        if (swept.Found != recorded.Found) return $"found {swept.Found}, recorded {recorded.Found}";
        if (!recorded.Found) return null;
        if (recorded is not { PosCell: { } cell, Pos: { } at })
            throw new InvalidDataException("not a recorded result of a peer: its result has no position.");
        if (swept.Position.CellId != cell) return $"cell {swept.Position.CellId:X8}, recorded {cell.Value:X8}";
        if (!((swept.Position.Frame.Origin - at).Length() <= Tolerance)) return $"position {swept.Position.Frame.Origin}, recorded {at}";
        bool contact = swept.Contact is not null;
        if (contact != recorded.Contact) return $"contact {contact}, recorded {recorded.Contact}";
        return SameNormal(swept.SlidingNormal, recorded.Sliding) ? null : "sliding normal";
    }

    private static string? CompareBody(PhysicsBody body, uint cell, Vector3 at, uint bits, Vector3? sliding)
    {
        if (body.Position.CellId != cell) return $"cell {body.Position.CellId:X8}, recorded {cell:X8}";
        if (!((body.Position.Frame.Origin - at).Length() <= Tolerance)) return $"position {body.Position.Frame.Origin}, recorded {at}";
        TransientState found = body.Transient & Compared, expected = (TransientState)bits & Compared;
        if (found != expected) return $"bits {found}, recorded {expected}";
        return SameNormal((body.Transient & TransientState.Sliding) != 0 ? body.SlidingNormal : null, sliding) ? null : "sliding normal";
    }

    private static string? CompareVelocity(PhysicsBody body, OracleQuantum quantum) =>
        (body.Velocity - quantum.Vel).Length() <= VelocityTolerance ? null : $"velocity {body.Velocity}, recorded {quantum.Vel}";

    private static bool SameNormal(Vector3? sliding, Vector3? recorded) =>
        recorded is { } expected ? sliding is { } normal && (normal - expected).Length() <= NormalTolerance : sliding is null;

    private PhysicsBody Create(OracleBody body)
    {
        WeenieTraits weenie = WeenieTraits.Present;
        if (body.Player) weenie |= WeenieTraits.Player;
        if (body.Creature) weenie |= WeenieTraits.Creature;
        return engine.CreateBody(body.Id, setups(body.Setup), (PhysicsState)body.State.Value, weenie, body.Scale ?? 1f);
    }

    private static void Seat(PhysicsBody body, OracleState state, Quaternion facing) => body.Seat(new BodySeat(
        PositionOf(state.Place, facing), state.Vel, (TransientState)state.Ts.Value, state.Plane, state.PlaneCell,
        state.Sliding ?? Vector3.Zero, state.CollidingEnv));

    private static Position PositionOf(OraclePlace place, Quaternion facing) => new(place.Cell, new Frame(place.Pos, place.Quat ?? facing));
}
