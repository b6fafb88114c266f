namespace Surefoot.Dats;

/// <summary>The text of a pstring. The five bytes without a character stand for U+0081 and so on, so that any bytes round-trip.</summary>
internal static class Windows1252
{
    // Characters of the bytes 0x80 to 0x9F; all others are their own code points.
    private const string High =
        "\u20AC\u0081\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\u008D\u017D\u008F"
        + "\u0090\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\u009D\u017E\u0178";

    public static char Decode(byte value) => value is >= 0x80 and <= 0x9F ? High[value - 0x80] : (char)value;

    public static bool TryEncode(char character, out byte value)
    {
        if (character is < '\u0080' or (>= '\u00A0' and <= '\u00FF'))
        {
            value = (byte)character;
            return true;
        }

        int index = High.IndexOf(character, StringComparison.Ordinal);
        value = (byte)(0x80 + index);
        return index >= 0;
    }
}
