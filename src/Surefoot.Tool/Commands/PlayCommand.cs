using System.CommandLine;
using System.Globalization;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Online;
using Surefoot.Workbench;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot play</c>: serves the workbench.</summary>
internal static class PlayCommand
{
    private const string Guest = "guest";

    internal static Command Create()
    {
        Option<int> port = new("--port")
        {
            Description = "Port on this machine; when it is taken, the next free one.",
            DefaultValueFactory = _ => WorkbenchOptions.DefaultPort,
        };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Option<bool> noBrowser = new("--no-browser") { Description = "Do not open the page." };
        Option<string?> server = new("--server")
        {
            Description = "Play in the world of a server, each page a client of its own: address and first port, as in 127.0.0.1:9000.",
        };
        Option<string> account = new("--account")
        {
            Description = "Account on that server. 'guest' is for servers that let anybody in: further pages are guest2, guest3 …",
            DefaultValueFactory = _ => Guest,
        };
        Option<string?> character = new("--character") { Description = "Character there; without it one with the account's name." };
        Option<bool> create = new("--create") { Description = "Make the character if the account has none of that name." };
        Option<FileInfo?> passwordFile = new("--password-file")
        {
            Description =
                $"File whose first line is the password. Without it {PasswordSource.Variable} is the password, or it is asked for.",
        };
        Command command = new("play",
            "Serves the workbench: a page to walk in.\n\nExample:\n  surefoot play --port 5150 --no-browser\n" +
            "  surefoot play --server 127.0.0.1:9000")
        { port, dats, noBrowser, server, account, character, create, passwordFile };
        command.SetAction(async (parsed, cancellation) =>
        {
            int wanted = parsed.GetRequiredValue(port);
            if (wanted is < 0 or > ushort.MaxValue)
                throw new UsageException(
                    string.Create(CultureInfo.InvariantCulture,
                        $"--port {wanted} is out of range: it is between 0 and 65535, for example --port 5150."));
            OnlineOptions? online = null;
            if (parsed.GetValue(server) is { } address)
            {
                string name = parsed.GetRequiredValue(account);
                bool isGuest = name == Guest && parsed.GetValue(passwordFile) is null;
                online = new OnlineOptions
                {
                    Server = ServerAddress.Find(address),
                    Login = isGuest
                        ? new ClientSessionOptions { Account = Guest, Password = Guest, SilenceTimeout = PasswordSource.Patience }
                        : PasswordSource.LogIn(name, parsed.GetValue(passwordFile), timeout: 30),
                    Character = parsed.GetValue(character) ?? char.ToUpperInvariant(name[0]) + name[1..],
                    Create = isGuest || parsed.GetValue(create),
                    NumbersPages = isGuest,
                };
            }

            return await ServeAsync(
                new WorkbenchOptions
                {
                    Port = wanted,
                    DatFolder = parsed.GetValue(dats)?.FullName,
                    Notice = CommonOptions.Say,
                    Online = online,
                },
                opensPage: !parsed.GetValue(noBrowser), cancellation).ConfigureAwait(false);
        });
        return command;
    }

    /// <summary>Serves the page until it is cancelled.</summary>
    internal static async Task<int> ServeAsync(WorkbenchOptions options, bool opensPage, CancellationToken cancellation)
    {
        WorkbenchServer server = await WorkbenchServer.StartAsync(options, cancellation).ConfigureAwait(false);
        await using (server.ConfigureAwait(false))
        {
            if (options.Port != 0 && server.Address.Port != options.Port)
                Console.Out.WriteLine($"Port {options.Port} is taken; using {server.Address.Port}.");
            Console.Out.WriteLine($"Surefoot workbench: {server.Address}  (Ctrl+C ends it)");
            if (opensPage) BrowserLauncher.TryOpen(server.Address);
            Task ended = await Task.WhenAny(server.Completion, Task.Delay(Timeout.Infinite, cancellation)).ConfigureAwait(false);
            if (ended == server.Completion) await ended.ConfigureAwait(false);
        }

        return ExitCode.Done;
    }
}
