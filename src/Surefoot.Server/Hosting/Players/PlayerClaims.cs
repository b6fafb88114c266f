using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>What a client claims of its player: it is judged, believed or put right, and everybody is told.</summary>
/// <remarks>Specification 08, 5.7. Servers of the field believe what their own sweep refuses; here it is put right.</remarks>
internal sealed class PlayerClaims(WorldStage stage, PlayerItem player)
{
    /// <summary>An honest client claims a few things a second; who claims more than this is not heard.</summary>
    private const double ClaimsPerSecond = 40, BurstSeconds = 5;

    /// <summary>How far a player that the server moves may be from where it was believed to be, metres, and metres a second.</summary>
    private const double OrderedSlack = 3, OrderedSpeed = 20;

    /// <summary>Farther than this from where it was believed to be a player is not, metres: it is a fall of nine seconds.</summary>
    private const double Farthest = 400;

    private double heardUntil, orderedSince;

    private bool IsJudged => stage.Server.Options.Authority is not null;

    /// <summary>The server moves the player from now on: its keys say nothing of where it goes.</summary>
    public void BeginOrder() => orderedSince = stage.Server.Now;

    public void Take(in MoveToState claim)
    {
        if (!IsHeard(out double now)) return;
        if (player.Broadcast.IsTeleporting)
        {
            player.Broadcast.Take(claim, now);
            return;
        }

        EndOrder(claim.Position, claim.Stamps, now);
        ClaimVerdict verdict = IsTooFar(claim.Position, claim.Stamps) ?? (IsJudged
            ? player.Authority.Judge(claim, now)
            : Believe(claim.Position, now));
        if (verdict.Reason == ClaimReason.StaleSequence)
        {
            // Where it was counts no more; its keys do.
            MoveToState keys = claim with { Position = WorldItem.WireOf(player.Authority.Position), Stamps = player.Authority.Stamps };
            if (player.Authority.Judge(keys, now).IsAccepted) player.Broadcast.Take(keys, now);
            return;
        }

        if (verdict.Reason != ClaimReason.BadNumber)
            player.Broadcast.Take(verdict.IsAccepted ? claim : claim with { Position = WorldItem.WireOf(verdict.Position) }, now);
        Settle(verdict, now);
    }

    public void Take(in AutonomousPosition claim)
    {
        if (!IsHeard(out double now) || player.Broadcast.IsTeleporting) return;
        ClaimVerdict verdict = player.Use.IsUnderWay && TryFollowOrder(claim.Position, claim.Stamps, now, out ClaimVerdict followed)
            ? followed
            : IsTooFar(claim.Position, claim.Stamps) ?? (IsJudged ? player.Authority.Judge(claim, now) : Believe(claim.Position, now));
        if (verdict.IsAccepted) player.Broadcast.Take(claim, now);
        Settle(verdict, now);
    }

    public void Take(in Jump claim)
    {
        if (!IsHeard(out double now)) return;
        EndOrder(claim.Position, claim.Stamps, now);
        ClaimVerdict verdict = !IsJudged || player.Broadcast.IsTeleporting
            ? default
            : IsTooFar(claim.Position, claim.Stamps) ?? player.Authority.Judge(claim, now);
        if (verdict.IsAccepted) player.Broadcast.Take(claim);
        else Settle(verdict, now);
    }

    /// <summary>Nobody comes so far between two claims: no way there is looked for.</summary>
    private ClaimVerdict? IsTooFar(in WirePosition at, in MovementStamps stamps)
    {
        if (!IsJudged || !IsCurrent(stamps) || !ClaimReader.TryRead(at, out Position place)) return null;
        return place.DistanceTo(player.Authority.Position) <= Farthest
            ? null
            : new ClaimVerdict(ClaimOutcome.Refused, ClaimReason.Teleport, player.Authority.Position);
    }

    private bool IsCurrent(in MovementStamps stamps)
    {
        MovementStamps own = player.Authority.Stamps;
        return stamps.Instance == own.Instance && stamps.Teleport == own.Teleport && stamps.ForcePosition == own.ForcePosition;
    }

    private bool IsHeard(out double now)
    {
        now = stage.Server.Now;
        double until = Math.Max(heardUntil, now) + (1 / ClaimsPerSecond);
        if (until - now > BurstSeconds)
        {
            stage.Server.Figures.ClaimsOverRate++;
            return false;
        }

        heardUntil = until;
        stage.Server.Figures.Claims++;
        return true;
    }

    private void Settle(in ClaimVerdict verdict, double now)
    {
        if (verdict.IsAccepted)
        {
            player.MoveTo(player.Authority.Position);
            return;
        }

        // Its client has yet to hear that it was put somewhere.
        if (verdict.Reason == ClaimReason.StaleSequence) return;
        stage.Server.Figures.Refuse(verdict.Reason);
        stage.Server.Say(
            $"{player.Name} claims what is not so ({verdict.Reason}, by {verdict.Miss:0.00} m): put to {verdict.Position}");
        player.Authority.TryPlace(verdict.Position, now);
        player.Broadcast.Force(WorldItem.WireOf(player.Authority.Position), player.Authority.OnWalkable, now);
        player.Authority.Stamps = player.MovementStamps();
        player.MoveTo(player.Authority.Position);
    }

    /// <summary>A move that the server ordered ends: its client has taken the control back, where it is now.</summary>
    private void EndOrder(in WirePosition at, in MovementStamps stamps, double now)
    {
        if (!player.Use.IsUnderWay) return;
        TryFollowOrder(at, stamps, now, out _);
        player.Use.End();
    }

    /// <summary>Where a player is that the server moves: anywhere that it can have come to.</summary>
    private bool TryFollowOrder(in WirePosition at, in MovementStamps stamps, double now, out ClaimVerdict verdict)
    {
        Position before = player.Authority.Position;
        verdict = new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, before);
        if (!IsCurrent(stamps) || !ClaimReader.TryRead(at, out Position place)) return false;
        if (place.DistanceTo(before) > OrderedSlack + (OrderedSpeed * (now - orderedSince)) || !stage.TryPlace(player.Authority, place))
            return false;
        orderedSince = now;
        verdict = verdict with { Position = player.Authority.Position };
        return true;
    }

    /// <summary>What is believed without a judge.</summary>
    private ClaimVerdict Believe(in WirePosition at, double now)
    {
        if (!ClaimReader.TryRead(at, out Position place))
            return new ClaimVerdict(ClaimOutcome.Refused, ClaimReason.BadNumber, player.Authority.Position);
        return stage.TryPlace(player.Authority, place)
            ? new ClaimVerdict(ClaimOutcome.Accepted, ClaimReason.None, place)
            : new ClaimVerdict(ClaimOutcome.Refused, ClaimReason.NotLoaded, player.Authority.Position);
    }
}
