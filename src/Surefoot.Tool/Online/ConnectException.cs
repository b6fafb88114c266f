using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Online;

/// <summary>A stay on a server that did not come about, or ended by itself.</summary>
/// <param name="message">One sentence.</param>
/// <param name="exitCode">What the process returns.</param>
internal sealed class ConnectException(string message, int exitCode) : Exception(message)
{
    internal int ExitCode { get; } = exitCode;

    /// <summary>What a session says when it ends by itself.</summary>
    internal static ConnectException Of(SessionFailure failure, bool wasInWorld) => new(failure.Sentence, failure.Kind switch
    {
        SessionFailureKind.NoAnswer or SessionFailureKind.Silent => Tool.ExitCode.NoServer,
        SessionFailureKind.VersionRefused => Tool.ExitCode.VersionRefused,
        SessionFailureKind.LoginRefused or SessionFailureKind.AccountUnknown or SessionFailureKind.AccountBanned =>
            Tool.ExitCode.AccountRefused,
        SessionFailureKind.AccountInUse or SessionFailureKind.CharacterInWorld => Tool.ExitCode.InUse,
        SessionFailureKind.CharacterRefused => Tool.ExitCode.CharacterRefused,
        SessionFailureKind.ServerFull or SessionFailureKind.ServerClosing => Tool.ExitCode.ServerClosed,
        _ when wasInWorld => Tool.ExitCode.SessionLost,
        _ => Tool.ExitCode.AccountRefused,
    });
}
