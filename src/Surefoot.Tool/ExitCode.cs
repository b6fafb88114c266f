namespace Surefoot.Tool;

/// <summary>What the process returns.</summary>
internal static class ExitCode
{
    /// <summary>Done.</summary>
    internal const int Done = 0;

    /// <summary>The thing asked for failed.</summary>
    internal const int Failed = 1;

    /// <summary>Wrong usage.</summary>
    internal const int Usage = 2;

    /// <summary>No server answers, or it has fallen silent.</summary>
    internal const int NoServer = 3;

    /// <summary>The server does not let the account in: wrong password, unknown or banned.</summary>
    internal const int AccountRefused = 4;

    /// <summary>The server wants another version of the client.</summary>
    internal const int VersionRefused = 5;

    /// <summary>The account, or the character, is in use.</summary>
    internal const int InUse = 6;

    /// <summary>There is no such character, it cannot be made, or it cannot be entered.</summary>
    internal const int CharacterRefused = 7;

    /// <summary>The server is full, closed or going down.</summary>
    internal const int ServerClosed = 8;

    /// <summary>The session ended in the world.</summary>
    internal const int SessionLost = 9;

    /// <summary>The dat files are not those of the server's world: the player has no shape or no ground there.</summary>
    internal const int WrongDats = 10;
}

/// <summary>The command line asks for something that cannot be: the message says what, and how it is done right.</summary>
internal sealed class UsageException(string message) : Exception(message);
