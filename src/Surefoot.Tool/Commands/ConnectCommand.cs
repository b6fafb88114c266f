using System.CommandLine;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Online;
using Surefoot.Tool.Walking;
using Surefoot.Workbench;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot connect</c>: a character enters the world of a server, looks around, walks a script and leaves.</summary>
internal static class ConnectCommand
{
    internal static Command Create()
    {
        Option<string> server = new("--server")
        {
            Description = "The server's address and first port, as in 127.0.0.1:9000; the next port is used too.",
            Required = true,
        };
        Option<string> account = new("--account") { Description = "Name of the account.", Required = true };
        Option<string> character = new("--character") { Description = "Name of the character.", Required = true };
        Option<bool> create = new("--create") { Description = "Make the character if the account has none of that name." };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Option<FileInfo?> passwordFile = new("--password-file")
        {
            Description =
                $"File whose first line is the password. Without it {PasswordSource.Variable} is the password, or it is asked for.",
        };
        Option<string?> script = new("--script")
        {
            Description = "Keys and seconds: W A S D Q E Shift Space Auto Wait, joined by + and separated by ;",
        };
        Option<FileInfo?> times = new("--times")
        {
            Description = "Write time, keys and place of each frame; 'surefoot walk --times' walks them again without a server.",
        };
        Option<double> timeout = new("--timeout")
        {
            Description = "Seconds that the login may take, 1 to 600.",
            DefaultValueFactory = _ => 30,
        };
        Option<bool> page = new("--page")
        {
            Description = "Play in a browser until Ctrl+C, instead of looking around and walking a script.",
        };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Command command = new(
            "connect",
            "Enters the world of a server, shows where the character is and who is near, walks a script and logs off.\n" +
            "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 no answer, 4 account refused, 5 version refused, 6 in use, " +
            "7 character refused, 8 server full or closed, 9 session lost, 10 other dat files.\n\nExample:\n" +
            $"  surefoot connect --server 127.0.0.1:9000 --account me --character Alma --create --script \"{WalkScript.Example}\"")
        {
            server, account, character, create, dats, passwordFile, script, times, timeout, page, json,
        };
        command.SetAction(async (parsed, cancellation) =>
        {
            IReadOnlyList<WalkLeg>? legs = parsed.GetValue(script) is { } text ? WalkCommand.ParseScript(text) : null;
            FileInfo? timesFile = parsed.GetValue(times);
            if (timesFile is not null && legs is null) throw new UsageException("--times keeps the frames of a --script: give one.");
            var address = ServerAddress.Find(parsed.GetRequiredValue(server));
            ClientSessionOptions login = PasswordSource.LogIn(
                parsed.GetRequiredValue(account), parsed.GetValue(passwordFile), parsed.GetValue(timeout));
            if (parsed.GetValue(page))
            {
                if (legs is not null || parsed.GetValue(json)) throw new UsageException("--page goes with neither --script nor --json.");
                return await PlayCommand.ServeAsync(
                    new WorkbenchOptions
                    {
                        DatFolder = parsed.GetValue(dats)?.FullName,
                        Notice = CommonOptions.Say,
                        Online = new OnlineOptions
                        {
                            Server = address,
                            Login = login,
                            Character = parsed.GetRequiredValue(character),
                            Create = parsed.GetValue(create),
                        },
                    },
                    opensPage: true, cancellation).ConfigureAwait(false);
            }

            ConnectReport report = new(parsed.GetValue(json), parsed.GetRequiredValue(server));
            try
            {
                using DatSet files = DatSet.Open(
                    parsed.GetValue(dats)?.FullName ?? DemoWorldCache.GetOrCreate(notice: CommonOptions.Say));
                using OnlineStay stay = new(address, login, new PhysicsDataCache(files), report.Say, cancellation);
                Stay(stay, report, parsed.GetRequiredValue(character), parsed.GetValue(create), legs, timesFile);
                return ExitCode.Done;
            }
            catch (ConnectException e)
            {
                report.Fail(e);
                return e.ExitCode;
            }
            catch (OperationCanceledException)
            {
                report.Fail(new ConnectException("Interrupted: the session was closed.", ExitCode.Failed));
                return ExitCode.Failed;
            }
        });
        return command;
    }

    private static void Stay(
        OnlineStay stay, ConnectReport report, string name, bool create, IReadOnlyList<WalkLeg>? legs, FileInfo? times)
    {
        report.Say("asking for a session");
        stay.LogIn();
        int characters = stay.Session.Characters!.Value.Characters.Count;
        report.Say($"logged in to '{stay.Session.Server?.Name}'; characters of the account: {characters}");
        var character = stay.Find(name, create);
        report.Say($"entering the world as {character.Name}");
        stay.Enter(character);
        report.TellArrival(stay, character);
        if (legs is not null)
        {
            report.Say("walking");
            WalkTimes? record = times is null ? null : stay.Record();
            if (record is not null) stay.Wait(0.5);
            stay.Walk(legs);
            record?.Write(times!.FullName);
            report.TellWalk(stay);
        }

        report.Say("logging off");
        stay.LogOff();
        report.Finish(stay);
    }
}
