using System.Buffers.Binary;
using System.Net;
using System.Net.Sockets;

namespace Surefoot.Server;

/// <summary>Where a client's datagrams come from, as a value: an address of either family and a port.</summary>
/// <param name="Address">The 16 bytes; those of version 4 in the form that version 6 has for them.</param>
/// <param name="Port">The port.</param>
internal readonly record struct ClientAddress(UInt128 Address, ushort Port)
{
    private const int PortAt = 2, V4At = 4, V6At = 8;

    private static readonly UInt128 V4Prefix = (UInt128)0xFFFF << 32;

    /// <summary>Those that a login limit sees as one: version 6 gives each customer at least 64 bits.</summary>
    public UInt128 Network => IsV4 ? Address : Address >> 64;

    private bool IsV4 => Address >> 32 == 0xFFFF;

    /// <summary>Reads what the system says.</summary>
    public static ClientAddress Of(SocketAddress socket)
    {
        ReadOnlySpan<byte> bytes = socket.Buffer.Span;
        ushort port = BinaryPrimitives.ReadUInt16BigEndian(bytes[PortAt..]);
        return socket.Family == AddressFamily.InterNetworkV6
            ? new ClientAddress(BinaryPrimitives.ReadUInt128BigEndian(bytes[V6At..]), port)
            : new ClientAddress(V4Prefix | BinaryPrimitives.ReadUInt32BigEndian(bytes[V4At..]), port);
    }

    /// <summary>Puts it into what the system takes; only address and port, the rest stays.</summary>
    public void WriteTo(SocketAddress socket)
    {
        Span<byte> bytes = socket.Buffer.Span;
        BinaryPrimitives.WriteUInt16BigEndian(bytes[PortAt..], Port);
        if (socket.Family == AddressFamily.InterNetworkV6) BinaryPrimitives.WriteUInt128BigEndian(bytes[V6At..], Address);
        else BinaryPrimitives.WriteUInt32BigEndian(bytes[V4At..], (uint)Address);
    }

    /// <inheritdoc/>
    public override string ToString()
    {
        Span<byte> bytes = stackalloc byte[16];
        BinaryPrimitives.WriteUInt128BigEndian(bytes, Address);
        return new IPEndPoint(new IPAddress(IsV4 ? bytes[12..] : bytes), Port).ToString();
    }
}
