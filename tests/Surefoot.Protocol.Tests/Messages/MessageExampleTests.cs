using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Messages;

/// <summary>The messages inside the worked examples; the datagrams around them are in the session's tests.</summary>
public class MessageExampleTests
{
    private const int AfterHeaders = 0x24, AfterAck = 0x28;

    private static readonly WirePosition Place =
        new(0xA9B40019, new Vector3(84, 7.1f, 94), new Quaternion(0, 0, -0.0784591f, 0.996917f));

    private static readonly MovementStamps Stamps = new(Instance: 1, ServerControlledMove: 2, Teleport: 3, ForcePosition: 4);

    [Fact, Behaviour("protocol.examples.move-to-state", "08, 11.6")]
    public void The_example_of_autorun_is_written_and_read()
        => Check(
            new MoveToState(
                new WireRawMotion(currentHoldKey: 2, forwardCommand: 0x45000005, forwardHoldKey: 2), Place, Stamps, Contact: true, false),
            WorkedExamples.MoveToState.AsSpan(AfterHeaders),
            stamp: 1);

    [Fact, Behaviour("protocol.examples.jump", "08, 11.7")]
    public void The_example_of_a_jump_is_written_and_read()
        => Check(new Jump(0.5f, new Vector3(0, 4, 7), Place, Stamps), WorkedExamples.Jump.AsSpan(AfterHeaders), stamp: 2);

    [Fact, Behaviour("protocol.examples.autonomous-position", "08, 11.8")]
    public void The_example_of_a_position_report_is_written_and_read()
        => Check(new AutonomousPosition(Place, Stamps, Contact: true), WorkedExamples.AutonomousPosition.AsSpan(AfterAck), stamp: 3);

    [Fact, Behaviour("protocol.examples.update-motion", "08, 11.9")]
    public void The_example_of_a_running_body_is_written_and_read()
        => Check(
            new UpdateMotion(
                0x50000001, Instance: 1, MovementStamp: 9, ServerControlledMove: 2, Autonomous: true,
                MovementData.Motion(0x3D, new WireInterpretedMotion(style: 0x3D, forwardCommand: 7, forwardSpeed: 2.5f))),
            WorkedExamples.UpdateMotion.AsSpan(AfterHeaders));

    [Fact, Behaviour("protocol.examples.update-position", "08, 11.10")]
    public void The_example_of_a_position_is_written_and_read()
        => Check(
            new UpdatePosition(
                0x50000001, new PositionPack(Place, contact: true, instance: 1, positionStamp: 17, teleport: 3, forcePosition: 4)),
            WorkedExamples.UpdatePosition.AsSpan(AfterHeaders));

    [Fact, Behaviour("protocol.examples.sticky-motion-with-action", "08, 11.11")]
    public void The_example_of_an_action_at_odd_alignment_is_written_and_read()
        => Check(
            new UpdateMotion(
                0x50000002, Instance: 1, MovementStamp: 10, ServerControlledMove: 3, Autonomous: false,
                MovementData.Motion(
                    0x3D,
                    new WireInterpretedMotion(
                        forwardCommand: 5, actions: new MotionActions([new MotionAction(0x87, Stamp: 3, Autonomous: false, 1)])),
                    stickTo: 0x80001234)),
            WorkedExamples.StickyMotion);

    [Fact, Behaviour("protocol.examples.keys-held", "08, 11.6; 09b, 15.8")]
    public void The_forward_key_sends_no_hold_key_of_its_own()
    {
        byte[] buffer = new byte[128];
        var held = new WireRawMotion(currentHoldKey: 2, forwardCommand: 0x45000005);
        Assert.True(WireMessage.TryWrite(new MoveToState(held, Place, Stamps, true, false), buffer, out int length));
        Assert.Equal("05000000" + "02000000" + "05000045", Hex.Of(buffer.AsSpan(12, 12)));
        Assert.Equal(12 + 12 + 32 + 8 + 4, length);
    }

    [Theory]
    [InlineData(10, 11, true)]
    [InlineData(11, 10, false)]
    [InlineData(5, 5, false)]
    [InlineData(65535, 0, true)]
    [InlineData(0, 65535, false)]
    [InlineData(0, 0x7FFF, true)]
    [InlineData(0, 0x8000, false)]
    [InlineData(0x8000, 0, true)]
    [InlineData(0x7FFF, 0xFFFF, false)]
    [Behaviour("protocol.stamps.newer-around-the-wrap", "08, 4.3 and 11")]
    public void A_stamp_is_newer_around_the_wrap(int stored, int incoming, bool newer)
        => Assert.Equal(newer, ObjectStamps.IsNewer((ushort)stored, (ushort)incoming));

    [Theory]
    [InlineData(0x7FFF, 0, true)]
    [InlineData(0, 0x7FFF, false)]
    [InlineData(0, 0x3FFF, true)]
    [InlineData(0, 0x4000, false)]
    [Behaviour("protocol.stamps.actions-have-fifteen-bits", "08, 6.4 and 11")]
    public void A_stamp_of_an_action_is_newer_around_fifteen_bits(int stored, int incoming, bool newer)
        => Assert.Equal(newer, MotionAction.IsNewer(stored, incoming));

    private static void Check<T>(T message, ReadOnlySpan<byte> bytes, uint stamp = 0)
        where T : IMessage<T>
    {
        byte[] buffer = new byte[256];
        Assert.True(WireMessage.TryWrite(message, buffer, out int length, stamp));
        Assert.Equal(Hex.Of(bytes), Hex.Of(buffer.AsSpan(0, length)));

        Assert.True(WireMessage.TryParse(bytes, out WireMessage wire));
        Assert.Equal(stamp, wire.Stamp);
        Assert.True(wire.TryRead(out T read));
        Assert.Equal(message, read);
    }
}
