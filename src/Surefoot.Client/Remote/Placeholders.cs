using System.Diagnostics.CodeAnalysis;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>An object of which something was said before it was described.</summary>
/// <param name="guid">Its id.</param>
/// <param name="now">When it was made, seconds.</param>
/// <remarks>Retail: CPhysicsObj::makeNullObject @0x00512600.</remarks>
internal sealed class Placeholder(uint guid, double now)
{
    /// <summary>Id of the object.</summary>
    internal uint Guid => guid;

    /// <summary>The messages for it, in the order of coming.</summary>
    internal List<byte[]> Messages { get; } = [];

    /// <summary>Who holds it, and where.</summary>
    internal HoldingLink? Holder { get; set; }

    /// <summary>When it was made or asked for last, seconds.</summary>
    internal double LastRequest { get; set; } = now;
}

/// <summary>Messages that wait for objects that are not known yet.</summary>
/// <remarks>Retail: CObjectMaint::QueueBlobForObject @0x005092D0, GetNullObject @0x00508FE0; specification 09, 5.9.</remarks>
internal sealed class Placeholders(RemoteWorldOptions limits, RemoteDrops drops)
{
    private const double RequestInterval = 20.0;

    private readonly Dictionary<uint, Placeholder> waiting = [];
    private long bytes;

    /// <summary>Objects waited for.</summary>
    internal int Count => waiting.Count;

    /// <summary>Messages that wait, in all.</summary>
    internal int MessageCount { get; private set; }

    /// <summary>An object waited for, made if need be.</summary>
    /// <returns>Null when too many are waited for.</returns>
    internal Placeholder? Get(uint guid, double now)
    {
        if (waiting.TryGetValue(guid, out Placeholder? placeholder)) return placeholder;
        if (waiting.Count >= limits.MostAwaited) return null;
        placeholder = new Placeholder(guid, now);
        waiting.Add(guid, placeholder);
        return placeholder;
    }

    /// <summary>Has a message wait.</summary>
    /// <returns>False when there is no room for the object it is for; one message more or less is only counted.</returns>
    internal bool TryQueue(uint guid, ReadOnlySpan<byte> message, double now)
    {
        if (Get(guid, now) is not { } placeholder)
        {
            drops.Add(RemoteDrop.NoRoom);
            return false;
        }

        if (placeholder.Messages.Count >= limits.MostMessagesEach || bytes + message.Length > limits.MostWaitingBytes)
        {
            drops.Add(RemoteDrop.NoRoom);
            return true;
        }

        placeholder.Messages.Add(message.ToArray());
        bytes += message.Length;
        MessageCount++;
        return true;
    }

    /// <summary>The object came, or is given up: its messages are the caller's now.</summary>
    internal bool TryTake(uint guid, [NotNullWhen(true)] out Placeholder? placeholder)
    {
        if (!waiting.Remove(guid, out placeholder)) return false;
        foreach (byte[] message in placeholder.Messages) bytes -= message.Length;
        MessageCount -= placeholder.Messages.Count;
        return true;
    }

    /// <summary>A holder is gone: what it was to hold is told.</summary>
    internal void LetGo(uint holder, Action<uint> letGo)
    {
        foreach (Placeholder placeholder in waiting.Values)
        {
            if (placeholder.Holder?.Guid != holder) continue;
            placeholder.Holder = null;
            letGo(placeholder.Guid);
        }
    }

    /// <summary>Asks for the objects that have been waited for long enough since they were asked for last.</summary>
    /// <remarks>Retail: CObjectMaint::UseTime @0x005089B0.</remarks>
    internal void Request(double now, IRemoteObserver? observer)
    {
        foreach (Placeholder placeholder in waiting.Values)
        {
            if (!(now - placeholder.LastRequest > RequestInterval)) continue;
            placeholder.LastRequest = now;
            observer?.OnMissing(placeholder.Guid);
        }
    }
}
