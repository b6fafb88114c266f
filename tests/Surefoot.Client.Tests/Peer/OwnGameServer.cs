using System.Net;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Client.Tests.Peer;

/// <summary>Our own server, over the demo world.</summary>
public sealed class OwnGameServer : IGameServer, IDisposable
{
    private readonly CancellationTokenSource ends = new();
    private readonly DatSet dats;
    private readonly WorldServer server;
    private readonly Thread thread;

    public OwnGameServer()
    {
        Dats = DemoWorldCache.GetOrCreate();
        dats = DatSet.Open(Dats);
        NamedPlace start = DemoPlaces.All[0];
        server = new WorldServer(new PhysicsDataCache(dats), new WorldServerOptions
        {
            Port = 0,
            Start = new Position(start.CellId, new Frame(start.Origin, start.Orientation)),
            Spawns = [.. DemoSpawns.All.Where(spawn => spawn.Kind == DemoSpawnKind.Door).Select(spawn => new WorldSpawn(
                spawn.Name, WorldSpawnKind.Door, spawn.SetupId,
                new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)), spawn.WanderRadius))],
        });
        thread = new Thread(() => server.Run(ends.Token));
        thread.Start();
    }

    public IPEndPoint Address => server.EndPoint;

    public string Dats { get; }

    public string Administrator => "admin";

    public bool JumpsCostStamina => false;

    public string[]? FailedTransitions(int since) => null;

    public void Dispose()
    {
        ends.Cancel();
        thread.Join();
        server.Dispose();
        dats.Dispose();
        ends.Dispose();
    }
}
