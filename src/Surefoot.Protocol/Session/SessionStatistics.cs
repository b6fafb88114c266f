namespace Surefoot.Protocol.Session;

/// <summary>What a session has counted.</summary>
public sealed class SessionStatistics
{
    private readonly long[] dropped = new long[Enum.GetValues<DropReason>().Length];

    /// <summary>Datagrams that arrived, good or not.</summary>
    public long DatagramsReceived { get; internal set; }

    /// <summary>Their bytes.</summary>
    public long BytesReceived { get; internal set; }

    /// <summary>Datagrams sent, repeated ones included.</summary>
    public long DatagramsSent { get; internal set; }

    /// <summary>Their bytes.</summary>
    public long BytesSent { get; internal set; }

    /// <summary>Packets sent again because the other side asked.</summary>
    public long Resent { get; internal set; }

    /// <summary>Times that the other side was asked to send again.</summary>
    public long RequestsSent { get; internal set; }

    /// <summary>Messages received whole.</summary>
    public long MessagesReceived { get; internal set; }

    /// <summary>Messages sent.</summary>
    public long MessagesSent { get; internal set; }

    /// <summary>How many datagrams or messages were not used for this reason.</summary>
    public long Dropped(DropReason reason) => dropped[(int)reason];

    internal void Count(DropReason reason)
    {
        if (reason != DropReason.None)
            dropped[(int)reason]++;
    }
}
