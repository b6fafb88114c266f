using System.Net;
using System.Net.Sockets;
using System.Text.Json;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>The command <c>surefoot serve</c>.</summary>
public sealed class ServeTests : IDisposable
{
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-serve");

    public void Dispose() => folder.Delete(recursive: true);

    [Fact, Behaviour("tool.serve.load", "design, the tool")]
    public async Task Clients_of_its_own_play_without_a_refusal_and_the_figures_are_one_object_of_json()
    {
        CommandLine.Outcome run = await CommandLine.RunAsync(
            "serve", "--port", "0", "--load", "8", "--minutes", "0.15", "--stats", "--json", "--every", "0");
        Assert.Equal((0, ""), (run.ExitCode, run.Error.Contains("failed", StringComparison.Ordinal) ? run.Error : ""));
        using JsonDocument document = JsonDocument.Parse(run.Output);
        JsonElement figures = document.RootElement;
        Assert.Equal(8, figures.GetProperty("entered").GetInt32());
        Assert.Equal(0, figures.GetProperty("faults").GetInt32());
        Assert.True(figures.GetProperty("claims").GetInt32() > 8);
        Assert.True(figures.GetProperty("step").GetProperty("p99Ms").GetDouble() > 0);
        Assert.Equal(0, figures.GetProperty("load").GetProperty("failed").GetInt32());
    }

    [Fact, Behaviour("tool.serve.accounts", "design, the tool")]
    public async Task Accounts_are_written_with_hashes_and_a_network_needs_them()
    {
        string accounts = Path.Combine(folder.FullName, "accounts.json"), secret = Path.Combine(folder.FullName, "password");
        await File.WriteAllTextAsync(secret, "correct horse\n");
        CommandLine.Outcome made = await CommandLine.RunAsync(
            "serve", "account", "--accounts", accounts, "--account", "Anna", "--admin", "--password-file", secret);
        Assert.Equal(0, made.ExitCode);
        string written = await File.ReadAllTextAsync(accounts);
        Assert.Contains("\"name\": \"anna\"", written, StringComparison.Ordinal);
        Assert.DoesNotContain("horse", written, StringComparison.Ordinal);

        CommandLine.Outcome refused = await CommandLine.RunAsync("serve", "--address", "0.0.0.0");
        Assert.Equal(2, refused.ExitCode);
        Assert.Contains("--accounts", refused.Error, StringComparison.Ordinal);
        CommandLine.Outcome missing = await CommandLine.RunAsync("serve", "--accounts", Path.Combine(folder.FullName, "none.json"));
        Assert.Equal(1, missing.ExitCode);
    }

    [Theory, Behaviour("tool.serve.usage", "design, the tool")]
    [InlineData("--port", "70000")]
    [InlineData("--slots", "0")]
    [InlineData("--minutes", "0")]
    [InlineData("--start", "nowhere")]
    [InlineData("--address", "here")]
    [InlineData("--load", "-1")]
    public async Task Wrong_words_are_wrong_usage(string option, string value)
    {
        CommandLine.Outcome run = await CommandLine.RunAsync("serve", option, value);
        Assert.Equal(2, run.ExitCode);
        Assert.Contains(option, run.Error, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.serve.metrics", "design, the tool")]
    public async Task The_page_of_metrics_is_text_that_prometheus_reads()
    {
        int port = FreePort();
        Task<CommandLine.Outcome> run = CommandLine.RunAsync(
            "serve", "--port", "0", "--metrics", $"{port}", "--minutes", "0.15", "--quiet");
        using HttpClient client = new();
        string page = "";
        while (!page.Contains("step_bucket", StringComparison.Ordinal) && !run.IsCompleted)
        {
            try
            {
                page = await client.GetStringAsync(new Uri($"http://127.0.0.1:{port}/metrics"));
            }
            catch (HttpRequestException)
            {
                await Task.Delay(50);
            }
        }

        Assert.Contains("step_bucket", page, StringComparison.Ordinal);
        Assert.Contains("claims_refused", page, StringComparison.Ordinal);
        Assert.Equal(0, (await run).ExitCode);
    }

    private static int FreePort()
    {
        using TcpListener listener = new(IPAddress.Loopback, 0);
        listener.Start();
        return ((IPEndPoint)listener.LocalEndpoint).Port;
    }
}
