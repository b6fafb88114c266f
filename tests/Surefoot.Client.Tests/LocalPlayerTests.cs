using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

public class LocalPlayerTests
{
    [Fact]
    [Behaviour("player.spawn.knows-its-numbers", "spec/08, 7.3 and 8.6")]
    public void A_player_knows_its_numbers_when_it_comes_into_the_world()
    {
        CharacterStats stats = new(300, 250, Stamina: 80, Strength: 90, Augmentations: 2, Burden: 5000);
        WalkFixture f = new(stats, latency: 5);
        Assert.Equal(stats, f.Player.Weenie.Stats);
        Assert.Equal(stats, f.Player.Weenie.Stats);
    }

    [Fact]
    [Behaviour("player.teleport.is-one-call", "spec/02, 4.17 (local player); spec/08, 4.4, step 5; spec/09b, 9.6")]
    public void A_teleported_player_stands_still_there_and_tells_it_once()
    {
        WalkFixture f = new(new CharacterStats(300, 300));
        f.Player.Controller.SetAutoRun(true, f.Now);
        f.Hold(MovementKeys.None, 10);
        f.Hold(MovementKeys.Jump, 30);
        f.Hold(MovementKeys.None, 5);
        Assert.True(f.Body.Velocity.Length() > 10);
        int sent = f.Sent.Moves.Count;

        Position place = new(StubWorld.CellId, new Vector3(20, 4, 0.005f));
        Assert.Equal(PlacementResult.OK, f.Player.Teleport(place, f.Now));
        Assert.Equal((Vector3.Zero, false), (f.Body.Velocity, f.Player.Controller.AutoRun));
        Assert.Equal(sent + 1, f.Sent.Moves.Count);
        Assert.Equal(0, Vector3.Distance(place.Frame.Origin, f.Sent.Moves[^1].Message.Position.Origin), 1e-4);
        Assert.Equal(MotionCommand.Ready, f.Sent.Moves[^1].State.ForwardCommand);
        f.Hold(MovementKeys.None, 10);
        Assert.Equal(0, Vector3.Distance(place.Frame.Origin, f.Origin), 1e-4);
        Assert.True(f.Body.OnWalkable);
    }

    [Fact]
    [Behaviour("player.bad-input-changes-nothing", "design, decision 7")]
    public void Bad_places_and_times_are_refused_and_change_nothing()
    {
        WalkFixture f = new(new CharacterStats(300, 300));
        Vector3 before = f.Origin;
        Assert.Throws<ArgumentException>(() => f.Player.Teleport(new Position(StubWorld.CellId, new Vector3(float.NaN, 0, 0)), f.Now));
        Assert.Throws<ArgumentException>(() => f.Player.Teleport(new Position(0, Vector3.One), f.Now));
        Assert.Throws<ArgumentException>(() => f.Player.Teleport(new Position(StubWorld.CellId, Vector3.One), double.NaN));
        Assert.Throws<ArgumentException>(() => f.Player.Update(MovementKeys.Forward, double.NaN));
        Assert.Equal(before, f.Origin);
        Assert.Empty(f.Sent.Moves);
    }

    [Fact]
    [Behaviour("player.killer-status", "spec/08, 6.7: PK status; spec/02, 4.11: the mover's flags come from its weenie")]
    public void A_player_whose_status_the_server_tells_is_stopped_by_its_like()
    {
        const WeenieTraits plain = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;
        PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
        FakeServer server = new();
        LocalPlayer player = LocalPlayer.Spawn(engine, KeyFixture.Id, WalkFixture.Setup, HumanoidTable.Create(),
            new Position(StubWorld.CellId, new Vector3(12, 12, 0)), server)!;
        Assert.Equal(plain, player.Body.Weenie);
        (int Status, WeenieTraits Trait)[] all =
            [(4, WeenieTraits.PK), (0x40, WeenieTraits.PKLite), (0x20, WeenieTraits.Impenetrable), (2, WeenieTraits.None)];
        byte sequence = 0;
        foreach ((int status, WeenieTraits trait) in all)
        {
            server.Say(new PublicUpdatePropertyInt(sequence++, KeyFixture.Id, 134, status));
            player.Update(MovementKeys.None, engine.Now);
            Assert.Equal(plain | trait, player.Body.Weenie);
        }
    }

    [Theory]
    [Behaviour("player.killer-in-a-fight", "spec/01, 4.1 and 6: status 4 or 64 and an attack on a player within the last 20 s")]
    [InlineData(4, 150)]
    [InlineData(0x40, 150)]
    [InlineData(0x20, 4)]
    [InlineData(2, 4)]
    public void A_killer_s_jumps_cost_more_for_twenty_seconds_after_an_attack_on_a_player(int status, int cost)
    {
        PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
        FakeServer server = new();
        LocalPlayer player = LocalPlayer.Spawn(engine, KeyFixture.Id, WalkFixture.Setup, HumanoidTable.Create(),
            new Position(StubWorld.CellId, new Vector3(12, 12, 0)), server)!;
        server.Say(new PublicUpdatePropertyInt(0, KeyFixture.Id, 134, status));
        server.Say(new PrivateUpdateAttribute(0, 1, new AttributeRecord(0, 100, 0)));
        player.Update(MovementKeys.None, 1);
        // Half a jump without load: ⌈0.5 · 0.5 · 8 + 2⌉ points of stamina, or 100 · 1.5 in a fight.
        Assert.Equal(4, CostOfHalfAJump());
        player.NoteAttackOnPlayer(1);
        Assert.Equal(cost, CostOfHalfAJump());
        player.Update(MovementKeys.None, 20.9);
        Assert.Equal(cost, CostOfHalfAJump());
        player.Update(MovementKeys.None, 21.1);
        Assert.Equal(4, CostOfHalfAJump());
        Assert.Throws<ArgumentException>(() => player.NoteAttackOnPlayer(double.NaN));

        int CostOfHalfAJump()
        {
            Assert.True(player.Weenie.JumpStaminaCost(0.5f, out int points));
            return points;
        }
    }

    [Fact]
    [Behaviour("player.messages-allocate-nothing", "design, decision 4")]
    public void Keys_that_change_each_frame_and_the_answers_to_them_allocate_nothing()
    {
        PhysicsEngine engine = new(new StubWorld(_ => StubWorld.Flat(0)));
        LoopbackServer server = new(1, new CharacterStats(300, 300), 0, latency: 0.1);
        LocalPlayer player = LocalPlayer.Spawn(engine, 1, WalkFixture.Setup, HumanoidTable.Create(),
            new Position(StubWorld.CellId, new Vector3(12, 12, 0)), server)!;
        int frame = 0;
        Hold(200);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Hold(300);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        void Hold(int frames)
        {
            for (int end = frame + frames; frame < end; frame++)
                player.Update(frame % 2 == 0 ? MovementKeys.TurnLeft : MovementKeys.SidestepRight, frame * WalkFixture.FrameTime);
        }
    }
}
