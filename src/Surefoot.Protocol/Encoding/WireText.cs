using System.Text;

namespace Surefoot.Protocol;

/// <summary>The text of the wire: Windows-1252, a character a byte. A character that it lacks is written as '?'.</summary>
internal static class WireText
{
    /// <summary>The code page. Its five bytes without a character stand for U+0081 and so on, so that any bytes round-trip.</summary>
    public static readonly System.Text.Encoding CodePage = CodePagesEncodingProvider.Instance.GetEncoding(
        1252, EncoderFallback.ReplacementFallback, DecoderFallback.ReplacementFallback)!;

    /// <summary>Every character is printable ASCII: what account names and passwords are kept to (specification 08, 10).</summary>
    public static bool IsPlain(string text)
    {
        foreach (char character in text)
        {
            if (character is < ' ' or > '~')
                return false;
        }

        return true;
    }
}
