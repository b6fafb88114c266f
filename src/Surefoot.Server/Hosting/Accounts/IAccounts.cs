namespace Surefoot.Server;

/// <summary>What comes of a login.</summary>
public enum AccountVerdict
{
    /// <summary>The account may come in.</summary>
    Welcome,

    /// <summary>It may come in, and give commands.</summary>
    Administrator,

    /// <summary>The password is another one.</summary>
    WrongPassword,

    /// <summary>There is no such account.</summary>
    Unknown,
}

/// <summary>The accounts of a server.</summary>
public interface IAccounts
{
    /// <summary>A check takes so long that a world must not wait for it: it is made on a thread of its own, one check at a time.</summary>
    bool IsSlow { get; }

    /// <summary>Checks a login.</summary>
    /// <param name="account">The name, in lower case.</param>
    /// <param name="password">The password.</param>
    AccountVerdict Check(string account, string password);
}
