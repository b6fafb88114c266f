using System.IO.Compression;
using System.Text.Json;

namespace Surefoot.Tool.Conformance;

/// <summary>
/// A file of recorded cases: one JSON object a line, gzipped or not. It is opened once and read once, from its first line to its last.
/// </summary>
internal sealed class VectorFile : IDisposable
{
    /// <summary>How the name of a gzipped file ends.</summary>
    internal const string Packed = ".gz";

    private readonly FileStream file;
    private readonly StreamReader reader;
    private int number;

    private VectorFile(string path)
    {
        Path = path;
        file = File.OpenRead(path);
        reader = Unpack(file, path);
    }

    /// <summary>The file.</summary>
    public string Path { get; }

    /// <summary>The first line that is not empty, before any other is read; null when there is none.</summary>
    public string? FirstLine { get; private set; }

    /// <summary>Share of the file that has been read, in percent; 0 where nobody knows, as in a pipe.</summary>
    public int Progress => !file.CanSeek || file.Length == 0 ? 0 : (int)(100 * file.Position / file.Length);

    /// <summary>Opens a file and reads its first line.</summary>
    /// <exception cref="IOException">There is no such file.</exception>
    /// <exception cref="InvalidDataException">It is damaged; the message names it.</exception>
    public static VectorFile Open(string path)
    {
        VectorFile opened = new(path);
        try
        {
            opened.FirstLine = opened.NextLine();
            return opened;
        }
        catch
        {
            opened.Dispose();
            throw;
        }
    }

    /// <summary>Reads every line as one thing; empty lines are left out.</summary>
    /// <param name="read">Reads a line, or replays what it records.</param>
    /// <exception cref="InvalidDataException">A line cannot be read, or holds what the engine refuses; the message names file and
    /// line.</exception>
    public IEnumerable<T> Read<T>(Func<string, T> read)
    {
        for (string? line = FirstLine; line is not null; line = NextLine())
        {
            T one;
            try
            {
                one = read(line);
            }
            catch (Exception e) when (e is JsonException or InvalidDataException or ArgumentException)
            {
                throw new InvalidDataException($"{Path}, line {number}: {e.Message.ReplaceLineEndings(" ")}", e);
            }

            yield return one;
        }
    }

    /// <summary>Reads the text of a file, gzipped or not.</summary>
    internal static StreamReader Unpack(Stream file, string path) =>
        new(path.EndsWith(Packed, StringComparison.OrdinalIgnoreCase) ? new GZipStream(file, CompressionMode.Decompress) : file);

    /// <inheritdoc/>
    public void Dispose() => reader.Dispose();

    private string? NextLine()
    {
        try
        {
            string? line;
            do
            {
                line = reader.ReadLine();
                number++;
            }
            while (line is { Length: 0 });
            return line;
        }
        catch (InvalidDataException e)
        {
            throw new InvalidDataException($"{Path}, line {number + 1}: {e.Message}", e);
        }
    }
}
