using System.Diagnostics;
using System.Net;
using System.Net.Sockets;

namespace Surefoot.Protocol.Tests.Peer;

/// <summary>A real ACE server, where the environment variable SUREFOOT_ACE names the folder of an unpacked one with its start.sh and
/// stop.sh.</summary>
public sealed class AceServer : IAsyncLifetime
{
    private const string Variable = "SUREFOOT_ACE";

    private readonly string? folder;
    private int port;
    private FileStream? inUse;

    /// <summary>The server in the folder that the environment names.</summary>
    public AceServer()
        : this(Unpacked)
    {
    }

    /// <summary>A server in a folder.</summary>
    /// <param name="folder">A copy of that folder; null where there is none.</param>
    internal AceServer(string? folder) => this.folder = folder;

    /// <summary>The folder of the unpacked server; null where there is none.</summary>
    public static string? Unpacked => Environment.GetEnvironmentVariable(Variable) is { Length: > 0 } named ? named : null;

    /// <summary>The dat files of its world; skips the test that asks when there is no server.</summary>
    public string Dats => Path.Combine(Present, "dats");

    /// <summary>Where it listens; skips the test that asks when there is no server.</summary>
    public IPEndPoint Address
    {
        get
        {
            _ = Present;
            return new IPEndPoint(IPAddress.Loopback, port);
        }
    }

    private string Present
    {
        get
        {
            Assert.SkipWhen(folder is null, "No ACE server: SUREFOOT_ACE does not name the folder of an unpacked one.");
            return folder;
        }
    }

    public async ValueTask InitializeAsync()
    {
        if (folder is null)
            return;
        while ((inUse = TryTake()) is null)
            await Task.Delay(500);
        port = FreePort();
        await RunAsync("start.sh", ("ACE_PORT", $"{port}"), ("ACE_DB_PORT", $"{FreePort()}"), ("ACE_LOG", "DEBUG"));
    }

    /// <summary>Lines of its log that have come since a line number, and hold a text.</summary>
    public string[] LogLines(string text, int since = 0)
    {
        using var log = new StreamReader(
            new FileStream(Path.Combine(folder!, "run", "server.log"), FileMode.Open, FileAccess.Read, FileShare.ReadWrite));
        return [.. log.ReadToEnd().Split('\n').Skip(since).Where(line => line.Contains(text, StringComparison.OrdinalIgnoreCase))];
    }

    public async ValueTask DisposeAsync()
    {
        if (folder is null)
            return;
        await RunAsync("stop.sh");
        if (inUse is not null)
            await inUse.DisposeAsync();
    }

    /// <summary>The folder serves one server: another assembly's tests may have theirs running.</summary>
    private FileStream? TryTake()
    {
        try
        {
            return new FileStream(Path.Combine(folder!, "tests.lock"), FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None);
        }
        catch (IOException)
        {
            return null;
        }
    }

    private async Task RunAsync(string script, params (string Name, string Value)[] settings)
    {
        // What the script starts keeps its output open: none is read.
        var start = new ProcessStartInfo("bash", [Path.Combine(folder!, script)]) { UseShellExecute = false };
        foreach ((string name, string value) in settings)
            start.Environment[name] = value;
        using Process process = Process.Start(start)!;
        await process.WaitForExitAsync();
        Assert.True(process.ExitCode == 0, $"{script} ended with {process.ExitCode}; see run/server.log in its folder.");
    }

    /// <summary>A port that is free, and most likely the next one too.</summary>
    private static int FreePort()
    {
        using var probe = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        probe.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        return ((IPEndPoint)probe.LocalEndPoint!).Port & ~1;
    }
}
