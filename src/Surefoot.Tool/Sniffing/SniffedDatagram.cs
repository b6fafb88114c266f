using System.Net;
using PacketDotNet;

namespace Surefoot.Tool.Sniffing;

/// <summary>A UDP datagram of a capture.</summary>
/// <param name="Time">When it was seen, seconds since 1970.</param>
/// <param name="From">Who sent it.</param>
/// <param name="To">To whom.</param>
/// <param name="Bytes">What it carries.</param>
internal sealed record SniffedDatagram(double Time, IPEndPoint From, IPEndPoint To, byte[] Bytes)
{
    /// <summary>The datagram in a frame; null when there is none, or only a part of one.</summary>
    internal static SniffedDatagram? Of(in CapturedFrame frame)
    {
        try
        {
            Packet packet = Packet.ParsePacket((LinkLayers)frame.LinkType, frame.Bytes);
            if (packet.Extract<UdpPacket>() is not { PayloadData: { } bytes } datagram || packet.Extract<IPPacket>() is not { } ip)
                return null;
            return new SniffedDatagram(
                frame.Time, new IPEndPoint(ip.SourceAddress, datagram.SourcePort),
                new IPEndPoint(ip.DestinationAddress, datagram.DestinationPort), bytes);
        }
        catch (Exception e) when (e is ArgumentException or IndexOutOfRangeException or InvalidOperationException or NotImplementedException
            or NotSupportedException or OverflowException or InvalidCastException)
        {
            // What is cut short or of a kind that the library does not know is nothing that we could read.
            return null;
        }
    }
}
