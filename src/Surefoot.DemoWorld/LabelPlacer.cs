namespace Surefoot.DemoWorld;

/// <summary>Finds room for the labels of dots: the first of eight positions around a dot that hits no earlier label.</summary>
internal sealed class LabelPlacer
{
    private const double CharacterWidth = 5.4, Height = 10;

    private readonly List<(double X, double Y, double Width, double Height)> taken = [];

    /// <summary>Keeps labels away from a rectangle.</summary>
    public void Block(double x, double y, double width, double height) => taken.Add((x, y, width, height));

    /// <summary>Left end and baseline of a label of so many characters beside a dot.</summary>
    public (double Left, double Baseline) Place(double x, double y, int characters)
    {
        double width = characters * CharacterWidth;
        (double Left, double Top)[] corners =
        [
            (x + 6, y - 5), (x - 6 - width, y - 5), (x - (width / 2), y - 16), (x - (width / 2), y + 6),
            (x + 5, y - 14), (x + 5, y + 4), (x - 5 - width, y - 14), (x - 5 - width, y + 4),
        ];
        int best = Array.FindIndex(corners, corner => !taken.Any(other =>
            corner.Left < other.X + other.Width && other.X < corner.Left + width && corner.Top < other.Y + other.Height &&
            other.Y < corner.Top + Height));
        var (left, top) = corners[Math.Max(best, 0)];
        Block(left, top, width, Height);
        return (left, top + 8.5);
    }
}
