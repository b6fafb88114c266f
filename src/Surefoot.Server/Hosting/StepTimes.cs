namespace Surefoot.Server;

/// <summary>How long passes of a server's loop took: their shares, to within a twentieth, in fixed memory.</summary>
public sealed class StepTimes
{
    private const int Buckets = 400;
    private const double Shortest = 1e-6, Growth = 1.05;

    private readonly long[] counts = new long[Buckets];

    /// <summary>Passes measured.</summary>
    public long Count { get; private set; }

    /// <summary>The longest, seconds.</summary>
    public double Longest { get; private set; }

    /// <summary>All together, seconds.</summary>
    public double Total { get; private set; }

    /// <summary>The time within which a share of the passes were over, seconds; 0 before the first.</summary>
    /// <param name="share">0 to 1.</param>
    public double Within(double share)
    {
        long wanted = (long)Math.Ceiling(share * Count), seen = 0;
        for (int i = 0; i < Buckets; i++)
        {
            seen += counts[i];
            if (seen >= wanted && seen > 0) return Math.Min(Longest, Shortest * Math.Pow(Growth, i + 1));
        }

        return Longest;
    }

    /// <summary>Begins anew.</summary>
    internal void Clear()
    {
        Array.Clear(counts);
        (Count, Longest, Total) = (0, 0, 0);
    }

    internal void Add(double seconds)
    {
        int bucket = seconds <= Shortest ? 0 : (int)(Math.Log(seconds / Shortest) / Math.Log(Growth));
        counts[Math.Min(bucket, Buckets - 1)]++;
        Count++;
        Total += seconds;
        Longest = Math.Max(Longest, seconds);
    }
}
