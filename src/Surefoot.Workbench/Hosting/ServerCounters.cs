using System.Diagnostics.Metrics;

namespace Surefoot.Workbench.Hosting;

/// <summary>What the server counts, for <c>/stats.json</c> and for listeners of the meter <c>Surefoot.Workbench</c>.</summary>
internal sealed class ServerCounters : IDisposable
{
    private readonly Meter meter = new("Surefoot.Workbench");
    private long received;
    private long malformed;
    private long overflowed;
    private long sent;
    private long unsent;
    private long ticks;
    private long players;

    public ServerCounters()
    {
        meter.CreateObservableCounter("surefoot.workbench.frames.received", () => Received, "{frame}", "Messages from pages");
        meter.CreateObservableCounter(
            "surefoot.workbench.frames.malformed", () => Malformed, "{frame}", "Messages dropped because they were not a frame");
        meter.CreateObservableCounter(
            "surefoot.workbench.frames.overflowed", () => Overflowed, "{frame}", "Frames dropped because a page sent too many");
        meter.CreateObservableCounter("surefoot.workbench.frames.sent", () => Sent, "{frame}", "Frames sent to pages");
        meter.CreateObservableCounter(
            "surefoot.workbench.frames.unsent", () => Unsent, "{frame}", "Frames dropped because a page reads too slowly");
        meter.CreateObservableCounter("surefoot.workbench.ticks", () => Ticks, "{tick}", "Ticks of the physics");
        meter.CreateObservableUpDownCounter("surefoot.workbench.players", () => Players, "{player}", "Players in the world");
    }

    public long Received => Interlocked.Read(ref received);

    public long Malformed => Interlocked.Read(ref malformed);

    public long Overflowed => Interlocked.Read(ref overflowed);

    public long Sent => Interlocked.Read(ref sent);

    public long Unsent => Interlocked.Read(ref unsent);

    public long Ticks => Interlocked.Read(ref ticks);

    public long Players => Interlocked.Read(ref players);

    public void CountReceived() => Interlocked.Increment(ref received);

    public void CountMalformed() => Interlocked.Increment(ref malformed);

    public void CountOverflowed() => Interlocked.Increment(ref overflowed);

    public void CountSent() => Interlocked.Increment(ref sent);

    public void CountUnsent() => Interlocked.Increment(ref unsent);

    public void CountTick() => Interlocked.Increment(ref ticks);

    public void CountPlayer(int change) => Interlocked.Add(ref players, change);

    public void Dispose() => meter.Dispose();
}
