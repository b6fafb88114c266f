namespace Surefoot.Workbench.Tests.Support;

/// <summary>The system's clock, of which a part can be passed over; timers go by the system's.</summary>
internal sealed class SkippingClock : TimeProvider
{
    private long skipped;

    public override long GetTimestamp() => System.GetTimestamp() + Interlocked.Read(ref skipped);

    public override long TimestampFrequency => System.TimestampFrequency;

    /// <summary>From now on it is so much later.</summary>
    public void Skip(TimeSpan time) => Interlocked.Add(ref skipped, (long)(time.TotalSeconds * TimestampFrequency));
}
