using System.Numerics;
using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Authority;

/// <summary>Verdicts on single claims, over a perfect network.</summary>
public sealed class MovementAuthorityTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const string Meadow = "runway", House = "house-door";
    private const MovementKeys Forward = MovementKeys.Forward;

    [Fact, Behaviour("authority.accepts", "spec/08, 5.6: what our own client tells")]
    public void What_an_honest_client_tells_of_a_run_with_turns_jumps_and_walks_is_accepted()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        f.Hold(Forward | MovementKeys.TurnLeft, 0.7);
        f.Hold(Forward | MovementKeys.Jump, 0.5);
        f.Hold(Forward | MovementKeys.SidestepRight, 2);
        f.Hold(Forward | MovementKeys.Walk, 1.5);
        f.Hold(MovementKeys.Back, 1.5);
        f.Hold(MovementKeys.None, 1);
        Assert.Empty(f.Objections);
        Assert.True(f.Verdicts.Count > 12);
        Assert.Equal(f.Verdicts.Count, f.Authority.AcceptedCount);
        Assert.Equal(f.Body.Position, f.Authority.Position);
    }

    [Fact, Behaviour("authority.world", "design, decision 6: probing never changes a live body")]
    public void To_judge_changes_nothing_of_the_servers_world()
    {
        AuthorityFixture f = new(ground, Meadow);
        PhysicsBody guard = ground.Spawn(f.Server, 7, DemoGround.At(Meadow, ahead: 6));
        f.Server.Tick(1);
        ulong before = f.Server.HashState();
        f.Hold(Forward, 3);
        Assert.Equal(before, f.Server.HashState());
        Assert.True(guard.HasCell);
    }

    [Fact, Behaviour("authority.allocations", "design, decision 4")]
    public void To_judge_a_message_allocates_nothing_in_the_steady_state()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 3);
        AutonomousPosition here = f.Here;
        for (int i = 0; i < 50; i++) f.Authority.Judge(here, f.Now);
        MoveToState keys = f.LastMove with { Position = here.Position };
        for (int i = 0; i < 50; i++) f.Authority.Judge(keys, f.Now);
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++)
        {
            f.Authority.Judge(here, f.Now + i);
            f.Authority.Judge(keys, f.Now + i);
        }

        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact, Behaviour("authority.not-finite", "design, decision 7: bad input is refused and counted, never thrown")]
    public void Claims_that_are_no_numbers_or_that_no_key_asks_for_are_refused()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        WirePosition here = f.Here.Position;
        foreach (WirePosition bad in (WirePosition[])
        [
            here with { Origin = new Vector3(float.NaN, 1, 1) }, here with { Origin = new Vector3(1e30f, 1, 1) },
            here with { Orientation = default }, here with { Cell = 0 }, here with { Cell = 0xFFFF0001 },
        ])
            Assert.Equal((ClaimOutcome.Refused, ClaimReason.BadNumber), Of(f.Authority.Judge(f.Here with { Position = bad }, f.Now)));
        WireRawMotion fast = new(forwardCommand: (uint)MotionCommand.WalkForward, forwardSpeed: 5);
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.BadNumber), Of(f.Authority.Judge(f.LastMove with { Motion = fast }, f.Now)));
        Jump jump = new(float.NaN, new Vector3(0, 0, 5), here, f.Here.Stamps);
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.BadNumber), Of(f.Authority.Judge(jump, f.Now)));
        Assert.Equal(7, f.Authority.RefusedCount);
        Assert.Throws<ArgumentException>(() => f.Authority.Judge(f.Here, double.NaN));
    }

    [Theory, Behaviour("authority.stale", "spec/08, 4.3 and 5.2")]
    [InlineData(0, 0, 0)]
    [InlineData(1, 1, 0)]
    [InlineData(1, 0, 1)]
    public void A_claim_of_another_life_teleport_or_correction_is_stale(ushort instance, ushort teleport, ushort force)
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        AutonomousPosition stale = f.Here with { Stamps = new MovementStamps(instance, 0, teleport, force) };
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.StaleSequence), Of(f.Authority.Judge(stale, f.Now)));
        f.Authority.Stamps = stale.Stamps;
        Assert.Equal(ClaimOutcome.Accepted, f.Authority.Judge(stale, f.Now).Outcome);
    }

    [Fact, Behaviour("authority.teleport", "design, server operator: a place that no motion leads to")]
    public void A_place_far_away_is_a_teleport_unless_the_server_put_the_player_there()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        Position far = f.Body.Position;
        far.Frame.Origin.Y += 90;
        far.AdjustToOutside();
        ClaimVerdict verdict = f.Say(AuthorityFixture.At(far));
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.Teleport), Of(verdict));
        Assert.NotEqual(far, verdict.Position);
        Assert.True(f.Authority.TryPlace(far, f.Now));
        Assert.Equal(ClaimOutcome.Accepted, f.Say(AuthorityFixture.At(f.Authority.Position)).Outcome);
    }

    [Fact, Behaviour("authority.wall", "design, server operator: walking through a wall")]
    public void A_place_behind_a_wall_is_refused_and_the_player_is_where_it_was()
    {
        AuthorityFixture f = new(ground, House, right: 3);
        f.Hold(Forward, 2);
        Assert.Empty(f.Objections);
        Position before = f.Authority.Position;
        f.Body.SetPositionSimple(DemoGround.At(House, right: 3, ahead: 6), sliding: true);
        ClaimVerdict verdict = f.Say(f.Here);
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.ThroughWall), Of(verdict));
        Assert.Equal(before, verdict.Position);
        Assert.Equal(before, f.Authority.Position);
    }

    [Fact, Behaviour("authority.corrects", "design, server operator: accepted, corrected or refused")]
    public void A_place_a_little_beside_the_way_is_put_right()
    {
        AuthorityFixture f = new(ground, Meadow, options: new AuthorityOptions { MostDoubts = 0 });
        f.Hold(Forward, 1.5);
        Position beside = f.Body.Position;
        beside.Frame.Origin = beside.Frame.LocalToGlobal(new Vector3(0.9f, 0.3f, 0));
        ClaimVerdict verdict = f.Say(AuthorityFixture.At(beside));
        Assert.Equal(ClaimOutcome.Corrected, verdict.Outcome);
        Assert.InRange(verdict.Miss, 0.5, 1);
        Assert.InRange(verdict.Position.DistanceTo(beside), 0.5, 1);
    }

    [Fact, Behaviour("authority.in-the-air", "design, server operator: flying")]
    public void Who_says_to_stand_where_there_is_no_ground_is_refused()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        Position above = f.Body.Position;
        above.Frame.Origin.Z += 3;
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.InTheAir), Of(f.Say(AuthorityFixture.At(above))));
    }

    [Fact, Behaviour("authority.hover", "spec/02: who is in the air falls")]
    public void Who_stays_in_the_air_is_refused_after_a_while()
    {
        AuthorityFixture f = new(ground, Meadow, options: new AuthorityOptions { Burst = 3 });
        f.Hold(Forward | MovementKeys.Jump, 0.5);
        f.Hold(Forward, 0.3);
        MoveToState hover = f.LastMove with { Position = f.Here.Position, Contact = false };
        ClaimVerdict verdict = default;
        double seconds = 0;
        for (; seconds < 10; seconds++)
        {
            verdict = f.Authority.Judge(hover, f.Now + seconds);
            if (!verdict.IsAccepted) break;
        }

        Assert.Equal(ClaimReason.InTheAir, verdict.Reason);
        Assert.InRange(seconds, 3, 6);
    }

    [Fact, Behaviour("authority.jump", "spec/01, 4.1: height from skill, load and charge; spec/08, 5.4")]
    public void A_jump_is_held_to_the_formula_and_to_the_ground()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward | MovementKeys.Jump, 0.5);
        f.Hold(Forward, 0.1);
        Assert.Empty(f.Objections);

        // Half of the charge, by the formula: the key was held for half a second.
        float allowed = MovementFormulas.JumpVelocity(MovementFormulas.JumpHeight(0, 200, f.LastJump.Extent));
        Assert.Equal(allowed, f.LastJump.Velocity.Z, 1e-3);
        f.Hold(Forward, 3);
        Jump jump = f.LastJump with { Position = f.Here.Position };
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.JumpTooHigh),
            Of(f.Authority.Judge(jump with { Velocity = jump.Velocity with { Z = allowed + 0.2f } }, f.Now)));
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.JumpTooHigh),
            Of(f.Authority.Judge(jump with { Velocity = jump.Velocity * new Vector3(1, 1.2f, 1) }, f.Now)));
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.JumpTooHigh), Of(f.Authority.Judge(jump with { Extent = 1.5f }, f.Now)));
        Assert.Equal(ClaimOutcome.Accepted, f.Authority.Judge(jump, f.Now).Outcome);
        Assert.Equal(ClaimReason.JumpInTheAir, AfterAWhile(f, jump, 0.4));
    }

    [Fact, Behaviour("authority.jump.exhausted", "spec/01, 4.1: at no stamina every skill counts as 0")]
    public void A_jump_of_skill_without_stamina_is_refused_once_the_player_must_have_heard_of_it()
    {
        AuthorityFixture f = new(ground, Meadow, stats: new CharacterStats(200, 300));
        f.Hold(MovementKeys.Jump, 0.8);
        f.Hold(MovementKeys.None, 3);
        Jump jump = f.LastJump with { Position = f.Here.Position };
        f.Authority.SetStats(f.Stats with { Stamina = 0 }, f.Now);
        f.Say(f.Here);
        f.Authority.Judge(f.Here, f.Now + 3.5);
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.JumpWithoutStamina), Of(f.Authority.Judge(jump, f.Now + 3.6)));
    }

    [Fact, Behaviour("authority.too-fast", "design, server operator: a budget of time of movement")]
    public void Who_covers_more_way_than_the_time_allows_is_too_fast()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        // Nine metres and a half a second, told ten times a second: a second's way each.
        Position place = f.Body.Position;
        ClaimVerdict verdict = default;
        int told = 0;
        for (; told < 10; told++)
        {
            place.Frame.Origin = place.Frame.LocalToGlobal(new Vector3(0, 9.4f, 0));
            if (CellIds.IsOutdoor(place.CellId)) place.AdjustToOutside();
            f.Server.World.EnsureLoadedAround(place, 1);
            verdict = f.Authority.Judge(AuthorityFixture.At(place), f.Now + (0.1 * told));
            if (!verdict.IsAccepted) break;
        }

        Assert.Equal((ClaimOutcome.Refused, ClaimReason.TooFast), Of(verdict));
        Assert.InRange(told, 1, 3);
    }

    [Fact, Behaviour("authority.not-loaded", "design, decision 7: a cell that is not loaded is not an error")]
    public void A_place_of_which_nothing_is_known_is_refused()
    {
        AuthorityFixture f = new(ground, Meadow);
        f.Hold(Forward, 1);
        Position nowhere = f.Body.Position;
        nowhere.CellId = (nowhere.CellId & 0xFFFF0000) | 0x0123;
        Assert.Equal((ClaimOutcome.Refused, ClaimReason.NotLoaded), Of(f.Say(AuthorityFixture.At(nowhere))));
    }

    private static ClaimReason AfterAWhile(AuthorityFixture f, Jump jump, double seconds)
    {
        Position high = f.Body.Position;
        high.Frame.Origin.Z += 2;
        return f.Authority.Judge(jump with { Position = AuthorityFixture.At(high).Position }, f.Now + seconds).Reason;
    }

    private static (ClaimOutcome Outcome, ClaimReason Reason) Of(in ClaimVerdict verdict) => (verdict.Outcome, verdict.Reason);
}
