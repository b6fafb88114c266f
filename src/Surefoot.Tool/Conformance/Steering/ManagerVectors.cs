using System.Text.Json;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Files of recorded runs of the managers that move other bodies. They need no world.</summary>
internal static class ManagerVectors
{
    /// <summary>Is the file one of these? Its first case names a family of them.</summary>
    internal static bool Reads(string path) => VectorFile.Read(path, static line => JsonElement.Parse(line)).Take(1).Any(
        first => SteeringReplay.Reads(first) || TimestampReplay.Reads(first));

    /// <summary>Replays every case of a file.</summary>
    /// <exception cref="InvalidDataException">A line is not a case; the message names file and line.</exception>
    internal static IEnumerable<ManagerResult> Run(string path) => VectorFile.Read(path, static line => Run(JsonElement.Parse(line)));

    private static ManagerResult Run(JsonElement recorded)
    {
        try
        {
            return TimestampReplay.Reads(recorded) ? TimestampReplay.Run(recorded) : SteeringReplay.Run(recorded);
        }
        catch (Exception e) when (e is KeyNotFoundException or InvalidOperationException or FormatException or ArgumentException or IndexOutOfRangeException)
        {
            throw new InvalidDataException($"not a recorded run: {e.Message}", e);
        }
    }
}
