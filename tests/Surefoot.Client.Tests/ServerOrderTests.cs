using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>What the movement in a server's messages makes a real body do: motions, ways and turns.</summary>
public class ServerOrderTests
{
    private const uint OtherId = 0x80001234;
    private const uint DefaultBits = (uint)MovementFlags.Default;
    private const ushort NonCombat = 0x3D, RunForward = 0x07, WalkForward = 0x05;
    private const float HumanRadius = 0.48f;

    /// <summary>Runs from more than a metre away on, and stops 0.6 m from the place.</summary>
    private static readonly MoveToParams Way = new(DefaultBits, 0.6f, 0, float.MaxValue, 1, 1, 0);

    [Fact]
    [Behaviour("controller.server.move-to-is-waited-for", "spec/09b, 6.3 and 9.6; spec/09, 5.4; CommandInterpreter::UseTime @0x006B3BF0")]
    public void An_order_to_a_place_is_walked_and_held_keys_wait_until_it_is_done()
    {
        OrderFixture f = new();
        f.Hold(MovementKeys.Forward, 30);
        Vector3 place = f.Origin - new Vector3(0, 5, 0);
        f.Say(MovementData.MoveToPosition(NonCombat, StubWorld.CellId, place, Way, 1));
        int sent = f.Sent.Moves.Count, idle = 0;
        for (int i = 0; i < 300 && (i == 0 || f.Player.Movement.IsMovingTo); i++)
        {
            f.Hold(MovementKeys.Forward, 1);
            if (f.Player.Movement.IsMovingTo) Assert.True(f.Player.Controller.IsControlledByServer);
            if (f.Player.Movement is { IsMovingTo: true, MotionsPending: false }) idle++;
        }

        Assert.True(idle > 10);
        Assert.InRange(f.Origin.Y - place.Y, 0, 0.6 + HumanRadius);
        f.Hold(MovementKeys.Forward, 5);
        Assert.False(f.Player.Controller.IsControlledByServer);
        Assert.Equal(MotionCommand.RunForward, f.Forward);
        Assert.Equal(sent, f.Sent.Moves.Count);
    }

    [Theory]
    [Behaviour("client.order.move-to-object", "spec/09, 5.4; spec/08, 6.4")]
    [InlineData(true)]
    [InlineData(false)]
    public void An_order_to_an_object_goes_there_and_to_the_place_in_the_message_when_it_is_unknown(bool isKnown)
    {
        OrderFixture f = new();
        Vector3 object1 = f.Origin + new Vector3(6, 0, 0), place = f.Origin - new Vector3(6, 0, 0);
        if (isKnown) f.Spawn(OtherId, object1);
        f.Say(MovementData.MoveToObject(NonCombat, OtherId, StubWorld.CellId, place, Way, 1));
        f.Hold(MovementKeys.None, 240);
        Assert.False(f.Player.Movement.IsMovingTo);
        float gap = Vector3.Distance(f.Origin, isKnown ? object1 : place);
        Assert.InRange(gap, HumanRadius, 0.6 + (2 * HumanRadius));
    }

    [Theory]
    [Behaviour("client.order.turn", "spec/09, 5.4; spec/09b, 6.3")]
    [InlineData(MovementType.TurnToHeading, false, 90f)]
    [InlineData(MovementType.TurnToObject, false, 200f)]
    [InlineData(MovementType.TurnToObject, true, 270f)]
    public void An_order_to_turn_faces_the_heading_or_the_object_when_it_is_known(MovementType kind, bool isKnown, float heading)
    {
        OrderFixture f = new();
        Vector3 start = f.Origin;
        if (isKnown) f.Spawn(OtherId, f.Origin - new Vector3(6, 0, 0));
        f.Say(kind == MovementType.TurnToHeading
            ? MovementData.TurnToHeading(NonCombat, DefaultBits, 1, heading)
            : MovementData.TurnToObject(NonCombat, OtherId, 200, DefaultBits, 1, 45));
        f.Hold(MovementKeys.None, 240);
        Assert.False(f.Player.Movement.IsMovingTo);
        Assert.Equal(heading, f.Player.Body.Position.Frame.Heading, 0.01);
        Assert.Equal((start.X, start.Y), (f.Origin.X, f.Origin.Y));
    }

    [Fact]
    [Behaviour("client.order.ends-the-charge", "spec/01, 4.12; spec/08, 5.6; spec/09b, 9.6")]
    public void An_order_to_go_somewhere_ends_a_charge_and_releasing_the_key_sends_no_jump()
    {
        OrderFixture f = new();
        f.Hold(MovementKeys.Forward, 3);
        f.Hold(MovementKeys.Jump, 10);
        Assert.Equal(MotionError.None, f.Player.Controller.LastRefusal);
        Assert.True(f.Player.Controller.IsChargingJump);
        f.Say(MovementData.MoveToObject(NonCombat, OtherId, StubWorld.CellId, f.Origin + new Vector3(6, 0, 0), Way, 1));
        f.Hold(MovementKeys.Jump, 1);
        Assert.False(f.Player.Controller.IsChargingJump);
        f.Hold(MovementKeys.None, 10);
        Assert.Empty(f.Sent.Jumps);
        Assert.True(f.Player.Body.OnWalkable);
        Assert.True(f.Player.Controller.IsControlledByServer);
    }

    [Fact]
    [Behaviour("client.order.autorun-ends", "spec/09b, 9.6; CommandInterpreter::LoseControlToServer @0x006B3170")]
    public void An_order_to_go_somewhere_ends_autorun()
    {
        OrderFixture f = new();
        f.Player.Controller.SetAutoRun(true, f.Now);
        f.Say(MovementData.MoveToPosition(NonCombat, StubWorld.CellId, f.Origin + new Vector3(6, 0, 0), Way, 1));
        f.Hold(MovementKeys.None, 240);
        Assert.False(f.Player.Controller.AutoRun);
        Assert.Equal(MotionCommand.Ready, f.Forward);
    }

    [Fact]
    [Behaviour("client.order.sticks", "spec/09, 5.4, type 0")]
    public void A_motion_with_an_object_to_stick_to_sticks_to_it_and_the_next_order_lets_go()
    {
        OrderFixture f = new();
        f.Spawn(OtherId, f.Origin + new Vector3(2, 0, 0));
        f.Say(MovementData.Motion(NonCombat, new WireInterpretedMotion(), stickTo: OtherId));
        f.Hold(MovementKeys.None, 1);
        Assert.Equal(OtherId, f.Player.Body.StickyObjectId);
        f.Say(MovementData.Motion(NonCombat, new WireInterpretedMotion()));
        f.Hold(MovementKeys.None, 1);
        Assert.Equal(0u, f.Player.Body.StickyObjectId);
    }

    [Fact]
    [Behaviour("client.order.unknown-kind", "spec/09, 5.4; spec/08, 6.4")]
    public void An_order_of_a_kind_that_there_is_not_ends_a_way_and_takes_control_but_moves_nothing()
    {
        OrderFixture f = new();
        f.Hold(MovementKeys.TurnLeft, 3);
        f.Say(MovementData.MoveToPosition(NonCombat, StubWorld.CellId, f.Origin + new Vector3(6, 0, 0), Way, 1));
        f.Hold(MovementKeys.None, 10);
        Assert.True(f.Player.Movement.IsMovingTo);
        f.SayKind(3);
        f.Hold(MovementKeys.None, 30);
        Assert.False(f.Player.Movement.IsMovingTo);
        Assert.Equal((0, true), (f.Player.UnreadableMessages, f.Player.Controller.IsControlledByServer));
    }

    [Fact]
    [Behaviour("client.order.style-beside-the-state", "spec/09, 5.4; spec/08, section 12, 1")]
    public void The_style_of_an_order_is_taken_before_its_kind_is_looked_at_and_word_0_names_none()
    {
        const MotionCommand Armed = (MotionCommand)0x8000003E;
        MotionAsset still = new([new AnimationSpan(HumanoidTable.TenFrames, 0, -1, 30f)]);
        MotionTableBuilder table = new MotionTableBuilder(0x09000001)
            .Style(MotionCommand.NonCombat, MotionCommand.Ready).Style(Armed, MotionCommand.Ready)
            .Cycle(MotionCommand.NonCombat, MotionCommand.Ready, still).Cycle(Armed, MotionCommand.Ready, still)
            .Link(MotionCommand.NonCombat, MotionCommand.Ready, Armed, still);
        OrderFixture f = new(table.Build());
        f.Say(MovementData.TurnToHeading(0, DefaultBits, 1, 90));
        f.Hold(MovementKeys.None, 1);
        Assert.Equal((0, MotionCommand.NonCombat), (f.Player.UnreadableMessages, f.Player.Movement.Interpreter.Raw.CurrentStyle));
        f.Say(MovementData.TurnToHeading(0x3E, DefaultBits, 1, 180));
        f.Hold(MovementKeys.None, 1);
        Assert.Equal((0, Armed), (f.Player.UnreadableMessages, f.Player.Movement.Interpreter.Interpreted.CurrentStyle));
    }

    public static TheoryData<MovementData> BadOrders => new(
        MovementData.MoveToPosition(0, StubWorld.CellId, new Vector3(float.NaN, 0, 0), Way, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, new Vector3(0, float.PositiveInfinity, 0), Way, 1),
        MovementData.MoveToPosition(0, 0xA9B40000, default, Way, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way, float.NaN),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { Speed = float.PositiveInfinity }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { Speed = 1e30f }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { DistanceToObject = float.NaN }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { MinDistance = float.NaN }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { FailDistance = float.NaN }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { WalkRunThreshold = float.NaN }, 1),
        MovementData.MoveToPosition(0, StubWorld.CellId, default, Way with { DesiredHeading = float.NaN }, 1),
        MovementData.MoveToObject(0xFFFF, OtherId, StubWorld.CellId, default, Way, 1),
        MovementData.TurnToHeading(0, DefaultBits, float.NaN, 90),
        MovementData.TurnToHeading(0, DefaultBits, 1, float.NaN),
        MovementData.TurnToObject(0, OtherId, float.NaN, DefaultBits, 1, 0),
        MovementData.Motion(0, new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: -1e30f)));

    [Theory]
    [Behaviour("client.order.bad-numbers", "design, decision 7")]
    [MemberData(nameof(BadOrders))]
    public void An_order_with_an_impossible_number_is_counted_and_not_obeyed(MovementData order)
    {
        OrderFixture f = new();
        f.Hold(MovementKeys.Forward, 3);
        f.Say(order);
        f.Hold(MovementKeys.Forward, 3);
        Assert.Equal((1, false, false, MotionCommand.RunForward),
            (f.Player.UnreadableMessages, f.Player.Movement.IsMovingTo, f.Player.Controller.IsControlledByServer, f.Forward));
    }

    [Fact]
    [Behaviour("client.order.damaged-never-throw", "design, decision 7")]
    public void No_damaged_order_throws_or_stalls_the_world()
    {
        MovementData[] orders =
        [
            MovementData.Motion(NonCombat, new WireInterpretedMotion(forwardCommand: WalkForward, forwardSpeed: 1.5f), OtherId),
            MovementData.MoveToObject(NonCombat, OtherId, StubWorld.CellId, new Vector3(1, 2, 3), Way, 1),
            MovementData.MoveToPosition(NonCombat, StubWorld.CellId, new Vector3(1, 2, 3), Way, 1),
            MovementData.TurnToObject(NonCombat, OtherId, 200, DefaultBits, 1, 45),
            MovementData.TurnToHeading(NonCombat, DefaultBits, 1, 45),
        ];
        OrderFixture f = new();
        Vector3 start = f.Origin;
        f.Spawn(OtherId, start + new Vector3(3, 0, 0));
        Gen.Select(Gen.Int[0, orders.Length - 1], Gen.Int[16, 60], Gen.Byte, Gen.Int[16, 60], Gen.Byte).Sample(
            (kind, first, firstValue, second, secondValue) =>
            {
                byte[] damaged = f.Bytes(orders[kind]);
                damaged[first % damaged.Length] = firstValue;
                damaged[second % damaged.Length] = secondValue;
                f.SayBytes(damaged);
                f.Hold(MovementKeys.Forward, 2);
                if (Vector3.Distance(f.Origin, start) > 50) f.Player.Teleport(new Position(StubWorld.CellId, start), f.Now);
            },
            iter: Fuzz.Cases(1000), threads: 1);
    }

    /// <summary>A player on an endless plain whose server says what a test has it say.</summary>
    private sealed class OrderFixture
    {
        private readonly FakeServer server = new();
        private ushort stamp;
        private int frames;

        internal OrderFixture(MotionTableAsset? table = null)
        {
            Engine = new Physics.PhysicsEngine(new StubWorld(_ => StubWorld.Flat(0)));
            server.Say(new PrivateUpdateSkill(0, 24, new SkillRecord(0, 1, 2, 0, 300, 0, 0)));
            server.Say(new PrivateUpdateAttribute(0, 1, new AttributeRecord(0, 100, 0)));
            server.Say(new PrivateUpdateAttribute2ndLevel(0, 4, 100));
            Player = LocalPlayer.Spawn(
                Engine, KeyFixture.Id, WalkFixture.Setup, table ?? HumanoidTable.Create(),
                new Position(StubWorld.CellId, new Vector3(12, 12, 0)), server, new LocalPlayerOptions { Observer = Sent })!;
            Engine.Player = Player.Body;
            Hold(MovementKeys.None, 5);
        }

        internal Physics.PhysicsEngine Engine { get; }

        internal LocalPlayer Player { get; }

        internal Recorder Sent { get; } = new();

        internal Vector3 Origin => Player.Body.Position.Frame.Origin;

        internal MotionCommand Forward => Player.Movement.Interpreter.Interpreted.ForwardCommand;

        internal double Now => frames * WalkFixture.FrameTime;

        internal void Hold(MovementKeys keys, int count)
        {
            for (int i = 0; i < count; i++)
            {
                frames++;
                Player.Update(keys, Now);
                Engine.Tick(Now);
            }
        }

        internal void Spawn(uint id, Vector3 place)
        {
            PhysicsBody body = Engine.CreateBody(id, WalkFixture.Setup, PhysicsState.Default, WeenieTraits.Present | WeenieTraits.Creature);
            Assert.True(body.EnterWorld(new Position(StubWorld.CellId, place)));
        }

        internal void Say(in MovementData order) => server.Say(Update(order));

        internal void SayBytes(ReadOnlySpan<byte> message) => server.SayBytes(message);

        /// <summary>An order of any kind, with nothing that belongs to its kind.</summary>
        internal void SayKind(byte kind)
        {
            byte[] message = Bytes(MovementData.TurnToHeading(NonCombat, 0, 1, 0))[..20];
            message[16] = kind;
            server.SayBytes(message);
        }

        /// <summary>The next message, which nobody hears.</summary>
        internal byte[] Bytes(in MovementData order)
        {
            byte[] bytes = new byte[256];
            Assert.True(WireMessage.TryWrite(Update(order), bytes, out int length));
            return bytes[..length];
        }

        private UpdateMotion Update(in MovementData order)
        {
            stamp++;
            return new UpdateMotion(KeyFixture.Id, 1, stamp, stamp, Autonomous: false, order);
        }
    }
}
