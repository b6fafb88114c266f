using System.Diagnostics;
using System.Net;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Serving;

/// <summary>Many clients of a server, on a thread of their own: they log in one after the other and play until they are told to
/// end.</summary>
internal sealed class LoadRun : IDisposable
{
    private const double LoginEvery = 0.06, Frame = 0.015, CourseSeconds = 40;
    private const int Courses = 8, LongestDatagram = 2048;

    private readonly IPEndPoint server;
    private readonly LoadClient?[] clients;
    private readonly List<LoadCourse> courses = [];
    private readonly Thread thread;
    private volatile bool ends;

    /// <summary>Begins.</summary>
    /// <param name="world">The world that the server serves.</param>
    /// <param name="server">The server.</param>
    /// <param name="count">How many clients.</param>
    /// <param name="stats">The numbers that their characters get.</param>
    internal LoadRun(ServedWorld world, IPEndPoint server, int count, CharacterStats stats)
    {
        this.server = server;
        clients = new LoadClient?[count];
        for (int i = 0; i < Math.Min(count, Courses); i++)
            courses.Add(LoadCourse.Record(world.Cache, world.Start, stats, (ulong)i + 1, CourseSeconds));
        thread = new Thread(Run) { IsBackground = true, Name = "Surefoot load" };
        thread.Start();
    }

    /// <summary>All of them are in the world, or were once.</summary>
    internal bool IsComplete { get; private set; }

    /// <summary>Clients whose player is in the world.</summary>
    internal int InWorld { get; private set; }

    /// <summary>Clients whose session ended by itself.</summary>
    internal int Failed { get; private set; }

    /// <summary>Claims that they made.</summary>
    internal long Claims { get; private set; }

    /// <summary>How often the server put one of them somewhere.</summary>
    internal long Forced { get; private set; }

    /// <summary>Datagrams that came and could not be used: none of a good network.</summary>
    internal long Dropped { get; private set; }

    /// <summary>Why the first one failed; null while none has.</summary>
    internal string? FirstFailure { get; private set; }

    /// <summary>They play no more; what was counted stays.</summary>
    internal void End()
    {
        ends = true;
        thread.Join();
    }

    public void Dispose()
    {
        End();
        foreach (LoadClient? client in clients) client?.Dispose();
    }

    private void Run()
    {
        byte[] buffer = new byte[LongestDatagram];
        long began = Stopwatch.GetTimestamp();
        double nextCount = 0;
        while (!ends)
        {
            double now = Stopwatch.GetElapsedTime(began).TotalSeconds;
            int due = (int)Math.Min(clients.Length, 1 + (now / LoginEvery));
            for (int i = 0; i < due; i++)
            {
                clients[i] ??= new LoadClient(
                    server, courses[i % courses.Count], $"load{i}", $"Load {Letters(i)}", buffer, now);
                clients[i]!.Update(now);
            }

            if (now >= nextCount) Count();
            nextCount = Math.Max(nextCount, Math.Floor(now) + 1);
            double rest = Frame - (Stopwatch.GetElapsedTime(began).TotalSeconds - now);
            if (rest > 0) Thread.Sleep(TimeSpan.FromSeconds(rest));
        }

        Count();
    }

    private void Count()
    {
        (int inWorld, int failed, long claims, long forced, long dropped) = (0, 0, 0, 0, 0);
        foreach (LoadClient? client in clients)
        {
            if (client is null) continue;
            if (client.IsInWorld && client.Failure is null) inWorld++;
            if (client.Failure is { } failure)
            {
                failed++;
                FirstFailure ??= failure.Sentence;
            }

            claims += client.Claims;
            forced += client.Forced;
            foreach (DropReason reason in Enum.GetValues<DropReason>()) dropped += client.Statistics.Dropped(reason);
        }

        IsComplete |= inWorld + failed == clients.Length;
        (InWorld, Failed, Claims, Forced, Dropped) = (inWorld, failed, claims, forced, dropped);
    }

    /// <summary>A number as letters: names have no digits.</summary>
    private static string Letters(int number) =>
        new([(char)('A' + (number / 676)), (char)('a' + (number / 26 % 26)), (char)('a' + (number % 26))]);
}
