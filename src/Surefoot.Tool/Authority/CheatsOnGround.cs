using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>Its clock runs a fifth too fast, and all of it with that.</summary>
internal sealed class FastClock : Cheat
{
    internal override string Name => "speed x 1.2 (clock)";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.TooFast];

    internal override double Limit => 15;

    internal override Position Place(Dice dice) => AnyOf(dice, 5, "runway", "meadow-east");

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

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.TooFast];

    internal override double Limit => 15;

    internal override Position Place(Dice dice) => AnyOf(dice, 5, "runway", "meadow-east");

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

/// <summary>It goes on straight through a wall.</summary>
internal sealed class ThroughWall : Cheat
{
    private const float DoorHalf = 1.2f, WallHalf = 3.4f;
    private Position last;
    private double blocked;

    internal override string Name => "through a wall";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.ThroughWall];

    internal override Position Place(Dice dice)
    {
        float side = dice.Is(0.5) ? 1 : -1;
        return (int)dice.Roll(0, 5) switch
        {
            0 => AuthorityWorld.PlaceOf("house-door", right: (float)dice.Roll(DoorHalf, WallHalf) * side),
            1 => AuthorityWorld.PlaceOf("house-hall", ahead: (float)dice.Roll(-1.5, 1), turn: 90 * side),
            2 => AuthorityWorld.PlaceOf("dungeon-corridor", ahead: (float)dice.Roll(0, 2), turn: 90 * side),
            3 => AuthorityWorld.PlaceOf("corners", turn: -30),
            _ => AuthorityWorld.PlaceOf("close-blocks", right: (float)dice.Roll(-1, 1), ahead: -6, up: -3),
        };
    }

    internal override void Act(PlayedClient client, double time, double frame)
    {
        double moved = last.CellId == 0 ? 0 : last.DistanceTo(client.Position);
        if (HasBegun) Push(client, (SpeedOf(client) * frame) - moved);
        blocked = time > 0.3 && last.DistanceTo(client.Position) < 1e-3 ? blocked + frame : 0;
        last = client.Position;
        if (blocked > 0.3) Begin(client, time);
    }
}

/// <summary>It cuts the corner of a house or of a block of stone, well over a metre of it.</summary>
internal sealed class ClippedCorner : Cheat
{
    private Position last;

    internal override string Name => "clipping a corner";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.ThroughWall];

    internal override Position Place(Dice dice)
    {
        float side = dice.Is(0.5) ? 1 : -1;
        return dice.Is(0.5)
            ? AuthorityWorld.PlaceOf("house-door", side * (float)dice.Roll(-0.3, 0.2), 0.5f, turn: side * (float)dice.Roll(36, 44))
            : AuthorityWorld.PlaceOf("close-blocks", -side * 3.3f, -6, turn: side * (float)dice.Roll(33, 37), up: -3);
    }

    internal override void Act(PlayedClient client, double time, double frame)
    {
        double moved = last.CellId == 0 ? 0 : last.DistanceTo(client.Position);
        if ((client.Body.CurrentSeat.Transient & TransientState.Sliding) != 0) Begin(client, time);
        if (HasBegun && time < Began + 0.6) Push(client, (SpeedOf(client) * frame) - moved);
        last = client.Position;
    }
}

/// <summary>It is where it was two seconds ago, all at once.</summary>
internal sealed class Rewind : Cheat
{
    private readonly List<(double Time, Position Place)> way = [];

    internal override string Name => "position rewind";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.OffCourse, ClaimReason.Teleport];

    internal override Position Place(Dice dice) => AnyOf(dice, 20, "runway", "meadow-east", "meadow", "block-corner", "landblock-border");

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
    private const float Ahead = 0.65f;
    private Position last;
    private float height;
    private double blocked;

    internal override string Name => "step height x 2";

    internal override IReadOnlyList<ClaimReason> Reasons => [ClaimReason.ThroughWall, ClaimReason.TooHigh];

    internal override Position Place(Dice dice)
    {
        (string name, height) = dice.Is(0.5) ? ("steps-90", 0.9f) : ("maze", 1.2f);
        return AuthorityWorld.PlaceOf(name, right: (float)dice.Roll(-0.4, 0.4));
    }

    internal override void Act(PlayedClient client, double time, double frame)
    {
        blocked = time > 0.3 && last.DistanceTo(client.Position) < 1e-3 ? blocked + frame : 0;
        last = client.Position;
        if (blocked < 0.2) return;
        Begin(client, time);
        client.Body.SetPositionSimple(AuthorityWorld.Beside(client.Position, 0, Ahead, up: height), sliding: false);
    }
}
