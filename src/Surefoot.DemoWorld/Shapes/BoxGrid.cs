using System.Collections.Immutable;

namespace Surefoot.DemoWorld.Shapes;

/// <summary>An upright box; metres, rounded to micrometres so that boxes meant to touch do.</summary>
internal readonly record struct Box
{
    public Box(double lowX, double lowY, double lowZ, double highX, double highY, double highZ)
    {
        Low = new(Math.Round(lowX, 6), Math.Round(lowY, 6), Math.Round(lowZ, 6));
        High = new(Math.Round(highX, 6), Math.Round(highY, 6), Math.Round(highZ, 6));
    }

    public Point3 Low { get; }

    public Point3 High { get; }

    public bool Contains(Point3 point)
        => point.X > Low.X && point.X < High.X && point.Y > Low.Y && point.Y < High.Y && point.Z > Low.Z && point.Z < High.Z;
}

/// <summary>A solid cut out of upright boxes: later boxes fill or clear what earlier ones left.</summary>
/// <remarks>All corners span a grid; what is solid is decided for each of its cells, so faces never overlap and meet exactly.</remarks>
internal sealed class BoxGrid
{
    private readonly List<(Box Box, uint Surface)> boxes = [];

    /// <summary>Adds matter with a surface.</summary>
    public BoxGrid Fill(Box box, uint surface)
    {
        boxes.Add((box, surface));
        return this;
    }

    /// <summary>Takes matter away.</summary>
    public BoxGrid Clear(Box box)
    {
        boxes.Add((box, 0));
        return this;
    }

    /// <summary>Faces of the matter, outwards, joined to rectangles as large as they go.</summary>
    public ImmutableArray<Face> Faces() => Faces((inside, outside, _, _) => inside != 0 && outside == 0 ? inside : null);

    /// <summary>
    /// Faces between what the rule tells apart. It is asked for the surfaces on the side behind and in front of a face, the face's
    /// direction (axis, and +1 or -1) and its middle, and answers the face's surface, or null for no face.
    /// </summary>
    public ImmutableArray<Face> Faces(Func<uint, uint, Direction, Point3, uint?> rule, params ReadOnlySpan<Box> extraCuts)
    {
        double[][] cuts = [.. Enumerable.Range(0, 3).Select(_ => Array.Empty<double>())];
        List<Box> all = [.. boxes.Select(entry => entry.Box), .. extraCuts];
        for (int axis = 0; axis < 3; axis++)
            cuts[axis] = [.. all.SelectMany(box => new[] { box.Low[axis], box.High[axis] }).Distinct().Order()];
        var faces = ImmutableArray.CreateBuilder<Face>();
        for (int axis = 0; axis < 3; axis++)
        {
            for (int sign = -1; sign <= 1; sign += 2)
            {
                for (int layer = 0; layer < cuts[axis].Length; layer++)
                    AddLayer(faces, cuts, new(axis, sign), layer, rule);
            }
        }

        return faces.ToImmutable();
    }

    private void AddLayer(
        ImmutableArray<Face>.Builder faces, double[][] cuts, Direction direction, int layer,
        Func<uint, uint, Direction, Point3, uint?> rule)
    {
        int axis = direction.Axis;
        double[] first = cuts[axis], second = cuts[(axis + 1) % 3], third = cuts[(axis + 2) % 3];
        double at = first[layer];
        double below = layer > 0 ? (first[layer - 1] + at) / 2 : at - 1,
            above = layer + 1 < first.Length ? (at + first[layer + 1]) / 2 : at + 1;
        var surfaces = new uint?[second.Length - 1, third.Length - 1];
        for (int i = 0; i + 1 < second.Length; i++)
        {
            for (int j = 0; j + 1 < third.Length; j++)
            {
                double u = (second[i] + second[i + 1]) / 2, v = (third[j] + third[j + 1]) / 2;
                uint low = SurfaceAt(Point3.Along(axis, below, u, v)), high = SurfaceAt(Point3.Along(axis, above, u, v));
                surfaces[i, j] = rule(direction.Sign > 0 ? low : high, direction.Sign > 0 ? high : low, direction,
                    Point3.Along(axis, at, u, v));
            }
        }

        for (int i = 0; i + 1 < second.Length; i++)
        {
            for (int j = 0; j + 1 < third.Length; j++)
            {
                if (surfaces[i, j] is not { } surface)
                    continue;
                var (endI, endJ) = Grow(surfaces, i, j, surface);
                ImmutableArray<Point3> points =
                [
                    Point3.Along(axis, at, second[i], third[j]), Point3.Along(axis, at, second[endI], third[j]),
                    Point3.Along(axis, at, second[endI], third[endJ]), Point3.Along(axis, at, second[i], third[endJ]),
                ];
                var face = new Face(points, surface);
                faces.Add(direction.Sign > 0 ? face : face.Flipped());
            }
        }
    }

    // Takes the largest rectangle of one surface that starts at (i, j): first along j, then along i.
    private static (int EndI, int EndJ) Grow(uint?[,] surfaces, int i, int j, uint surface)
    {
        int endJ = j;
        while (endJ < surfaces.GetLength(1) && surfaces[i, endJ] == surface)
            endJ++;
        int endI = i;
        while (endI < surfaces.GetLength(0) && Enumerable.Range(j, endJ - j).All(k => surfaces[endI, k] == surface))
        {
            for (int k = j; k < endJ; k++)
                surfaces[endI, k] = null;
            endI++;
        }

        return (endI, endJ);
    }

    private uint SurfaceAt(Point3 point)
    {
        for (int i = boxes.Count - 1; i >= 0; i--)
        {
            if (boxes[i].Box.Contains(point))
                return boxes[i].Surface;
        }

        return 0;
    }

    /// <summary>One of the six directions: axis 0 to 2 and sign +1 or -1.</summary>
    internal readonly record struct Direction(int Axis, int Sign);
}
