namespace Surefoot.Client;

/// <summary>How much the pointer turns the player: settings, and the filter that its movement goes through.</summary>
/// <remarks>Retail: CameraSet::MouseLookHandler @0x00458D80 and FilterMouseInput @0x00457530; specification 09b, 9.7.</remarks>
public sealed class MouseTurning
{
    /// <summary>A turn smaller than this does nothing.</summary>
    internal const float DeadZone = 0.02f;

    /// <summary>Fastest turn asked for; running makes it half as fast again.</summary>
    internal const float MaxSpeed = 1.5f;

    private const float Scale = (float)(1.0 / 15.0);
    private const double SmoothingWindow = 0.25;
    private const int EventsSkipped = 5;

    private float sensitivity = 0.25f;
    private float smoothing;
    private float last;
    private double lastTime = double.NegativeInfinity;
    private int moving;

    /// <summary>Factor on the pointer's movement, 0 or more.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative or not finite.</exception>
    public float Sensitivity
    {
        get => sensitivity;
        set =>
            sensitivity = value >= 0 && float.IsFinite(value)
                ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "A factor is 0 or more.");
    }

    /// <summary>Share of the average with the movement before, 0 to 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Less than 0 or more than 1.</exception>
    public float Smoothing
    {
        get => smoothing;
        set =>
            smoothing = value is >= 0 and <= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "A share is 0 to 1.");
    }

    /// <summary>
    /// Turns the direction round. Retail's own is that of a camera which orbits the player: the pointer to the left turns the player right.
    /// Inverted, it turns where the pointer goes.
    /// </summary>
    public bool Inverted { get; set; }

    /// <summary>Takes in a movement of the pointer.</summary>
    /// <param name="counts">To the right, in counts of the pointer; 0 when it rests.</param>
    /// <param name="now">Seconds.</param>
    /// <param name="turn">How to turn: below 0 right, above 0 left.</param>
    /// <returns>True from the sixth movement in a row on; the ones before do not act.</returns>
    internal bool Filter(float counts, double now, out float turn)
    {
        double average = now - lastTime <= SmoothingWindow ? ((double)last + counts) / 2 : counts;
        last = (float)((counts * (1.0 - smoothing)) + (average * smoothing));
        lastTime = now;
        turn = (float)((double)last * sensitivity * Scale);
        if (Inverted) turn = -turn;
        moving = turn == 0 ? 0 : moving + 1;
        return moving > EventsSkipped;
    }
}
