using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>
/// A server in the same process, for one player: it owns the character's numbers and says what everybody is told of the player's movement.
/// It speaks the bytes of the wire both ways; what it says arrives after a while.
/// </summary>
/// <remarks>
/// Specification 08, 5.7, 7 and 8. It has no world of its own: it neither checks where the player says to be nor answers that, and it takes
/// no stamina for a jump.
/// </remarks>
public sealed class LoopbackServer : IServerLink
{
    private const ushort FirstLife = 1;
    private const int LongestAction = 1024;

    private readonly MessageQueue queue = new();
    private readonly CharacterMessages character;
    private readonly PassedActions actions = new();
    private readonly TopSpeedRule topSpeedRule;
    private readonly uint player;
    private readonly byte[] scratch = new byte[LongestAction];
    private double latency;
    private WireRawMotion asked = new();
    private bool chargesLongJump;
    private bool onGround;
    private uint sent;
    private ushort movementStamp, serverControlStamp;

    /// <summary>A server whose player has just logged in: the character's numbers are on their way.</summary>
    /// <param name="player">Id of the player's object, not 0.</param>
    /// <param name="stats">The character's numbers.</param>
    /// <param name="now">Seconds.</param>
    /// <param name="latency">Seconds from a message of the client to its answer, 0 or more. The login is over: its messages are there
    /// already.</param>
    /// <param name="topSpeedRule">From which run skill on the top speed holds.</param>
    /// <exception cref="ArgumentException">A number is out of range.</exception>
    public LoopbackServer(
        uint player, CharacterStats stats, double now, double latency = 0, TopSpeedRule topSpeedRule = TopSpeedRule.EightHundredAndAbove)
    {
        ArgumentOutOfRangeException.ThrowIfZero(player);
        ThrowIfNegative(stats);
        ThrowIfNotFinite(now);
        this.player = player;
        this.topSpeedRule = topSpeedRule;
        Latency = latency;
        Stats = stats;
        character = new CharacterMessages(queue, player);
        character.TellAll(stats, now);
    }

    /// <summary>Seconds from a message of the client to its answer.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative or not finite.</exception>
    public double Latency
    {
        get => latency;
        set
        {
            if (!(value >= 0) || !double.IsFinite(value))
                throw new ArgumentOutOfRangeException(nameof(value), value, "A latency is a number of seconds, 0 or more.");
            latency = value;
        }
    }

    /// <summary>The character's numbers, as the server has them.</summary>
    public CharacterStats Stats { get; private set; }

    /// <summary>The run rate that follows from them.</summary>
    public float RunRate => Stats.RunRate(topSpeedRule);

    /// <summary>Messages on their way to the client.</summary>
    public int PendingCount => queue.Count;

    /// <summary>Messages of the client that could not be read. Nothing follows from them.</summary>
    public long UnreadableCount { get; private set; }

    /// <summary>
    /// Changes the character's numbers and tells the client. When its body then goes at another speed, the server orders it to go on at
    /// that speed, and so has the control until the client's keys take it back.
    /// </summary>
    /// <param name="stats">The numbers.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">A number is negative, or the time is not finite; nothing has changed.</exception>
    public void SetStats(CharacterStats stats, double now)
    {
        ThrowIfNotFinite(now);
        ThrowIfNegative(stats);
        CharacterStats before = Stats;
        Stats = stats;
        character.TellChanges(before, stats, now + latency);
        MovementData motion = MotionTranslation.Interpret(asked, RunRate, chargesLongJump);
        if (onGround && motion != MotionTranslation.Interpret(asked, before.RunRate(topSpeedRule), chargesLongJump)) Order(motion, now);
    }

    /// <inheritdoc/>
    /// <exception cref="ArgumentException">The time is not finite, or the message has no form on the wire; nothing has changed.</exception>
    public void Send<T>(in T action, double now)
        where T : IGameAction<T>
    {
        ThrowIfNotFinite(now);
        if (!WireMessage.TryWrite(action, scratch, out int length, sent + 1))
            throw new ArgumentException($"This {T.Type} has no form on the wire.", nameof(action));
        sent++;
        Take(scratch.AsSpan(0, length), now);
    }

    /// <inheritdoc/>
    public void Receive(double now, IMessageReceiver receiver)
    {
        ArgumentNullException.ThrowIfNull(receiver);
        while (queue.TryPeek(now, out WireMessage message))
        {
            try
            {
                receiver.OnMessage(message);
            }
            finally
            {
                queue.Dequeue();
            }
        }
    }

    /// <summary>Takes in the bytes of a message of the client.</summary>
    internal void Take(ReadOnlySpan<byte> bytes, double now)
    {
        if (!WireMessage.TryParse(bytes, out WireMessage message))
        {
            UnreadableCount++;
            return;
        }

        switch (message.Id.Action)
        {
            case GameActionType.MoveToState when IsReadable(message, out MoveToState move):
                OnMoveToState(move, now);
                break;
            case GameActionType.Jump when IsReadable(message, out Jump _):
                onGround = false;
                break;
            case GameActionType.AutonomousPosition when IsReadable(message, out AutonomousPosition position):
                onGround = position.Contact;
                break;
        }
    }

    private void OnMoveToState(in MoveToState move, double now)
    {
        asked = move.Motion;
        chargesLongJump = move.StandingLongJump;
        onGround = move.Contact;
        if (!actions.TryPass(asked.Actions, out MotionActions passed)) return;
        Tell(MotionTranslation.Interpret(asked, RunRate, chargesLongJump, passed), autonomous: true, now);
    }

    private void Order(in MovementData motion, double now)
    {
        serverControlStamp++;
        Tell(motion, autonomous: false, now);
    }

    private void Tell(in MovementData motion, bool autonomous, double now) =>
        queue.Enqueue(new UpdateMotion(player, FirstLife, ++movementStamp, serverControlStamp, autonomous, motion), now + latency);

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value)) return true;
        UnreadableCount++;
        return false;
    }

    private static void ThrowIfNegative(in CharacterStats stats)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(stats.RunSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.JumpSkill, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.Stamina, nameof(stats));
        ArgumentOutOfRangeException.ThrowIfNegative(stats.Strength, nameof(stats));
    }

    private static void ThrowIfNotFinite(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
    }
}
