using System.Buffers;
using System.Runtime.CompilerServices;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>The files of tests/data.</summary>
internal static class TestData
{
    public static string Root { get; } = Path.GetFullPath(Path.Combine(SourceFolder(), "..", "..", "data"));

    public static string Samples { get; } = Path.Combine(Root, "dat-samples");

    public static string Mini { get; } = Path.Combine(Samples, "mini");

    /// <summary>Every dat file of the tests.</summary>
    public static IEnumerable<string> DatFiles { get; } =
    [
        .. new[] { Mini, Path.Combine(Root, "worlds", "first"), Path.Combine(Root, "worlds", "oracle") }
            .SelectMany(folder => Directory.GetFiles(folder, "*.dat"))
            .Order(StringComparer.Ordinal),
    ];

    /// <summary>Bytes of a sample, e.g. <c>gfxobj-01000010</c>.</summary>
    public static byte[] SampleBytes(string name) => File.ReadAllBytes(Path.Combine(Samples, name + ".bin"));

    /// <summary>A sample, decoded; its id is in its name.</summary>
    public static T Sample<T>(string name)
        where T : DatRecord, IDatRecord<T>
        => DatRecord.Decode<T>(SampleId(name), new ReadOnlySequence<byte>(SampleBytes(name)), name);

    public static uint SampleId(string name) => Convert.ToUInt32(name[(name.LastIndexOf('-') + 1)..], 16);

    private static string SourceFolder([CallerFilePath] string path = "") => Path.GetDirectoryName(path)!;
}
