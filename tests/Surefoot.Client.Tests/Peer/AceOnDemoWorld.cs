using System.Net;
using Surefoot.DemoWorld;
using Surefoot.Protocol.Tests.Peer;

namespace Surefoot.Client.Tests.Peer;

/// <summary>A real server of the field on nothing but what <c>surefoot demo write</c> and <c>surefoot demo rows</c> give.</summary>
public sealed class AceOnDemoWorld : IGameServer, IAsyncLifetime
{
    private readonly string? copy = AceServer.Unpacked is null ? null : Directory.CreateTempSubdirectory("surefoot-ace").FullName;
    private readonly AceServer server;

    public AceOnDemoWorld() => server = new AceServer(copy);

    public IPEndPoint Address => server.Address;

    public string Dats => server.Dats;

    public string Administrator => "admin";

    public bool JumpsCostStamina => true;

    public string[] FailedTransitions(int since) => server.LogLines("failed transition")[since..];

    /// <summary>Records that it looked for in the dat files in vain.</summary>
    public string[] AbsentRecords() => server.LogLines("Unable to find object_id");

    public async ValueTask InitializeAsync()
    {
        if (copy is null) return;
        string[] own = ["db", "run", "mods", "dats"];
        foreach (string entry in Directory.GetFileSystemEntries(AceServer.Unpacked!))
        {
            string name = Path.GetFileName(entry), to = Path.Combine(copy, name);
            if (Directory.Exists(entry) && !own.Contains(name)) CopyFolder(entry, to);
            else if (File.Exists(entry) && name != "tests.lock") File.Copy(entry, to);
        }

        DemoWorldBuilder.Write(Path.Combine(copy, "dats"));
        await File.WriteAllTextAsync(Path.Combine(copy, "sql", "world.sql"), DemoServerRows.ToSql());
        await File.WriteAllTextAsync(Path.Combine(copy, "sql", "spawns.sql"), "");
        await server.InitializeAsync();
    }

    public async ValueTask DisposeAsync()
    {
        await server.DisposeAsync();
        if (copy is not null) Directory.Delete(copy, recursive: true);
    }

    private static void CopyFolder(string from, string to)
    {
        Directory.CreateDirectory(to);
        foreach (string file in Directory.GetFiles(from)) File.Copy(file, Path.Combine(to, Path.GetFileName(file)));
        foreach (string folder in Directory.GetDirectories(from)) CopyFolder(folder, Path.Combine(to, Path.GetFileName(folder)));
    }
}
