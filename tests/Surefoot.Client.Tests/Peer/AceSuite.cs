namespace Surefoot.Client.Tests.Peer;

/// <summary>The client on a real server of the field.</summary>
public sealed class AceSuite(AceGameServer server) : ServerSuite(server), IClassFixture<AceGameServer>;
