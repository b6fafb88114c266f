using Surefoot.Client;
using Surefoot.DemoWorld;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Tool.Tests.Samples;

/// <summary>What a client tells of its movement, in the lines that the claim server reads.</summary>
internal sealed class ClaimLines : IMovementObserver
{
    private double last;

    internal List<string> Lines { get; } = [];

    /// <summary>Runs into the corner and jumps.</summary>
    internal static ClaimLines OfAWalk(NamedPlace from)
    {
        ClaimLines told = new();
        using Simulation world = Simulation.Open(Sample.World);
        Player player = world.SpawnPlayer(
            Place.Parse(from.Words()), new CharacterStats(RunSkill: 300, JumpSkill: 250),
            options: new LocalPlayerOptions { Observer = told });
        for (double now = 0; now < 4; now += 1.0 / 60)
            player.Update(MovementKeys.Forward | (now is > 1 and < 1.4 ? MovementKeys.Jump : MovementKeys.None), now);
        return told;
    }

    public void OnMoveToState(in MoveToState message, double now)
    {
        int bits = (message.Contact ? 1 : 0) + (message.StandingLongJump ? 2 : 0);
        WireRawMotion m = message.Motion;
        Say("keys", now, $"{m.ForwardCommand:X},{m.SidestepCommand:X},{m.TurnCommand:X},{m.CurrentHoldKey:X},{bits}", message.Position);
    }

    public void OnJump(in Jump message, double now)
    {
        var v = message.Velocity;
        Say("jump", now, FormattableString.Invariant($"{message.Extent:R},{v.X:R},{v.Y:R},{v.Z:R}"), message.Position);
    }

    public void OnAutonomousPosition(in AutonomousPosition message, double now) => Say("claim", now, "-", message.Position);

    private void Say(string what, double now, string words, WirePosition at)
    {
        var (o, q) = (at.Origin, at.Orientation);
        string place = FormattableString.Invariant($"0x{at.Cell:X8} [{o.X:R} {o.Y:R} {o.Z:R}] {q.W:R} {q.X:R} {q.Y:R} {q.Z:R}");
        Lines.Add(FormattableString.Invariant($"{what} {now - last:R} {words} {place}"));
        last = now;
    }
}
