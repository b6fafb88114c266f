namespace Surefoot.Client.Tests.Peer;

/// <summary>The client on our own server.</summary>
public sealed class OwnServerSuite(OwnGameServer server) : ServerSuite(server), IClassFixture<OwnGameServer>;
