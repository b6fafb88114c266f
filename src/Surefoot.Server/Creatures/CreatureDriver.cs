using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>
/// Drives a creature for whoever thinks for it: it takes goals, has the engine's own managers move the body, tells clients with messages
/// that make their bodies do the same, and notices when the body gets nowhere. One that is stuck stands, and costs no sweep until something
/// near it changes. How the goals are gone about is in <c>CreatureDriver.Orders.cs</c>.
/// </summary>
/// <remarks>Specification 09b, 6 (how a body goes somewhere) and 08, 8.7 (who is told what).</remarks>
public sealed partial class CreatureDriver
{
    private readonly PhysicsEngine engine;
    private readonly MovementManager movement;
    private readonly ICreatureListener listener;
    private readonly CreatureDriverOptions options;
    private readonly CreatureMessages messages;
    private readonly StuckWatch watch;
    private Position place = Position.Nowhere;
    private float heading;
    private double tellAt;
    private double outrunFrom;
    private bool hasArrived, goesByItself, charges;

    /// <summary>A driver of a body. Its home is where the body is.</summary>
    /// <param name="engine">The world.</param>
    /// <param name="body">The body; it was made with motions.</param>
    /// <param name="listener">Hears what is to be told.</param>
    /// <param name="options">How it goes about its goals.</param>
    /// <exception cref="ArgumentException">The body belongs to another engine or has no motions, or an option is out of range.</exception>
    public CreatureDriver(PhysicsEngine engine, PhysicsBody body, ICreatureListener listener, CreatureDriverOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        ArgumentNullException.ThrowIfNull(body);
        ArgumentNullException.ThrowIfNull(listener);
        options ??= new CreatureDriverOptions();
        options.ThrowIfBad();
        this.engine = engine;
        this.listener = listener;
        this.options = options;
        movement = engine.MovementOf(body) ??
            throw new ArgumentException($"The body 0x{body.Id:X8} has no motions; make it with some.", nameof(body));
        Body = body;
        Home = body.Position;
        messages = new CreatureMessages(body, options.Stamps);
        watch = new StuckWatch(body, options);
    }

    /// <summary>The body.</summary>
    public PhysicsBody Body { get; }

    /// <summary>Where it goes when it goes home, and how it faces there.</summary>
    public Position Home { get; set; }

    /// <summary>What it is driven to do.</summary>
    public CreatureGoal Goal { get; private set; }

    /// <summary>The object of the goal; 0 when it has none.</summary>
    public uint TargetId { get; private set; }

    /// <summary>How far it is with the goal.</summary>
    public CreatureProgress Progress { get; private set; }

    /// <summary>How often it has got stuck.</summary>
    public long StuckCount { get; private set; }

    /// <summary>Comes to an object, wherever that goes meanwhile.</summary>
    /// <returns>False when there is no such object or it is the creature itself; nothing has changed then.</returns>
    public bool MoveTo(uint id) => TryAim(CreatureGoal.Object, id);

    /// <summary>Comes to a place.</summary>
    /// <exception cref="ArgumentException">The place is not finite, or its id names no cell; nothing has changed.</exception>
    public void MoveTo(in Position destination)
    {
        ThrowIfBad(destination);
        Aim(CreatureGoal.Place, 0, destination, 0);
    }

    /// <summary>Goes home, and faces there as it did.</summary>
    public void GoHome() => Aim(CreatureGoal.Home, 0, Home, 0);

    /// <summary>Turns to an object.</summary>
    /// <returns>False when there is no such object or it is the creature itself; nothing has changed then.</returns>
    public bool TurnTo(uint id) => TryAim(CreatureGoal.FaceObject, id);

    /// <summary>Turns to a heading.</summary>
    /// <param name="degrees">0 north, 90 east.</param>
    /// <exception cref="ArgumentOutOfRangeException">It is not finite; nothing has changed.</exception>
    public void TurnTo(float degrees)
    {
        if (!float.IsFinite(degrees))
            throw new ArgumentOutOfRangeException(nameof(degrees), degrees, "A heading is a finite number of degrees.");
        Aim(CreatureGoal.FaceHeading, 0, Position.Nowhere, degrees);
    }

    /// <summary>Stays near an object, wherever that goes.</summary>
    /// <returns>False when there is no such object or it is the creature itself; nothing has changed then.</returns>
    public bool Follow(uint id) => TryAim(CreatureGoal.Follow, id);

    /// <summary>Stays right next to an object, facing it.</summary>
    /// <returns>False when there is no such object or it is the creature itself; nothing has changed then.</returns>
    public bool StickTo(uint id) => TryAim(CreatureGoal.Stick, id);

    /// <summary>Stays away from an object.</summary>
    /// <returns>False when there is no such object or it is the creature itself; nothing has changed then.</returns>
    public bool FleeFrom(uint id) => TryAim(CreatureGoal.Flee, id);

    /// <summary>Stands still from now on.</summary>
    public void Stop()
    {
        (Goal, TargetId, Progress) = (CreatureGoal.None, 0, CreatureProgress.Idle);
        Stand();
    }

    /// <summary>Looks how the goal goes. To be called after <see cref="PhysicsEngine.Tick"/>.</summary>
    public void Update()
    {
        double now = engine.Now;
        if (Goal == CreatureGoal.None || !Body.HasCell) return;
        if (TargetId != 0 && engine.Find(TargetId) is not { HasCell: true })
        {
            GiveUp(MotionError.TargetGone);
            return;
        }

        switch (Progress)
        {
            case CreatureProgress.Moving:
                OnTheWay(now);
                break;
            case CreatureProgress.Watching when Goal == CreatureGoal.Stick && Body.StickyObjectId != 0:
                Hold(now);
                break;
            case CreatureProgress.Watching when IsToGoOn():
                Begin();
                break;
            case CreatureProgress.Stuck when watch.IsWorthATry(now, Sought):
                ForgetWall();
                Begin();
                listener.OnTriesAgain(this);
                break;
        }
    }

    /// <summary>Where the goal lies now.</summary>
    private Position Sought => TargetId == 0 ? place : engine.Find(TargetId)?.Position ?? place;

    private void OnTheWay(double now)
    {
        if (now >= tellAt) TellPosition(now);
        if (movement.IsMovingTo)
        {
            if (watch.IsStuck(now, movement.MotionsPending)) Park(now);
            else if (IsOutrun()) Charge();
        }
        else if (goesByItself && movement.LastMoveToError is not MotionError.None and var error)
        {
            GiveUp(error);
        }
        else
        {
            Arrive(now);
        }
    }

    /// <summary>It sticks to its target: that pulls it along, or against what is between.</summary>
    private void Hold(double now)
    {
        if (now >= tellAt) TellPosition(now);
        if (Gap(Sought) <= options.Reach) watch.Begin(now);
        else if (watch.IsStuck(now, busy: false)) Park(now);
    }

    private void Arrive(double now)
    {
        TellPosition(now);
        watch.Forget();
        // Whoever stands is walked up to again.
        if (engine.Find(TargetId) is not PhysicsBody { AchievedVelocity: var velocity } || velocity == Vector3.Zero) charges = false;
        bool again = hasArrived && Goal == CreatureGoal.Stick;
        hasArrived = true;
        bool goesOn = Goal is CreatureGoal.Follow or CreatureGoal.Stick or CreatureGoal.Flee;
        Progress = goesOn ? CreatureProgress.Watching : CreatureProgress.Idle;
        if (!goesOn) (Goal, TargetId) = (CreatureGoal.None, 0);
        if (!again) listener.OnArrived(this);
    }

    private void Charge()
    {
        charges = true;
        Begin();
    }

    private void GiveUp(MotionError error)
    {
        Stop();
        listener.OnGivenUp(this, error);
    }

    /// <summary>The body stands, and clients see it stand: a body that presses against a wall is swept in every quantum.</summary>
    private void Park(double now)
    {
        Stand();
        // One that hangs somewhere would go on falling against it.
        if (!Body.OnWalkable) Body.SetActive(false);
        watch.Park(now, Sought);
        hasArrived = false;
        Progress = CreatureProgress.Stuck;
        StuckCount++;
        listener.OnStuck(this);
    }

    /// <summary>
    /// Lets go of the wall that the body slid along last. A body keeps it until a move succeeds, and who pushes exactly head-on, as one on
    /// its straight way does, would stay blocked by a door that has opened.
    /// </summary>
    private void ForgetWall() => Body.Seat(new BodySeat(
        Body.Position, Body.Velocity, Body.Transient & ~TransientState.Sliding, Body.ContactPlane, Body.ContactPlaneCellId, Vector3.Zero));

    private void TellPosition(double now)
    {
        tellAt = now + options.TellEvery;
        if (messages.TryTellPosition(out var message)) listener.OnPosition(this, message);
    }

    private bool TryAim(CreatureGoal goal, uint id)
    {
        if (id == Body.Id || engine.Find(id) is not { HasCell: true } target) return false;
        Aim(goal, id, target.Position, 0);
        return true;
    }

    private void Aim(CreatureGoal goal, uint id, in Position where, float degrees)
    {
        (Goal, TargetId, place, heading, hasArrived, charges) = (goal, id, where, degrees, false, false);
        watch.Forget();
        Begin();
    }

    private static void ThrowIfBad(in Position position)
    {
        if (!position.IsValid || !float.IsFinite(position.Frame.Origin.LengthSquared()))
            throw new ArgumentException("The place is not finite, or its id names no cell.", nameof(position));
    }
}
