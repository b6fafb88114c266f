using Surefoot.Physics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Tool.Authority;

/// <summary>A server that hears a player's messages and judges each of them.</summary>
internal sealed class JudgingServer(PhysicsEngine engine, MovementAuthority authority) : IMessageReceiver
{
    private uint loadedBlock;

    /// <summary>The time of what arrives, seconds.</summary>
    internal double Now { get; set; }

    /// <summary>Claims that were judged.</summary>
    internal int Claims { get; private set; }

    /// <summary>Claims that told a place and were judged.</summary>
    internal int Positions { get; private set; }

    /// <summary>What was not accepted.</summary>
    internal List<Objection> Objections { get; } = [];

    /// <summary>Believes the claim all the same, so that the next ones are judged by themselves.</summary>
    internal bool GivesIn { get; init; }

    public void OnMessage(in WireMessage message)
    {
        uint block = CellIds.BlockOf(authority.Position.CellId);
        if (block != loadedBlock) engine.World.EnsureLoadedAround(authority.Position, 1);
        loadedBlock = block;
        engine.Tick(Now);
        ClaimVerdict verdict;
        WirePosition place;
        string what;
        if (message.TryRead(out MoveToState move)) (verdict, place, what) = (authority.Judge(move, Now), move.Position, "MoveToState");
        else if (message.TryRead(out Jump jump)) (verdict, place, what) = (authority.Judge(jump, Now), jump.Position, "Jump");
        else if (message.TryRead(out AutonomousPosition position))
            (verdict, place, what) = (authority.Judge(position, Now), position.Position, "AutonomousPosition");
        else return;
        Claims++;
        if (what != "Jump") Positions++;
        if (verdict.IsAccepted) return;
        Position claimed = new(place.Cell, new Frame(place.Origin, place.Orientation));
        Objections.Add(new Objection(Now, what, verdict, claimed, Claims, Positions));
        if (GivesIn) authority.TryPlace(claimed, Now);
    }
}

/// <summary>A claim that was not accepted.</summary>
/// <param name="Time">When, seconds.</param>
/// <param name="Message">What kind of message.</param>
/// <param name="Verdict">The verdict.</param>
/// <param name="Claimed">The place claimed.</param>
/// <param name="ClaimNumber">The how many-th claim it was.</param>
/// <param name="PositionNumber">The how many-th place told it was.</param>
internal sealed record Objection(double Time, string Message, ClaimVerdict Verdict, Position Claimed, int ClaimNumber, int PositionNumber);
