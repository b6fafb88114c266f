using System.Globalization;
using System.Net;
using System.Net.WebSockets;
using Microsoft.AspNetCore.Builder;
using Microsoft.AspNetCore.Connections;
using Microsoft.AspNetCore.Hosting;
using Microsoft.AspNetCore.Hosting.Server;
using Microsoft.AspNetCore.Hosting.Server.Features;
using Microsoft.AspNetCore.Http;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Workbench.Hosting;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench;

/// <summary>
/// A running workbench: the page, the world behind it, and the loop that moves the players. Listens on the loopback address only.
/// </summary>
public sealed class WorkbenchServer : IAsyncDisposable
{
    private const int PortsToTry = 100;
    private const int MaxTerrainRadius = 8;
    private const int LastBlock = 254;

    private readonly WebApplication app;
    private readonly IWorkbenchWorld world;
    private readonly ServerCounters counters;
    private readonly CancellationTokenSource stopping = new();
    private readonly Task running;
    private int disposed;

    private WorkbenchServer(WebApplication app, IWorkbenchWorld world, ServerCounters counters, WorldLoop loop, Uri address)
    {
        this.app = app;
        this.world = world;
        this.counters = counters;
        Loop = loop;
        Address = address;
        running = loop.RunAsync(stopping.Token);
    }

    /// <summary>Where the page is, e.g. <c>http://127.0.0.1:5150/</c>.</summary>
    public Uri Address { get; }

    /// <summary>Completes when the world has stopped: after disposal, or with the error that ended it.</summary>
    public Task Completion => running;

    internal WorldLoop Loop { get; }

    internal ServerCounters Counters => counters;

    internal IReadOnlyList<WorkbenchPlace> Places => world.Places;

    /// <summary>Opens the world and serves it. When the port is taken the next free one is used: see <see cref="Address"/>.</summary>
    /// <param name="options">What and where.</param>
    /// <param name="cancellation">Gives up starting.</param>
    /// <returns>The running server; dispose it to stop.</returns>
    /// <exception cref="DatFolderException">The dat folder or a file in it is missing; the message says which.</exception>
    /// <exception cref="DatFormatException">
    /// A file is no dat file, or the region, the human setup or its motion table is malformed.
    /// </exception>
    /// <exception cref="DatRecordMissingException">The region, the human setup or its motion table is missing.</exception>
    /// <exception cref="ArgumentException">An option is out of range, or the list of places is empty.</exception>
    /// <exception cref="IOException">The demo world cannot be written, or a hundred ports from the one asked for are taken.</exception>
    public static async Task<WorkbenchServer> StartAsync(WorkbenchOptions options, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(options);
        if (options.Places is { Count: 0 }) throw new ArgumentException("There is no place to enter the world at.", nameof(options));
        ILogger logger = (options.LoggerFactory ?? NullLoggerFactory.Instance).CreateLogger<SimulatedWorld>();
        bool demo = options.DatFolder is null;
        DatSet dats = DatSet.Open(options.DatFolder ?? DemoWorldCache.GetOrCreate(notice: options.Notice));
        IReadOnlyList<WorkbenchPlace> places = options.Places ?? (demo ? KnownPlaces.Demo() : KnownPlaces.Retail());
        IWorkbenchWorld? world = null;
        try
        {
            if (options.Online is { } online)
            {
                world = new NetworkWorld(dats, places, online) { Notice = options.Notice };
                int pages = online.NumbersPages ? options.MaxPlayers : 1;
                return await StartAsync(world, options with { MaxPlayers = pages }, cancellation: cancellation).ConfigureAwait(false);
            }

            string name = demo ? "Demo world" : Path.GetFileName(Path.TrimEndingDirectorySeparator(dats.Folder));
            world = new SimulatedWorld(name, dats, places, logger, demo ? DemoSpawns.All : [])
            {
                Notice = options.Notice,
                DatFolder = demo ? null : Path.GetFullPath(dats.Folder),
            };
            return await StartAsync(world, options, cancellation: cancellation).ConfigureAwait(false);
        }
        catch
        {
            if (world is null) dats.Dispose();
            else world.Dispose();
            throw;
        }
    }

    internal static async Task<WorkbenchServer> StartAsync(
        IWorkbenchWorld world, WorkbenchOptions options, TimeProvider? clock = null, CancellationToken cancellation = default)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(options.Port);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(options.Port, ushort.MaxValue);
        ArgumentOutOfRangeException.ThrowIfLessThan(options.MaxPlayers, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(options.MaxPlayers, 256);
        ILoggerFactory loggers = options.LoggerFactory ?? NullLoggerFactory.Instance;
        ServerCounters counters = new();
        WorldLoop loop = new(world, counters, clock ?? TimeProvider.System, loggers.CreateLogger<WorldLoop>(), options.MaxPlayers);
        int last = options.Port == 0 ? 0 : Math.Min(options.Port + PortsToTry - 1, ushort.MaxValue);
        for (int port = options.Port; ; port++)
        {
            WebApplication app = Build(world, counters, loop, port, loggers);
            try
            {
                await app.StartAsync(cancellation).ConfigureAwait(false);
                Uri address = new(app.Services.GetRequiredService<IServer>().Features.Get<IServerAddressesFeature>()!.Addresses.First());
                return new WorkbenchServer(app, world, counters, loop, address);
            }
            catch (IOException taken) when (taken.InnerException is AddressInUseException && port < last)
            {
                await app.DisposeAsync().ConfigureAwait(false);
            }
            catch
            {
                await app.DisposeAsync().ConfigureAwait(false);
                counters.Dispose();
                throw;
            }
        }
    }

    /// <summary>Stops serving, ends every page's connection and closes the world.</summary>
    public async ValueTask DisposeAsync()
    {
        if (Interlocked.Exchange(ref disposed, 1) != 0) return;
        await stopping.CancelAsync().ConfigureAwait(false);
        await running.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing);
        using (CancellationTokenSource patience = new(TimeSpan.FromSeconds(2))) await app.StopAsync(patience.Token).ConfigureAwait(false);
        await app.DisposeAsync().ConfigureAwait(false);
        world.Dispose();
        counters.Dispose();
        stopping.Dispose();
    }

    private static WebApplication Build(IWorkbenchWorld world, ServerCounters counters, WorldLoop loop, int port, ILoggerFactory loggers)
    {
        WebApplicationBuilder builder = WebApplication.CreateEmptyBuilder(new WebApplicationOptions());
        builder.WebHost.UseKestrelCore().ConfigureKestrel(kestrel =>
        {
            kestrel.AddServerHeader = false;
            kestrel.Limits.MaxRequestBodySize = 0;
            kestrel.Listen(IPAddress.Loopback, port);
        });
        builder.Services.AddSingleton(loggers);
        builder.Services.AddRoutingCore();
        builder.Services.AddSingleton<IHostLifetime, CallersLifetime>();
        WebApplication app = builder.Build();
        app.Use(OnlyThisMachine);
        app.UseWebSockets(
            new WebSocketOptions { KeepAliveInterval = TimeSpan.FromSeconds(10), KeepAliveTimeout = TimeSpan.FromSeconds(20) });
        app.UseRouting();
        PageFiles page = new();
        app.MapGet("/places.json", () => Results.Json(Listing(world)));
        app.MapGet("/left-out.json", () => Results.Json(LeftOut(world)));
        app.MapGet("/stats.json", () => Results.Json(Statistics(counters)));
        app.MapGet("/terrain/{block}/{radius:int}", (string block, int radius) => Terrain(world, block, radius));
        app.MapGet("/shapes/{block}", (string block) => Shapes(world, block));
        app.MapGet("/ws", context => Play(context, world, counters, loop));
        app.MapGet("/{**path}", (HttpContext context, string? path) => page.Serve(context, path));
        return app;
    }

    /// <summary>
    /// A page of another site must not reach this server through the person's browser: the host asked for is this machine, and a socket
    /// comes from our page.
    /// </summary>
    private static Task OnlyThisMachine(HttpContext context, RequestDelegate next)
    {
        string host = context.Request.Host.Host;
        string? origin = context.Request.Headers.Origin;
        bool here = host is "127.0.0.1" or "localhost" or "[::1]" or "::1";
        bool ours = origin is null ||
            (Uri.TryCreate(origin, UriKind.Absolute, out Uri? from) && from.Authority == context.Request.Host.Value);
        if (!here || !ours)
        {
            context.Response.StatusCode = StatusCodes.Status403Forbidden;
            return Task.CompletedTask;
        }

        context.Response.Headers.XContentTypeOptions = "nosniff";
        context.Response.Headers.ContentSecurityPolicy =
            "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; connect-src 'self' ws:; " +
            "frame-ancestors 'none'";
        return next(context);
    }

    private static object Listing(IWorkbenchWorld world) => new
    {
        world = world.Name,
        places = world.Places.Select(place => new
        {
            name = place.Name,
            cell = place.CellId,
            x = place.Position.X,
            y = place.Position.Y,
            z = place.Position.Z,
            yaw = place.Yaw,
            hint = place.Hint,
            lookFrom = place.LookFrom,
        }),
    };

    private static object LeftOut(IWorkbenchWorld world) => new { total = world.LeftOut.Total, lines = world.LeftOut.Lines };

    private static object Statistics(ServerCounters counters) => new
    {
        players = counters.Players,
        ticks = counters.Ticks,
        received = counters.Received,
        malformed = counters.Malformed,
        overflowed = counters.Overflowed,
        sent = counters.Sent,
        unsent = counters.Unsent,
    };

    private static IResult Shapes(IWorkbenchWorld world, string block)
    {
        if (!TryParseBlock(block, out ushort id)) return Results.NotFound();
        return world.ReadShapes(id) is { } shapes
            ? Results.Bytes(ShapesFrame.Encode(shapes), "application/octet-stream")
            : Results.NoContent();
    }

    private static bool TryParseBlock(string text, out ushort block)
    {
        block = 0;
        return text.Length == 4 && ushort.TryParse(text, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out block);
    }

    /// <summary>The landblocks that exist within a square radius of one, each as <see cref="TerrainFrame"/> says.</summary>
    private static IResult Terrain(IWorkbenchWorld world, string block, int radius)
    {
        if (!TryParseBlock(block, out ushort id) || radius is < 0 or > MaxTerrainRadius) return Results.NotFound();
        using MemoryStream found = new();
        int x = id >> 8, y = id & 0xFF;
        for (int i = Math.Max(0, x - radius); i <= Math.Min(LastBlock, x + radius); i++)
        {
            for (int j = Math.Max(0, y - radius); j <= Math.Min(LastBlock, y + radius); j++)
            {
                ushort near = (ushort)((i << 8) | j);
                if (world.ReadTerrain(near) is { } terrain) found.Write(TerrainFrame.Encode(near, terrain));
            }
        }

        return Results.Bytes(found.ToArray(), "application/octet-stream");
    }

    private static async Task Play(HttpContext context, IWorkbenchWorld world, ServerCounters counters, WorldLoop loop)
    {
        if (!context.WebSockets.IsWebSocketRequest)
        {
            context.Response.StatusCode = StatusCodes.Status400BadRequest;
            return;
        }

        if (!loop.TryReserve())
        {
            context.Response.StatusCode = StatusCodes.Status503ServiceUnavailable;
            return;
        }

        try
        {
            using WebSocket socket = await context.WebSockets.AcceptWebSocketAsync().ConfigureAwait(false);
            PageConnection page = new(socket, counters, world.Places.Count);
            loop.Enter(page);
            try
            {
                await page.RunAsync(context.RequestAborted).ConfigureAwait(false);
            }
            finally
            {
                loop.Exit(page);
            }
        }
        finally
        {
            loop.Release();
        }
    }

    /// <summary>Ctrl+C and signals belong to the program that started the server, not to the server.</summary>
    private sealed class CallersLifetime : IHostLifetime
    {
        public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

        public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;
    }
}
