using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Bodies;

/// <summary>The growing and shrinking of one object that takes time.</summary>
/// <remarks>Retail: FPHook::Execute @0x0051BAA0; specification 02, 4.18, tween.</remarks>
internal sealed class ScaleTweens
{
    private List<Tween>? running;

    private readonly record struct Tween(double Created, double Duration, float Start, float End);

    /// <summary>The scale right after one was asked for: the same as before where it takes time.</summary>
    internal float Set(float scale, float value, float seconds, double now)
    {
        if (seconds < RetailMath.Epsilon) return value;
        (running ??= []).Add(new Tween(now, seconds, scale, value));
        return scale;
    }

    /// <summary>The scale at a time; the newest goes first, so that the oldest has the last word.</summary>
    internal float Advance(float scale, double now)
    {
        for (int i = (running?.Count ?? 0) - 1; i >= 0; i--)
        {
            Tween tween = running![i];
            double t = now - tween.Created, u = t <= 0 ? 0 : t < tween.Duration ? t / tween.Duration : 1;
            scale = (float)(tween.Start + (((double)tween.End - tween.Start) * u));
            if (u >= 1) running.RemoveAt(i);
        }

        return scale;
    }
}
