using System.Text.Json;

namespace Surefoot.Server;

/// <summary>
/// A file of accounts: JSON, a list of names with salted hashes of their passwords (PBKDF2, SHA-512). Who is not in it does not come in.
/// </summary>
/// <remarks>Changes of the file hold from the next start of a server on.</remarks>
public sealed class AccountFile : IAccounts
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    private readonly string path;
    private readonly Dictionary<string, Entry> entries = [];

    private AccountFile(string path) => this.path = path;

    /// <inheritdoc/>
    public bool IsSlow => true;

    /// <summary>How many accounts there are.</summary>
    public int Count => entries.Count;

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="InvalidDataException">It is no file of accounts.</exception>
    public static AccountFile Read(string path)
    {
        AccountFile file = new(path);
        try
        {
            foreach (Entry entry in JsonSerializer.Deserialize<List<Entry>>(File.ReadAllText(path), Json) ?? [])
            {
                if (!IsName(entry.Name) || !PasswordHash.IsWellFormed(entry.Hash) || !file.entries.TryAdd(Key(entry.Name), entry))
                    throw new InvalidDataException($"{path}: the account '{entry.Name}' is there twice, or its name or hash is none.");
            }
        }
        catch (JsonException error)
        {
            throw new InvalidDataException($"{path} is no list of accounts: {error.Message}", error);
        }

        return file;
    }

    /// <summary>Reads a file, or begins one that is not there yet.</summary>
    /// <inheritdoc cref="Read"/>
    public static AccountFile ReadOrBegin(string path) => File.Exists(path) ? Read(path) : new AccountFile(path);

    /// <summary>Puts an account in, or gives it another password, and writes the file.</summary>
    /// <param name="account">Its name: 1 to 50 printable characters of ASCII. Upper and lower case are the same.</param>
    /// <param name="password">Its password: 1 to 127 printable characters of ASCII, as clients can send.</param>
    /// <param name="administrator">It may give commands.</param>
    /// <exception cref="ArgumentException">Name or password is none; nothing has changed.</exception>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public void Set(string account, string password, bool administrator)
    {
        if (!IsName(account)) throw new ArgumentException("An account name has 1 to 50 printable characters of ASCII.", nameof(account));
        if (password.Length is 0 or > Surefoot.Protocol.Session.LoginRequest.MostPassword || !password.All(IsPrintable))
            throw new ArgumentException("A password has 1 to 127 printable characters of ASCII.", nameof(password));
        entries[Key(account)] = new Entry(Key(account), PasswordHash.Make(password, PasswordHash.FileRounds), administrator);
        string unfinished = $"{path}.{Guid.NewGuid():N}.tmp";
        File.WriteAllText(unfinished, JsonSerializer.Serialize(entries.Values.OrderBy(entry => entry.Name, StringComparer.Ordinal), Json));
        if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(unfinished, UnixFileMode.UserRead | UnixFileMode.UserWrite);
        File.Move(unfinished, path, overwrite: true);
    }

    /// <inheritdoc/>
    public AccountVerdict Check(string account, string password)
    {
        if (!entries.TryGetValue(account, out Entry? entry)) return AccountVerdict.Unknown;
        if (!PasswordHash.Fits(password, entry.Hash)) return AccountVerdict.WrongPassword;
        return entry.Administrator ? AccountVerdict.Administrator : AccountVerdict.Welcome;
    }

    internal static string Key(string account) => account.ToLowerInvariant();

    internal static bool IsName(string? account) =>
        account is { Length: > 0 and <= Surefoot.Protocol.Session.LoginRequest.MostAccount } &&
        account.All(IsPrintable);

    private static bool IsPrintable(char letter) => letter is >= ' ' and < '\x7F';

    private sealed record Entry(string Name, string Hash, bool Administrator);
}
