using Surefoot.Tool.Conformance;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Captures;

/// <summary>The sessions in <c>tests/data/wire-captures</c>.</summary>
internal static class RecordedSessions
{
    private const string Ending = ".jsonl.gz";

    public static TheoryData<string> All { get; } =
    [
        .. Directory.EnumerateFiles(Folder, "*" + Ending)
            .Select(path => Path.GetFileName(path)[..^Ending.Length])
            .Order(StringComparer.Ordinal),
    ];

    public static Capture Load(string name)
    {
        using var file = VectorFile.Open(Path.Combine(Folder, name + Ending));
        return Capture.Load(file);
    }

    private static string Folder => Repository.PathOf("tests", "data", "wire-captures");
}
