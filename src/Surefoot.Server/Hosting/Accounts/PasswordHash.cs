using System.Globalization;
using System.Security.Cryptography;

namespace Surefoot.Server;

/// <summary>Salted hashes of passwords: PBKDF2 with SHA-512, as text that carries its salt and its number of rounds.</summary>
internal static class PasswordHash
{
    /// <summary>Rounds of a hash that is kept in a file, as OWASP advises for this function.</summary>
    public const int FileRounds = 210_000;

    /// <summary>Rounds of a hash that no file has.</summary>
    public const int MemoryRounds = 1000;

    private const string Scheme = "pbkdf2-sha512";
    private const int SaltSize = 16, HashSize = 32, MostRounds = 10_000_000;

    /// <summary>Makes a hash with a new salt.</summary>
    public static string Make(string password, int rounds)
    {
        byte[] salt = RandomNumberGenerator.GetBytes(SaltSize);
        byte[] hash = Rfc2898DeriveBytes.Pbkdf2(password, salt, rounds, HashAlgorithmName.SHA512, HashSize);
        return string.Create(
            CultureInfo.InvariantCulture, $"{Scheme}${rounds}${Convert.ToBase64String(salt)}${Convert.ToBase64String(hash)}");
    }

    /// <summary>It is a text that <see cref="Make"/> could have made.</summary>
    public static bool IsWellFormed(string text) => TryParse(text, out _, out _, out _);

    /// <summary>The password is the one of the hash. Takes as long for a wrong one.</summary>
    public static bool Fits(string password, string text) => TryParse(text, out int rounds, out byte[] salt, out byte[] hash)
        && CryptographicOperations.FixedTimeEquals(
            Rfc2898DeriveBytes.Pbkdf2(password, salt, rounds, HashAlgorithmName.SHA512, hash.Length), hash);

    private static bool TryParse(string text, out int rounds, out byte[] salt, out byte[] hash)
    {
        string[] parts = text.Split('$');
        (rounds, salt, hash) = (0, [], []);
        if (parts.Length != 4 || parts[0] != Scheme) return false;
        if (!int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out rounds) || rounds is < 1 or > MostRounds)
            return false;
        try
        {
            (salt, hash) = (Convert.FromBase64String(parts[2]), Convert.FromBase64String(parts[3]));
        }
        catch (FormatException)
        {
            return false;
        }

        return salt.Length > 0 && hash.Length == HashSize;
    }
}
