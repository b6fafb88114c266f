using System.Net;
using Surefoot.Protocol.Tests.Peer;

namespace Surefoot.Client.Tests.Peer;

/// <summary>A real server of the field.</summary>
public sealed class AceGameServer : IGameServer, IAsyncLifetime
{
    private readonly AceServer server = new();

    public IPEndPoint Address => server.Address;

    public string Dats => server.Dats;

    public string Administrator => "admin";

    public bool JumpsCostStamina => true;

    public string[] FailedTransitions(int since) => server.LogLines("failed transition")[since..];

    public ValueTask InitializeAsync() => server.InitializeAsync();

    public ValueTask DisposeAsync() => server.DisposeAsync();
}
