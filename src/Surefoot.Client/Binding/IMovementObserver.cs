using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>Looks on at what the local player tells its server; each message has been sent already.</summary>
public interface IMovementObserver
{
    /// <summary>What is asked of the body changed.</summary>
    /// <param name="message">The message.</param>
    /// <param name="now">When, seconds.</param>
    void OnMoveToState(in MoveToState message, double now)
    {
    }

    /// <summary>The body jumped.</summary>
    /// <param name="message">The message.</param>
    /// <param name="now">When, seconds.</param>
    void OnJump(in Jump message, double now)
    {
    }

    /// <summary>Where the body is.</summary>
    /// <param name="message">The message.</param>
    /// <param name="now">When, seconds.</param>
    void OnAutonomousPosition(in AutonomousPosition message, double now)
    {
    }
}
