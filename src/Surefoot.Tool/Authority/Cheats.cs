using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Authority;

/// <summary>All that a judge has to catch.</summary>
internal static class Cheats
{
    /// <summary>A new one of each, what differs between seeds among it.</summary>
    internal static IEnumerable<Cheat> All(Dice dice) =>
    [
        new FastClock(), new FastLegs(), new ThroughWall(), new ClippedCorner(), new Flight(), new SuperJump(tells: dice.Is(0.5)),
        new Glide(), new Rewind(), new HighSteps(),
    ];
}

/// <summary>Its clock runs a fifth too fast, and all of it with that.</summary>
internal sealed class FastClock : Cheat
{
    internal override string Name => "speed x 1.2 (clock)";

    internal override double Limit => 15;

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-5, 5));

    internal override MovementKeys Keys(double time) => MovementKeys.Forward | (time % 7 < 1.2 ? MovementKeys.TurnLeft : MovementKeys.None);

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (time < 3) return;
        client.ClockRate = 1.2;
        Begin(client, time);
    }
}

/// <summary>It runs a fifth faster than its skill allows.</summary>
internal sealed class FastLegs : Cheat
{
    internal override string Name => "speed x 1.2 (legs)";

    internal override double Limit => 15;

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-5, 5));

    // It lets go for a moment, and runs faster from then on.
    internal override MovementKeys Keys(double time) => time is > 2.9 and < 3.1 ? MovementKeys.None : MovementKeys.Forward;

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (time < 3 || HasBegun) return;
        CharacterStats own = client.Player.Weenie.Stats;
        double share = ((4 * 1.2 * own.RunRate()) - 4) / 11;
        client.Player.Weenie.SetStats(own with { RunSkill = (int)Math.Round(200 * share / (1 - share)) });
        Begin(client, time);
    }
}

/// <summary>It goes on straight through a house's wall.</summary>
internal sealed class ThroughWall : Cheat
{
    private const float DoorHalf = 1.2f, WallHalf = 3.4f;
    private Position last;
    private double blocked;

    internal override string Name => "through a wall";

    internal override Position Place(Dice dice) =>
        AuthorityWorld.PlaceOf("house-door", right: (float)dice.Roll(DoorHalf, WallHalf) * (dice.Is(0.5) ? 1 : -1));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (HasBegun)
        {
            Push(client, SpeedOf(client) * frame);
            return;
        }

        blocked = time > 0.5 && last.DistanceTo(client.Position) < 1e-3 ? blocked + frame : 0;
        last = client.Position;
        if (blocked > 0.3) Begin(client, time);
    }
}

/// <summary>It cuts the corner of a house, well over a metre of it.</summary>
internal sealed class ClippedCorner : Cheat
{
    private double speed;
    private Position last;

    internal override string Name => "clipping a corner";

    internal override Position Place(Dice dice) =>
        AuthorityWorld.PlaceOf("house-door", right: (float)dice.Roll(0.2, 0.7), ahead: 0.5f, turn: (float)dice.Roll(36, 44));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        double moved = last.CellId == 0 ? 0 : last.DistanceTo(client.Position);
        last = client.Position;
        if (!HasBegun && time > 0.2 && moved > 0 && moved < 0.8 * speed * frame) Begin(client, time);
        speed = Math.Max(speed, moved / frame);
        if (!HasBegun || time > Began + 0.6) return;
        Push(client, SpeedOf(client) * frame);
        last = client.Position;
    }
}

/// <summary>It jumps, and from the top on nothing pulls it down. It tells its places as if it stood.</summary>
internal sealed class Flight : Cheat
{
    private double told;

    internal override string Name => "flying";

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-20, 20));

    internal override MovementKeys Keys(double time) =>
        MovementKeys.Forward | (time is > 2 and < 2.6 ? MovementKeys.Jump : MovementKeys.None);

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (time < 2.6 || (!HasBegun && (client.Body.HasContact || client.Body.Velocity.Z > 1))) return;
        if (!HasBegun) told = time;
        Begin(client, time);
        client.Body.SetState(client.Body.State & ~PhysicsState.Gravity);
        client.Body.SetVelocity(client.Body.Velocity with { Z = 0 });
        if (time < told + 1) return;
        told = time;
        client.TellPosition();
    }
}

/// <summary>Its jump goes up faster than skill allows; the message of it says so, or lies.</summary>
internal sealed class SuperJump(bool tells) : Cheat
{
    private const float Factor = 1.6f;

    internal override string Name => tells ? "super jump (told)" : "super jump (not told)";

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-20, 20));

    internal override MovementKeys Keys(double time) => MovementKeys.Forward | (time is > 2 and < 2.7 ? MovementKeys.Jump : Tap(time, 0.5));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (HasBegun || time < 2) return;
        if (tells)
        {
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
internal sealed class Glide : Cheat
{
    internal override string Name => "gliding";

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-20, 20));

    internal override CharacterStats Stats(Dice dice) => new((int)dice.Roll(100, 300), (int)dice.Roll(250, 400));

    internal override MovementKeys Keys(double time) =>
        MovementKeys.Forward | (time is > 2 and < 2.95 ? MovementKeys.Jump : Tap(time, 0.8));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        if (client.Body.HasContact || !(client.Body.Velocity.Z < -1)) return;
        client.Body.SetVelocity(client.Body.Velocity with { Z = -1 });
        Begin(client, time);
    }
}

/// <summary>It is where it was two seconds ago, all at once.</summary>
internal sealed class Rewind : Cheat
{
    private readonly List<(double Time, Position Place)> way = [];

    internal override string Name => "position rewind";

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("runway", turn: (float)dice.Roll(-20, 20));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        way.Add((time, client.Position));
        if (time < 6 || HasBegun) return;
        client.Body.SetPositionSimple(way.Find(one => one.Time >= time - 2).Place, sliding: true);
        Begin(client, time);
    }
}

/// <summary>It climbs steps twice as high as a human's: where those of a human end, it is lifted onto the next one.</summary>
internal sealed class HighSteps : Cheat
{
    private const float Height = 0.9f, Ahead = 0.65f;
    private Position last;
    private double blocked;

    internal override string Name => "step height x 2";

    internal override Position Place(Dice dice) => AuthorityWorld.PlaceOf("steps-90", right: (float)dice.Roll(-0.4, 0.4));

    internal override void Act(PlayedClient client, double time, double frame)
    {
        blocked = time > 0.3 && last.DistanceTo(client.Position) < 1e-3 ? blocked + frame : 0;
        last = client.Position;
        if (blocked < 0.2) return;
        Begin(client, time);
        client.Body.SetPositionSimple(AuthorityWorld.Beside(client.Position, 0, Ahead, up: Height), sliding: false);
    }
}
