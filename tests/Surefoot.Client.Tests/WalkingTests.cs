using System.Numerics;
using CsCheck;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>The acceptance lines of walking, running and jumping, with a real body.</summary>
public class WalkingTests
{
    /// <summary>At most two animation frames of the run are outstanding at either end of a measurement.</summary>
    private const double OutstandingMetres = 2 * 4.0 / 30;

    [Theory]
    [Behaviour("acceptance.run-speed", "design; spec/01, 4.1 and 6")]
    [InlineData(0, 0, 4.0)]
    [InlineData(10, 0, 4.52380944)]
    [InlineData(100, 0, 7.66666652)]
    [InlineData(200, 0, 9.5)]
    [InlineData(300, 0, 10.6000004)]
    [InlineData(799, 0, 12.79779816)]
    [InlineData(800, 0, 18.0)]
    [InlineData(1200, 0, 18.0)]
    [InlineData(300, 22500, 7.3000002)]
    [InlineData(300, 29850, 4.066)]
    public void A_runner_covers_the_formulas_distance(int skill, int burden, double expected)
    {
        WalkFixture f = new(new CharacterStats(skill, 300, Burden: burden));
        f.Hold(MovementKeys.Forward, 10);
        const double seconds = 10;
        Assert.Equal(expected, f.SpeedOver(MovementKeys.Forward, seconds), OutstandingMetres / seconds);
        Assert.True(f.Body.OnWalkable);
        Assert.Equal(WalkFixture.RestHeight, f.Origin.Z, 1e-4f);
    }

    [Theory]
    [Behaviour("acceptance.walk-speed", "design; spec/01, 3 and 4.3")]
    [InlineData(0)]
    [InlineData(300)]
    [InlineData(900)]
    public void A_walker_covers_three_point_one_two_metres_a_second_whatever_the_skill(int skill)
    {
        WalkFixture f = new(new CharacterStats(skill, 300));
        f.Hold(MovementKeys.Forward | MovementKeys.Walk, 10);
        Assert.Equal(3.12, f.SpeedOver(MovementKeys.Forward | MovementKeys.Walk, 10), 2 * 0.104 / 10);
    }

    [Fact]
    [Behaviour("acceptance.backwards-and-sidestep-speed", "spec/01, 4.2 and 4.3")]
    public void Backwards_and_sideways_have_their_own_speeds()
    {
        WalkFixture f = new(new CharacterStats(300, 300));
        Assert.Equal(3.12 * 0.65 * 2.65, f.SpeedOver(MovementKeys.Back, 10), 0.05);
        Assert.Equal(3.12 * 0.65, f.SpeedOver(MovementKeys.Back | MovementKeys.Walk, 10), 0.05);
        f.Hold(MovementKeys.None, 30);
        Assert.Equal(3.75, f.SpeedOver(MovementKeys.SidestepRight, 10), 0.05);
        Assert.Equal(1.56, f.SpeedOver(MovementKeys.SidestepLeft | MovementKeys.Walk, 10), 0.05);
    }

    [Fact]
    [Behaviour("acceptance.turn-speed", "spec/01, 4.3; spec/01b, 4")]
    public void Turning_is_one_point_five_radians_a_second_and_half_again_as_fast_with_run()
    {
        (MovementKeys Keys, double Rate)[] turns = [(MovementKeys.TurnRight, 2.25), (MovementKeys.TurnRight | MovementKeys.Walk, 1.5)];
        foreach ((MovementKeys keys, double rate) in turns)
        {
            WalkFixture f = new(new CharacterStats(300, 300));
            f.Hold(keys, 30);
            Assert.Equal(rate * 180 / Math.PI, f.Body.Position.Frame.Heading, 2 * 0.05 * 180 / Math.PI);
            Assert.Equal(12f, f.Origin.X, 1e-4f);
        }
    }

    [Fact]
    [Behaviour("acceptance.smooth-table-moves-each-quantum", "spec/01b, 4")]
    public void Without_animations_each_quantum_covers_its_share()
    {
        WalkFixture f = new(new CharacterStats(300, 300), smooth: true);
        f.Hold(MovementKeys.Forward, 3);
        float before = f.Origin.Y;
        f.Hold(MovementKeys.Forward, 1);
        Assert.Equal(10.6 / 30, f.Origin.Y - before, 1e-5);
    }

    [Fact]
    [Behaviour("acceptance.old-rate-until-the-servers-answer", "design.md, Who uses it")]
    public void A_new_skill_acts_when_the_servers_answer_arrives()
    {
        WalkFixture f = new(new CharacterStats(0, 300), latency: 0.5, smooth: true);
        f.Hold(MovementKeys.Forward, 60);
        f.Server.SetStats(new CharacterStats(300, 300), f.Now);
        Assert.Equal(4.0, f.SpeedOver(MovementKeys.Forward, 14.0 / 30), 1e-4);
        f.Hold(MovementKeys.Forward, 2);
        Assert.Equal(10.6, f.SpeedOver(MovementKeys.Forward, 1), 1e-4);
    }

    [Fact]
    [Behaviour("acceptance.other-body-moves-at-its-forward-speed", "design; spec/01, 4.14")]
    public void Another_body_moves_at_the_forward_speed_of_its_update_motion()
    {
        WalkFixture f = new(new CharacterStats(800, 300));
        PhysicsBody other = f.Engine.CreateBody(2, WalkFixture.Setup, weenie: WeenieTraits.Present | WeenieTraits.Creature,
            motions: new BodyMotions(f.Table, new OtherWeenie()));
        MovementManager movement = f.Engine.MovementOf(other)!;
        Assert.True(other.EnterWorld(new Position(StubWorld.CellId, new Vector3(30, 12, 0))));
        f.Hold(MovementKeys.None, 5);
        movement.ApplyUpdate(new InterpretedMotionState { ForwardCommand = MotionCommand.RunForward, ForwardSpeed = 1.7f },
            autonomous: true);
        f.Hold(MovementKeys.None, 5);
        float from = other.Position.Frame.Origin.Y;
        f.Hold(MovementKeys.None, 150);
        Assert.Equal(6.8 * 5, other.Position.Frame.Origin.Y - from, OutstandingMetres);

        movement.ApplyUpdate(new InterpretedMotionState(), autonomous: true);
        f.Hold(MovementKeys.None, 5);
        from = other.Position.Frame.Origin.Y;
        f.Hold(MovementKeys.None, 30);
        Assert.Equal(from, other.Position.Frame.Origin.Y);
    }

    [Theory]
    [Behaviour("acceptance.jump-apex", "design; spec/01, 4.1 and spec/02, 6.4 and 6.5")]
    [InlineData(0, 0, 30)]
    [InlineData(100, 0, 30)]
    [InlineData(300, 0, 30)]
    [InlineData(300, 0, 15)]
    [InlineData(300, 0, 1)]
    [InlineData(1000, 0, 30)]
    [InlineData(300, 22500, 30)]
    public void A_standing_jump_reaches_the_formulas_height_in_the_air_time_of_the_integration(int skill, int burden, int chargeFrames)
    {
        WalkFixture f = new(new CharacterStats(300, skill, Burden: burden));
        f.Hold(MovementKeys.Jump, chargeFrames);
        f.Hold(MovementKeys.None, 1);
        SentJump jump = Assert.Single(f.Sent.Jumps);
        Assert.Equal(Math.Min(1, chargeFrames / 30.0), jump.Extent, 1e-6);
        Assert.Equal(jump.Velocity,
            new Vector3(0, 0, MovementFormulas.JumpVelocity(MovementFormulas.JumpHeight(burden / 15000f, skill, jump.Extent))));

        (double apex, int landing) = Fly(jump.Velocity.Z);
        double highest = f.Height;
        int quanta = 1;
        for (; !f.Body.HasContact && quanta < 300; quanta++)
        {
            f.Hold(MovementKeys.None, 1);
            highest = Math.Max(highest, f.Height);
        }

        Assert.Equal(apex, highest, 1e-4);
        Assert.Equal(landing, quanta);
        Assert.InRange(highest, 0.34, 20);
    }

    [Fact]
    [Behaviour("acceptance.smallest-jump", "spec/02, 6.5")]
    public void The_smallest_jump_rises_as_the_specifications_table()
    {
        WalkFixture f = new(new CharacterStats(300, 0));
        f.Hold(MovementKeys.Jump, 1);
        float[] expected = [0.0818608999f, 0.15283291f, 0.212916031f, 0.262110263f, 0.300415605f, 0.327832043f, 0.344359607f, 0.349998266f,
            0.344553828f];
        foreach (float z in expected)
        {
            f.Hold(MovementKeys.None, 1);
            Assert.Equal(z, f.Height, 2e-6f);
        }
    }

    [Fact]
    [Behaviour("acceptance.longer-hold-jumps-higher", "design")]
    public void A_longer_hold_jumps_higher()
    {
        double before = 0;
        foreach (int frames in (int[])[5, 10, 20, 30])
        {
            WalkFixture f = new(new CharacterStats(300, 300));
            f.Hold(MovementKeys.Jump, frames);
            double highest = 0;
            for (int i = 0; i < 40; i++)
            {
                f.Hold(MovementKeys.None, 1);
                highest = Math.Max(highest, f.Height);
            }

            Assert.True(highest > before, $"{frames} frames: {highest} m after {before} m");
            before = highest;
        }
    }

    [Fact]
    [Behaviour("acceptance.running-jump-keeps-velocity", "spec/01, 4.12")]
    public void A_running_jump_keeps_its_velocity_whatever_keys_are_held_in_the_air()
    {
        WalkFixture f = new(new CharacterStats(300, 300));
        f.Hold(MovementKeys.Forward, 20);
        f.Hold(MovementKeys.Forward | MovementKeys.Jump, 30);
        f.Hold(MovementKeys.Forward, 1);
        Assert.Equal(10.6000004f, Assert.Single(f.Sent.Jumps).Velocity.Y);
        float from = f.Origin.Y;
        f.Hold(MovementKeys.SidestepLeft, 20);
        f.Hold(MovementKeys.Back, 20);
        Assert.False(f.Body.HasContact);
        Assert.Equal(10.6 * 40 / 30, f.Origin.Y - from, 1e-3);
        Assert.Equal(12f, f.Origin.X, 1e-3f);

        // The key held at the landing acts at once.
        for (int i = 0; !f.Body.OnWalkable && i < 60; i++) f.Hold(MovementKeys.Back, 1);
        f.Hold(MovementKeys.Back, 40);
        Assert.True(f.SpeedOver(MovementKeys.Back, 2) is > 5.2 and < 5.5);
    }

    [Fact]
    [Behaviour("acceptance.nothing-from-the-air", "spec/08, 5.6")]
    public void No_position_is_told_from_the_air_and_one_at_landing_elsewhere()
    {
        WalkFixture f = new(new CharacterStats(300, 1000));
        f.Hold(MovementKeys.Forward | MovementKeys.Jump, 31);
        f.Hold(MovementKeys.Forward, 1);
        f.Hold(MovementKeys.Forward, 1);
        int before = f.Sent.Positions.Count;
        f.Hold(MovementKeys.Forward, 45);
        Assert.False(f.Body.HasContact);
        Assert.Equal(before, f.Sent.Positions.Count);
        f.Hold(MovementKeys.Forward, 60);
        Assert.True(f.Sent.Positions.Count > before);
    }

    [Fact]
    [Behaviour("acceptance.deterministic", "design, decision 5")]
    public void The_same_keys_give_the_same_bits() =>
        Gen.Select(Gen.Int[0, 0xFF], Gen.Int[1, 20]).List[1, 12].Sample(
            script =>
            {
                ulong[] hashes = new ulong[2];
                for (int run = 0; run < 2; run++)
                {
                    WalkFixture f = new(new CharacterStats(250, 150));
                    foreach ((int keys, int frames) in script) f.Hold((MovementKeys)keys, frames);
                    hashes[run] = f.Engine.HashState();
                }

                return hashes[0] == hashes[1];
            },
            iter: Fuzz.Cases(20));

    /// <summary>Retail's integration of a standing jump, in double: apex, and the quantum in which the ground is met again.</summary>
    private static (double Apex, int Landing) Fly(double velocity)
    {
        const double q = 1.0 / 30, g = -9.8;
        double z = 0, apex = 0;
        for (int quantum = 1; ; quantum++)
        {
            // 0.0625 + ε: below it the velocity is dropped before the quantum, so a straight jump loses its last speed at the apex.
            if (velocity * velocity < 0.0627) velocity = 0;
            z += (q * velocity) + (0.5 * g * q * q);
            velocity += g * q;
            if (z <= 0) return (apex, quantum);
            apex = Math.Max(apex, z);
        }
    }
}
