using BenchmarkDotNet.Running;

namespace Surefoot.Bench;

/// <summary>Runs benchmarks: <c>dotnet run -c Release --project bench/Surefoot.Bench -- --filter '*'</c>.</summary>
internal static class Program
{
    private static void Main(string[] args) => BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args);
}
