using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
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

    /// <summary>Another result of a case recorded from a peer as it is.</summary>
    Result,
}

/// <summary>A divergence, for people.</summary>
internal sealed record Divergence(string CaseId, string Scene, int Step, StepDifference Difference, string Detail);

/// <summary>Replays recorded walks in a world.</summary>
internal sealed class WalkReplay(ICellWorld world, Func<uint, SetupAsset> setups)
{
    private const double PositionTolerance = 0.001;
    private const uint MoverId = 0x50000001;
    private const uint FirstOtherId = 0x60000001;
    private const TransientState Compared = (TransientState)0x7F;
    private const PhysicsState BodyState = PhysicsState.Gravity | PhysicsState.ReportCollisions | PhysicsState.EdgeSlide;

    /// <summary>
    /// Replays one case and calls back for each step with what differs. Re-seated, each step begins from the recorded state; free
    /// running, from where the replay is, and ends at the first difference.
    /// </summary>
    internal (int Steps, int Equal, Divergence? First) Run(WalkCase walk, bool reseat)
    {
        // The recorder keeps a body that would leave its cells where it is (specification 02, 5, UpdateObjectInternal).
        PhysicsEngine engine = new(world) { RefuseLeavingCells = true };
        List<PhysicsBody> all = [];
        foreach (WalkOther other in walk.Others ?? [])
        {
            PhysicsBody creature = engine.CreateBody(
                FirstOtherId + (uint)all.Count, setups(WalkCase.ParseId(other.Setup)), BodyState, WeenieTraits.Present | WeenieTraits.Creature);
            creature.SetPosition(new PlacementRequest(new Position(WalkCase.ParseId(other.Cell), Vector(other.Pos)), PlacementFlags.Slide));
            all.Add(creature);
        }

        PhysicsBody body = engine.CreateBody(
            MoverId, setups(WalkCase.ParseId(walk.Setup)), BodyState, WeenieTraits.Present | WeenieTraits.Player | WeenieTraits.Creature);
        all.Add(body);
        RecordedMotion motion = new();
        body.AttachMovement(motion);
        try
        {
            return Replay(walk, body, motion, reseat);
        }
        finally
        {
            foreach (PhysicsBody b in all) engine.RemoveBody(b);
        }
    }

    private static (int Steps, int Equal, Divergence? First) Replay(WalkCase walk, PhysicsBody body, RecordedMotion motion, bool reseat)
    {
        Position place = new(
            WalkCase.ParseId(walk.Place.Cell), new Frame(Vector(walk.Place.Pos), Quaternion.CreateFromAxisAngle(Vector3.UnitZ, walk.Place.Yaw)));
        PlacementResult result = body.SetPosition(new PlacementRequest(place, PlacementFlags.Slide));
        Divergence? first = null;
        if (result == PlacementResult.OK != (walk.Placed == "OK"))
            return (walk.Steps?.Length ?? 0, 0, new Divergence(walk.Id, walk.Scene, -1, StepDifference.Placement, $"placed {result}, recorded {walk.Placed}"));
        if (walk.Start is null || walk.Steps is null) return (0, 0, null);
        StepDifference start = Compare(body, walk.Start);
        if (start != StepDifference.None) first = new Divergence(walk.Id, walk.Scene, -1, start, Describe(body, walk.Start));

        // The recorded start has no more than the state; the orientation is that of the placement.
        Frame facing = place.Frame;
        WalkStep before = walk.Start;
        int equal = 0;
        for (int i = 0; i < walk.Steps.Length; i++)
        {
            WalkStep step = walk.Steps[i];
            if (reseat) Seat(body, before, facing);
            body.SetActive(true);
            if (step.Jump is not null)
            {
                body.SetOnWalkable(false);
                body.SetVelocity(Vector(step.Jump));
            }

            motion.Offset = step.Off is null ? Vector3.Zero : Vector(step.Off);
            body.Step(step.Q, sweepWithoutSpheres: true);
            StepDifference difference = Compare(body, step);
            if (difference == StepDifference.None) equal++;
            else first ??= new Divergence(walk.Id, walk.Scene, i, difference, Describe(body, step));
            before = step;
        }

        return (walk.Steps.Length, equal, first);
    }

    private static void Seat(PhysicsBody body, WalkStep state, Frame facing)
    {
        facing.Origin = Vector(state.Pos);
        body.Seat(new BodySeat(
            new Position(WalkCase.ParseId(state.Cell), facing), Vector(state.Vel), (TransientState)state.Ts,
            state.Plane is null ? default : new Plane(state.Plane[0], state.Plane[1], state.Plane[2], state.Plane[3]),
            state.Pcell is null ? 0 : WalkCase.ParseId(state.Pcell), state.Slide is null ? Vector3.Zero : Vector(state.Slide)));
    }

    private static StepDifference Compare(PhysicsBody body, WalkStep step)
    {
        if (body.Position.CellId != WalkCase.ParseId(step.Cell)) return StepDifference.Cell;
        Vector3 off = body.Position.Frame.Origin - Vector(step.Pos);
        if (!(off.Length() <= PositionTolerance)) return StepDifference.Position;
        return ((body.Transient ^ (TransientState)step.Ts) & Compared) == 0 ? StepDifference.None : StepDifference.Flags;
    }

    private static string Describe(PhysicsBody body, WalkStep step)
    {
        Vector3 at = body.Position.Frame.Origin;
        return FormattableString.Invariant(
            $"at {body.Position.CellId:X8} ({at.X:0.####}, {at.Y:0.####}, {at.Z:0.####}) bits {(uint)(body.Transient & Compared):X2}, recorded {step.Cell} ({step.Pos[0]:0.####}, {step.Pos[1]:0.####}, {step.Pos[2]:0.####}) bits {step.Ts & 0x7F:X2}");
    }

    private static Vector3 Vector(float[] v) => new(v[0], v[1], v[2]);
}
