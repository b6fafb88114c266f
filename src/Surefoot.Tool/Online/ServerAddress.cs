using System.Globalization;
using System.Net;
using System.Net.Sockets;

namespace Surefoot.Tool.Online;

/// <summary>A server by name or number.</summary>
internal static class ServerAddress
{
    private const int UsualPort = 9000;

    /// <summary>Reads HOST:PORT, or HOST for the usual port, and looks the name up.</summary>
    /// <exception cref="UsageException">That is no address, or the name is not known.</exception>
    internal static IPEndPoint Find(string text)
    {
        int colon = text.LastIndexOf(':');
        bool isNumber = text.Count(c => c == ':') > 1 && !text.Contains(']', StringComparison.Ordinal);
        string host = colon < 0 || isNumber ? text : text[..colon];
        int port = UsualPort;
        if (host.Length != text.Length && (!int.TryParse(text[(colon + 1)..], NumberStyles.None, CultureInfo.InvariantCulture, out port) ||
            port is < 1 or >= IPEndPoint.MaxPort))
            throw new UsageException($"--server {text}: the port is a number from 1 to 65534, for example --server 127.0.0.1:9000.");
        if (host.Length == 0) throw new UsageException($"--server {text}: there is no host, for example --server 127.0.0.1:9000.");
        if (IPAddress.TryParse(host.Trim('[', ']'), out IPAddress? address)) return new IPEndPoint(address, port);
        try
        {
            IPAddress[] found = Dns.GetHostAddresses(host);
            address = found.FirstOrDefault(one => one.AddressFamily == AddressFamily.InterNetwork) ?? found.FirstOrDefault();
        }
        catch (Exception e) when (e is SocketException or ArgumentException)
        {
            address = null;
        }

        return address is null
            ? throw new UsageException($"--server {text}: no host '{host}' is known here.")
            : new IPEndPoint(address, port);
    }
}
