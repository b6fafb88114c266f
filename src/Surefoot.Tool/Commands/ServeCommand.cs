using System.CommandLine;
using Surefoot.Server;
using Surefoot.Tool.Serving;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot serve</c>: a server for clients of the field.</summary>
internal static class ServeCommand
{
    internal static Command Create()
    {
        Option<int> port = new("--port") { Description = "The first port; the next one is used too.", DefaultValueFactory = _ => 9000 };
        Option<DirectoryInfo?> dats = CommonOptions.Dats();
        Option<string?> start = new("--start") { Description = "Place of the demo world where new characters begin." };
        Command command = new("serve", "Serves a world to clients of the field.\n\nExample:\n  surefoot serve --port 9000 --stats")
        {
            port, dats, start,
        };
        command.SetAction((parsed, cancellation) =>
        {
            using ServedWorld world = ServedWorld.Open(parsed.GetValue(dats), parsed.GetValue(start));
            using WorldServer server = new(world.Cache, new WorldServerOptions
            {
                Port = parsed.GetValue(port),
                Start = world.Start,
                Spawns = world.Spawns,
                RunSkill = 200,
                JumpSkill = 200,
                Log = CommonOptions.Say,
            });
            Console.Out.WriteLine($"world is open on {server.EndPoint} and {server.EndPoint.Port + 1}  (Ctrl+C ends it)");
            server.Run(cancellation);
            return Task.FromResult(ExitCode.Done);
        });
        return command;
    }
}
