using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client.Tests;

/// <summary>The way to a server that says what a test has it say, at once.</summary>
internal sealed class FakeServer : IServerLink
{
    private readonly byte[] bytes = new byte[4096];
    private readonly List<byte[]> waiting = [];

    /// <summary>Bytes of what the client sent.</summary>
    internal List<byte[]> Sent { get; } = [];

    /// <summary>It takes what the client sends and keeps nothing.</summary>
    internal bool IsDeaf { get; set; }

    /// <summary>Objects that the client asked for.</summary>
    internal List<uint> Requested { get; } = [];

    public void RequestObject(uint guid, double now) => Requested.Add(guid);

    public void Send<T>(in T action, double now)
        where T : IGameAction<T>
    {
        if (IsDeaf) return;
        Assert.True(WireMessage.TryWrite(action, bytes, out int length, (uint)Sent.Count + 1));
        Sent.Add(bytes[..length]);
    }

    public void Receive(double now, IMessageReceiver receiver)
    {
        foreach (byte[] message in waiting)
        {
            Assert.True(WireMessage.TryParse(message, out WireMessage parsed));
            receiver.OnMessage(parsed);
        }

        waiting.Clear();
    }

    /// <summary>Something that the client will hear of when it asks next.</summary>
    internal byte[] Say<T>(in T message)
        where T : IMessage<T>
    {
        Assert.True(WireMessage.TryWrite(message, bytes, out int length, stamp: 1, guid: KeyFixture.Id));
        waiting.Add(bytes[..length]);
        return waiting[^1];
    }

    /// <summary>The same with bytes as they are.</summary>
    internal void SayBytes(ReadOnlySpan<byte> message) => waiting.Add(message.ToArray());

    /// <summary>Nothing has been said.</summary>
    internal void Clear() => waiting.Clear();
}
