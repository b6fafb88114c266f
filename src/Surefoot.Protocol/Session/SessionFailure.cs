namespace Surefoot.Protocol.Session;

/// <summary>Why a session ended, or a wish was refused.</summary>
public enum SessionFailureKind
{
    /// <summary>Nobody answers.</summary>
    NoAnswer,

    /// <summary>The server has fallen silent.</summary>
    Silent,

    /// <summary>The server wants another version of the client.</summary>
    VersionRefused,

    /// <summary>The server does not let the account in, most often because of a wrong password.</summary>
    LoginRefused,

    /// <summary>The account is in use; the older session is ended too.</summary>
    AccountInUse,

    /// <summary>The account's name cannot be one, or is not known.</summary>
    AccountUnknown,

    /// <summary>The account is banned.</summary>
    AccountBanned,

    /// <summary>The server is full or closed.</summary>
    ServerFull,

    /// <summary>The server is going down.</summary>
    ServerClosing,

    /// <summary>The server threw the account out.</summary>
    Booted,

    /// <summary>The server closed the session without a word.</summary>
    ClosedByServer,

    /// <summary>The character is still in the world; it leaves it in a few seconds.</summary>
    CharacterInWorld,

    /// <summary>The character cannot be entered.</summary>
    CharacterRefused,
}

/// <summary>Why a session ended, or a wish was refused.</summary>
/// <param name="Kind">What kind of failure.</param>
/// <param name="Sentence">One sentence for whoever sits in front of it.</param>
public sealed record SessionFailure(SessionFailureKind Kind, string Sentence)
{
    /// <summary>What a number of <see cref="Messages.CharacterError"/> says (specification 08, 3.5).</summary>
    internal static SessionFailure OfCode(uint code) => code switch
    {
        1 => new(SessionFailureKind.AccountInUse, "The account is in use; both sessions were ended: wait four seconds and try again."),
        4 => new(SessionFailureKind.ServerClosing, "The server is going down."),
        9 => new(SessionFailureKind.AccountUnknown, "The server does not take this account name."),
        0x0A => new(SessionFailureKind.AccountUnknown, "The server does not know this account."),
        0x0B => new(SessionFailureKind.CharacterRefused, "The server does not know this character."),
        0x0D => new(SessionFailureKind.CharacterInWorld, "The character is still in the world: try again in a few seconds."),
        0x0F => new(SessionFailureKind.CharacterRefused, "The character is another account's, or is being deleted."),
        0x14 => new(SessionFailureKind.CharacterRefused, "The server cannot place the character."),
        0x15 => new(SessionFailureKind.ServerFull, "The server is full or closed."),
        _ => new(SessionFailureKind.LoginRefused, $"The server refused with error 0x{code:X2}."),
    };

    /// <summary>A refusal of the character alone: the session goes on.</summary>
    internal static bool IsAboutCharacter(uint code) => code is 0x0B or 0x0D or 0x0F or 0x14 or 0x15;
}
