using System.Numerics;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>The interpreter when its body comes into the world and leaves it, and the numbers of its refusals.</summary>
public class WorldAndErrorTests
{
    [Theory]
    [Behaviour("motion.errors.numbers", "spec/01, 3: errors; 09, 3.3 and 5.3; 09b, 6.7; 01b, 3")]
    [InlineData(0x00, "None")]
    [InlineData(0x07, "NoAnimationTable")]
    [InlineData(0x08, "NoBody")]
    [InlineData(0x0B, "NoInterpreter")]
    [InlineData(0x24, "NotOnGround")]
    [InlineData(0x36, "Cancelled")]
    [InlineData(0x37, "TargetGone")]
    [InlineData(0x38, "NoTarget")]
    [InlineData(0x3D, "ChargedTooFar")]
    [InlineData(0x3F, "NoCrouchInCombat")]
    [InlineData(0x40, "NoSitInCombat")]
    [InlineData(0x41, "NoSleepInCombat")]
    [InlineData(0x42, "NoEmoteInCombat")]
    [InlineData(0x43, "NoMotionData")]
    [InlineData(0x45, "TooManyActions")]
    [InlineData(0x47, "GeneralFailure")]
    [InlineData(0x48, "CannotJumpFromThisPosition")]
    [InlineData(0x49, "TooLoadedToJump")]
    public void A_refusal_has_retails_number(int number, string name) => Assert.Equal(number, (int)Enum.Parse<MotionError>(name));

    [Fact]
    [Behaviour("motion.enter-default-state", "spec/01, 4.13; CMotionInterp::enter_default_state @0x00528C80")]
    public void Entering_the_default_state_forgets_what_was_asked_and_leaves_the_ground()
    {
        FakeBody body = new() { LocalVelocity = new Vector3(0, 0, -3) };
        MotionInterpreter interpreter = new(new MotionTableManager(HumanoidTable.Create()), body, FakeBody.Player());
        interpreter.Raw.ForwardCommand = MotionCommand.WalkForward;
        interpreter.Interpreted.ForwardCommand = MotionCommand.RunForward;
        Assert.False(interpreter.IsInitialised);
        interpreter.EnterDefaultState();
        Assert.True(interpreter.IsInitialised);
        Assert.Equal((MotionCommand.Ready, MotionCommand.Ready), (interpreter.Raw.ForwardCommand, interpreter.Interpreted.ForwardCommand));
        Assert.Equal(MotionCommand.Ready, interpreter.Animation!.Substate);
        Assert.Equal((MotionCommand.Ready, MotionError.None), (interpreter.GetPending(0).Motion, interpreter.GetPending(0).JumpError));

        // Its motion has no velocity: the body keeps the one that it has (4.12).
        Assert.Equal(new Vector3(0, 0, -3), body.LocalVelocity);
    }

    [Fact]
    [Behaviour("motion.exit-world", "spec/01, 4.10; spec/09b, 11: with the same side effects as MotionDone")]
    public void Leaving_the_world_ends_what_is_pending_and_an_action_lets_go_of_what_the_body_sticks_to()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(FakeBody.Player(), HumanoidTable.Create(links: true));
        interpreter.DoMotion(MotionCommand.TurnRight, new MovementParameters());
        interpreter.StopMotion(MotionCommand.TurnRight, new MovementParameters());
        interpreter.HandleExitWorld();
        Assert.False(interpreter.MotionsPending || body.Unstuck);

        interpreter.DoMotion(HumanoidTable.Bow, new MovementParameters());
        Assert.Equal((1, 1), (interpreter.Raw.ActionCount, interpreter.Interpreted.ActionCount));
        interpreter.HandleExitWorld();
        Assert.True(body.Unstuck && !interpreter.MotionsPending);
        Assert.Equal((0, 0), (interpreter.Raw.ActionCount, interpreter.Interpreted.ActionCount));
    }

    [Fact]
    [Behaviour("motion.jump.weenie-refuses-the-cost", "spec/01, 4.12: weenie's JumpStaminaCost fails → 71")]
    public void A_jump_that_its_weenie_does_not_pay_for_is_refused_last_of_all()
    {
        (FakeBody body, MotionInterpreter interpreter) = FakeBody.Standing(new Miser());
        interpreter.Interpreted.ForwardCommand = MotionCommand.Crouch;
        Assert.Equal(MotionError.CannotJumpFromThisPosition, interpreter.Jump(1f));
        interpreter.Interpreted.ForwardCommand = MotionCommand.Ready;
        Assert.Equal(MotionError.GeneralFailure, interpreter.Jump(1f));
        Assert.True(body.OnWalkable);
    }

    /// <summary>May jump, and pays for none.</summary>
    private sealed class Miser : IWeenieObj
    {
        public bool IsThePlayer => true;

        public bool IsCreature => true;

        public bool InqRunRate(out float rate)
        {
            rate = 1;
            return true;
        }

        public bool InqJumpVelocity(float extent, out float velocity)
        {
            velocity = 5;
            return true;
        }

        public bool CanJump(float extent) => true;

        public bool JumpStaminaCost(float extent, out int cost)
        {
            cost = 0;
            return false;
        }
    }
}
