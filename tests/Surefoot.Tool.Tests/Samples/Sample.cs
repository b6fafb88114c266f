using System.Diagnostics;
using Surefoot.DemoWorld;
using Surefoot.Tool.Tests.Commands;

namespace Surefoot.Tool.Tests.Samples;

/// <summary>A program of <c>samples/</c>, as it was built beside these tests.</summary>
internal static class Sample
{
    /// <summary>The demo world's folder.</summary>
    internal static string World { get; } = DemoWorldCache.GetOrCreate();

    /// <summary>Runs a sample to its end.</summary>
    internal static Task<CommandLine.Outcome> RunAsync(string name, string? input, params string[] arguments) =>
        CommandLine.RunAsync(Start(name, arguments), input);

    /// <summary>How a sample is started.</summary>
    internal static ProcessStartInfo Start(string name, params string[] arguments)
    {
        string configuration = AppContext.BaseDirectory.Split(Path.DirectorySeparatorChar).Contains("Debug") ? "Debug" : "Release";
        return new("dotnet", ["exec", Repository.PathOf("samples", name, "bin", configuration, "net10.0", $"{name}.dll"), .. arguments]);
    }

    /// <summary>A named place of the demo world as a command line has it.</summary>
    internal static string Words(this NamedPlace place, float up = 0) =>
        FormattableString.Invariant($"0x{place.CellId:X8},{place.Origin.X},{place.Origin.Y},{place.Origin.Z + up}");

    /// <summary>A named place of the demo world.</summary>
    internal static NamedPlace PlaceOf(string name) =>
        DemoPlaces.TryFind(name, out NamedPlace? place) ? place : throw new KeyNotFoundException(name);
}
