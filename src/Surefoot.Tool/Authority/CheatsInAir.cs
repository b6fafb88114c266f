using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>It jumps, and from the top on nothing pulls it down.</summary>
/// <param name="every">How often it tells where it is, seconds.</param>
internal sealed class Flight(double every) : Cheat
{
    private double told;

    internal override string Name => SaysContact == true ? "flying (as if it stood)" : "flying";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.InTheAir, ClaimReason.TooHigh];

    internal override Position Place(Dice dice) => Anywhere(dice);

    internal override MovementKeys Keys(double time) =>
        MovementKeys.Forward | (time is > 2 and < 2.6 ? MovementKeys.Jump : MovementKeys.None);

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (time < 2.6 || (!HasBegun && (client.Body.HasContact || client.Body.Velocity.Z > 1))) return;
        if (!HasBegun) told = time;
        Begin(client, time);
        client.Body.SetState(client.Body.State & ~PhysicsState.Gravity);
        client.Body.SetVelocity(client.Body.Velocity with { Z = 0 });
        if (time < told + every) return;
        told = time;
        client.TellPosition();
    }
}

/// <summary>Its jump goes up faster than skill allows; the message of it says so, or lies.</summary>
internal sealed class SuperJump(bool tells) : Cheat
{
    private const float Factor = 1.6f;

    internal override string Name => tells ? "super jump (told)" : "super jump (not told)";

    internal override IReadOnlyList<ClaimReason> Reasons => tells ? [ClaimReason.JumpTooHigh] : [ClaimReason.TooHigh];

    internal override Position Place(Dice dice) => Anywhere(dice);

    internal override MovementKeys Keys(double time) => MovementKeys.Forward | (time is > 2 and < 2.7 ? MovementKeys.Jump : Tap(time, 0.5));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (HasBegun || time < 2) return;
        if (tells)
        {
            if (time < 2.6) return;
            CharacterStats own = client.Player.Weenie.Stats;
            client.Player.Weenie.SetStats(own with { JumpSkill = 4 * own.JumpSkill });
            Begin(client, time);
        }
        else if (client.Body.Velocity.Z > 1)
        {
            Begin(client, time);
            client.Body.SetVelocity(client.Body.Velocity * new Vector3(1, 1, Factor));
        }
    }
}

/// <summary>It falls by a metre a second and no faster.</summary>
/// <param name="every">How often it tells where it is, seconds.</param>
internal sealed class Glide(double every) : Cheat
{
    private double told;

    internal override string Name => SaysContact == true ? "gliding (as if it stood)" : "gliding";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.InTheAir, ClaimReason.TooHigh];

    internal override Position Place(Dice dice) => Anywhere(dice);

    internal override CharacterStats Stats(Dice dice) => new((int)dice.Roll(100, 300), (int)dice.Roll(250, 400));

    internal override MovementKeys Keys(double time) =>
        MovementKeys.Forward | (time is > 2 and < 2.95 ? MovementKeys.Jump : MovementKeys.None);

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (client.Body.HasContact || !(client.Body.Velocity.Z < -1)) return;
        client.Body.SetVelocity(client.Body.Velocity with { Z = -1 });
        if (!HasBegun) told = time;
        Begin(client, time);
        if (time < told + every) return;
        told = time;
        client.TellPosition();
    }
}
