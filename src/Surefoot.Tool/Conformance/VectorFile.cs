using System.IO.Compression;
using System.Text.Json;

namespace Surefoot.Tool.Conformance;

/// <summary>A file of recorded cases: one JSON object a line, gzipped or not.</summary>
internal static class VectorFile
{
    /// <summary>Reads every line as one thing; empty lines are left out.</summary>
    /// <param name="path">The file.</param>
    /// <param name="parse">Reads a line.</param>
    /// <exception cref="InvalidDataException">A line cannot be read; the message names file and line.</exception>
    public static IEnumerable<T> Read<T>(string path, Func<string, T> parse)
    {
        using FileStream file = File.OpenRead(path);
        using Stream stream = path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? new GZipStream(file, CompressionMode.Decompress) : file;
        using StreamReader reader = new(stream);
        for (int number = 1; reader.ReadLine() is { } line; number++)
        {
            if (line.Length == 0) continue;
            T one;
            try
            {
                one = parse(line);
            }
            catch (Exception e) when (e is JsonException or InvalidDataException)
            {
                throw new InvalidDataException($"{path}, line {number}: {e.Message}", e);
            }

            yield return one;
        }
    }
}
