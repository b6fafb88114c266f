using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>Keeps what is sent.</summary>
internal sealed class SentDatagrams : IDatagramSink
{
    public List<(byte[] Bytes, ServerPort Port)> All { get; } = [];

    public byte[] Last => All[^1].Bytes;

    public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => All.Add((datagram.ToArray(), port));

    /// <summary>Takes what was sent since the last time.</summary>
    public (byte[] Bytes, ServerPort Port)[] Take()
    {
        (byte[] Bytes, ServerPort Port)[] taken = [.. All];
        All.Clear();
        return taken;
    }
}

/// <summary>Keeps what arrives.</summary>
internal sealed class ReceivedMessages : ISessionHandler
{
    public List<byte[]> All { get; } = [];

    public List<SessionState> States { get; } = [];

    public IEnumerable<MessageId> Ids => All.Select(bytes => WireMessage.TryParse(bytes, out WireMessage message) ? message.Id : default);

    public void OnMessage(in WireMessage message) => All.Add(message.Bytes.ToArray());

    public void OnStateChanged(SessionState state) => States.Add(state);

    /// <summary>All messages of a type.</summary>
    public IReadOnlyList<T> Of<T>()
        where T : IMessage<T>
    {
        List<T> found = [];
        foreach (byte[] bytes in All)
        {
            if (WireMessage.TryParse(bytes, out WireMessage message) && message.TryRead(out T value))
                found.Add(value);
        }

        return found;
    }
}
