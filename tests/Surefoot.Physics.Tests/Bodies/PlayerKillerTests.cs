using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.Tests.World;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>Players who walk into players: specification 06, 6, and 02, 4.21, step 4; one rule a test.</summary>
public class PlayerKillerTests
{
    private const uint Cell = (WorldRecords.Block & 0xFFFF0000) | 0x1C;
    private const WeenieTraits Creature = WeenieTraits.Present | WeenieTraits.Creature;
    private const WeenieTraits Ordinary = Creature | WeenieTraits.Player, Killer = Ordinary | WeenieTraits.PK,
        Lite = Ordinary | WeenieTraits.PKLite, Both = Killer | WeenieTraits.PKLite, Impenetrable = Ordinary | WeenieTraits.Impenetrable;

    private static readonly SetupAsset Human = StubWorld.Setup(
        new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f));

    [Fact, Behaviour("players.ordinary-pass", "spec/06, 6: non-PK player and non-PK player")]
    public void Ordinary_players_walk_through_each_other() => AssertPasses(Ordinary, Ordinary);

    [Fact, Behaviour("players.killers-stop-killers", "spec/06, 6: PK player and PK player")]
    public void Killers_stop_each_other() => AssertStops(Killer, Killer);

    [Fact, Behaviour("players.killer-and-ordinary-pass", "spec/06, 6: both must be killers")]
    public void A_killer_and_an_ordinary_player_walk_through_each_other()
    {
        AssertPasses(Killer, Ordinary);
        AssertPasses(Ordinary, Killer);
    }

    [Fact, Behaviour("players.lite-stop-lite", "spec/06, 6: PK-lite player and PK-lite player")]
    public void Killers_of_the_lite_kind_stop_each_other() => AssertStops(Lite, Lite);

    [Fact, Behaviour("players.lite-and-ordinary-pass", "spec/06, 6: both must be PK-lite")]
    public void A_killer_of_the_lite_kind_and_an_ordinary_player_walk_through_each_other()
    {
        AssertPasses(Lite, Ordinary);
        AssertPasses(Ordinary, Lite);
    }

    [Fact, Behaviour("players.killer-and-lite-pass", "spec/06, 6; spec/02, 4.21, step 4: the kinds are compared one by one")]
    public void Killers_of_different_kinds_walk_through_each_other()
    {
        AssertPasses(Killer, Lite);
        AssertPasses(Lite, Killer);
        AssertStops(Both, Killer);
        AssertStops(Lite, Both);
    }

    [Fact, Behaviour("players.impenetrable-stops-and-is-stopped", "spec/06, 6: impenetrable player, and the line below the table")]
    public void An_impenetrable_player_stops_everyone_and_is_stopped_by_everyone()
    {
        foreach (WeenieTraits other in (WeenieTraits[])[Ordinary, Killer, Lite, Creature])
        {
            AssertStops(other, Impenetrable);
            AssertStops(Impenetrable, other);
        }
    }

    [Fact, Behaviour("players.creatures-stop-players", "spec/06, 6: creature row and creature column")]
    public void Creatures_and_players_of_every_kind_stop_each_other()
    {
        foreach (WeenieTraits player in (WeenieTraits[])[Ordinary, Killer, Lite])
        {
            AssertStops(player, Creature);
            AssertStops(Creature, player);
        }
    }

    [Theory, Behaviour("players.mover-flags", "spec/02, 2.4 and 4.11, OBJECTINFO::init @0x0050CF30: 0x80, 0x100, 0x800, 0x1000")]
    [InlineData(WeenieTraits.None, 0)]
    [InlineData(Creature, 0)]
    [InlineData(Ordinary, 0x100)]
    [InlineData(Killer, 0x900)]
    [InlineData(Lite, 0x1100)]
    [InlineData(Impenetrable, 0x180)]
    [InlineData(Both | WeenieTraits.Impenetrable, 0x1980)]
    public void A_sweep_takes_what_its_mover_is_from_the_weenie(WeenieTraits weenie, int flags)
    {
        ObjectInfo info = new();
        info.Init(new WorldObject(1, Human, PhysicsState.Default) { Weenie = weenie }, MoverFlags.Contact);
        Assert.Equal((MoverFlags)(flags | 1), info.Flags);
    }

    [Fact, Behaviour("players.status-acts-at-once", "spec/02, 4.11: the flags are asked for at every transition")]
    public void Who_becomes_a_killer_is_stopped_from_the_next_quantum_on()
    {
        PhysicsEngine engine = new(new WorldRecords().Ground().World());
        PhysicsBody mover = Enter(engine, 1, 84, Ordinary), other = Enter(engine, 2, 85.5f, Killer);
        Strides.Walk(mover, new Vector3(0, 0.2f, 0));
        Assert.Equal(84.2f, mover.Position.Frame.Origin.Y, 1e-4f);
        mover.SetWeenie(Killer);
        for (int i = 0; i < 20; i++) Strides.Walk(mover, new Vector3(0, 0.2f, 0));
        Assert.InRange(mover.Position.Frame.Origin.Y, 84.2f, other.Position.Frame.Origin.Y - 0.96f);
        mover.SetWeenie(Ordinary);
        // Whoever was stopped head on slides along nothing until a step succeeds: retail keeps the sliding normal of the last one.
        Strides.Walk(mover, new Vector3(0, -0.2f, 0));
        for (int i = 0; i < 20; i++) Strides.Walk(mover, new Vector3(0, 0.2f, 0));
        Assert.True(mover.Position.Frame.Origin.Y > other.Position.Frame.Origin.Y);
    }

    private static void AssertPasses(WeenieTraits mover, WeenieTraits other) => Assert.Equal(88, WalkInto(mover, other), 1e-3f);

    private static void AssertStops(WeenieTraits mover, WeenieTraits other) => Assert.InRange(WalkInto(mover, other), 84, 86 - 0.96f);

    /// <summary>Four metres north, two of them up to somebody; where the way ends.</summary>
    private static float WalkInto(WeenieTraits mover, WeenieTraits other)
    {
        PhysicsEngine engine = new(new WorldRecords().Ground().World());
        PhysicsBody walker = Enter(engine, 1, 84, mover);
        Enter(engine, 2, 86, other);
        for (int i = 0; i < 20; i++) Strides.Walk(walker, new Vector3(0, 0.2f, 0));
        return walker.Position.Frame.Origin.Y;
    }

    private static PhysicsBody Enter(PhysicsEngine engine, uint id, float y, WeenieTraits weenie)
    {
        PhysicsBody body = engine.CreateBody(id, Human, weenie: weenie);
        Assert.True(body.EnterWorld(new Position(Cell, new Vector3(84, y, 0)), slide: false));
        return body;
    }
}
