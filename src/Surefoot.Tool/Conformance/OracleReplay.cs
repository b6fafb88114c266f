using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Surefoot.Dats;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance;

/// <summary>
/// Replays cases recorded from a peer as it is: single sweeps, placements, and walks re-seated before each step. Results that known departures of
/// the peer change are listed beside them; the lists leave out two departures that the mover's state word tells (<see cref="DepartureOf"/>).
/// </summary>
internal sealed class OracleReplay(ICellWorld world, Func<uint, SetupAsset> setups)
{
    private const double Tolerance = 0.001;
    private const double NormalTolerance = 1e-4;
    private const double VelocityTolerance = 0.01;
    private const TransientState Compared = (TransientState)0x7F;

    /// <summary>One compared result.</summary>
    /// <param name="Id">Case.</param>
    /// <param name="Step">Step of a walk, -1 for the others.</param>
    /// <param name="Family">Kind of case.</param>
    /// <param name="Tag">Where it was aimed at.</param>
    /// <param name="Difference">What differs; null when nothing does.</param>
    /// <param name="Departure">Why a difference is expected although the result is not listed; null when none is.</param>
    internal sealed record Result(string Id, int Step, string Family, string Tag, string? Difference, string? Departure = null);

    /// <summary>A replay over a world of these landblocks, with its rooms read as the peer reads them.</summary>
    internal static OracleReplay Over(IDatSource source, IEnumerable<uint> blocks)
    {
        PhysicsDataCache cache = new(new PeerPortals(source));
        PhysicsWorld world = new(cache);
        foreach (uint id in blocks) world.LoadLandblock(id);
        return new OracleReplay(world, cache.GetSetup);
    }

    /// <summary>Replays every case of a file.</summary>
    internal IEnumerable<Result> Run(string path)
    {
        foreach (JsonElement walk in ReadLines(path))
        {
            PhysicsEngine engine = new(world) { RefuseLeavingCells = true };
            List<PhysicsBody> bodies = [];
            if (walk.TryGetProperty("others", out JsonElement others) && others.ValueKind == JsonValueKind.Array)
                foreach (JsonElement other in others.EnumerateArray()) bodies.Add(Place(engine, other, PlacementFlags.None));
            PhysicsBody mover = Create(engine, walk.GetProperty("mover"));
            bodies.Add(mover);
            foreach (Result result in Replay(mover, walk)) yield return result;
            foreach (PhysicsBody body in bodies) engine.RemoveBody(body);
        }
    }

    /// <summary>Is the file one of a peer as it is? Its cases name their family.</summary>
    internal static bool Reads(string path) => ReadLines(path).Take(1).Any(first => first.TryGetProperty("family", out _));

    /// <summary>Is the file a list of departures? It is read beside the cases it belongs to.</summary>
    internal static bool IsDepartureList(string path) => ReadLines(path).Take(1).Any(first => first.TryGetProperty("differs", out _));

    /// <summary>Replays every case of a file and counts those apart that known departures change.</summary>
    internal void Score(string path, ConformanceReport report)
    {
        HashSet<string> departures = DeparturesBeside(path);
        foreach (Result result in Run(path)) report.Add(result, departures.Contains(result.Step < 0 ? result.Id : $"{result.Id}/{result.Step}"));
    }

    /// <summary>The list beside a file of cases: <c>departures-201.jsonl.gz</c> for <c>walk-201.jsonl.gz</c>; empty without one.</summary>
    internal static HashSet<string> DeparturesBeside(string path)
    {
        string name = Path.GetFileName(path);
        string list = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(path))!, "departures" + name[Math.Max(0, name.IndexOf('-', StringComparison.Ordinal))..]);
        return File.Exists(list) ? ReadDepartures(list) : [];
    }

    /// <summary>The results that known departures change, as <c>id</c> or <c>id/step</c>.</summary>
    internal static HashSet<string> ReadDepartures(string path) =>
        [.. ReadLines(path).Select(d => d.TryGetProperty("step", out JsonElement step) ? $"{d.GetProperty("id").GetString()}/{step.GetInt32()}" : d.GetProperty("id").GetString()!)];

    /// <summary>
    /// What the peer does differently in every quantum of such a mover. A missile that follows its path is pitched about y instead of x
    /// (specification 03, 4.1.4), so that its sphere is elsewhere; a sled is not accelerated, slips where retail grips, and pitches (02, section 5).
    /// </summary>
    private static string? DepartureOf(PhysicsState state) =>
        (state & PhysicsState.AlignPath) != 0 ? "heading of a missile" : (state & PhysicsState.Sledding) != 0 ? "sled" : null;

    private static IEnumerable<Result> Replay(PhysicsBody mover, JsonElement walk)
    {
        string id = walk.GetProperty("id").GetString()!, family = walk.GetProperty("family").GetString()!, tag = walk.GetProperty("tag").GetString()!;
        switch (family)
        {
            case "transition":
                Seat(mover, walk.GetProperty("begin"), Quaternion.Identity);
                ResolveResult swept = mover.Probe(PositionOf(walk.GetProperty("end"), Quaternion.Identity));
                yield return new Result(id, -1, family, tag, CompareSweep(swept, walk.GetProperty("out")));
                break;
            case "placement":
                PlacementFlags flags = walk.GetProperty("slide").GetBoolean() ? PlacementFlags.Slide : PlacementFlags.None;
                PlacementResult placed = mover.SetPosition(new PlacementRequest(PositionOf(walk.GetProperty("request"), Quaternion.Identity), flags));
                JsonElement expected = walk.GetProperty("out");
                string? difference = placed.ToString() != expected.GetProperty("result").GetString() ? $"{placed}, recorded {expected.GetProperty("result").GetString()}"
                    : placed == PlacementResult.OK && expected.TryGetProperty("pos", out _) && mover.HasCell ? CompareBody(mover, expected) : null;
                yield return new Result(id, -1, family, tag, difference);
                break;
            default:
                foreach (Result result in ReplayWalk(mover, walk, id, tag)) yield return result;
                break;
        }
    }

    private static IEnumerable<Result> ReplayWalk(PhysicsBody mover, JsonElement walk, string id, string tag)
    {
        float quantum = walk.GetProperty("q").GetSingle();
        RecordedMotion motion = new();
        mover.AttachMovement(motion);
        JsonElement before = walk.GetProperty("start");
        Quaternion facing = Quaternion.Identity;
        int index = 0;
        foreach (JsonElement step in walk.GetProperty("steps").EnumerateArray())
        {
            facing = Seat(mover, before, facing);
            if (step.TryGetProperty("root", out JsonElement root)) motion.Offset = RetailMath.Scale(Vector(root), quantum);
            if (step.TryGetProperty("leave", out JsonElement leave) && leave.ValueKind == JsonValueKind.True) mover.SetOnWalkable(false);
            if (step.TryGetProperty("set_velocity", out JsonElement velocity)) mover.SetVelocity(Vector(velocity));
            mover.SetActive(true);
            string? departure = DepartureOf(mover.State);
            mover.Step(quantum, sweepWithoutSpheres: true);
            string? difference = CompareBody(mover, step) ?? (departure is null ? CompareVelocity(mover, step) : null);
            yield return new Result(id, index++, "walk", tag, difference, departure);
            if (step.TryGetProperty("state", out JsonElement state)) mover.SetState((PhysicsState)Hex(state));
            before = step;
        }
    }

    private static string? CompareSweep(in ResolveResult swept, JsonElement expected)
    {
        bool found = expected.TryGetProperty("found", out JsonElement f) && f.GetBoolean();
        if (swept.Found != found) return $"found {swept.Found}, recorded {found}";
        if (!found) return null;
        if (swept.Position.CellId != Hex(expected.GetProperty("pos_cell"))) return "cell";
        Vector3 at = Vector(expected.GetProperty("pos"));
        if (!((swept.Position.Frame.Origin - at).Length() <= Tolerance)) return $"position {swept.Position.Frame.Origin}, recorded {at}";
        bool contact = expected.TryGetProperty("contact", out JsonElement c) && c.GetBoolean();
        if (swept.HasContact != contact) return "contact";
        return SameNormal(swept.SlidingNormal, expected) ? null : "sliding normal";
    }

    private static string? CompareBody(PhysicsBody body, JsonElement expected)
    {
        if (body.Position.CellId != Hex(expected.GetProperty("cell"))) return $"cell {body.Position.CellId:X8}, recorded {expected.GetProperty("cell").GetString()}";
        Vector3 at = Vector(expected.GetProperty("pos"));
        if (!((body.Position.Frame.Origin - at).Length() <= Tolerance)) return $"position {body.Position.Frame.Origin}, recorded {at}";
        TransientState bits = (TransientState)Hex(expected.GetProperty("ts"));
        if (((body.Transient ^ bits) & Compared) != 0) return $"bits {body.Transient & Compared}, recorded {bits & Compared}";
        return SameNormal((body.Transient & TransientState.Sliding) != 0 ? body.SlidingNormal : null, expected) ? null : "sliding normal";
    }

    private static string? CompareVelocity(PhysicsBody body, JsonElement expected)
    {
        Vector3 recorded = Vector(expected.GetProperty("vel"));
        return (body.Velocity - recorded).Length() <= VelocityTolerance ? null : $"velocity {body.Velocity}, recorded {recorded}";
    }

    private static bool SameNormal(Vector3? sliding, JsonElement expected) => expected.TryGetProperty("sliding", out JsonElement recorded)
        ? sliding is { } normal && (normal - Vector(recorded)).Length() <= NormalTolerance
        : sliding is null;

    private PhysicsBody Create(PhysicsEngine engine, JsonElement element)
    {
        WeenieTraits weenie = WeenieTraits.Present;
        if (element.TryGetProperty("player", out JsonElement player) && player.GetBoolean()) weenie |= WeenieTraits.Player;
        if (element.TryGetProperty("creature", out JsonElement creature) && creature.GetBoolean()) weenie |= WeenieTraits.Creature;
        float scale = element.TryGetProperty("scale", out JsonElement s) ? s.GetSingle() : 1f;
        return engine.CreateBody(Hex(element.GetProperty("id")), setups(Hex(element.GetProperty("setup"))), (PhysicsState)Hex(element.GetProperty("state")), weenie, scale);
    }

    private PhysicsBody Place(PhysicsEngine engine, JsonElement element, PlacementFlags flags)
    {
        PhysicsBody body = Create(engine, element);
        body.SetPosition(new PlacementRequest(PositionOf(element.GetProperty("request"), Quaternion.Identity), flags));
        return body;
    }

    private static Quaternion Seat(PhysicsBody body, JsonElement state, Quaternion facing)
    {
        Position position = PositionOf(state, facing);
        Plane plane = state.TryGetProperty("plane", out JsonElement p) ? new Plane(p[0].GetSingle(), p[1].GetSingle(), p[2].GetSingle(), p[3].GetSingle()) : default;
        body.Seat(new BodySeat(
            position, Vector(state.GetProperty("vel")), (TransientState)Hex(state.GetProperty("ts")), plane,
            state.TryGetProperty("plane_cell", out JsonElement cell) ? Hex(cell) : 0,
            state.TryGetProperty("sliding", out JsonElement sliding) ? Vector(sliding) : Vector3.Zero,
            state.TryGetProperty("colliding_env", out JsonElement env) && env.GetBoolean()));
        return position.Frame.Rotation;
    }

    private static Position PositionOf(JsonElement state, Quaternion facing)
    {
        if (state.TryGetProperty("quat", out JsonElement q)) facing = new Quaternion(q[1].GetSingle(), q[2].GetSingle(), q[3].GetSingle(), q[0].GetSingle());
        return new Position(Hex(state.GetProperty("cell")), new Frame(Vector(state.GetProperty("pos")), facing));
    }

    private static IEnumerable<JsonElement> ReadLines(string path) => VectorFile.Read(path, static line => JsonElement.Parse(line));

    private static Vector3 Vector(JsonElement v) => new(v[0].GetSingle(), v[1].GetSingle(), v[2].GetSingle());

    private static uint Hex(JsonElement text) => uint.Parse(text.GetString()!, NumberStyles.HexNumber, CultureInfo.InvariantCulture);
}
