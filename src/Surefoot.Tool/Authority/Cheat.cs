using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>A client that is honest but for one thing.</summary>
internal abstract class Cheat
{
    private double tappedAt;
    private bool tapped;

    /// <summary>What it is called.</summary>
    internal abstract string Name { get; }

    /// <summary>The reasons of a verdict that are right for it; caught for another one is not caught.</summary>
    internal abstract IReadOnlyList<ClaimReason> Reasons { get; }

    /// <summary>Where it is played, from a seed.</summary>
    internal abstract Position Place(Dice dice);

    /// <summary>
    /// What it says, once it cheats, of whether it stands on the ground; null for what its body does.
    /// </summary>
    internal bool? SaysContact { get; init; }

    /// <summary>Numbers of the character.</summary>
    internal virtual CharacterStats Stats(Dice dice) => new((int)dice.Roll(100, 300), (int)dice.Roll(150, 300));

    /// <summary>It began to cheat, seconds from the begin; infinite before.</summary>
    internal double Began { get; private set; } = double.PositiveInfinity;

    /// <summary>How many places it had told then.</summary>
    internal int PlacesBefore { get; private set; }

    /// <summary>How many messages of its movement it had sent then.</summary>
    internal int ClaimsBefore { get; private set; }

    /// <summary>Seconds within which it must be caught; infinite when it is to be caught by the second place told.</summary>
    internal virtual double Limit => double.PositiveInfinity;

    protected bool HasBegun => double.IsFinite(Began);

    /// <summary>The keys it holds.</summary>
    internal virtual MovementKeys Keys(double time) => MovementKeys.Forward;

    /// <summary>After a frame of the client.</summary>
    internal abstract void Act(PlayedClient client, double time, double frame);

    protected void Begin(PlayedClient client, double time)
    {
        if (HasBegun) return;
        Began = time;
        (PlacesBefore, ClaimsBefore) = (client.PositionsTold, client.ClaimsTold);
        client.SaysContact = SaysContact;
    }

    /// <summary>A sidestep key tapped every so often: each tap tells where the body is, be it in the air.</summary>
    protected MovementKeys Tap(double time, double every)
    {
        if (time - tappedAt >= every) (tappedAt, tapped) = (time, !tapped);
        return tapped ? MovementKeys.SidestepLeft : MovementKeys.None;
    }

    /// <summary>One of some places, and a heading up to so many degrees beside its own.</summary>
    protected static Position AnyOf(Dice dice, double aside, params ReadOnlySpan<string> names) =>
        AuthorityWorld.PlaceOf(names[(int)dice.Roll(0, names.Length)], turn: (float)dice.Roll(-aside, aside));

    /// <summary>Open country, in which nobody runs into anything for some seconds.</summary>
    protected static Position Anywhere(Dice dice) =>
        AnyOf(dice, 20, "runway", "meadow-east", "meadow", "block-corner", "landblock-border", "hills");

    /// <summary>The body goes on along its heading whatever is there, on the level.</summary>
    protected static void Push(PlayedClient client, double metres)
    {
        if (metres <= 0) return;
        PhysicsBody body = client.Body;
        Position place = AuthorityWorld.Beside(body.Position, 0, (float)metres);
        body.Seat(new BodySeat(
            place, Vector3.Zero, TransientState.Contact | TransientState.OnWalkable, body.ContactPlane, body.ContactPlaneCellId,
            Vector3.Zero));
    }

    /// <summary>Running speed, m/s.</summary>
    protected static double SpeedOf(PlayedClient client) => MovementFormulas.RunSpeed * client.Player.Weenie.Stats.RunRate();
}
