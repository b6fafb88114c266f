namespace Surefoot.Protocol.Session;

/// <summary>The two ports of a server; the second is the next higher number.</summary>
public enum ServerPort
{
    /// <summary>The one that a server is known by: it takes everything but connect responses and signs of life.</summary>
    First,

    /// <summary>The one after it: connect responses and signs of life go there, and a connected client is answered from there.</summary>
    Second,
}

/// <summary>Sends datagrams.</summary>
public interface IDatagramSink
{
    /// <summary>Sends a datagram; it may be lost.</summary>
    /// <param name="datagram">Its bytes, which belong to the caller again afterwards.</param>
    /// <param name="port">From a client: the port to send to. From a server: the port to send from.</param>
    void Send(ReadOnlySpan<byte> datagram, ServerPort port);
}
