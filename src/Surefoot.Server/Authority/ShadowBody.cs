using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>
/// A player's body that nobody meets: it meets everything in an engine's world, and moves as the player's own does from the same keys. It
/// writes nothing of the world, so any number may be stepped at once while nobody changes that.
/// </summary>
internal sealed class ShadowBody
{
    /// <summary>Velocities that differ by less are the same, m/s.</summary>
    private const float SameVelocity = 0.02f;

    /// <summary>How speeds follow from a run rate: specification 01, 4.3.</summary>
    private const float SidestepFactor = 1.248f, MostSidestep = 3, BackFactor = -0.65f;

    /// <summary>The fastest sidestep, m/s.</summary>
    internal const double FastestSidestep = MostSidestep * (double)MovementFormulas.SidestepSpeed;

    private readonly PhysicsBody body;
    private readonly MovementManager movement;

    internal ShadowBody(ICellWorld cells, SetupAsset setup, MotionTableAsset table, PlayerWeenie weenie, WeenieTraits traits)
    {
        Population population = new(new ShadowCells(cells), seed: 1, made => new SteeredPhysicsBody(made));
        body = new PhysicsBody(population, id: 1, setup, PhysicsState.Default, traits, scale: 1f);
        movement = new MovementManager(body, table, weenie);
        SteeredPhysicsBody.Of(body).Attach(movement);
    }

    /// <summary>What moved since then may have been elsewhere for the player, seconds.</summary>
    internal double MovedSince { get; set; } = double.PositiveInfinity;

    /// <summary>What the server says of the player: other players and it may stop each other.</summary>
    internal void SetWeenie(WeenieTraits traits) => body.SetWeenie(traits);

    /// <summary>The player's own body in the world, which is no obstacle for it; null for none.</summary>
    internal void StandFor(PhysicsBody? own) => body.StandsFor = own;

    internal BodySeat Seat => body.CurrentSeat;

    internal Position Position => body.Position;

    internal bool OnWalkable => body.OnWalkable;

    internal bool HasCell => body.HasCell;

    internal Vector3 LocalVelocity => body.LocalVelocity;

    /// <summary>Is put somewhere, or on a free place near by.</summary>
    internal bool TryEnter(in Position place)
    {
        body.LeaveWorld();
        if (!body.EnterWorld(place) || !body.HasCell) return false;
        SeatAt(Seat with { Velocity = Vector3.Zero });
        return true;
    }

    /// <summary>Becomes the same as another one.</summary>
    /// <param name="other">The other one.</param>
    /// <param name="passesMovers">It does not meet what moved lately.</param>
    internal void CopyFrom(ShadowBody other, bool passesMovers)
    {
        body.PassesChangedSince = passesMovers ? MovedSince : double.PositiveInfinity;
        SeatAt(other.Seat);
        movement.CopyMotionsFrom(other.movement);
    }

    /// <summary>Is in a state, with the motions that it has.</summary>
    internal void SeatAt(in BodySeat seat)
    {
        body.Seat(seat);
        body.SetActive(true);
        body.LastMoveWasAutonomous = true;
    }

    /// <summary>Stands on the ground, or is in the air, and takes it as a landing or a leaving when it was not so before.</summary>
    /// <param name="place">Where.</param>
    /// <param name="ground">What it stands on; null in the air.</param>
    /// <param name="landing">What is left of its velocity when it lands by that.</param>
    internal void Put(in Position place, in Contact? ground, Landing landing)
    {
        BodySeat seat = Seat with { Position = place };
        bool stood = body.OnWalkable;
        if (ground is { } floor)
        {
            TransientState state = seat.Transient | TransientState.Contact;
            state = floor.IsWater ? state | TransientState.WaterContact : state & ~TransientState.WaterContact;
            Vector3 velocity = stood ? seat.Velocity : Left(seat.Velocity, floor.Plane.Normal, landing);
            SeatAt(seat with { Transient = state, ContactPlane = floor.Plane, ContactPlaneCellId = floor.CellId, Velocity = velocity });
            if (!stood) body.SetOnWalkable(true);
            return;
        }

        SeatAt(seat);
        if (!stood) return;
        body.SetOnWalkable(false);
        SeatAt(Seat with { Transient = Seat.Transient & ~(TransientState.Contact | TransientState.WaterContact) });
    }

    /// <summary>Does what its keys ask for and nothing else.</summary>
    internal void Refresh()
    {
        MotionInterpreter motions = movement.Interpreter;
        movement.Animation?.HandleExitWorld();
        motions.HandleExitWorld();
        motions.Interpreted.Reset();
        movement.Animation?.InitializeState();
        motions.ApplyRawMovement(cancelMoveTo: false, disallowJump: false);
    }

    /// <summary>Drifts, and turns at a rate.</summary>
    /// <param name="drift">How.</param>
    /// <param name="omega">rad/s, to the left.</param>
    internal void Set(in Drift drift, double omega)
    {
        float rate = movement.RunRate, side = Math.Min(MostSidestep, SidestepFactor * rate) * MovementFormulas.SidestepSpeed;
        float walk = SidestepFactor * MovementFormulas.SidestepSpeed;
        float ahead = movement.Interpreter.Raw.ForwardCommand switch
        {
            MotionCommand.WalkForward => drift.Runs ? MovementFormulas.RunSpeed * rate : MovementFormulas.WalkSpeed,
            MotionCommand.WalkBackwards => BackFactor * MovementFormulas.WalkSpeed * (drift.Runs ? rate : 1),
            _ => 0,
        };
        float right = drift.Side switch
        {
            SideDrift.Walk => walk,
            SideDrift.Run => side,
            SideDrift.Rest => side - walk,
            _ => 0,
        };
        movement.Animation?.Sequence.SetPhysics(new Vector3(drift.Left ? -right : right, ahead, 0), new Vector3(0, 0, (float)omega));
    }

    private Vector3 Left(Vector3 velocity, Vector3 normal, Landing landing) => landing switch
    {
        Landing.Bounced => velocity - ((1 + body.Elasticity) * Vector3.Dot(velocity, normal) * normal),
        Landing.Level => velocity with { Z = 0 },
        Landing.Whole => velocity,
        Landing.Along => velocity - (Vector3.Dot(velocity, normal) * normal),
        _ => Vector3.Zero,
    };

    /// <summary>Holds other keys from now on: each that changed goes down or comes up.</summary>
    internal void Hold(RawMotionState keys, bool standingLongJump)
    {
        MotionInterpreter motions = movement.Interpreter;
        RawMotionState own = motions.Raw;
        motions.StandingLongJump = standingLongJump;
        motions.SetHoldRun(keys.CurrentHoldKey == HoldKey.Run, cancelMoveTo: true);
        if (keys.CurrentStyle != own.CurrentStyle) movement.DoMotion(keys.CurrentStyle, new MovementParameters());
        if ((keys.ForwardCommand, keys.ForwardHoldKey, keys.ForwardSpeed) != (own.ForwardCommand, own.ForwardHoldKey, own.ForwardSpeed))
            Press(own.ForwardCommand, keys.ForwardCommand, MotionCommand.Ready, keys.ForwardHoldKey, keys.ForwardSpeed);
        if ((keys.SidestepCommand, keys.SidestepHoldKey, keys.SidestepSpeed) !=
            (own.SidestepCommand, own.SidestepHoldKey, own.SidestepSpeed))
            Press(own.SidestepCommand, keys.SidestepCommand, MotionCommand.None, keys.SidestepHoldKey, keys.SidestepSpeed);
        if ((keys.TurnCommand, keys.TurnHoldKey, keys.TurnSpeed) != (own.TurnCommand, own.TurnHoldKey, own.TurnSpeed))
            Press(own.TurnCommand, keys.TurnCommand, MotionCommand.None, keys.TurnHoldKey, keys.TurnSpeed);
        own.CopyFrom(keys);
    }

    private void Press(MotionCommand before, MotionCommand now, MotionCommand nothing, HoldKey key, float speed)
    {
        MovementParameters p = new() { Speed = speed };
        if (key != HoldKey.Invalid) (p.HoldKey, p.Flags) = (key, p.Flags & ~MovementFlags.SetHoldKey);
        if (now != nothing) movement.DoMotion(now, p);
        else if (before != nothing) movement.StopMotion(before, p);
    }

    /// <summary>The walk key goes down or comes up.</summary>
    internal void ToggleRun() =>
        movement.Interpreter.SetHoldRun(movement.Interpreter.Raw.CurrentHoldKey != HoldKey.Run, cancelMoveTo: false);

    internal void SetHeading(float degrees) => body.SetHeading(degrees);

    /// <summary>Gravity acts on the velocity for a time, seconds; the place stays.</summary>
    internal void Fall(double seconds)
    {
        BodySeat seat = Seat;
        SeatAt(seat with { Velocity = seat.Velocity with { Z = (float)(seat.Velocity.Z + (PhysicsBody.Gravity * seconds)) } });
    }

    internal void Step(float quantum) => body.AdvanceQuantum(quantum);

    /// <summary>Jumps with a charge.</summary>
    /// <param name="extent">The charge.</param>
    /// <param name="velocity">The velocity in its own axes that it then has, m/s; null for that of its motions and the charge.</param>
    internal void Jump(float extent, Vector3? velocity)
    {
        movement.Interpreter.EndJumpCharge();
        if (movement.Interpreter.Jump(extent) != MotionError.None) body.SetOnWalkable(false);
        if (velocity is { } told) body.SetLocalVelocity(told);
    }

    /// <summary>What comes after now does not differ from what comes after another one.</summary>
    internal bool IsLike(ShadowBody other)
    {
        MotionTableManager? own = movement.Animation, its = other.movement.Animation;
        return Vector3.Distance(body.Velocity, other.body.Velocity) < SameVelocity && body.OnWalkable == other.body.OnWalkable &&
            (body.OnWalkable || Vector3.Distance(WallAlong, other.WallAlong) < SameVelocity) &&
            own?.Substate == its?.Substate && own?.SubstateSpeed == its?.SubstateSpeed &&
            own?.Sequence.Velocity == its?.Sequence.Velocity && own?.Sequence.Omega == its?.Sequence.Omega &&
            movement.Interpreter.Raw.CurrentHoldKey == other.movement.Interpreter.Raw.CurrentHoldKey;
    }

    /// <summary>Normal of the wall that the next quantum slides along; zero for none.</summary>
    private Vector3 WallAlong => (Seat.Transient & TransientState.Sliding) != 0 ? body.SlidingNormal : Vector3.Zero;

    /// <summary>It is in the air, or slides on with what a landing left it: what comes next hangs on how time is divided.</summary>
    internal bool IsTouchy => !body.OnWalkable || body.Velocity != Vector3.Zero;

    /// <summary>Where its velocity and its motions lead it, m/s, world axes.</summary>
    internal Vector3 Going
    {
        get
        {
            Vector3 motion = movement.Animation?.Sequence.Velocity ?? Vector3.Zero;
            return body.Velocity + (body.OnWalkable ? body.Position.Frame.LocalToGlobalVector(motion) : Vector3.Zero);
        }
    }

    /// <summary>Where its motions alone would lead it if it were placed like that, m/s, world axes.</summary>
    internal Vector3 Striding(in Position place) =>
        place.Frame.LocalToGlobalVector(movement.Animation?.Sequence.Velocity ?? Vector3.Zero);

    /// <summary>It would walk if it went.</summary>
    internal bool Walks => movement.Interpreter.Raw.CurrentHoldKey != HoldKey.Run;

    /// <summary>A key to go somewhere is held.</summary>
    internal bool Moves => movement.Interpreter.Raw is not { ForwardCommand: MotionCommand.Ready, SidestepCommand: MotionCommand.None };

    internal bool Turns => movement.Interpreter.Raw.TurnCommand != MotionCommand.None;

    internal MotionCommand TurnKey => movement.Interpreter.Raw.TurnCommand;
}

/// <summary>What is left of a velocity by a landing that was not seen.</summary>
internal enum Landing
{
    /// <summary>All but what was towards the ground, a little of which is thrown back: the next quantum may be a hop.</summary>
    Bounced,

    /// <summary>What of it was level.</summary>
    Level,

    /// <summary>What of it was along the ground.</summary>
    Along,

    /// <summary>Nothing.</summary>
    Still,

    /// <summary>All: who jumps out of shallow water touches it for one more quantum.</summary>
    Whole,
}
