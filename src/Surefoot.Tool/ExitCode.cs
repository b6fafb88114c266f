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
}

/// <summary>The command line asks for something that cannot be: the message says what, and how it is done right.</summary>
internal sealed class UsageException(string message) : Exception(message);
