using System.CommandLine;

namespace Surefoot.Tool.Commands;

/// <summary>Options that several commands share.</summary>
internal static class CommonOptions
{
    /// <summary>Folder of dat files; without it the demo world.</summary>
    internal static Option<DirectoryInfo?> Dats() => new("--dats") { Description = "Folder with client_portal.dat and client_cell_1.dat; without it the demo world." };

    /// <summary>Says something that is no result.</summary>
    internal static void Say(string line) => Console.Error.WriteLine($"surefoot: {line}");
}
