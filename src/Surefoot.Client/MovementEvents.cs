using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client;

/// <summary>The player's keys changed what is asked of the body.</summary>
/// <param name="Time">When, seconds.</param>
/// <param name="State">What is asked: commands as the keys name them, forward speed 1, the hold key. Belongs to the receiver.</param>
/// <param name="Position">Where the body is.</param>
/// <param name="Contact">It stands on the ground.</param>
/// <param name="StandingLongJump">It charges a standing long jump.</param>
/// <remarks>Message 0xF61C; specification 08, 5.3.</remarks>
public readonly record struct MoveToStateEvent(double Time, RawMotionState State, Position Position, bool Contact, bool StandingLongJump);

/// <summary>The body jumped.</summary>
/// <param name="Time">When, seconds.</param>
/// <param name="Extent">Charge, 0.001 to 1.</param>
/// <param name="Velocity">Velocity after the jump in the body's own axes, m/s.</param>
/// <param name="Position">Where the body is.</param>
/// <remarks>Message 0xF61B; specification 08, 5.4.</remarks>
public readonly record struct JumpEvent(double Time, float Extent, Vector3 Velocity, Position Position);

/// <summary>Where the body is, told now and then while it stands.</summary>
/// <param name="Time">When, seconds.</param>
/// <param name="Position">Where the body is.</param>
/// <param name="Contact">It stands on the ground; always true, since nothing is sent from the air.</param>
/// <remarks>Message 0xF753; specification 08, 5.5.</remarks>
public readonly record struct AutonomousPositionEvent(double Time, Position Position, bool Contact);

/// <summary>Receives what a client would send to its server.</summary>
public interface IMovementSink
{
    /// <summary>What is asked of the body changed.</summary>
    void OnMoveToState(in MoveToStateEvent e);

    /// <summary>The body jumped.</summary>
    void OnJump(in JumpEvent e);

    /// <summary>Where the body is.</summary>
    void OnAutonomousPosition(in AutonomousPositionEvent e);
}

/// <summary>A server says what a body does.</summary>
/// <param name="State">What it does.</param>
/// <param name="Autonomous">Its own player asked for it; else the server did.</param>
/// <param name="StandingLongJump">It charges a standing long jump.</param>
/// <remarks>Message 0xF74C with movement type 0; specification 08, 6.4.</remarks>
public readonly record struct UpdateMotionEvent(InterpretedMotionState State, bool Autonomous, bool StandingLongJump = false);

/// <summary>A server says what numbers the player's character has, and which run rate follows.</summary>
/// <param name="Stats">The numbers.</param>
/// <param name="RunRate">Factor on the running speed of 4 m/s.</param>
/// <remarks>Stands for the character messages of specification 08, section 7.</remarks>
public readonly record struct CharacterUpdateEvent(CharacterStats Stats, float RunRate);

/// <summary>Receives what a server says of the local player.</summary>
public interface IServerMessageHandler
{
    /// <summary>What the body does.</summary>
    void HandleUpdateMotion(in UpdateMotionEvent message);

    /// <summary>What numbers the character has.</summary>
    void HandleCharacterUpdate(in CharacterUpdateEvent message);
}
