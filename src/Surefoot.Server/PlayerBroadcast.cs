using System.Numerics;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>How much others are told of a player.</summary>
public enum BroadcastDetail
{
    /// <summary>
    /// As much as live servers tell: places that come with motions once a second at most, a jumper seen standing until its keys change.
    /// Others may draw a player metres off for a second, and for good where a motion came late and the player stands.
    /// </summary>
    Live,

    /// <summary>
    /// More, in the same messages: a place with each motion but a jump's; a jumper that goes on turning in the air, and running when it has
    /// landed; no velocity some time after it landed, so that a take-off which comes later than that is dropped; all of it three times
    /// within 0.3 s with the same stamps, so that nobody waits for what was lost; the place of one who stands three times more, a second
    /// apart. Needs <see cref="PlayerBroadcast.Update"/>.
    /// </summary>
    Full,
}

/// <summary>
/// What those who know a player are told of what its client claims: each motion, each place, each jump, with the stamps of the player's
/// object. What a client sends is given to <c>Take</c>; what follows goes to the <see cref="IAudience"/>. Who comes later is told
/// <see cref="Describe"/> first. Nothing is checked: a claim that is to be refused is not to be given here.
/// </summary>
/// <remarks>
/// Specification 08, 5.7, 8.7 and 8.8, and 09, 4.4 (a jump). What the server makes of a claim by a body of its own, such as a place in the
/// air, is left out: nobody sees it, as only places on the ground are followed (09, 5.3). The player's own echoes are its server's affair.
/// </remarks>
public sealed class PlayerBroadcast
{
    /// <summary>Seconds between two places that come with motions; those that come alone are all told.</summary>
    private const double PositionInterval = 1.0;

    private const double RepeatInterval = 1.0;

    /// <summary>Seconds between two places that come alone, in full: who climbs a stair reports each step.</summary>
    private const double LeastInterval = 0.2;


    /// <summary>Seconds after a landing at which others have seen it, as a rule.</summary>
    private const double FlightsEnd = 0.4;

    private const int MostRepeats = 3;
    private const uint Visible = 0x600408, InPortalSpace = 0x604410, Entering = 0x404410;
    private const uint Ready = 0x41000003, CreatureType = 0x10, PlayerFlags = 0x1C;

    private readonly uint player;
    private readonly IAudience audience;
    private readonly PassedActions actions = new();
    private readonly Retelling retelling;
    private WireRawMotion asked = new();
    private bool chargesLongJump, onGround = true, hasJumped;
    private MovementData seen = MovementData.Motion(0, new WireInterpretedMotion());
    private WirePosition place;
    private uint state = Visible;
    private double lastPosition = double.NegativeInfinity, landedAt = double.PositiveInfinity, owedAt = double.PositiveInfinity;
    private int repeats = MostRepeats;

    /// <summary>A player whose life in the world begins: it stands. Nobody is told yet.</summary>
    /// <param name="player">Id of the player's object, not 0.</param>
    /// <param name="place">Where it begins.</param>
    /// <param name="audience">Everybody who knows it, itself not among them.</param>
    /// <param name="runRate">Factor on its running speed, as the server has it.</param>
    /// <param name="instance">Which life of the object.</param>
    /// <exception cref="ArgumentOutOfRangeException">The id is 0, or the run rate is negative or not finite.</exception>
    public PlayerBroadcast(uint player, in WirePosition place, IAudience audience, float runRate = 1, ushort instance = 1)
    {
        ArgumentOutOfRangeException.ThrowIfZero(player);
        ArgumentNullException.ThrowIfNull(audience);
        ThrowIfNoRate(runRate);
        this.player = player;
        this.place = place;
        this.audience = audience;
        RunRate = runRate;
        retelling = new Retelling(audience);
        Stamps = new ObjectStamps(0, 0, 0, 0, 0, 0, 0, 0, instance);
    }

    /// <summary>The stamps of what was told last.</summary>
    public ObjectStamps Stamps { get; private set; }

    /// <summary>Factor on the player's running speed, as the server has it.</summary>
    public float RunRate { get; private set; }

    /// <summary>The player is on its way to another place: its own places are not told.</summary>
    public bool IsTeleporting => state != Visible;

    /// <summary>The player is hidden at first, and its own places are not told, until <see cref="EndTeleport"/>: its client has yet to load
    /// the place.</summary>
    public bool BeginsHidden
    {
        init => state = value ? Entering : Visible;
    }

    /// <summary>How much others are told.</summary>
    public BroadcastDetail Detail { get; init; }

    /// <summary>The player as it is now, for somebody who does not know it yet; what is told afterwards goes on from there.</summary>
    /// <param name="setup">Its shape, 0x02…</param>
    /// <param name="motionTable">Its motions, 0x09…</param>
    /// <param name="name">Its name.</param>
    /// <param name="model">What it looks like; null for as the shape does.</param>
    /// <remarks>Specification 08, 8.6, smallest CreateObject of a player.</remarks>
    public CreateObject Describe(uint setup, uint motionTable, string name, ModelData? model = null) => new(new ObjectDescription(
        player, model ?? new ModelData(),
        new PhysicsDescription
        {
            State = state,
            Setup = setup,
            MotionTable = motionTable,
            Movement = seen,
            Autonomous = 1,
            Position = place,
            Stamps = Stamps,
        },
        new WeenieDescription { Name = name, ItemType = CreatureType, Description = PlayerFlags }));

    /// <summary>The player's keys changed.</summary>
    /// <param name="move">What its client says.</param>
    /// <param name="now">Seconds.</param>
    public void Take(in MoveToState move, double now)
    {
        bool lands = Lands(move.Contact, now);
        if (actions.TryPass(move.Motion.Actions, out MotionActions passed))
        {
            asked = move.Motion;
            chargesLongJump = move.StandingLongJump;
            seen = Seen();
            TellMotion(Seen(passed), autonomous: true);
        }
        else if (lands)
        {
            TellMotion(seen = Seen(), autonomous: true);
        }

        if (Detail == BroadcastDetail.Full) Owe(move.Position, move.Contact, due: now);
        else TakePlace(move.Position, move.Contact, isDue: now - lastPosition >= PositionInterval, now);
    }

    /// <summary>The player is somewhere.</summary>
    /// <param name="position">What its client says.</param>
    /// <param name="now">Seconds.</param>
    public void Take(in AutonomousPosition position, double now)
    {
        if (Detail == BroadcastDetail.Full) Owe(position.Position, position.Contact, due: lastPosition + LeastInterval);
        else TakePlace(position.Position, position.Contact, isDue: true, now);
        if (Lands(position.Contact, now)) TellMotion(seen = Seen(), autonomous: true);
    }

    /// <summary>
    /// The player jumps. Everybody sees it stand, so that the velocity that comes next is not replaced by that of its motion: a turn has
    /// none.
    /// </summary>
    /// <param name="jump">What its client says.</param>
    public void Take(in Jump jump)
    {
        onGround = false;
        hasJumped = true;
        landedAt = owedAt = double.PositiveInfinity;
        seen = Detail == BroadcastDetail.Full ? Seen() : MovementData.Motion(0, new WireInterpretedMotion());
        TellMotion(seen, autonomous: true);
        TellVelocity(Vector3.Transform(jump.Velocity, jump.Position.Orientation));
        // Nobody follows a place in the air, but the stamp is newer than those of places that come late: whoever has taken off goes back
        // to such a place when it has landed.
        if (Detail == BroadcastDetail.Full && !IsTeleporting) TellPosition(jump.Position, contact: false, lastPosition);
    }

    /// <summary>Lets time pass: places that wait and what is told once more are told. To be called often, as each frame.</summary>
    /// <param name="now">Seconds.</param>
    public void Update(double now)
    {
        if (Detail != BroadcastDetail.Full) return;
        if (now >= owedAt) TellPosition(place, contact: true, now);
        // Stamps of places do not hold back a take-off that comes late, those of velocities do: nobody jumps where it stands already.
        if (now - landedAt >= FlightsEnd)
        {
            landedAt = double.PositiveInfinity;
            TellVelocity(default);
        }

        retelling.Update(now);
        if (repeats >= MostRepeats || IsTeleporting || !Stands || now - lastPosition < RepeatInterval) return;
        repeats++;
        TellPosition(place, contact: true, now, isRepeat: true);
    }

    /// <summary>The player's run rate changed. One that moves on the ground by it is ordered to go on at the new speed.</summary>
    /// <param name="runRate">Factor on its running speed.</param>
    /// <exception cref="ArgumentOutOfRangeException">Negative or not finite; nothing has changed.</exception>
    public void ChangeRunRate(float runRate)
    {
        ThrowIfNoRate(runRate);
        MovementData before = Asked();
        RunRate = runRate;
        if (!onGround || Asked() == before) return;
        Stamps = Stamps with { ServerControlledMove = Next(Stamps.ServerControlledMove) };
        TellMotion(seen = Asked(), autonomous: false);
    }

    /// <summary>The server puts the player somewhere else. It is hidden there, until <see cref="EndTeleport"/>.</summary>
    /// <param name="to">Where.</param>
    /// <param name="now">Seconds.</param>
    public void Teleport(in WirePosition to, double now)
    {
        Stamps = Stamps with { Teleport = Next(Stamps.Teleport) };
        TellPosition(to, contact: true, now);
        TellState(InPortalSpace);
        TellPosition(to, contact: true, now);
    }

    /// <summary>The server does not believe where the player says to be, and puts it where it is.</summary>
    /// <param name="to">Where.</param>
    /// <param name="contact">It stands there.</param>
    /// <param name="now">Seconds.</param>
    public void Force(in WirePosition to, bool contact, double now)
    {
        Stamps = Stamps with { ForcePosition = Next(Stamps.ForcePosition) };
        TellPosition(to, contact, now);
    }

    /// <summary>The server takes the control and moves the player.</summary>
    /// <param name="movement">What the player does from now on.</param>
    public void Order(in MovementData movement)
    {
        Stamps = Stamps with { ServerControlledMove = Next(Stamps.ServerControlledMove) };
        TellMotion(seen = movement, autonomous: false);
    }

    /// <summary>The player's client is there: it is seen, and its places are told again.</summary>
    public void EndTeleport()
    {
        if (IsTeleporting) TellState(Visible);
    }

    private static ushort Next(ushort stamp) => unchecked((ushort)(stamp + 1));

    private static void ThrowIfNoRate(float runRate)
    {
        if (!(runRate >= 0) || !float.IsFinite(runRate))
            throw new ArgumentOutOfRangeException(nameof(runRate), runRate, "A run rate is a finite number, 0 or more.");
    }

    /// <summary>Nothing is asked of it that would move or turn it.</summary>
    private bool Stands => onGround && asked is { ForwardCommand: Ready, SidestepCommand: 0, TurnCommand: 0 };

    /// <summary>It is on the ground or not: one that jumped and is, is told of in full.</summary>
    private bool Lands(bool contact, double now)
    {
        onGround = contact;
        if (!contact || !hasJumped) return false;
        hasJumped = false;
        if (Detail != BroadcastDetail.Full) return false;
        landedAt = now;
        return true;
    }

    /// <summary>
    /// What others see it do. One that jumped only turns in the air, whatever its keys say: the velocity of a take-off that comes after a
    /// motion would be replaced by the motion's (specification 09, 4.4).
    /// </summary>
    private MovementData Seen(in MotionActions passed = default)
    {
        if (!hasJumped || Detail != BroadcastDetail.Full) return MotionTranslation.Interpret(asked, RunRate, chargesLongJump, passed);
        MovementData still = MotionTranslation.Interpret(asked, RunRate, standingLongJump: true, passed);
        return MovementData.Motion(still.Style, still.State);
    }

    private MovementData Asked() => MotionTranslation.Interpret(asked, RunRate, chargesLongJump);

    /// <summary>A place on the ground is told with the next update, or a little later where another one was told just now.</summary>
    private void Owe(in WirePosition at, bool contact, double due)
    {
        TakePlace(at, contact, isDue: false, due);
        owedAt = contact && !IsTeleporting ? Math.Min(owedAt, due) : double.PositiveInfinity;
    }

    private void TakePlace(in WirePosition at, bool contact, bool isDue, double now)
    {
        if (IsTeleporting) return;
        repeats = 0;
        place = at;
        if (isDue) TellPosition(at, contact, now);
    }

    private void TellPosition(in WirePosition at, bool contact, double now, bool isRepeat = false)
    {
        place = at;
        lastPosition = now;
        owedAt = double.PositiveInfinity;
        Stamps = Stamps with { Position = Next(Stamps.Position) };
        UpdatePosition told = new(
            player, new PositionPack(at, contact, Stamps.Instance, Stamps.Position, Stamps.Teleport, Stamps.ForcePosition));
        audience.Tell(told);
        if (!isRepeat) retelling.Note(told);
    }

    private void TellMotion(in MovementData motion, bool autonomous)
    {
        Stamps = Stamps with { Movement = Next(Stamps.Movement) };
        UpdateMotion told = new(player, Stamps.Instance, Stamps.Movement, Stamps.ServerControlledMove, autonomous, motion);
        audience.Tell(told);
        retelling.Note(told);
    }

    private void TellVelocity(Vector3 velocity)
    {
        Stamps = Stamps with { Vector = Next(Stamps.Vector) };
        VectorUpdate told = new(player, velocity, default, Stamps.Instance, Stamps.Vector);
        audience.Tell(told);
        retelling.Note(told);
    }

    private void TellState(uint value)
    {
        state = value;
        Stamps = Stamps with { State = Next(Stamps.State) };
        audience.Tell(new SetState(player, value, Stamps.Instance, Stamps.State));
    }
}
