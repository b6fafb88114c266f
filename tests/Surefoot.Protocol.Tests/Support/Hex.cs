namespace Surefoot.Protocol.Tests.Support;

/// <summary>Bytes as the specification prints them.</summary>
internal static class Hex
{
    /// <summary>The bytes of lines of hexadecimal pairs; a line's offset before two spaces is left out.</summary>
    public static byte[] Bytes(string text) => Convert.FromHexString(string.Concat(
        text.Split('\n').Select(line => line.IndexOf("  ", StringComparison.Ordinal) is > 0 and var gap ? line[gap..] : line))
        .Replace(" ", "", StringComparison.Ordinal).Replace("\r", "", StringComparison.Ordinal));

    /// <summary>As the specification prints bytes.</summary>
    public static string Of(ReadOnlySpan<byte> bytes) => Convert.ToHexString(bytes);
}
