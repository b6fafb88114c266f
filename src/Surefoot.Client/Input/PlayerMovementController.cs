using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Client;

/// <summary>
/// Turns keys, pointer and time into motions of the player's body, and into what a client tells its server. Called once a frame, before the
/// world is advanced; it reads no clock and owns nothing global.
/// </summary>
/// <remarks>Retail: the input side of the client; specification 01, 4.12 and 4.15, 08, 5.6 and 09b, 9 and 10.</remarks>
public sealed class PlayerMovementController
{
    /// <summary>The pointer rests when nothing has come in for this long, seconds.</summary>
    private const double RestTime = 0.2;

    private readonly JumpKey jump;
    private readonly CommandInterpreter commands;
    private MovementKeys held;
    private double lastInput = double.NegativeInfinity;

    /// <summary>A controller of a body.</summary>
    /// <param name="body">The body.</param>
    /// <param name="movement">Its motion side, which the body already calls.</param>
    /// <param name="sender">Tells the server.</param>
    internal PlayerMovementController(IMotionBody body, MovementManager movement, MovementSender sender)
    {
        jump = new JumpKey(movement, sender);
        commands = new CommandInterpreter(body, movement, sender, jump);
    }

    /// <summary>
    /// Forward runs and <see cref="MovementKeys.Walk"/> walks; or, when false, the other way round. A change acts at once, as if the walk
    /// key were not held.
    /// </summary>
    public bool RunAsDefault
    {
        get => commands.RunAsDefault;
        set => commands.RunAsDefault = value;
    }

    /// <summary>
    /// Runs ahead without a key. Ended by the keys for ahead and back, by postures and actions, and when a server takes over.
    /// </summary>
    public bool AutoRun => commands.AutoRun;

    /// <summary>A server moves the body; the next key takes control back, and so do keys held when the server's order is done.</summary>
    public bool IsControlledByServer => commands.IsControlledByServer;

    /// <summary>Keys act; see <see cref="Disable"/>.</summary>
    public bool IsEnabled => commands.IsEnabled;

    /// <summary>The jump key is held and charges a jump.</summary>
    public bool IsChargingJump => jump.IsPending;

    /// <summary>Why the last jump was refused; none when it was not.</summary>
    public MotionError LastRefusal => jump.LastRefusal;

    /// <summary>The pointer turns the player while its right button is held; off at first.</summary>
    public bool UsesMouseTurning => commands.UsesMouse;

    /// <summary>How much it turns the player.</summary>
    public MouseTurning MouseTurning { get; } = new();

    /// <summary>Charge of the jump under way, 0 to 1; 0 without one.</summary>
    /// <param name="now">Seconds.</param>
    public float JumpLevel(double now) => jump.Level(now);

    /// <summary>A frame of input.</summary>
    /// <param name="keys">Keys held now. Unknown bits are ignored.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Update(MovementKeys keys, double now)
    {
        ThrowIfNotFinite(now);
        MovementKeys changed = keys ^ held;
        held = keys;
        if (changed != MovementKeys.None) HandleKeys(changed, now);
        if (commands.IsLooking && commands.IsEnabled && now - lastInput > RestTime)
        {
            commands.RestMouse(now);
            TurnByMouse(0f, now);
        }

        commands.UseTime(now);
    }

    /// <summary>
    /// Runs ahead without a key, or stops doing so. It runs whatever the walk key says, which still decides how fast the player turns.
    /// </summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void SetAutoRun(bool on, double now)
    {
        ThrowIfNotFinite(now);
        commands.HandleAutoRun(on, now);
    }

    /// <summary>Takes a posture or does an action (an emote), as a key for it would. An action stops everything else first.</summary>
    /// <param name="motion">The motion; none that is bound to <see cref="MovementKeys"/>.</param>
    /// <param name="now">Seconds.</param>
    /// <returns>Why it was refused; none when it was not.</returns>
    /// <exception cref="ArgumentException">The time is not finite, or the motion is bound to keys; nothing has changed.</exception>
    public MotionError Perform(MotionCommand motion, double now)
    {
        ThrowIfNotFinite(now);
        if (commands.IsHeld(motion)) throw new ArgumentException($"{motion} lasts as long as its key is held.", nameof(motion));
        return commands.HandleKey(motion, down: true, now);
    }

    /// <summary>
    /// Stops everything, what the keys asked for and autorun included, and says so. The escape key does; so do attacks and spells, but only
    /// while the player is in control.
    /// </summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void StopCompletely(double now)
    {
        ThrowIfNotFinite(now);
        commands.StopCompletely(now);
    }

    /// <summary>
    /// Gives up a jump that is being charged: a chat entry opens, the escape key, an attack. Nothing is sent, and the key's release does
    /// nothing.
    /// </summary>
    public void AbortJump() => jump.Finish();

    /// <summary>
    /// The keyboard belongs to somebody else: every key counts as let go, and a jump under way is given up. Autorun goes on.
    /// </summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void LoseKeyboardFocus(double now)
    {
        ThrowIfNotFinite(now);
        held = MovementKeys.None;
        commands.LoseKeyboardFocus(now);
    }

    /// <summary>The input ends, as at logging off: every key counts as let go, none acts any more, and no position is told.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Disable(double now)
    {
        ThrowIfNotFinite(now);
        commands.Disable(now);
    }

    /// <summary>Keys act again, from their next change on.</summary>
    public void Enable() => commands.Enable();

    /// <summary>Switches turning by the pointer on or off.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void UseMouseTurning(bool on, double now)
    {
        ThrowIfNotFinite(now);
        commands.UseMouse(on, now);
    }

    /// <summary>The pointer's buttons. The right one turns the player by the pointer; both together run ahead.</summary>
    /// <param name="left">The left button is held.</param>
    /// <param name="right">The right button is held.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void SetMouseButtons(bool left, bool right, double now)
    {
        ThrowIfNotFinite(now);
        lastInput = now;
        commands.HandleLeftButton(left, now);
        commands.HandleLook(right, now);
    }

    /// <summary>The pointer moved. It turns the player while the right button is held, from the sixth movement in a row on.</summary>
    /// <param name="counts">How far to the right, in counts of the pointer.</param>
    /// <param name="now">Seconds.</param>
    /// <exception cref="ArgumentException">A number is not finite; nothing has changed.</exception>
    public void MoveMouse(float counts, double now)
    {
        ThrowIfNotFinite(now);
        if (!float.IsFinite(counts)) throw new ArgumentException("The movement is not finite.", nameof(counts));
        lastInput = now;
        if (commands.IsLooking && commands.IsEnabled) TurnByMouse(counts, now);
    }

    /// <summary>The body was teleported: the server is told what is asked of it there.</summary>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void OnTeleported(double now)
    {
        ThrowIfNotFinite(now);
        commands.HandleTeleport(now);
    }

    /// <summary>The body does what a server ordered; the keys wait until that is done.</summary>
    internal void LoseControlToServer() => commands.LoseControlToServer();

    /// <summary>Keys that changed within one frame are taken in this order.</summary>
    private void HandleKeys(MovementKeys changed, double now)
    {
        lastInput = now;
        if ((changed & MovementKeys.Walk) != 0) commands.HandleWalkKey(IsDown(MovementKeys.Walk));
        if ((changed & MovementKeys.HoldSidestep) != 0) commands.HandleSidestepKey(IsDown(MovementKeys.HoldSidestep), now);
        HandleKey(changed, MovementKeys.Forward, MotionCommand.WalkForward, now);
        HandleKey(changed, MovementKeys.Back, MotionCommand.WalkBackwards, now);
        HandleKey(changed, MovementKeys.SidestepLeft, MotionCommand.SideStepLeft, now);
        HandleKey(changed, MovementKeys.SidestepRight, MotionCommand.SideStepRight, now);
        HandleKey(changed, MovementKeys.TurnLeft, MotionCommand.TurnLeft, now);
        HandleKey(changed, MovementKeys.TurnRight, MotionCommand.TurnRight, now);
        if ((changed & MovementKeys.Jump) == 0 || !commands.IsEnabled) return;
        if (IsDown(MovementKeys.Jump)) jump.Press(now);
        else jump.Release(now);
    }

    private void HandleKey(MovementKeys changed, MovementKeys key, MotionCommand command, double now)
    {
        if ((changed & key) != 0) commands.HandleKey(command, IsDown(key), now);
    }

    private bool IsDown(MovementKeys key) => (held & key) != 0;

    private void TurnByMouse(float counts, double now)
    {
        if (MouseTurning.Filter(counts, now, out float turn)) commands.TurnByMouse(turn, now);
    }

    internal static void ThrowIfNotFinite(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
    }
}
