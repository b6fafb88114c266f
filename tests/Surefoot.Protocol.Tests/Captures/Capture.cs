using System.IO.Compression;
using System.Text.Json;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Captures;

/// <summary>One datagram of a recorded session.</summary>
/// <param name="Time">Seconds since the client began.</param>
/// <param name="Direction">Who sent it.</param>
/// <param name="Port">The server's port.</param>
/// <param name="Lost">It never arrived.</param>
/// <param name="Bytes">Its bytes.</param>
/// <param name="Expected">What there is to find in it.</param>
internal sealed record CapturedDatagram(
    double Time, WireDirection Direction, ServerPort Port, bool Lost, byte[] Bytes, JsonElement Expected);

/// <summary>A recorded session with what a correct decoder finds in it; tests/data/wire-captures/README.md has the format.</summary>
internal sealed class Capture
{
    private Capture(string name, JsonElement expected, CapturedDatagram[] datagrams)
    {
        Name = name;
        Expected = expected;
        Datagrams = datagrams;
    }

    public static IReadOnlyList<string> Names { get; } =
    [
        .. Directory.EnumerateFiles(Folder, "*.jsonl.gz")
            .Select(path => Path.GetFileName(path)[..^".jsonl.gz".Length])
            .Order(StringComparer.Ordinal),
    ];

    public static TheoryData<string> All { get; } = [.. Names];

    public string Name { get; }

    public JsonElement Expected { get; }

    public CapturedDatagram[] Datagrams { get; }

    /// <summary>Messages to be found, in the order of their completion.</summary>
    public JsonElement.ArrayEnumerator Messages => Expected.GetProperty("messages").EnumerateArray();

    public uint? Seed(WireDirection direction)
    {
        JsonElement seed = Expected.GetProperty(direction == WireDirection.ClientToServer ? "clientSeed" : "serverSeed");
        return seed.ValueKind == JsonValueKind.Null ? null : seed.GetUInt32();
    }

    public static Capture Load(string name)
    {
        JsonElement expected = JsonDocument.Parse(Unpack($"{name}.expected.json.gz")).RootElement;
        int basePort = expected.GetProperty("basePort").GetInt32();
        JsonElement[] found = [.. expected.GetProperty("datagrams").EnumerateArray()];
        CapturedDatagram[] datagrams =
        [
            .. Unpack($"{name}.jsonl.gz").Split('\n', StringSplitOptions.RemoveEmptyEntries).Select((line, index) =>
            {
                JsonElement entry = JsonDocument.Parse(line).RootElement;
                return new CapturedDatagram(
                    entry.GetProperty("t").GetDouble(),
                    DirectionOf(entry),
                    entry.GetProperty("port").GetInt32() == basePort ? ServerPort.First : ServerPort.Second,
                    entry.TryGetProperty("lost", out JsonElement lost) && lost.GetBoolean(),
                    Convert.FromHexString(entry.GetProperty("hex").GetString()!),
                    found[index]);
            }),
        ];
        Assert.Equal(found.Length, datagrams.Length);
        return new Capture(name, expected, datagrams);
    }

    public static WireDirection DirectionOf(JsonElement entry)
        => entry.GetProperty("dir").GetString() == "c2s" ? WireDirection.ClientToServer : WireDirection.ServerToClient;

    private static string Folder => Repository.PathOf("tests", "data", "wire-captures");

    private static string Unpack(string file)
    {
        using var reader = new StreamReader(new GZipStream(File.OpenRead(Path.Combine(Folder, file)), CompressionMode.Decompress));
        return reader.ReadToEnd();
    }
}
