using BenchmarkDotNet.Running;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>
/// Runs benchmarks: <c>dotnet run -c Release --project bench/Surefoot.Bench -- --filter '*'</c>. With <c>hashes</c> alone it prints the
/// state hash of each scene.
/// </summary>
internal static class Program
{
    private static void Main(string[] args)
    {
        if (args is ["hashes"]) PrintHashes();
        else BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args);
    }

    private static void PrintHashes()
    {
        using DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        foreach (Scene scene in Scene.All) Console.WriteLine($"{scene.Hash(dats):x16}  {scene.Name}");
    }
}
