using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>Who sent a datagram.</summary>
public enum WireDirection
{
    /// <summary>The client.</summary>
    ClientToServer,

    /// <summary>The server.</summary>
    ServerToClient,
}

/// <summary>What a <see cref="WireTap"/> found in a datagram.</summary>
/// <param name="Header">The header; empty when the datagram is shorter than one.</param>
/// <param name="Reason">Why its receiver does not use it.</param>
/// <param name="IsVerified">False when it came before anything that could be checked against: what it says is believed.</param>
/// <param name="KeyIndex">Which word of its sender's key stream its checksum was made with, from 0; null for clear text.</param>
public readonly record struct TapReport(PacketHeader Header, DropReason Reason, bool IsVerified, int? KeyIndex);

/// <summary>Receives the messages that a <see cref="WireTap"/> sees.</summary>
public interface ITapReceiver
{
    /// <summary>A message is complete.</summary>
    /// <param name="direction">Who sent it.</param>
    /// <param name="fragment">Header of the fragment that completed it.</param>
    /// <param name="message">The message; lives until this returns.</param>
    void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message);
}

/// <summary>Listens to a session between others, from its beginning, and tells what each datagram is to its receiver.</summary>
public sealed class WireTap
{
    private const uint Farthest = 0x7FFF;
    private const int MostMissing = 40_000;

    private readonly FragmentAssembler[] assemblers = [new(), new()];
    private ReceiveWindow? fromClient, fromServer;
    private uint? unverifiedMessage;

    /// <summary>What the server chose for the session; null until it has.</summary>
    public ConnectRequest? Session { get; private set; }

    /// <summary>Looks at a datagram.</summary>
    /// <param name="direction">Who sent it.</param>
    /// <param name="bytes">The datagram.</param>
    /// <param name="receiver">Takes the messages that it completes.</param>
    public TapReport Observe(WireDirection direction, ReadOnlySpan<byte> bytes, ITapReceiver receiver)
    {
        DropReason reason = Datagram.TryParse(bytes, out Datagram datagram);
        if (reason != DropReason.None)
            return new TapReport(bytes.Length < PacketHeader.Length ? default : PacketHeader.Read(bytes), reason, true, null);

        bool isVerified = true;
        int keyIndex = -1;
        ReceiveWindow? window = direction == WireDirection.ClientToServer ? fromClient : fromServer;
        if (window is not null)
            reason = window.Accept(datagram, out keyIndex);
        else if (datagram.Header.IsEncrypted)
            isVerified = false;
        else if (!datagram.IsIntact)
            reason = DropReason.Checksum;

        if (reason == DropReason.None)
            Follow(direction, datagram, isVerified, receiver);
        return new TapReport(datagram.Header, reason, isVerified, keyIndex < 0 ? null : keyIndex);
    }

    private void Follow(WireDirection direction, in Datagram datagram, bool isVerified, ITapReceiver receiver)
    {
        if (datagram.Has(PacketFlags.ConnectRequest) && Session is null)
        {
            ConnectRequest session = ConnectRequest.Read(datagram.Handshake);
            Session = session;
            fromClient = new ReceiveWindow(session.ClientSeed, Farthest, MostMissing);
            fromServer = new ReceiveWindow(session.ServerSeed, Farthest, MostMissing);
        }

        if (datagram.Has(PacketFlags.RejectRetransmit))
            (direction == WireDirection.ClientToServer ? fromClient : fromServer)?.Forget(datagram.Rejected);
        foreach (Datagram.Fragment fragment in datagram.Fragments)
        {
            assemblers[(int)direction].Add(fragment.Header, fragment.Data, out ReadOnlySpan<byte> bytes);
            if (!WireMessage.TryParse(bytes, out WireMessage message))
                continue;

            // Nothing numbers these packets: a message that comes again has only its own number to know it by.
            if (!isVerified && unverifiedMessage == fragment.Header.Sequence)
                continue;
            if (!isVerified)
                unverifiedMessage = fragment.Header.Sequence;
            receiver.OnMessage(direction, fragment.Header, message);
        }
    }
}
