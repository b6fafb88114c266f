using System.Net;

namespace Surefoot.Client.Tests.Peer;

/// <summary>A server of the field or our own, for <see cref="ServerSuite"/>.</summary>
public interface IGameServer
{
    /// <summary>Its first port; skips the test that asks when there is no server.</summary>
    IPEndPoint Address { get; }

    /// <summary>Folder of the dat files that it serves.</summary>
    string Dats { get; }

    /// <summary>An account whose player may give commands by chat, such as <c>@teleloc</c>.</summary>
    string Administrator { get; }

    /// <summary>It takes stamina for jumps.</summary>
    bool JumpsCostStamina { get; }

    /// <summary>Places that its own sweep could not reach, as its log tells; null for a server that does not tell.</summary>
    /// <param name="since">How many it had told before.</param>
    string[]? FailedTransitions(int since);
}
