using System.Diagnostics;
using System.Net;
using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>Pages as clients of a server over real sockets, on the demo world.</summary>
public sealed class NetworkWorldTests : IDisposable
{
    private static readonly NamedPlace Meadow = DemoPlaces.All.Single(place => place.Name == "meadow");

    private readonly DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
    private readonly WorldServer server;
    private readonly CancellationTokenSource stopping = new();
    private readonly Thread thread;
    private readonly Stopwatch watch = Stopwatch.StartNew();

    public NetworkWorldTests()
    {
        Position start = new(Meadow.CellId, Meadow.Origin);
        server = new WorldServer(new PhysicsDataCache(dats), new WorldServerOptions { Port = 0, Start = start, RunSkill = 300 });
        thread = new Thread(() => server.Run(stopping.Token));
        thread.Start();
    }

    private double Now => watch.Elapsed.TotalSeconds;

    public void Dispose()
    {
        stopping.Cancel();
        thread.Join();
        server.Dispose();
        stopping.Dispose();
        dats.Dispose();
    }

    [Fact]
    [Behaviour("workbench.online.walks-on-a-server", "spec/08, 3 and 5")]
    public void Two_pages_walk_in_a_servers_world_and_see_each_other()
    {
        using NetworkWorld world = Open(server.EndPoint, create: true);
        IWorkbenchPlayer first = world.Join(1, PlayerSettings.Default, world.Places[0], Now);
        List<string> said = [];
        Assert.True(Until(world, () => IsThere(first, said)), string.Join('\n', said));
        Assert.Contains(said, line => line.Contains("Guest enters Surefoot", StringComparison.Ordinal));
        Assert.Equal(Meadow.CellId & 0xFFFF0000, first.Pose.CellId & 0xFFFF0000);

        IWorkbenchPlayer second = world.Join(2, PlayerSettings.Default, world.Places[0], Now);
        Assert.True(Until(world, () => IsThere(second, said)), string.Join('\n', said));
        List<(uint Id, PlayerPose Pose)> others = [];
        Assert.True(Until(world, () =>
        {
            world.LookAtPlayers(second, others);
            return others.Count == 1;
        }));

        Vector3 from = first.Pose.Position;
        first.SetKeys(PlayerKeys.Forward, Now);
        Assert.True(Until(world, () => Vector3.Distance(from, first.Pose.Position) > 5));
        first.SetKeys(PlayerKeys.None, Now);
        Pass(world, 2.5);

        // The one who walked, the server and the one who looked on agree.
        world.LookAtPlayers(second, others);
        Assert.Equal(first.Pose.Position, others[0].Pose.Position, Near);
        Assert.Equal(first.Pose.Position, server.FindPlayer("Guest")!.Value.Frame.Origin, Near);
        Assert.Equal(0, server.Figures.AllRefusedClaims);
    }

    [Fact]
    [Behaviour("workbench.online.goes-to-a-place", "spec/08, 3.5")]
    public void A_page_goes_to_a_place_where_the_server_lets_it()
    {
        using NetworkWorld world = Open(server.EndPoint, create: true);
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, world.Places[0], Now);
        Assert.True(Until(world, () => IsThere(player, [])));
        byte before = player.Pose.Teleports;
        WorkbenchPlace runway = world.Places.Single(place => place.Name == "The runway");
        player.Goto(runway, Now);
        Assert.True(Until(world, () => player.Pose.Teleports != before));
        Assert.Equal(runway.CellId, player.Pose.CellId);
        Assert.Equal(runway.Position, player.Pose.Position, Near);
    }

    [Fact]
    [Behaviour("workbench.online.says-what-is-wrong", "spec/08, 3.1")]
    public void Where_nobody_answers_or_there_is_no_character_the_page_is_told_so_in_a_sentence()
    {
        using NetworkWorld none = Open(server.EndPoint, create: false);
        IWorkbenchPlayer stranger = none.Join(1, PlayerSettings.Default, none.Places[0], Now);
        List<string> said = [];
        Assert.True(Until(none, () => Says(stranger, said, "has no character 'Guest'")), string.Join('\n', said));
        Assert.True(stranger.Pose.Flags.HasFlag(PoseFlags.Nowhere));

        using NetworkWorld deaf = Open(new IPEndPoint(IPAddress.Loopback, 9), create: true);
        IWorkbenchPlayer lonely = deaf.Join(1, PlayerSettings.Default, deaf.Places[0], Now);
        said.Clear();
        Assert.True(Until(deaf, () => Says(lonely, said, "did not let us in")), string.Join('\n', said));
    }

    private static bool Near(Vector3 a, Vector3 b) => Vector3.Distance(a, b) < 0.05f;

    private static NetworkWorld Open(IPEndPoint server, bool create) => new(
        DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), new OnlineOptions
        {
            Server = server,
            Login = new ClientSessionOptions { Account = "guest", Password = "guest", LoginTimeout = 3 },
            Character = "Guest",
            Create = create,
            NumbersPages = true,
        });

    private static bool IsThere(IWorkbenchPlayer player, List<string> said)
    {
        while (player.TryTakeSentence(out string sentence)) said.Add(sentence);
        return !player.Pose.Flags.HasFlag(PoseFlags.Nowhere) && player.Pose.Flags.HasFlag(PoseFlags.OnWalkable);
    }

    private static bool Says(IWorkbenchPlayer player, List<string> said, string words)
    {
        while (player.TryTakeSentence(out string sentence)) said.Add(sentence);
        return said.Exists(line => line.Contains(words, StringComparison.Ordinal));
    }

    private bool Until(NetworkWorld world, Func<bool> isSo, double patience = 60)
    {
        for (double end = Now + patience; Now < end;)
        {
            world.Advance(Now);
            if (isSo()) return true;
            Thread.Sleep(5);
        }

        return false;
    }

    private void Pass(NetworkWorld world, double seconds)
    {
        double end = Now + seconds;
        Until(world, () => Now >= end);
    }
}
