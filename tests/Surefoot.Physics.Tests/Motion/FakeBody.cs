using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>A body without a world: it stands where it is told to stand.</summary>
internal sealed class FakeBody : IMotionBody
{
    internal MotionInterpreter? Interpreter { get; set; }

    public bool HasContact { get; set; } = true;

    public bool OnWalkable { get; set; } = true;

    public bool HasGravity { get; set; } = true;

    public bool HasCell { get; set; } = true;

    public bool IsFullyConstrained { get; set; }

    public bool LastMoveWasAutonomous { get; set; } = true;

    public Position Position { get; set; } = new(0xA9B40001, new Vector3(12, 12, 0));

    public Plane ContactPlane { get; set; } = new(0, 0, 1, 0);

    public Vector3 LocalVelocity { get; set; }

    /// <summary>Is told when a move-to is to end.</summary>
    internal Action? OnCancelMoveTo { get; set; }

    /// <summary>Was told to let go of what it sticks to.</summary>
    internal bool Unstuck { get; private set; }

    public void CancelMoveTo() => OnCancelMoveTo?.Invoke();

    public void Unstick() => Unstuck = true;

    public void SetLocalVelocity(Vector3 velocity) => LocalVelocity = velocity;

    public void SetOnWalkable(bool on)
    {
        bool before = OnWalkable;
        OnWalkable = on;
        if (before && !on) Interpreter?.LeaveGround();
        else if (!before && on) Interpreter?.HitGround();
    }

    /// <summary>An interpreter that stands ready on the ground, every motion done.</summary>
    internal static (FakeBody Body, MotionInterpreter Interpreter) Standing(IWeenieObj? weenie, MotionTableAsset? table = null)
    {
        FakeBody body = new();
        MotionInterpreter interpreter = new(new MotionTableManager(table ?? HumanoidTable.Create()), body, weenie);
        body.Interpreter = interpreter;
        interpreter.EnterDefaultState();
        interpreter.Animation!.HandleEnterWorld();
        while (interpreter.MotionsPending) interpreter.MotionDone(true);
        return (body, interpreter);
    }

    internal static PlayerWeenie Player(int run = 300, int jump = 300, double load = 0) =>
        new(new CharacterStats(run, jump, Burden: (int)(15000 * load)));
}
