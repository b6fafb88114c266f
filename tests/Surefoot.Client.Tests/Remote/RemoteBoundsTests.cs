using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>What a server may say, however wrong: it is counted and bounded, and no body comes into an impossible state.</summary>
public class RemoteBoundsTests
{
    [Fact]
    [Behaviour("remote.bounds.object-that-never-comes", "design, decision 7; spec/09, 5.9")]
    public void Ten_thousand_messages_for_an_object_that_never_comes_are_bounded_and_over_after_25_seconds()
    {
        RemoteFixture f = new();
        for (int i = 0; i < 10_000; i++) f.Say(MotionOf((ushort)i, 1, Run()));
        Assert.Equal((1, 256), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        Assert.Equal(10_000L - 256, f.Remote.Drops[RemoteDrop.NoRoom]);
        f.FramesUntil(25.1);
        Assert.Equal((0, 0, 256L), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount, f.Remote.Drops[RemoteDrop.NeverCame]));
    }

    [Fact]
    [Behaviour("remote.bounds.unknown-objects", "design, decision 7")]
    public void Messages_for_ten_thousand_unknown_objects_are_bounded()
    {
        RemoteFixture f = new(new RemoteWorldOptions { Player = PlayerId, MostWaitingBytes = 1 << 20 });
        for (uint i = 0; i < 10_000; i++) f.Say(MotionOf(1, 1, Run(), guid: One + i));
        Assert.Equal((1024, 1024), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        Assert.Equal(10_000L - 1024, f.Remote.Drops[RemoteDrop.NoRoom]);

        RemoteFixture small = new(new RemoteWorldOptions { Player = PlayerId, MostWaitingBytes = 1000 });
        byte[] message = small.Say(MotionOf(1, 1, Run()));
        for (int i = 0; i < 100; i++) small.SayBytes(message);
        Assert.Equal(1000 / message.Length, small.Remote.WaitingMessageCount);
    }

    [Fact]
    [Behaviour("remote.bounds.before-the-player", "design, decision 7")]
    public void What_waits_for_the_player_is_bounded()
    {
        RemoteFixture f = new(new RemoteWorldOptions { MostWaitingBytes = 1000 });
        byte[] message = f.Say(MotionOf(1, 1, Run()));
        for (int i = 0; i < 100; i++) f.SayBytes(message);
        Assert.Equal(1000 / message.Length, f.Remote.WaitingMessageCount);
        Assert.Equal(101 - (1000 / message.Length), f.Remote.Drops[RemoteDrop.NoRoom]);
    }

    [Fact]
    [Behaviour("remote.bounds.objects", "design, decision 7")]
    public void There_are_not_more_objects_than_the_options_say()
    {
        RemoteFixture f = new(new RemoteWorldOptions { Player = PlayerId, MostObjects = 2 });
        for (uint i = 0; i < 5; i++) f.Say(new CreateObject(Describe(One + i)));
        Assert.Equal((2, 3L), (f.Remote.Objects.Count, f.Remote.Drops[RemoteDrop.NoRoom]));
        f.Say(new DeleteObject(One, 1));
        f.Create(Describe(One + 4));
    }

    [Theory]
    [Behaviour("remote.create.no-assets", "design, decision 7; spec/09, 5.8, step 4")]
    [InlineData(0x02FFFFFFu, HumanTable)]
    [InlineData(Human, 0x09FFFFFFu)]
    [InlineData(null, HumanTable)]
    public void An_object_whose_shape_or_motions_are_in_no_file_is_left_out_and_counted(uint? setup, uint? table)
    {
        RemoteFixture f = new();
        ObjectDescription described = Describe(One, Start);
        f.Say(new CreateObject(described with { Physics = described.Physics with { Setup = setup, MotionTable = table } }));
        Assert.Equal((null, null, 1L), (f.Remote.Find(One), f.Engine.Find(One), f.Remote.Drops[RemoteDrop.NoAssets]));
        f.Create(described);
    }

    [Fact]
    [Behaviour("remote.create.foreign-body", "design, decision 7")]
    public void A_body_that_the_application_made_is_left_alone()
    {
        RemoteFixture f = new();
        PhysicsBody own = f.Engine.CreateBody(One, StubAssets.HumanShape);
        f.Say(new CreateObject(Describe(One, Start)));
        Assert.Equal((1L, own), (f.Remote.Drops[RemoteDrop.NotOurs], f.Engine.Find(One)));
        Assert.Null(own.Cell);
    }

    public static TheoryData<WirePosition> BadPlaces => new(
        At(new Vector3(float.NaN, 0, 0)), At(new Vector3(0, float.PositiveInfinity, 0)), At(new Vector3(0, 0, 1e30f)),
        At(Start) with { Cell = 0xA9B40000 }, At(Start) with { Cell = 0xA9B400FF }, At(Start) with { Cell = 0xFFFF0001 },
        At(Start) with { Orientation = default }, At(Start) with { Orientation = new Quaternion(0, 0, 0, float.NaN) },
        At(Start) with { Orientation = new Quaternion(0, 0, 0, 2) });

    [Theory]
    [Behaviour("remote.position.bad-values", "design, decision 7")]
    [MemberData(nameof(BadPlaces))]
    public void A_place_that_cannot_be_is_counted_and_uses_no_stamp_up(WirePosition place)
    {
        RemoteFixture f = new();
        f.CreateStanding();
        ulong before = f.Engine.HashState();
        f.Say(new UpdatePosition(One, new PositionPack(place, true, 1, 1, 1, 0)));
        Assert.Equal((before, 1L), (f.Engine.HashState(), f.Remote.Drops[RemoteDrop.BadValue]));
        Assert.Equal((ushort)0, f.Item.Stamps[ObjectStamp.Position]);

        ObjectDescription described = Describe(Other);
        RemoteBody other = f.Create(described with { Physics = described.Physics with { Position = place } });
        Assert.Equal((null, 2L), (other.Body.Cell, f.Remote.Drops[RemoteDrop.BadValue]));
    }

    [Fact]
    [Behaviour("remote.position.off-the-map", "spec/02, 4.16, step 3 and 4.17; design, decision 7")]
    public void A_place_far_off_the_map_is_taken_and_the_body_is_in_a_valid_state()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(PositionOf(new Vector3(1e9f, -1e9f, 0), 1, teleport: 1));
        f.Create(Describe(Other, new Vector3(-1e9f, 1e9f, 0)));
        f.Frames(5);
        AssertValid(f);
    }

    [Theory]
    [Behaviour("remote.velocity.bad-values", "design, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    [InlineData(1e30f)]
    public void A_velocity_that_cannot_be_is_counted(float speed)
    {
        RemoteFixture f = new();
        f.CreateStanding();
        ulong before = f.Engine.HashState();
        f.Say(new VectorUpdate(One, new Vector3(speed, 0, 0), default, 1, 1));
        f.Say(new VectorUpdate(One, default, new Vector3(0, speed, 0), 1, 1));
        Assert.Equal((before, 2L), (f.Engine.HashState(), f.Remote.Drops[RemoteDrop.BadValue]));
        Assert.Equal((ushort)0, f.Item.Stamps[ObjectStamp.Vector]);
    }

    [Fact]
    [Behaviour("remote.create.bad-values", "design, decision 7")]
    public void Numbers_of_a_description_that_cannot_be_are_counted_and_have_their_defaults()
    {
        RemoteFixture f = new();
        ObjectDescription described = Describe(One, Start);
        f.Create(described with
        {
            Physics = described.Physics with
            {
                Scale = 1e30f,
                Friction = float.NaN,
                Elasticity = float.NaN,
                Velocity = new Vector3(float.NaN, 0, 0),
                Movement = Run(float.NegativeInfinity),
            },
        });
        Assert.Equal((1f, 0.95f, 0.05f, Vector3.Zero), (f.Body.Scale, f.Body.Friction, f.Body.Elasticity, f.Body.Velocity));
        // The scale, the friction, the elasticity, the velocity and the motion, each for itself.
        Assert.Equal(5, f.Remote.Drops[RemoteDrop.BadValue]);
        f.Say(new CreateObject(Describe(0, Start)));
        f.Say(PositionOf(Start, 1, guid: 0));
        Assert.Equal((7L, 0), (f.Remote.Drops[RemoteDrop.BadValue], f.Remote.AwaitedCount));
        foreach (float scale in (float[])[0, -1, float.NaN, 1e-6f])
            f.Say(new UpdateObject(described with { Physics = described.Physics with { Scale = scale } }));
        Assert.Equal((11L, 1f), (f.Remote.Drops[RemoteDrop.BadValue], f.Body.Scale));
    }

    [Fact]
    [Behaviour("remote.motion.target-is-itself", "spec/09b, 6.3: top = own id, CleanUp and StopCompletely")]
    public void A_body_that_is_sent_to_itself_stands_where_it_is()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        Position before = f.Body.Position;
        f.Say(MotionOf(1, 1, Run()));
        f.Say(MotionOf(2, 2, MovementData.MoveToObject(NonCombat, One, StubWorld.CellId, Start, Way, 1)));
        Assert.False(f.Body.IsMovingTo);
        Assert.Equal(MotionCommand.Ready, f.Motion.ForwardCommand);
        f.Frames(60);
        Assert.Equal(before, f.Body.Position);
        AssertValid(f);
    }

    [Fact]
    [Behaviour("remote.motion.sticks-to-itself", "spec/09, 3.3 and 6.6: a null vector has no length and the heading 0; one second")]
    public void A_body_that_is_to_stick_to_itself_stays_where_it_is_faces_north_and_lets_go_after_a_second()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Body.SetHeading(90);
        Vector3 before = f.Origin;
        f.Say(MotionOf(1, 1, MovementData.Motion(NonCombat, new WireInterpretedMotion(), stickTo: One)));
        Assert.Equal(One, f.Body.StickyObjectId);
        f.Frames(1);
        Assert.Equal(0, f.Body.Position.Frame.Heading, 1e-3);
        f.Frames(28);
        Assert.Equal(One, f.Body.StickyObjectId);
        f.Frames(3);
        Assert.Equal(0u, f.Body.StickyObjectId);
        Assert.Equal(before, f.Origin);
        AssertValid(f);
    }

    [Fact]
    [Behaviour("remote.unreadable", "design, decision 7")]
    public void A_message_that_is_cut_short_is_counted()
    {
        RemoteFixture f = new();
        byte[][] messages =
        [
            f.Encode(new CreateObject(Describe(One, Start))), f.Encode(PositionOf(Start, 1)), f.Encode(MotionOf(1, 1, Run())),
            f.Encode(new VectorUpdate(One, default, default, 1, 1)), f.Encode(new SetState(One, 0, 1, 1)),
            f.Encode(new ParentEvent(One, Other, Hand, 0, 1, 1)), f.Encode(new PickupEvent(One, 1, 1)),
        ];
        long cuts = 0;
        foreach (byte[] message in messages)
        {
            // The last bytes of a creature's description may be left out without harm: they only fill it up.
            for (int length = 4; length < message.Length - 4; length++, cuts++) f.SayBytes(message.AsSpan(0, length));
        }

        Assert.Equal((cuts, 0), (f.Remote.Drops[RemoteDrop.Unreadable], f.Remote.AwaitedCount));
        Assert.Empty(f.Remote.Objects);
    }

    [Fact]
    [Behaviour("remote.fuzz", "design, decision 7")]
    public void Whatever_a_server_says_nothing_is_thrown_and_every_body_stays_valid()
    {
        Gen<uint> odd = Gen.OneOf(Gen.Const(PlayerId), Gen.Const(0u), Gen.Const(0xFFFFFFFFu));
        Gen<uint> guid = Gen.Frequency((8, Gen.UInt[One, One + 3]), (1, odd));
        Gen<ushort> stamp = Gen.Frequency((8, Gen.UShort[0, 20]), (1, Gen.UShort));
        Gen<float> number = Gen.Frequency(
            (12, Gen.Float[-8, 8]), (2, Gen.Float[-500, 500]),
            (1, Gen.OneOf(Gen.Const(float.NaN), Gen.Const(float.PositiveInfinity), Gen.Const(1e30f), Gen.Const(-1e9f), Gen.Const(1e-30f))));
        Gen<Vector3> vector = Gen.Select(number, number, number, (x, y, z) => new Vector3(x, y, z));
        Gen<uint> state = Gen.Frequency((3, Gen.Const(Standing)), (1, Gen.UInt));
        Gen<Said> said = Gen.Select(
            Gen.Int[0, 11], Gen.Select(guid, guid), Gen.Select(stamp, stamp, stamp), vector, Gen.Select(state, number, Gen.Bool),
            Gen.Int[0, 400],
            (kind, who, stamps, place, rest, damage) => new Said(kind, who.Item1, who.Item2, stamps.Item1, stamps.Item2,
                stamps.Item3, place, rest.Item1, rest.Item2, rest.Item3, damage));
        said.Array[1, 60].Sample(
            messages =>
            {
                RemoteFixture f = new();
                f.Create(Describe(One, Start));
                f.Create(Describe(One + 1, Start + new Vector3(2, 0, 0)));
                foreach (Said message in messages)
                {
                    f.SayBytes(message.Encode(f));
                    f.Frames(1);
                    AssertValid(f);
                }
            },
            iter: Fuzz.Cases(300), threads: 1);
    }

    private static void AssertValid(RemoteFixture f)
    {
        foreach (RemoteBody item in f.Remote.Objects)
        {
            PhysicsBody body = item.Body;
            Frame frame = body.Position.Frame;
            Assert.True(frame.IsValid && IsFinite(frame.Origin), $"{item.Id:X} {body.Position}");
            Assert.True(IsFinite(body.Velocity) && IsFinite(body.Omega), $"{item.Id:X} {body.Velocity} {body.Omega}");
            Assert.True(body.Cell is null || CellIds.IsValid(body.Position.CellId), $"{body.Position}");
            Assert.Same(body, f.Engine.Find(item.Id));
        }

        static bool IsFinite(Vector3 v) => float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z);
    }

    /// <summary>A message by the numbers it is made of; now and then some of its bytes are damaged.</summary>
    private sealed record Said(
        int Kind, uint Who, uint Whom, ushort First, ushort Second, ushort Third, Vector3 Vector, uint State, float Number, bool Flag,
        int Damage)
    {
        public byte[] Encode(RemoteFixture f)
        {
            byte[] message = Kind switch
            {
                0 or 1 => f.Encode(PositionOf(Start + Vector, First, Second, Flag, guid: Who)),
                2 => f.Encode(MotionOf(First, Second, Run(Number), Flag, guid: Who)),
                3 => f.Encode(MotionOf(First, Second, MovementData.MoveToObject(
                    NonCombat, Whom, StubWorld.CellId, Start + Vector, Way with { Bits = State }, Number), guid: Who)),
                4 => f.Encode(MotionOf(First, Second, MovementData.MoveToPosition(
                    NonCombat, StubWorld.CellId, Start + Vector, Way with { DistanceToObject = Number }, 1), guid: Who)),
                5 => f.Encode(MotionOf(First, Second, MovementData.TurnToObject(NonCombat, Whom, Number, State, 1, Number), guid: Who)),
                6 => f.Encode(new VectorUpdate(Who, Vector, new Vector3(Number), 1, First)),
                7 => f.Encode(new SetState(Who, State, 1, First)),
                8 => f.Encode(new ParentEvent(Who, Whom, Flag ? Hand : State, State, 1, First)),
                9 => Flag ? f.Encode(new PickupEvent(Who, 1, First)) : f.Encode(new DeleteObject(Who, 1)),
                _ => f.Encode(new CreateObject(Description())),
            };
            if (Damage < 100)
            {
                message[4 + (Damage % (message.Length - 4))] = (byte)First;
                message[4 + (Third % (message.Length - 4))] = (byte)Second;
            }

            return message;
        }

        private ObjectDescription Description()
        {
            ObjectDescription described = Describe(
                Who, Flag ? Start + Vector : null, new ObjectStamps(First, First, First, First, Second, 0, 0, 0, 1));
            return described with
            {
                Physics = described.Physics with
                {
                    State = State,
                    Scale = Number,
                    Velocity = Vector,
                    Omega = Vector,
                    Movement = Run(Number),
                    Parent = Third < 5 ? new HoldingLink(Whom, Hand) : null,
                    Children = Third is > 5 and < 10 ? [new HoldingLink(Whom, Hand)] : null,
                },
            };
        }
    }
}
