using System.CommandLine;
using System.Globalization;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool.Serving;

/// <summary>The options of <c>surefoot serve</c>.</summary>
internal sealed class ServeOptions
{
    internal Option<int> Port { get; } = new("--port")
    {
        Description = "The first port; the next one is used too. 0 for any that is free.",
        DefaultValueFactory = _ => 9000,
    };

    internal Option<string> Address { get; } = new("--address")
    {
        Description = "Address of this machine to listen to.",
        DefaultValueFactory = _ => "127.0.0.1",
    };

    internal Option<DirectoryInfo?> Dats { get; } = CommonOptions.Dats();

    internal Option<string?> Start { get; } = new("--start")
    {
        Description = "Where new characters begin: a place of the demo world by name, or a cell and metres, as in 0xA9B40001,12,12,0.",
    };

    internal Option<string> Name { get; } = new("--name") { Description = "Name of the world.", DefaultValueFactory = _ => "Surefoot" };

    internal Option<string?> Accounts { get; } = new("--accounts")
    {
        Description = "File of accounts with salted hashes; 'surefoot serve account' writes it. Who is not in it does not come in.",
    };

    internal Option<string?> Characters { get; } = new("--characters")
    {
        Description = "File that keeps the characters; without it they are gone with the server.",
    };

    internal Option<bool> Administrators { get; } = new("--admins-only")
    {
        Description = "Commands by chat (@help lists them) are for administrators' accounts; always so when not on this machine alone.",
    };

    internal Option<int> Slots { get; } = new("--slots") { Description = "Most sessions at a time.", DefaultValueFactory = _ => 256 };

    internal Option<int> PerAddress { get; } = new("--per-address")
    {
        Description = "Most sessions at a time from one address; 0 for as many as there are slots.",
        DefaultValueFactory = _ => 0,
    };

    internal Option<int> LoginRate { get; } = new("--login-rate")
    {
        Description = "Logins a second that are looked at from one address; four times as many at once.",
        DefaultValueFactory = _ => 20,
    };

    internal Option<int> RunSkill { get; } = new("--run") { Description = "Run skill of new characters.", DefaultValueFactory = _ => 200 };

    internal Option<int> JumpSkill { get; } = new("--jump")
    {
        Description = "Jump skill of new characters.",
        DefaultValueFactory = _ => 200,
    };

    internal Option<bool> Believe { get; } = new("--believe")
    {
        Description = "Believe what clients claim of their movement, as live servers do, instead of judging it.",
    };

    internal Option<bool> Full { get; } = new("--full")
    {
        Description = "Tell others of a player more than live servers do, so that they draw it nearer to where it is.",
    };

    internal Option<int?> Metrics { get; } = new("--metrics")
    {
        Description = "Port of a page of metrics for Prometheus, on this machine alone.",
    };

    internal Option<bool> Stats { get; } = new("--stats") { Description = "Show a live table of figures." };

    internal Option<bool> Json { get; } = new("--json")
    {
        Description = "With --stats: print the figures as one JSON object a line, every --every seconds and at the end.",
    };

    internal Option<double> Every { get; } = new("--every")
    {
        Description = "Seconds between figures; 0 for the end alone.",
        DefaultValueFactory = _ => 10,
    };

    internal Option<bool> Quiet { get; } = new("--quiet") { Description = "Say nothing of who comes and goes." };

    internal Option<int> Load { get; } = new("--load")
    {
        Description = "Log so many clients of our own in that play all the time: a test of load.",
        DefaultValueFactory = _ => 0,
    };

    internal Option<double?> Minutes { get; } = new("--minutes") { Description = "End after so long." };

    internal void AddTo(Command command)
    {
        foreach (Option option in (Option[])
            [
                Port, Address, Dats, Start, Name, Accounts, Characters, Administrators, Slots, PerAddress, LoginRate, RunSkill, JumpSkill,
                Believe, Full, Metrics, Stats, Json, Every, Quiet, Load, Minutes,
            ])
        {
            command.Add(option);
        }
    }

    internal static int Between(ParseResult parsed, Option<int> option, int least, int most, string example)
    {
        int value = parsed.GetRequiredValue(option);
        return value >= least && value <= most
            ? value
            : throw new UsageException(string.Create(
                CultureInfo.InvariantCulture,
                $"{option.Name} {value} is out of range: it is between {least} and {most}, for example {example}."));
    }
}
