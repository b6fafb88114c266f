namespace Surefoot.Protocol.Session;

/// <summary>How far a client's session has come.</summary>
public enum SessionState
{
    /// <summary>Nothing has been sent.</summary>
    Idle,

    /// <summary>The server is asked for a session.</summary>
    Connecting,

    /// <summary>The server has answered; it checks the password.</summary>
    LoggingIn,

    /// <summary>The account's characters are known; one can be made or entered.</summary>
    CharacterSelect,

    /// <summary>A character is about to enter the world.</summary>
    Entering,

    /// <summary>A character is in the world.</summary>
    InWorld,

    /// <summary>The character is leaving the world.</summary>
    LoggingOff,

    /// <summary>The session was ended by its owner.</summary>
    Closed,

    /// <summary>The session ended by itself: <see cref="ClientSession.Failure"/> says why.</summary>
    Failed,
}
