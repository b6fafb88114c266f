using System.CommandLine;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Surefoot.Physics.Motion;
using Surefoot.Server;
using Surefoot.Tool.Serving;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot serve</c>: a server for clients of the field.</summary>
internal static class ServeCommand
{
    /// <summary>How the line begins that says where the server is.</summary>
    internal const string Opened = "Surefoot server";

    private const int MostLoad = 1000, MostSkill = 10_000, LoadAttribute = 10;

    internal static Command Create()
    {
        ServeOptions options = new();
        Command command = new("serve",
            "Serves a world to clients of the field, for tests, demos and load: characters, movement, doors, creatures; no fights, no " +
            "things. " +
            "On this machine alone, accounts are made at their first login; elsewhere --accounts is needed. Exit code 1 when a port is " +
            "taken, a file cannot be read, or a client of --load failed.\n\n" +
            "Example:\n" +
            "  surefoot serve --port 9000 --stats\n" +
            "  surefoot serve --address 0.0.0.0 --accounts accounts.json --metrics 9100\n" +
            "  surefoot serve --load 200 --minutes 10 --stats --json")
        {
            ServeAccountCommand.Create(),
        };
        options.AddTo(command);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(options, parsed, cancellation)));
        return command;
    }

    private static int Run(ServeOptions options, ParseResult parsed, CancellationToken cancellation)
    {
        int load = ServeOptions.Between(parsed, options.Load, 0, MostLoad, "--load 200");
        double minutes = parsed.GetValue(options.Minutes) ?? double.PositiveInfinity;
        if (!(minutes > 0)) throw new UsageException("--minutes is more than 0, for example --minutes 10.");
        bool stats = parsed.GetValue(options.Stats), json = parsed.GetValue(options.Json);
        if (json && !stats) throw new UsageException("--json is for the figures of --stats: give both.");
        if (!(parsed.GetValue(options.Every) >= 0)) throw new UsageException("--every is 0 or more seconds, for example --every 10.");
        if (parsed.GetValue(options.Metrics) is < 1 or > IPEndPoint.MaxPort)
            throw new UsageException("--metrics is a port from 1 to 65535, for example --metrics 9100.");
        WorldServerOptions wanted = Read(options, parsed, load, stats);
        using ServedWorld world = ServedWorld.Open(parsed.GetValue(options.Dats), parsed.GetValue(options.Start));
        using WorldServer server = Open(world, wanted with { Start = world.Start, Spawns = world.Spawns });
        using MetricsPage? page = parsed.GetValue(options.Metrics) is { } port ? new MetricsPage(port) : null;
        (json ? Console.Error : Console.Out).WriteLine(
            $"{Opened}: {server.EndPoint} and {server.EndPoint.Port + 1}" +
            (page is null ? "" : $", metrics at {page.Address}") + "  (Ctrl+C ends it)");
        using CancellationTokenSource ends = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        if (double.IsFinite(minutes)) ends.CancelAfter(TimeSpan.FromMinutes(Math.Min(minutes, 100_000)));
        CharacterStats character = new(
            Math.Max(wanted.RunSkill ?? 0, LoadAttribute), Math.Max(wanted.JumpSkill ?? 0, LoadAttribute), LoadAttribute, LoadAttribute);
        using LoadRun? clients = load == 0 ? null : new LoadRun(world, server.EndPoint, load, character);
        ServerReport report = new(server, clients);
        using ServerWatch? watch = stats ? new ServerWatch(report, json, parsed.GetValue(options.Every)) : null;
        Serve(server, () =>
        {
            // While everybody is still there.
            watch?.Dispose();
            clients?.End();
            if (stats && json) Console.Out.WriteLine(report.ToJson());
        }, ends.Token);
        if (clients is not { Failed: > 0 }) return ExitCode.Done;
        CommonOptions.Say($"{clients.Failed} clients failed; the first: {clients.FirstFailure}");
        return ExitCode.Failed;
    }

    /// <summary>Serves until somebody cancels; what is to be done before sessions are ended is done then.</summary>
    private static void Serve(WorldServer server, Action atEnd, CancellationToken cancellation)
    {
        using CancellationTokenSource closes = new();
        Task serving = Task.Factory.StartNew(
            () => server.Run(closes.Token), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        while (!cancellation.IsCancellationRequested && !serving.IsCompleted)
            WaitHandle.WaitAny([cancellation.WaitHandle, ((IAsyncResult)serving).AsyncWaitHandle]);
        atEnd();
        closes.Cancel();
        serving.GetAwaiter().GetResult();
    }

    private static WorldServerOptions Read(ServeOptions options, ParseResult parsed, int load, bool stats)
    {
        string text = parsed.GetRequiredValue(options.Address);
        if (!IPAddress.TryParse(text, out IPAddress? address))
            throw new UsageException($"--address {text} is no address of this machine, for example --address 127.0.0.1.");
        string? accounts = parsed.GetValue(options.Accounts);
        if (accounts is null && !IPAddress.IsLoopback(address))
            throw new UsageException("--address of a network needs --accounts FILE; 'surefoot serve account --help' says how to make one.");
        if (accounts is not null && load > 0) throw new UsageException("--load makes its own accounts: leave --accounts away.");
        bool administrators = parsed.GetValue(options.Administrators);
        return new WorldServerOptions
        {
            Address = address,
            Port = ServeOptions.Between(parsed, options.Port, 0, IPEndPoint.MaxPort - 1, "--port 9000"),
            WorldName = parsed.GetRequiredValue(options.Name),
            Slots = Math.Max(ServeOptions.Between(parsed, options.Slots, 1, ushort.MaxValue, "--slots 256"), load == 0 ? 0 : load + 8),
            MostPerAddress = ServeOptions.Between(parsed, options.PerAddress, 0, ushort.MaxValue, "--per-address 8"),
            LoginsPerSecond = ServeOptions.Between(parsed, options.LoginRate, 1, 10_000, "--login-rate 20"),
            RunSkill = ServeOptions.Between(parsed, options.RunSkill, 0, MostSkill, "--run 200"),
            JumpSkill = ServeOptions.Between(parsed, options.JumpSkill, 0, MostSkill, "--jump 200"),
            Authority = parsed.GetValue(options.Believe) ? null : new AuthorityOptions(),
            Detail = parsed.GetValue(options.Full) ? BroadcastDetail.Full : BroadcastDetail.Live,
            Commands = administrators || !IPAddress.IsLoopback(address) ? CommandRights.Administrators : CommandRights.Everybody,
            Accounts = accounts is null ? null : AccountFile.Read(accounts),
            CharacterFile = parsed.GetValue(options.Characters),
            Log = stats || parsed.GetValue(options.Quiet) ? null : CommonOptions.Say,
            Start = default,
        };
    }

    private static WorldServer Open(ServedWorld world, WorldServerOptions options)
    {
        try
        {
            return new WorldServer(world.Cache, options);
        }
        catch (SocketException error)
        {
            throw new IOException(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"The server cannot open the ports {options.Port} and {options.Port + 1} of {options.Address}: {error.Message}. " +
                    $"Is one running already? --port chooses others."),
                error);
        }
    }
}
