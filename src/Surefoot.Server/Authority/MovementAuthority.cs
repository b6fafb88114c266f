using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>
/// Judges what one player claims of its movement. It steps a shadow of the player's body, which nobody meets, with the keys that the player
/// said it holds, and looks whether that comes to where the player says to be, and how long it takes. It only asks about the engine's
/// world: any number of authorities may judge at once, each on one thread at a time, while nobody changes that world.
/// </summary>
/// <remarks>
/// Specification 08, 5.6 (what a client sends when) and 8; 01 (speeds and jumps). How a way is judged is in
/// <c>MovementAuthority.Way.cs</c>.
/// </remarks>
public sealed partial class MovementAuthority
{
    private const WeenieTraits Player = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;

    private readonly PhysicsEngine engine;
    private readonly AuthorityOptions options;
    private readonly WorldQuery query;
    private readonly Mover solid, soft;
    private readonly PlayerWeenie weenie;
    private readonly List<ShadowBody> shadows;
    private readonly ShadowBody probe;
    private readonly Beliefs beliefs;
    private readonly Course course;
    private CharacterStats stats, formerStats;
    private double statsChanged = double.NegativeInfinity;
    private double turnedAt = double.NegativeInfinity, steppedAt = double.NegativeInfinity;
    private readonly double foot;
    private double lastTime, lateAt = double.NegativeInfinity, credit, airLag, doubts, doubtTime, opinions;
    private bool isPlaced;

    /// <summary>An authority over a player that is not yet anywhere; <see cref="TryPlace"/> puts it into the world.</summary>
    /// <param name="engine">The world. What is around the player is to be loaded.</param>
    /// <param name="setup">Shape of the player.</param>
    /// <param name="motions">Motions of the player.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="options">Thresholds.</param>
    /// <exception cref="ArgumentException">A number is out of range.</exception>
    public MovementAuthority(
        PhysicsEngine engine, SetupAsset setup, MotionTableAsset motions, CharacterStats stats, AuthorityOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(engine);
        ArgumentNullException.ThrowIfNull(setup);
        ArgumentNullException.ThrowIfNull(motions);
        options ??= new AuthorityOptions();
        options.ThrowIfBad();
        this.engine = engine;
        this.options = options;
        this.stats = formerStats = stats;
        query = engine.CreateQuery();
        solid = Mover.OfBody(setup, weenie: Player);
        foot = setup.Spheres.Length > 0 ? setup.Spheres[0].Radius : 0;
        soft = Mover.OfBody(setup, weenie: Player);
        weenie = new PlayerWeenie(stats, options.TopSpeedRule);
        shadows = [];
        probe = MakeShadow();
        beliefs = new Beliefs(MakeShadow, probe);
        course = new Course(probe);

        ShadowBody MakeShadow()
        {
            ShadowBody made = new(engine.Cells, setup, motions, weenie, Player);
            shadows.Add(made);
            return made;
        }
    }

    /// <summary>Where the player is, by the last claim that was accepted.</summary>
    public Position Position => beliefs.First.Position;

    /// <summary>It stands on the ground, by that claim.</summary>
    public bool OnWalkable => beliefs.First.OnWalkable;

    /// <summary>
    /// The stamps of the player's object that claims must have: claims with another life, teleport or correction are stale. To be changed
    /// when a message that changes them is sent.
    /// </summary>
    public MovementStamps Stamps { get; set; } = new(1, 0, 0, 0);

    /// <summary>
    /// What the server says of the player, to be changed when it says something else: killers of the same kind stop each other, and the
    /// impenetrable everybody; other players pass. That the player is one is understood.
    /// </summary>
    public WeenieTraits Traits
    {
        get => solid.Weenie;
        set
        {
            foreach (ShadowBody shadow in shadows) shadow.SetWeenie(value | Player);
            solid.Object.Weenie = soft.Object.Weenie = value | Player;
        }
    }

    /// <summary>The player's own body in the engine's world, which does not stand in its way; null when it has none there.</summary>
    public PhysicsBody? Body
    {
        get => solid.Object.StandsFor as PhysicsBody;
        set
        {
            foreach (ShadowBody shadow in shadows) shadow.StandFor(value);
            solid.Object.StandsFor = soft.Object.StandsFor = value;
        }
    }

    /// <summary>Claims that were accepted.</summary>
    public long AcceptedCount { get; private set; }

    /// <summary>Claims that were put right.</summary>
    public long CorrectedCount { get; private set; }

    /// <summary>Claims that were refused.</summary>
    public long RefusedCount { get; private set; }

    /// <summary>Courses that were stepped: about one a claim.</summary>
    public long CourseCount { get; private set; }

    /// <summary>Puts the player somewhere: into the world, or to where it was teleported or put right.</summary>
    /// <param name="place">Where.</param>
    /// <param name="now">Seconds.</param>
    /// <returns>False when there is no room; nothing has changed then.</returns>
    /// <exception cref="ArgumentException">The place or the time is not finite, or the id names no cell; nothing has changed.</exception>
    public bool TryPlace(in Position place, double now)
    {
        ThrowIfNotFinite(now);
        if (!probe.TryEnter(place)) return false;
        beliefs.Collapse();
        beliefs.First.TryEnter(place);
        isPlaced = true;
        (lastTime, lateAt, credit, airLag) = (now, double.NegativeInfinity, options.Slack, 0);
        (doubts, opinions, doubtTime) = (options.MostDoubts, MostOpinions, now);
        return true;
    }

    /// <summary>
    /// Takes over new numbers of the character. The last ones hold as well for a while: the player hears of the change late.
    /// </summary>
    /// <exception cref="ArgumentException">A number is negative, or the time is not finite; nothing has changed.</exception>
    public void SetStats(CharacterStats value, double now)
    {
        ThrowIfNotFinite(now);
        weenie.SetStats(value);
        if (value == stats) return;
        (formerStats, stats, statsChanged) = (stats, value, now);
    }

    /// <summary>Judges what is asked of the player's body, and where it is.</summary>
    /// <param name="claim">The message.</param>
    /// <param name="now">When it arrived, seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The player is not anywhere yet.</exception>
    public ClaimVerdict Judge(in MoveToState claim, double now)
    {
        if (CheckForm(claim.Position, claim.Stamps, now, out Position to) is { } bad) return bad;
        if (!ClaimReader.TryRead(claim.Motion, keys)) return Refuse(ClaimReason.BadNumber, now);
        ClaimVerdict verdict = JudgeWay(to, claim.Contact, now);
        if (keys.TurnCommand != MotionCommand.None) turnedAt = now;
        if (keys.SidestepCommand != MotionCommand.None) steppedAt = now;
        for (int i = 0; i < beliefs.Count; i++) beliefs[i].Hold(keys, claim.StandingLongJump);
        return Count(verdict);
    }

    /// <summary>Judges where the player's body is.</summary>
    /// <param name="claim">The message.</param>
    /// <param name="now">When it arrived, seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The player is not anywhere yet.</exception>
    public ClaimVerdict Judge(in AutonomousPosition claim, double now) =>
        CheckForm(claim.Position, claim.Stamps, now, out Position to) ?? Count(JudgeWay(to, claim.Contact, now));

    /// <summary>Judges a jump.</summary>
    /// <param name="claim">The message.</param>
    /// <param name="now">When it arrived, seconds.</param>
    /// <remarks>As in retail, too little stamina refuses no jump: the exhausted jump as if they had no skill.</remarks>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    /// <exception cref="InvalidOperationException">The player is not anywhere yet.</exception>
    public ClaimVerdict Judge(in Jump claim, double now)
    {
        if (CheckForm(claim.Position, claim.Stamps, now, out Position to) is { } bad) return bad;
        if (!float.IsFinite(claim.Extent) || !float.IsFinite(claim.Velocity.LengthSquared())) return Refuse(ClaimReason.BadNumber, now);
        ClaimVerdict verdict = JudgeWay(to, stands: true, now);
        if (verdict.Reason == ClaimReason.InTheAir) verdict = verdict with { Reason = ClaimReason.JumpInTheAir };
        if (!verdict.IsAccepted) return Count(verdict);
        ClaimReason reason = JudgeJump(claim.Extent, claim.Velocity, now);
        if (reason != ClaimReason.None) return Refuse(reason, now);
        for (int i = 0; i < beliefs.Count; i++) beliefs[i].Jump(claim.Extent, claim.Velocity);
        Span<Vector3> walls = stackalloc Vector3[Sides];
        beliefs.ForkByWalls(walls[..FindWalls(walls)]);
        return Count(verdict);
    }

    /// <summary>What a claim must be before it is looked at.</summary>
    private ClaimVerdict? CheckForm(in WirePosition wire, in MovementStamps stamps, double now, out Position to)
    {
        ThrowIfNotFinite(now);
        if (!isPlaced) throw new InvalidOperationException("The player is not anywhere yet; place it first.");
        if (!ClaimReader.TryRead(wire, out to)) return Refuse(ClaimReason.BadNumber, now);
        bool current = stamps.Instance == Stamps.Instance && stamps.Teleport == Stamps.Teleport &&
            stamps.ForcePosition == Stamps.ForcePosition;
        return current ? null : Refuse(ClaimReason.StaleSequence, now);
    }

    /// <summary>The shadow jumps from where the player is; its velocity and that of the claim are compared.</summary>
    private ClaimReason JudgeJump(float extent, Vector3 velocity, double now)
    {
        if (!(extent is > 0 and <= 1) || !weenie.CanJump(extent)) return ClaimReason.JumpTooHigh;
        double across = new Vector2(velocity.X, velocity.Y).Length() - options.JumpTolerance, up = velocity.Z - options.JumpTolerance;
        ClaimReason reason = TryJump(stats) && (!HasFormerStats(now) || TryJump(formerStats))
            ? ClaimReason.JumpTooHigh
            : ClaimReason.None;
        if (reason != ClaimReason.None && stats.Stamina == 0 && !TryJump(stats with { Stamina = 1 }))
            reason = ClaimReason.JumpWithoutStamina;
        weenie.SetStats(stats);
        return reason;

        // True when these numbers do not allow it, running or walking.
        bool TryJump(CharacterStats numbers)
        {
            weenie.SetStats(numbers);
            double far = 0, high = 0;
            for (int i = 0; i < 2; i++)
            {
                probe.CopyFrom(beliefs.First, passesMovers: false);
                if (i == 0) probe.ToggleRun();
                probe.Jump(extent, null);
                Vector3 own = probe.LocalVelocity;
                far = Math.Max(far, new Vector2(own.X, own.Y).Length());
                high = Math.Max(high, own.Z);
            }

            return across > far || up > high;
        }
    }

    private ClaimVerdict Refuse(ClaimReason reason, double now, double miss = 0)
    {
        PassTime(now);
        return Count(new ClaimVerdict(ClaimOutcome.Refused, reason, Position, (float)miss));
    }

    private ClaimVerdict Count(in ClaimVerdict verdict)
    {
        if (verdict.Outcome == ClaimOutcome.Accepted) AcceptedCount++;
        else if (verdict.Outcome == ClaimOutcome.Corrected) CorrectedCount++;
        else RefusedCount++;
        return verdict;
    }

    private static void ThrowIfNotFinite(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
    }
}
