using Microsoft.Extensions.Logging;

namespace Surefoot.Workbench;

/// <summary>What a workbench serves, and where.</summary>
public sealed record WorkbenchOptions
{
    /// <summary>The port that <c>./play</c> uses.</summary>
    public const int DefaultPort = 5150;

    /// <summary>Folder with the dat files; null for the demo world, which is written first when it is not cached yet.</summary>
    public string? DatFolder { get; init; }

    /// <summary>Named places; null for the demo world's own, or for some well-known towns of the retail world.</summary>
    public IReadOnlyList<WorkbenchPlace>? Places { get; init; }

    /// <summary>
    /// A server whose world is played in, each page a client of its own; null for a world in this process. <see cref="DatFolder"/>
    /// must then hold the server's own files.
    /// </summary>
    public OnlineOptions? Online { get; init; }

    /// <summary>Port on the loopback address; when it is taken, the next free one. 0 for any free port.</summary>
    public int Port { get; init; } = DefaultPort;

    /// <summary>How many pages may play at once, 1 to 256. One more is answered with 503.</summary>
    public int MaxPlayers { get; init; } = 32;

    /// <summary>
    /// Told, in a sentence each, what whoever starts the server should know: a cache that cannot be written to; null for nobody.
    /// </summary>
    public Action<string>? Notice { get; init; }

    /// <summary>Where to log; null for nowhere.</summary>
    public ILoggerFactory? LoggerFactory { get; init; }
}
