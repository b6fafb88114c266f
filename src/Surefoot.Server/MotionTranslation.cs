using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>What everybody is told of what a player's keys ask: normalised commands, to the right and ahead only, with the server's own
/// speeds.</summary>
/// <remarks>Specification 08, 8.8.</remarks>
public static class MotionTranslation
{
    private const float BackwardsFactor = -0.65f;
    private const float SidestepFactor = (float)(MovementFormulas.WalkSpeed / (double)MovementFormulas.SidestepSpeed * 0.5);
    private const float MaxSidestep = 3f;
    private const float RunTurnSpeed = 1.5f;
    private const uint NonCombat = (uint)MotionCommand.NonCombat;

    /// <summary>Translates what is asked. Running is decided by the hold key of the whole state; those of the single commands are not
    /// looked at.</summary>
    /// <param name="raw">What is asked.</param>
    /// <param name="runRate">Factor on the running speed, as the server has it.</param>
    /// <param name="standingLongJump">A standing long jump is being charged: the body stands, whatever is asked.</param>
    /// <param name="actions">The one-shot motions that are passed on, with the server's stamps.</param>
    /// <returns>A movement of type 0. What was not asked is left out, and so are speeds of 1 and the peaceful style.</returns>
    public static MovementData Interpret(in WireRawMotion raw, float runRate, bool standingLongJump, in MotionActions actions = default)
    {
        bool run = raw.CurrentHoldKey == (uint)HoldKey.Run;
        float rate = run ? runRate : 1f;
        ushort? style = raw.CurrentStyle == NonCombat ? null : (ushort)raw.CurrentStyle;
        Part forward = standingLongJump ? default : ForwardOf(raw, run, rate);
        Part sidestep = standingLongJump ? default : SidestepOf(raw, rate);
        Part turn = TurnOf(raw, run);
        WireInterpretedMotion state = new(
            style, forward.Command, forward.Speed, sidestep.Command, sidestep.Speed, turn.Command, turn.Speed, actions);
        return MovementData.Motion(style ?? 0, state, standingLongJump: standingLongJump);
    }

    private static Part ForwardOf(in WireRawMotion raw, bool run, float rate) => (MotionCommand)raw.ForwardCommand switch
    {
        MotionCommand.Ready => default,
        MotionCommand.WalkForward => Part.Of(run ? MotionCommand.RunForward : MotionCommand.WalkForward, rate),
        MotionCommand.WalkBackwards => Part.Of(MotionCommand.WalkForward, (float)((double)rate * BackwardsFactor)),
        MotionCommand other => Part.Of(other, 1f),
    };

    private static Part SidestepOf(in WireRawMotion raw, float rate)
    {
        float speed = Math.Clamp((float)((double)rate * SidestepFactor), -MaxSidestep, MaxSidestep);
        return (MotionCommand)raw.SidestepCommand switch
        {
            MotionCommand.SideStepRight => Part.Of(MotionCommand.SideStepRight, speed),
            MotionCommand.SideStepLeft => Part.Of(MotionCommand.SideStepRight, -speed),
            _ => default,
        };
    }

    private static Part TurnOf(in WireRawMotion raw, bool run)
    {
        // A speed of 1 does not travel: the server puts its own in its place.
        bool own = raw.TurnSpeed is not (0f or 1f) and > float.NegativeInfinity and <= RunTurnSpeed;
        float speed = own ? raw.TurnSpeed : run ? RunTurnSpeed : 1f;
        return (MotionCommand)raw.TurnCommand switch
        {
            MotionCommand.TurnRight => Part.Of(MotionCommand.TurnRight, speed),
            MotionCommand.TurnLeft => Part.Of(MotionCommand.TurnRight, -speed),
            _ => default,
        };
    }

    /// <summary>A command and its speed, each only when it is sent.</summary>
    private readonly record struct Part(ushort? Command, float? Speed)
    {
        public static Part Of(MotionCommand command, float speed) => new((ushort)command, speed == 1f ? null : speed);
    }
}
