using System.Globalization;
using Spectre.Console;

namespace Surefoot.Tool.Serving;

/// <summary>Shows a server's figures while it runs: a table that is drawn anew, or a line of JSON now and then.</summary>
internal sealed class ServerWatch : IDisposable
{
    private const double DrawEvery = 1, Forever = 1e6;

    private readonly ManualResetEventSlim ends = new();
    private readonly Thread thread;
    private bool isDisposed;

    /// <summary>Begins.</summary>
    /// <param name="report">The figures.</param>
    /// <param name="json">As JSON.</param>
    /// <param name="every">Seconds between lines of JSON; 0 for none but the last.</param>
    internal ServerWatch(ServerReport report, bool json, double every)
    {
        if (!(every >= 0))
            throw new UsageException(string.Create(
                CultureInfo.InvariantCulture, $"--every {every} is not 0 or more, for example --every 10."));
        thread = new Thread(() => Run(report, json, every)) { IsBackground = true, Name = "Surefoot figures" };
        thread.Start();
    }

    public void Dispose()
    {
        if (isDisposed) return;
        isDisposed = true;
        ends.Set();
        thread.Join();
        ends.Dispose();
    }

    private void Run(ServerReport report, bool json, double every)
    {
        if (json)
        {
            while (!ends.Wait(TimeSpan.FromSeconds(every == 0 ? Forever : Math.Min(every, Forever))))
                Console.Out.WriteLine(report.ToJson());
            return;
        }

        if (!AnsiConsole.Profile.Capabilities.Interactive)
        {
            ends.Wait();
            Output.Terminal.Write(report.ToTable());
            return;
        }

        AnsiConsole.Live(report.ToTable()).Start(live =>
        {
            while (!ends.Wait(TimeSpan.FromSeconds(DrawEvery))) live.UpdateTarget(report.ToTable());
            live.UpdateTarget(report.ToTable());
        });
    }
}
