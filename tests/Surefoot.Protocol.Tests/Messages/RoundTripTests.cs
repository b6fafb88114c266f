using CsCheck;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Messages;

/// <summary>Every message type that the library has, found by reflection.</summary>
public class RoundTripTests
{
    private static readonly byte[] Buffer = new byte[1 << 16];

    public static TheoryData<string> MessageTypes { get; } = [.. MessageTypesOf().Select(type => type.Name).Order()];

    private interface IProbe
    {
        void RoundTrip(int seed);

        void Damage(int seed);
    }

    [Theory, MemberData(nameof(MessageTypes)), Behaviour("protocol.messages.round-trip", "08, 3 to 7")]
    public void Any_message_is_read_as_it_was_written(string type)
    {
        IProbe probe = ProbeOf(type);
        Gen.Int.Sample(probe.RoundTrip, iter: Fuzz.Cases(200), threads: 1);
    }

    [Theory, MemberData(nameof(MessageTypes)), Behaviour("protocol.messages.damage-is-a-reason", "design.md, 7")]
    public void Cut_and_damaged_messages_are_refused_with_a_reason_and_never_throw(string type)
    {
        IProbe probe = ProbeOf(type);
        Gen.Int.Sample(probe.Damage, iter: Fuzz.Cases(100), threads: 1);
    }

    private static IEnumerable<Type> MessageTypesOf() => typeof(IMessage<>).Assembly.GetTypes().Where(type =>
        !type.IsInterface && type.GetInterfaces().Any(i => i.IsGenericType && i.GetGenericTypeDefinition() == typeof(IMessage<>)));

    private static IProbe ProbeOf(string name)
        => (IProbe)Activator.CreateInstance(typeof(Probe<>).MakeGenericType(MessageTypesOf().Single(type => type.Name == name)))!;

    private sealed class Probe<T> : IProbe
        where T : IMessage<T>
    {
        public void RoundTrip(int seed)
        {
            var values = new RandomValues(seed);
            T sent = values.Of<T>();
            uint stamp = values.Of<uint>(), guid = values.Of<uint>();
            Assert.True(WireMessage.TryWrite(sent, Buffer, out int length, stamp, guid));
            byte[] bytes = Buffer[..length];

            Assert.True(WireMessage.TryParse(bytes, out WireMessage message));
            Assert.Equal(T.Id, message.Id);
            Assert.Equal(T.Id.Opcode is Opcode.GameAction or Opcode.GameEvent ? stamp : 0, message.Stamp);
            Assert.Equal(T.Id.Opcode is Opcode.GameEvent ? guid : 0, message.Guid);
            Assert.True(message.TryRead(out T received, out int unread, out WireFault fault), fault.ToString());
            Assert.Equal(0, unread);
            Assert.Equal(sent, received);
            Assert.True(WireMessage.TryWrite(received, Buffer, out int again, stamp, guid));
            Assert.Equal(Hex.Of(bytes), Hex.Of(Buffer.AsSpan(0, again)));
        }

        public void Damage(int seed)
        {
            var values = new RandomValues(seed);
            Assert.True(WireMessage.TryWrite(values.Of<T>(), Buffer, out int length));
            byte[] bytes = Buffer[..length];
            for (int cut = 0; cut <= length; cut++)
                Read(bytes.AsSpan(0, cut));
            for (int i = 0; i < 50; i++)
            {
                byte[] damaged = [.. bytes];
                damaged[(int)(values.Of<uint>() % (uint)length)] ^= (byte)(1 << (values.Of<byte>() & 7));
                Read(damaged);
            }
        }

        private static void Read(ReadOnlySpan<byte> bytes)
        {
            bool isMessage = WireMessage.TryParse(bytes, out WireMessage message);
            Assert.Equal(bytes.Length >= 4, isMessage);
            bool isRead = message.TryRead(out T _, out WireFault fault);
            Assert.Equal(isRead, fault == WireFault.None);
        }
    }
}
