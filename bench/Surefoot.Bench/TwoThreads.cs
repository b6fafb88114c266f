using System.Diagnostics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Queries;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>
/// Two threads that sweep in the same block of one world, against each alone. Windows of two milliseconds in turns, and the best of many of each kind, so that
/// what else the machine does counts for little.
/// </summary>
internal static class TwoThreads
{
    private const int Windows = 1500;
    private const double WindowSeconds = 0.002;

    internal static void Print()
    {
        using DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate());
        Console.WriteLine("scene     one alone    the other    both at once    ratio");
        foreach ((string name, string place) in (ReadOnlySpan<(string, string)>)[("flat", "runway"), ("forest", "forest")])
        {
            ProbeRun run = new(dats, place, 2, 4f);
            double one = 0, other = 0, both = 0;
            for (int i = 0; i < Windows; i++)
            {
                one = Math.Max(one, Measure(run, 0));
                other = Math.Max(other, Measure(run, 1));
                both = Math.Max(both, Measure(run, 0, 1));
            }

            Console.WriteLine(FormattableString.Invariant($"{name,-8}{one,9:0} /ms{other,9:0} /ms{both,12:0} /ms{both / (one + other),9:0.00}"));
        }
    }

    /// <summary>Sweeps in a millisecond, of all threads together, each of which asks about a player of its own.</summary>
    private static double Measure(ProbeRun run, params ReadOnlySpan<int> runners)
    {
        double[] rates = new double[runners.Length];
        using Barrier start = new(runners.Length);
        Thread[] threads = new Thread[runners.Length];
        for (int i = 0; i < threads.Length; i++)
        {
            int runner = runners[i], slot = i;
            threads[i] = new Thread(() =>
            {
                WorldQuery query = run.Engine.CreateQuery();
                run.Ask(query, runner);
                start.SignalAndWait();
                rates[slot] = Rate(run, query, runner);
            });
            threads[i].Start();
        }

        foreach (Thread thread in threads) thread.Join();
        return rates.Sum();
    }

    private static double Rate(ProbeRun run, WorldQuery query, int runner)
    {
        long begin = Stopwatch.GetTimestamp(), sweeps = 0;
        double seconds;
        do
        {
            sweeps += run.Ask(query, runner);
            seconds = Stopwatch.GetElapsedTime(begin).TotalSeconds;
        }
        while (seconds < WindowSeconds);
        return sweeps / seconds / 1000;
    }
}
