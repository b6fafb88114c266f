using System.Numerics;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Tests.Messages;

public class AllocationTests
{
    private static readonly byte[] Buffer = new byte[1024];

    [Fact, Behaviour("protocol.messages.movement-allocates-nothing", "design.md, 4")]
    public void Movement_messages_are_written_and_read_without_allocating()
    {
        var place = new WirePosition(0xA9B40019, new Vector3(84, 7, 94), Quaternion.Identity);
        var stamps = new MovementStamps(1, 2, 3, 4);
        var actions = new MotionActions([new MotionAction(0x87, 1, false, 1), new MotionAction(0x88, 2, true, 1)]);
        var goal = new MoveToParams(0x1EE0F, 0.6f, 0, float.MaxValue, 1, 15, 0);
        var messages = new
        {
            State = new MoveToState(new WireRawMotion(2, turnCommand: 0x6500000D, actions: actions), place, stamps, true, false),
            Jump = new Jump(1, Vector3.UnitZ, place, stamps),
            Report = new AutonomousPosition(place, stamps, true),
            Motion = new UpdateMotion(
                1, 2, 3, 4, true, MovementData.Motion(0x3D, new WireInterpretedMotion(forwardCommand: 7, actions: actions), 5)),
            Chase = new UpdateMotion(1, 2, 3, 4, false, MovementData.MoveToObject(0x3D, 7, 8, Vector3.One, goal, 2)),
            Position = new UpdatePosition(1, new PositionPack(place, true, 1, 2, 3, 4, Vector3.One, 0x65)),
            Vector = new VectorUpdate(1, Vector3.One, Vector3.Zero, 1, 2),
            SetState = new SetState(1, 0x400, 1, 2),
            Parent = new ParentEvent(1, 2, 1, 1, 1, 1),
            Pickup = new PickupEvent(1, 1, 1),
            Delete = new DeleteObject(1, 1),
            Teleport = new PlayerTeleport(7),
        };

        long allocated = 0;
        for (int round = 0; round < 3; round++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            BothWays(messages.State);
            BothWays(messages.Jump);
            BothWays(messages.Report);
            BothWays(messages.Motion);
            BothWays(messages.Chase);
            BothWays(messages.Position);
            BothWays(messages.Vector);
            BothWays(messages.SetState);
            BothWays(messages.Parent);
            BothWays(messages.Pickup);
            BothWays(messages.Delete);
            BothWays(messages.Teleport);
            allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, allocated);
    }

    private static void BothWays<T>(in T sent)
        where T : struct, IMessage<T>, IEquatable<T>
    {
        bool written = WireMessage.TryWrite(sent, Buffer, out int length, stamp: 1);
        bool parsed = WireMessage.TryParse(Buffer.AsSpan(0, length), out WireMessage message);
        bool read = message.TryRead(out T received);
        if (!written || !parsed || !read || !received.Equals(sent))
            throw new InvalidOperationException($"{typeof(T).Name} did not come back.");
    }
}
