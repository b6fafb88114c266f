using System.CommandLine;
using System.Globalization;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Commands;

/// <summary>Options that several commands share.</summary>
internal static class CommonOptions
{
    private const int MostSaid = 5;

    /// <summary>Folder of dat files; without it the demo world.</summary>
    internal static Option<DirectoryInfo?> Dats() =>
        new("--dats") { Description = "Folder with client_portal.dat and client_cell_1.dat; without it the demo world." };

    /// <summary>Says once what a world does without, the first things only.</summary>
    internal static void SayLeftOut(LeftOutList leftOut)
    {
        foreach (LeftOutItem item in leftOut.Take(MostSaid)) Say($"left out: {item}");
        if (leftOut.Count > MostSaid)
            Say(string.Create(CultureInfo.InvariantCulture, $"left out: {leftOut.Total} things in all; 'surefoot dats verify' lists them"));
    }

    /// <summary>Says something that is no result.</summary>
    internal static void Say(string line) => Console.Error.WriteLine($"surefoot: {line}");
}
