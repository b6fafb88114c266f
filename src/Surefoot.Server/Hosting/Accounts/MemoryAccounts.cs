namespace Surefoot.Server;

/// <summary>Accounts that are made at their first login, with its password, and are gone with the server.</summary>
internal sealed class MemoryAccounts : IAccounts
{
    /// <summary>Strangers must not fill the memory.</summary>
    private const int Most = 10_000;

    private readonly Dictionary<string, string> hashes = [];

    public bool IsSlow => false;

    public AccountVerdict Check(string account, string password)
    {
        if (hashes.TryGetValue(account, out string? hash))
            return PasswordHash.Fits(password, hash) ? AccountVerdict.Welcome : AccountVerdict.WrongPassword;
        if (password.Length == 0 || hashes.Count >= Most) return AccountVerdict.Unknown;
        hashes.Add(account, PasswordHash.Make(password, PasswordHash.MemoryRounds));
        return AccountVerdict.Welcome;
    }
}
