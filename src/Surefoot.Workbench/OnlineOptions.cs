using System.Net;
using Surefoot.Protocol.Session;

namespace Surefoot.Workbench;

/// <summary>A server to play on, and who logs in there.</summary>
public sealed record OnlineOptions
{
    /// <summary>The server's first port; the next one is used too.</summary>
    public required IPEndPoint Server { get; init; }

    /// <summary>Account and password. A second page at the same time is a second login, which servers answer by ending both.</summary>
    public required ClientSessionOptions Login { get; init; }

    /// <summary>Name of the character.</summary>
    public required string Character { get; init; }

    /// <summary>Makes the character when the account has none of that name.</summary>
    public bool Create { get; init; }

    /// <summary>
    /// Each page after the first logs in with its number behind account and character: for servers that let anybody in.
    /// </summary>
    public bool NumbersPages { get; init; }
}
