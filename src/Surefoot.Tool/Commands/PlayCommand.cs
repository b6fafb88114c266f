using System.CommandLine;
using System.Globalization;
using Surefoot.Workbench;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot play</c>: serves the workbench.</summary>
internal static class PlayCommand
{
    internal static Command Create()
    {
        Option<int> port = new("--port")
        {
            Description = "Port on this machine; when it is taken, the next free one.",
            DefaultValueFactory = _ => WorkbenchOptions.DefaultPort,
        };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Option<bool> noBrowser = new("--no-browser") { Description = "Do not open the page." };
        Command command = new("play",
            "Serves the workbench: a page to walk in.\n\nExample:\n  surefoot play --port 5150 --no-browser") { port, dats, noBrowser };
        command.SetAction(async (parsed, cancellation) =>
        {
            int wanted = parsed.GetRequiredValue(port);
            if (wanted is < 0 or > ushort.MaxValue)
                throw new UsageException(
                    string.Create(CultureInfo.InvariantCulture,
                        $"--port {wanted} is out of range: it is between 0 and 65535, for example --port 5150."));
            WorkbenchServer server = await WorkbenchServer.StartAsync(
                new WorkbenchOptions { Port = wanted, DatFolder = parsed.GetValue(dats)?.FullName, Notice = CommonOptions.Say },
                cancellation).ConfigureAwait(false);
            await using (server.ConfigureAwait(false))
            {
                if (wanted != 0 && server.Address.Port != wanted)
                    Console.Out.WriteLine($"Port {wanted} is taken; using {server.Address.Port}.");
                Console.Out.WriteLine($"Surefoot workbench: {server.Address}  (Ctrl+C ends it)");
                if (!parsed.GetValue(noBrowser)) BrowserLauncher.TryOpen(server.Address);
                Task ended = await Task.WhenAny(server.Completion, Task.Delay(Timeout.Infinite, cancellation)).ConfigureAwait(false);
                if (ended == server.Completion) await ended.ConfigureAwait(false);
            }

            return ExitCode.Done;
        });
        return command;
    }
}
