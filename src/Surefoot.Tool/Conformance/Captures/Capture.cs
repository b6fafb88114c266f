using System.Text.Json;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>One datagram of a recorded session.</summary>
/// <param name="Time">Seconds since the client began.</param>
/// <param name="Direction">Who sent it.</param>
/// <param name="Port">The server's port.</param>
/// <param name="Lost">It never arrived.</param>
/// <param name="Bytes">Its bytes.</param>
/// <param name="Expected">What there is to find in it.</param>
internal sealed record CapturedDatagram(
    double Time, WireDirection Direction, ServerPort Port, bool Lost, byte[] Bytes, JsonElement Expected);

/// <summary>A recorded session with what a correct decoder finds in it, which stands in a file beside it.</summary>
internal sealed class Capture
{
    private const string Lines = ".jsonl";

    private Capture(string path, JsonElement expected, CapturedDatagram[] datagrams)
    {
        Name = Path.GetFileName(path)[..^Lines.Length];
        Expected = expected;
        Datagrams = datagrams;
    }

    /// <summary>Name of the session.</summary>
    public string Name { get; }

    /// <summary>What there is to find.</summary>
    public JsonElement Expected { get; }

    /// <summary>The datagrams, as the client's side saw them.</summary>
    public CapturedDatagram[] Datagrams { get; }

    /// <summary>Messages to be found, in the order of their completion.</summary>
    public JsonElement.ArrayEnumerator Messages => Expected.GetProperty("messages").EnumerateArray();

    /// <summary>Where the keys of a direction begin; null when no server chose.</summary>
    public uint? Seed(WireDirection direction)
    {
        JsonElement seed = Expected.GetProperty(direction == WireDirection.ClientToServer ? "clientSeed" : "serverSeed");
        return seed.ValueKind == JsonValueKind.Null ? null : seed.GetUInt32();
    }

    /// <summary>Is this a file of what there is to find? It is read beside the session it belongs to.</summary>
    public static bool IsExpectation(string path) => Unpacked(path).EndsWith(".expected.json", StringComparison.OrdinalIgnoreCase);

    /// <summary>Reads a session.</summary>
    /// <param name="file">Its datagrams.</param>
    /// <exception cref="InvalidDataException">It is damaged, or what there is to find is missing; the message names the file.</exception>
    public static Capture Load(VectorFile file)
    {
        string session = Unpacked(file.Path);
        string beside = $"{session[..^Lines.Length]}.expected.json";
        if (!File.Exists(beside)) beside += VectorFile.Packed;
        if (!File.Exists(beside))
            throw new InvalidDataException($"{file.Path}: what there is to find in it belongs beside it, in {Path.GetFileName(beside)}.");
        return Guarded(beside, () =>
        {
            JsonElement expected = JsonElement.Parse(ReadAll(beside));
            JsonElement[] found = [.. expected.GetProperty("datagrams").EnumerateArray()];
            int basePort = expected.GetProperty("basePort").GetInt32(), read = 0;
            CapturedDatagram[] datagrams =
            [
                .. file.Read(line => Guarded(file.Path, () => read < found.Length
                    ? Parse(JsonElement.Parse(line), basePort, found[read++])
                    : throw new InvalidDataException(
                        $"there are more than the {found.Length} datagrams in which there is something to find."))),
            ];
            if (read < found.Length) throw new InvalidDataException($"{file.Path}: it ends after {read} of {found.Length} datagrams.");
            return new Capture(session, expected, datagrams);
        });
    }

    /// <summary>Replays what a damaged file may ask for.</summary>
    /// <exception cref="InvalidDataException">Something is missing, or of another kind; the message names the file.</exception>
    public static T Guarded<T>(string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (
            e is JsonException or KeyNotFoundException or InvalidOperationException or ArgumentException or FormatException
                or OverflowException)
        {
            throw new InvalidDataException($"{path}: not a recorded session: {e.Message}", e);
        }
    }

    private static CapturedDatagram Parse(JsonElement entry, int basePort, JsonElement expected) => new(
        entry.GetProperty("t").GetDouble(),
        entry.GetProperty("dir").GetString() == "c2s" ? WireDirection.ClientToServer : WireDirection.ServerToClient,
        entry.GetProperty("port").GetInt32() == basePort ? ServerPort.First : ServerPort.Second,
        entry.TryGetProperty("lost", out JsonElement lost) && lost.GetBoolean(),
        Convert.FromHexString(entry.GetProperty("hex").GetString() ?? throw new FormatException("a datagram has no bytes.")),
        expected);

    private static string Unpacked(string path) =>
        path.EndsWith(VectorFile.Packed, StringComparison.OrdinalIgnoreCase) ? path[..^VectorFile.Packed.Length] : path;

    private static string ReadAll(string path)
    {
        using FileStream file = File.OpenRead(path);
        using StreamReader reader = VectorFile.Unpack(file, path);
        try
        {
            return reader.ReadToEnd();
        }
        catch (InvalidDataException e)
        {
            throw new InvalidDataException($"{path}: {e.Message}", e);
        }
    }
}
