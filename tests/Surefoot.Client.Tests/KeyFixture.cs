using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>A controller over a body without a world, at 30 frames a second.</summary>
internal sealed class KeyFixture : IMotionBody
{
    internal const double FrameTime = 1.0 / 30;

    internal KeyFixture(IWeenieObj? weenie = null, MotionTableAsset? table = null)
    {
        Movement = new MovementManager(this, table ?? HumanoidTable.Create(), weenie ?? new PlayerWeenie(new CharacterStats(300, 300)));
        Controller = new PlayerMovementController(this, Movement, Sent, Now);
        Press(MovementKeys.None);
    }

    internal double Now { get; set; }

    internal Recorder Sent { get; } = new();

    internal MovementManager Movement { get; }

    internal PlayerMovementController Controller { get; }

    internal MotionInterpreter Interpreter => Movement.Interpreter;

    internal RawMotionState Raw => Interpreter.Raw;

    /// <summary>What was sent last.</summary>
    internal MoveToStateEvent LastSent => Sent.Moves[^1];

    internal (MotionCommand Command, float Speed) Forward => (Interpreter.Interpreted.ForwardCommand, Interpreter.Interpreted.ForwardSpeed);

    internal (MotionCommand Command, float Speed) Turn => (Interpreter.Interpreted.TurnCommand, Interpreter.Interpreted.TurnSpeed);

    internal (MotionCommand Command, float Speed) Sidestep => (Interpreter.Interpreted.SidestepCommand, Interpreter.Interpreted.SidestepSpeed);

    public bool HasContact { get; set; } = true;

    public bool OnWalkable { get; set; } = true;

    public bool HasGravity => true;

    public bool HasCell => true;

    public bool IsFullyConstrained => false;

    public bool LastMoveWasAutonomous { get; set; }

    public Position Position { get; set; } = new(0xA9B40001, new Vector3(12, 12, 0));

    public Plane ContactPlane { get; set; } = new(0, 0, 1, 0);

    public Vector3 LocalVelocity { get; private set; }

    public void SetLocalVelocity(Vector3 velocity) => LocalVelocity = velocity;

    public void SetOnWalkable(bool on)
    {
        bool before = OnWalkable;
        OnWalkable = on;
        if (before && !on) Movement.LeaveGround();
        else if (!before && on) Movement.HitGround();
    }

    /// <summary>Holds keys for a number of frames.</summary>
    internal void Press(MovementKeys keys, int frames = 1)
    {
        for (int i = 0; i < frames; i++)
        {
            Now += FrameTime;
            Controller.Update(keys, Now);
            Animate();
        }
    }

    /// <summary>A server orders a state.</summary>
    internal void Order(MotionCommand forward, float speed = 1f) => Controller.HandleUpdateMotion(
        new UpdateMotionEvent(new InterpretedMotionState { ForwardCommand = forward, ForwardSpeed = speed }, Autonomous: false));

    private void Animate()
    {
        Frame offset = Frame.Identity;
        Movement.AccumulateRootMotion((float)FrameTime, ref offset);
        Movement.Animation!.ProcessHooks(null);
        Movement.UseTime();
    }
}
