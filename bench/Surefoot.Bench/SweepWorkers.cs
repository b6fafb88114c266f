using System.Diagnostics;
using Surefoot.Physics.Queries;
using Surefoot.Scenes;

namespace Surefoot.Bench;

/// <summary>Threads that sweep for a while when they are told to, each with a query of its own, each about a player of its own.</summary>
internal sealed class SweepWorkers : IDisposable
{
    private const double WindowSeconds = 0.0005, LeastOverlap = 0.9;

    private readonly Worker[] workers;

    /// <summary>Starts a thread for each player of a scene.</summary>
    internal SweepWorkers(ProbeRun run) => workers = [.. Enumerable.Range(0, run.Bodies.Count).Select(runner => new Worker(run, runner))];

    /// <summary>Sweeps in a millisecond, of all these threads together.</summary>
    /// <returns>Not a number when their windows overlap in wall time for less than nine tenths.</returns>
    internal double Measure(params ReadOnlySpan<int> who)
    {
        using Barrier start = new(who.Length);
        foreach (int i in who) workers[i].Begin(start);
        double rate = 0;
        long begin = 0, end = long.MaxValue;
        foreach (int i in who)
        {
            Window window = workers[i].End();
            rate += window.Rate;
            begin = Math.Max(begin, window.Begin);
            end = Math.Min(end, window.End);
        }

        return Stopwatch.GetElapsedTime(begin, end).TotalSeconds >= LeastOverlap * WindowSeconds ? rate : double.NaN;
    }

    /// <summary>Ends the threads.</summary>
    public void Dispose()
    {
        foreach (Worker worker in workers) worker.Dispose();
    }

    /// <summary>What a thread did in a window: sweeps in a millisecond, from when to when.</summary>
    private readonly record struct Window(double Rate, long Begin, long End);

    private sealed class Worker : IDisposable
    {
        private readonly ProbeRun run;
        private readonly int runner;
        private readonly WorldQuery made;
        private readonly Thread thread;
        private readonly AutoResetEvent wanted = new(false), done = new(false);
        private Barrier? start;
        private Window window;

        internal Worker(ProbeRun run, int runner)
        {
            this.run = run;
            this.runner = runner;
            made = run.Engine.CreateQuery();
            thread = new Thread(Work) { IsBackground = true };
            thread.Start();
        }

        internal void Begin(Barrier together)
        {
            start = together;
            wanted.Set();
        }

        internal Window End()
        {
            done.WaitOne();
            return window;
        }

        public void Dispose()
        {
            start = null;
            wanted.Set();
            thread.Join();
            wanted.Dispose();
            done.Dispose();
        }

        private void Work()
        {
            WorldQuery query = made;
            while (true)
            {
                wanted.WaitOne();
                if (start is not { } together) return;
                run.Ask(query, runner);
                together.SignalAndWait();
                window = Sweep(query);
                done.Set();
            }
        }

        private Window Sweep(WorldQuery query)
        {
            long begin = Stopwatch.GetTimestamp(), sweeps = 0, now;
            do
            {
                sweeps += run.Ask(query, runner);
                now = Stopwatch.GetTimestamp();
            }
            while (Stopwatch.GetElapsedTime(begin, now).TotalSeconds < WindowSeconds);
            return new Window(sweeps / Stopwatch.GetElapsedTime(begin, now).TotalMilliseconds, begin, now);
        }
    }
}
