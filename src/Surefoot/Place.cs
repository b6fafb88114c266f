using System.Globalization;
using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot;

/// <summary>Where a player is put.</summary>
/// <param name="Position">The place: metres from the corner of its landblock. Outdoors its cell is put right for them.</param>
/// <param name="OnGround">It lies on the ground, at whatever height that is there.</param>
public readonly record struct Place(Position Position, bool OnGround = false)
{
    private const int FullCount = 7;

    private const string Forms = "a place is a cell and metres: 0xA9B40001,12,12,0, with a heading in degrees 0xA9B40001,12,12,0,90, "
        + "on the ground outdoors 0xA9B40001,12,12, or as the game prints it 0xA9B40001 [12 12 0] 1 0 0 0";

    /// <summary>A place that is given in full.</summary>
    public static implicit operator Place(Position position) => new(position);

    /// <summary>
    /// Reads a cell id and numbers, separated by commas, spaces or brackets: x, y for a place on the ground; x, y, z; x, y, z and a heading
    /// in degrees; or x, y, z and a rotation w, x, y, z, which is what the game prints for <c>/loc</c>.
    /// </summary>
    /// <exception cref="FormatException">It is none of these; the message shows what is.</exception>
    public static Place Parse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        string[] parts = text.Split([',', ' ', '[', ']'], StringSplitOptions.RemoveEmptyEntries);
        if (parts.Length is not (3 or 4 or 5 or 8) || !TryParseCell(parts[0], out uint cell)) throw Refusal(text, Forms);
        Span<float> numbers = stackalloc float[FullCount];
        for (int i = 1; i < parts.Length; i++)
        {
            bool isNumber = float.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i - 1]);
            if (!isNumber || !float.IsFinite(numbers[i - 1])) throw Refusal(text, $"{parts[i]} is not a finite number; {Forms}");
        }

        bool onGround = parts.Length == 3;
        if ((cell & 0xFFFF) >= 0xFFFE)
        {
            uint example = (cell & 0xFFFF0000) | 1;
            throw Refusal(text,
                $"0x{cell:X8} is the id of a landblock's record, not of a cell: give one of its cells, for example 0x{example:X8}");
        }

        if (!CellIds.HasValidIndex(cell))
            throw Refusal(text, $"0x{cell:X8} cannot name a cell: its low half is 0001 to 0040 outdoors, 0100 to FFFD indoors");
        if (onGround && !CellIds.IsOutdoor(cell)) throw Refusal(text, $"a place in a room needs its height, as in 0x{cell:X8},12,12,0");
        Frame frame = FrameOf(numbers, parts.Length - 1);
        if (!frame.IsValid) throw Refusal(text, $"the rotation is not a unit quaternion; {Forms}");
        return new Place(new Position(cell, frame), onGround);
    }

    /// <summary>The cell and the metres, in the form that <see cref="Parse"/> reads.</summary>
    public override string ToString()
    {
        Vector3 o = Position.Frame.Origin;
        string height = OnGround ? "" : FormattableString.Invariant($",{o.Z}");
        return FormattableString.Invariant($"0x{Position.CellId:X8},{o.X},{o.Y}{height}");
    }

    private static FormatException Refusal(string text, string why) => new($"'{text}': {why}.");

    private static bool TryParseCell(string text, out uint cell)
    {
        cell = 0;
        return text.StartsWith("0x", StringComparison.OrdinalIgnoreCase)
            && uint.TryParse(text.AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out cell);
    }

    private static Frame FrameOf(ReadOnlySpan<float> numbers, int count)
    {
        Vector3 origin = new(numbers[0], numbers[1], numbers[2]);
        Quaternion rotation = new(numbers[4], numbers[5], numbers[6], numbers[3]);
        // One that is a unit already, as far as floats tell, is the one that was meant.
        bool isUnit = Math.Abs(rotation.LengthSquared() - 1f) < 1e-6f;
        if (count == FullCount) return new Frame(origin, isUnit ? rotation : Quaternion.Normalize(rotation));
        Frame frame = new(origin, Quaternion.Identity);
        if (count == 4) frame.SetHeading(numbers[3]);
        return frame;
    }
}
