using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>
/// Asks an engine's world: where a way leads, whether something fits, what is below, what is here. It holds the work objects of one worker,
/// so each thread that asks makes one of its own (<see cref="PhysicsEngine.CreateQuery"/>) and keeps it. Nothing in the world changes by
/// being asked, and any number of threads may ask while nobody changes it; a question allocates nothing once the work objects have grown.
/// <c>WorldQuery.Overlaps.cs</c> asks about points and spheres.
/// </summary>
public sealed partial class WorldQuery
{
    /// <summary>
    /// Most sub-steps of one question, each as long as the radius of the mover's foot: a longer way is to be asked about in parts.
    /// </summary>
    public const int MostSubSteps = 100_000;

    /// <summary>A share of the foot's radius that is one sub-step whatever the rounding.</summary>
    private const float ProbeStride = 0.9375f;

    private readonly Population population;
    private readonly TransitionPool work;
    private readonly TraceBuffer heard = new();

    /// <summary>A query of a worker.</summary>
    /// <param name="population">Whom it asks about.</param>
    /// <param name="work">The worker's work objects.</param>
    internal WorldQuery(Population population, TransitionPool work)
    {
        this.population = population;
        this.work = work;
    }

    /// <summary>Where a mover ends that goes a way in one quantum.</summary>
    /// <param name="input">Who goes where.</param>
    /// <param name="trace">Is told each decision.</param>
    /// <exception cref="ArgumentException">
    /// A position, the contact or the wall is not finite, a normal not of unit length, an id names no cell of the map, or the way is
    /// longer than <see cref="MostSubSteps"/>.
    /// </exception>
    /// <remarks>Retail: CTransition::find_transitional_position @0x0050BDF0.</remarks>
    public SweepResult Sweep(in SweepInput input, TraceBuffer? trace = null)
    {
        ArgumentNullException.ThrowIfNull(input.Mover, nameof(input));
        ThrowIfNowhere(input.From, nameof(input));
        input.Contact?.ThrowIfBad(nameof(input));
        if (input.SlidingNormal is { } normal) SweepInput.ThrowIfNoWall(normal, nameof(input));
        Position from = input.From;
        population.Cells.AdjustPosition(ref from, TransitionSeeds.FootOf(input.Mover.Object), out ObjCell? cell);
        return Sweep(input.Mover.Object, input.Begin(from), cell, input.To, trace, nameof(input));
    }

    /// <summary>Where a body of the engine would end if it went from where it is to a place in one sweep.</summary>
    /// <param name="body">The body; it stays as it is.</param>
    /// <param name="to">Where it wants to go.</param>
    /// <param name="trace">Is told each decision; the body's own <see cref="PhysicsBody.Trace"/> is not.</param>
    /// <exception cref="ArgumentException">
    /// The body belongs to another engine, the position is not finite or its id names no cell of the map, or the way is longer than
    /// <see cref="MostSubSteps"/>.
    /// </exception>
    public SweepResult Sweep(PhysicsBody body, in Position to, TraceBuffer? trace = null)
    {
        population.ThrowIfForeign(body);
        return Sweep(body, body.CurrentSeat, body.Cell, to, trace, nameof(to));
    }

    /// <summary>
    /// Where a body of the engine would end if it were in another state and went from there to a place in one sweep: how a server checks a
    /// movement that a client claims.
    /// </summary>
    /// <param name="body">The body; it stays as it is.</param>
    /// <param name="from">The state it begins in.</param>
    /// <param name="to">Where it wants to go.</param>
    /// <param name="trace">Is told each decision; the body's own <see cref="PhysicsBody.Trace"/> is not.</param>
    /// <exception cref="ArgumentException">
    /// The body belongs to another engine, a position or a number of the state is not finite, an id names no cell of the map, or the way is
    /// longer than <see cref="MostSubSteps"/>.
    /// </exception>
    public SweepResult Sweep(PhysicsBody body, in BodySeat from, in Position to, TraceBuffer? trace = null)
    {
        population.ThrowIfForeign(body);
        from.ThrowIfBad(nameof(from));
        ThrowIfNowhere(from.Position, nameof(from));
        if (from.ContactPlaneCellId != 0) Contact.ThrowIfOffMap(from.ContactPlaneCellId, nameof(from));
        return Sweep(body, from, population.Cells.GetVisible(from.Position.CellId), to, trace, nameof(to));
    }

    /// <summary>Whether a mover can be put at a place, and where it would be then.</summary>
    /// <param name="input">Who is put where.</param>
    /// <param name="trace">Is told each decision.</param>
    /// <exception cref="ArgumentException">The position is not finite or its id names no cell of the map.</exception>
    /// <remarks>Retail: CTransition::find_placement_position @0x0050C170.</remarks>
    public PlaceResult Place(in PlaceInput input, TraceBuffer? trace = null)
    {
        ArgumentNullException.ThrowIfNull(input.Mover, nameof(input));
        ThrowIfNowhere(input.Position, nameof(input));
        WorldObject mover = input.Mover.Object;
        Position place = input.Position;
        population.Cells.AdjustPosition(ref place, TransitionSeeds.FootOf(mover), out ObjCell? cell);
        if (cell is null) return new PlaceResult(false, false, input.Position, null);
        if (PhysicsBody.HangsWhereItIsPut(mover.Weenie)) return new PlaceResult(true, true, place, null);

        Transition transition = Rent(trace);
        try
        {
            transition.SeedMover(mover, MoverFlags.None);
            if (!transition.Place(cell, ref place, input.Slides)) return new PlaceResult(false, true, input.Position, null);
            return transition.Path.CurrCell is null
                ? new PlaceResult(false, false, input.Position, null)
                : new PlaceResult(true, true, transition.Path.CurrPos, Contact.Of(transition.Collision));
        }
        finally
        {
            work.Return();
        }
    }

    /// <summary>Lets a mover down from a place, as it falls but without sliding, until it touches something.</summary>
    /// <param name="input">Who, from where, how far.</param>
    /// <param name="trace">Is told each decision.</param>
    /// <exception cref="ArgumentException">
    /// The position is not finite or its id names no cell of the map, the depth is not a positive finite number or more than
    /// <see cref="MostSubSteps"/>.
    /// </exception>
    public ProbeDownResult ProbeDown(in ProbeDownInput input, TraceBuffer? trace = null)
    {
        ArgumentNullException.ThrowIfNull(input.Mover, nameof(input));
        ThrowIfNowhere(input.From, nameof(input));
        if (!(input.Depth > 0) || !float.IsFinite(input.Depth))
            throw new ArgumentException("The depth is not a positive finite number.", nameof(input));
        WorldObject mover = input.Mover.Object;
        Position at = input.From;
        population.Cells.AdjustPosition(ref at, TransitionSeeds.FootOf(mover), out ObjCell? cell);
        if (cell is null) return new ProbeDownResult(false, false, input.From, 0, null, TraceSubject.None);

        TraceBuffer told = trace ?? heard;
        heard.Clear();
        Transition transition = Rent(told);
        try
        {
            float from = at.Frame.Origin.Z, stride = ProbeStride * RadiusOf(mover);
            ThrowIfTooMany(input.Depth / (double)stride, nameof(input));
            ProbeDownResult result = default;
            for (float left = input.Depth; left > 0; left -= stride)
            {
                Position below = at;
                below.Frame.Origin.Z -= Math.Min(left, stride);
                if (below.Frame.Origin.Z == at.Frame.Origin.Z) break;
                transition.Reset();
                BodySeat falling = new(at, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero);
                bool found = transition.Sweep(mover, falling, cell, below);
                (at, cell) = (transition.Path.CurrPos, transition.Path.CurrCell);
                Contact? contact = Contact.Of(transition.Collision);
                bool stopped = !found || contact is not null || transition.Collision.CollisionNormalValid;
                TraceSubject subject = !stopped ? TraceSubject.None : contact is null ? LastHit(told) : told.Contact;
                result = new ProbeDownResult(stopped, cell is not null, at, from - at.Frame.Origin.Z, contact, subject);
                if (stopped || cell is null) break;
            }

            return result;
        }
        finally
        {
            work.Return();
        }
    }

    private SweepResult Sweep(WorldObject mover, in BodySeat from, ObjCell? cell, in Position to, TraceBuffer? trace, string name)
    {
        ThrowIfNowhere(to, name);
        ThrowIfTooMany(RetailMath.Length(from.Position.OffsetTo(to)) / RadiusOf(mover), name);
        if (cell is null) return SweepResult.NotLoaded(from.Position);
        Transition transition = Rent(trace);
        try
        {
            return SweepResult.Of(transition.Sweep(mover, from, cell, to), transition);
        }
        finally
        {
            work.Return();
        }
    }

    private Transition Rent(TraceBuffer? trace) => work.TryRent(out Transition? transition, trace)
        ? transition
        : throw new InvalidOperationException("The question was asked from inside itself; give who asks inside it a query of his own.");

    private static float RadiusOf(WorldObject mover) => TransitionSeeds.RadiusOf(mover);

    /// <summary>What was met last.</summary>
    private static TraceSubject LastHit(TraceBuffer told)
    {
        for (int i = told.Count - 1; i >= 0; i--)
        {
            if (told.Entries[i].Kind == TraceKind.Hit) return told.Entries[i].Subject;
        }

        return TraceSubject.None;
    }

    /// <summary>A place that is asked about is on the map; a body may be told of others, and does not go there.</summary>
    private static void ThrowIfNowhere(in Position position, string name)
    {
        PhysicsBody.ThrowIfBad(position, name);
        if (!CellIds.IsValid(position.CellId)) throw new ArgumentException($"0x{position.CellId:X8} is not on the map.", name);
    }

    private static void ThrowIfTooMany(double subSteps, string name)
    {
        if (!(subSteps <= MostSubSteps))
            throw new ArgumentException($"The way has more than {MostSubSteps} sub-steps of one radius; ask about it in parts.", name);
    }
}
