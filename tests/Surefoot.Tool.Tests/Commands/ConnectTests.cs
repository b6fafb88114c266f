using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text.Json;
using Surefoot.Server;
using Surefoot.Tool.Online;
using Surefoot.Tool.Serving;

namespace Surefoot.Tool.Tests.Commands;

/// <summary><c>surefoot connect</c> over sockets, against a server in this process.</summary>
public sealed class ConnectTests : IDisposable
{
    private const string Password = "p4ss-w0rd-of-a-test";

    private readonly string folder = Directory.CreateTempSubdirectory("surefoot-connect").FullName;
    private readonly CancellationTokenSource ends = new();
    private readonly ServedWorld world = ServedWorld.Open(null);
    private readonly WorldServer server;
    private readonly Thread thread;

    public ConnectTests()
    {
        server = new WorldServer(world.Cache, new WorldServerOptions { Port = 0, Start = world.Start, Spawns = world.Spawns });
        thread = new Thread(() => server.Run(ends.Token));
        thread.Start();
    }

    private string Address => server.EndPoint.ToString();

    public void Dispose()
    {
        ends.Cancel();
        thread.Join();
        server.Dispose();
        world.Dispose();
        ends.Dispose();
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    [Behaviour("tool.connect.walks", "08, 3 to 6; design.md, The tool")]
    [Behaviour("tool.connect.same-bits-offline", "design.md, decision 5: the same inputs give the same bits")]
    public async Task A_character_is_made_walks_a_script_and_the_same_times_without_a_server_give_the_same_bits()
    {
        string times = Path.Combine(folder, "times.txt");
        CommandLine.Outcome run = await ConnectAsync(
            Password, "--character", "Alma", "--create", "--script", "W 1.5; A 0.4; W+Space 0.5; W 1; Q 0.5; S 0.4",
            "--times", times, "--json");
        Assert.True(run.ExitCode == 0, run.Error);
        JsonElement told = JsonDocument.Parse(run.Output).RootElement;
        Assert.Equal("Alma", told.GetProperty("character").GetString());
        Assert.InRange(told.GetProperty("disagreement").GetDouble(), 0, 0.05);
        Assert.Equal(0, told.GetProperty("unreadable").GetInt32());
        float[] start = PlaceOf(told.GetProperty("start")), end = PlaceOf(told.GetProperty("end"));
        Assert.True(Math.Abs(end[1] - start[1]) > 5, "it did not run");

        CommandLine.Outcome offline = await CommandLine.RunAsync("walk", "--times", times);
        Assert.True(offline.ExitCode == 0, offline.Error);
        Assert.Contains("every position the same bits", offline.Error, StringComparison.Ordinal);
        AssertUntold(run, offline);

        // A place that was not there: the comparison does compare.
        string[] lines = await File.ReadAllLinesAsync(times, TestContext.Current.CancellationToken);
        string[] words = lines[^1].Split(' ');
        words[3] = (float.Parse(words[3], CultureInfo.InvariantCulture) + 0.001f).ToString("R", CultureInfo.InvariantCulture);
        lines[^1] = string.Join(' ', words);
        await File.WriteAllLinesAsync(times, lines, TestContext.Current.CancellationToken);
        CommandLine.Outcome other = await CommandLine.RunAsync("walk", "--times", times);
        Assert.Equal(1, other.ExitCode);
        Assert.Contains($"from frame {lines.Length - 2} of", other.Error, StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("tool.connect.exit-codes", "design.md, The tool; 08, 3.2 to 3.6")]
    public async Task What_went_wrong_is_one_sentence_and_an_exit_code_of_its_own()
    {
        CommandLine.Outcome made = await ConnectAsync(Password, "--character", "Berta", "--create");
        Assert.True(made.ExitCode == 0, made.Error);
        Assert.Contains("Berta is at 0x", made.Output, StringComparison.Ordinal);
        await Task.Delay(2500, TestContext.Current.CancellationToken);

        await RefusedAsync(ExitCode.AccountRefused, "another", "--character", "Berta");
        await RefusedAsync(ExitCode.CharacterRefused, Password, "--character", "Nobody");
        await RefusedAsync(ExitCode.Usage, Password, "--character", "Berta", "--script", "Z 1");
        await RefusedAsync(ExitCode.Usage, Password, "--character", "Berta", "--times", "x");
        await RefusedAsync(ExitCode.Usage, null, "--character", "Berta");

        using Socket silent = new(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
        silent.Bind(new IPEndPoint(IPAddress.Loopback, 0));
        CommandLine.Outcome unanswered = await RunAsync(
            Password, "connect", "--server", silent.LocalEndPoint!.ToString()!, "--account", "a", "--character", "b",
            "--timeout", "2", "--json");
        Assert.Equal(ExitCode.NoServer, unanswered.ExitCode);
        JsonElement error = JsonDocument.Parse(unanswered.Output).RootElement;
        Assert.Equal(ExitCode.NoServer, error.GetProperty("exitCode").GetInt32());
        Assert.Equal("The server did not let us in within 2 s.", error.GetProperty("error").GetString());
    }

    [Theory]
    [Behaviour("tool.connect.server-address", "design.md, The tool")]
    [InlineData("127.0.0.1:9000", "127.0.0.1:9000")]
    [InlineData("127.0.0.1", "127.0.0.1:9000")]
    [InlineData("127.0.0.1:1", "127.0.0.1:1")]
    [InlineData("[::1]:9010", "[::1]:9010")]
    [InlineData("::1", "[::1]:9000")]
    [InlineData("127.0.0.1:0", null)]
    [InlineData("127.0.0.1:65535", null)]
    [InlineData("127.0.0.1:x", null)]
    [InlineData(":9000", null)]
    public void A_server_is_an_address_and_a_port_below_the_last_one(string text, string? found)
    {
        if (found is not null)
        {
            Assert.Equal(found, ServerAddress.Find(text).ToString());
            return;
        }

        string refusal = Assert.Throws<UsageException>(() => ServerAddress.Find(text)).Message;
        Assert.StartsWith("--server", refusal, StringComparison.Ordinal);
    }

    private async Task RefusedAsync(int code, string? password, params string[] arguments)
    {
        CommandLine.Outcome run = await ConnectAsync(password, arguments);
        Assert.True(run.ExitCode == code, $"{run.ExitCode} instead of {code}: {run.Error}");
        AssertUntold(run);
        await Task.Delay(2500, TestContext.Current.CancellationToken);
    }

    private Task<CommandLine.Outcome> ConnectAsync(string? password, params string[] arguments) =>
        RunAsync(password, ["connect", "--server", Address, "--account", "tester", .. arguments]);

    /// <summary>The password is in a file, which is how it stays out of lists of processes.</summary>
    private async Task<CommandLine.Outcome> RunAsync(string? password, params string[] arguments)
    {
        ProcessStartInfo start = new("dotnet", ["exec", Path.Combine(AppContext.BaseDirectory, "Surefoot.Tool.dll"), .. arguments]);
        start.Environment.Remove(PasswordSource.Variable);
        if (password is not null)
        {
            string file = Path.Combine(folder, "password");
            await File.WriteAllTextAsync(file, password + "\n");
            start.ArgumentList.Add("--password-file");
            start.ArgumentList.Add(file);
        }

        return await CommandLine.RunAsync(start, "");
    }

    private static void AssertUntold(params CommandLine.Outcome[] runs) =>
        Assert.All(runs, run => Assert.DoesNotContain(Password, run.Output + run.Error, StringComparison.Ordinal));

    private static float[] PlaceOf(JsonElement form) => [.. form.GetProperty("position").EnumerateArray().Select(n => n.GetSingle())];
}
