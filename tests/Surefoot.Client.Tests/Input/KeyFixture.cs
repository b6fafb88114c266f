using System.Buffers.Binary;
using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client.Tests;

/// <summary>A controller over a body without a world, at 30 frames a second.</summary>
internal sealed class KeyFixture : IMotionBody
{
    internal const double FrameTime = 1.0 / 30;
    internal const uint Id = 0x50000001;

    private readonly FakeServer orders = new();
    private ushort movementStamp;
    private ushort serverControlStamp;

    internal KeyFixture(PlayerWeenie? weenie = null, MotionTableAsset? table = null, IServerLink? server = null)
    {
        Server = server ?? orders;
        weenie ??= new PlayerWeenie(new CharacterStats(300, 300));
        PlayerObject player = new(Id, new LocalPlayerOptions().Stamps);
        Movement = new MovementManager(this, table ?? HumanoidTable.Create(), weenie);
        Controller = new PlayerMovementController(this, Movement, new MovementSender(this, Movement, player, Server, Sent, Now));
        Messages = new PlayerMessages(player, Movement, Controller, weenie, new CharacterSheet(), CommandTable.Retail);
        Press(MovementKeys.None);
    }

    internal double Now { get; set; }

    internal Recorder Sent { get; } = new();

    internal IServerLink Server { get; }

    internal PlayerMessages Messages { get; }

    internal MovementManager Movement { get; }

    internal PlayerMovementController Controller { get; }

    internal MotionInterpreter Interpreter => Movement.Interpreter;

    internal RawMotionState Raw => Interpreter.Raw;

    /// <summary>What was sent last.</summary>
    internal SentMove LastSent => Sent.Moves[^1];

    internal (MotionCommand Command, float Speed) Forward => (Interpreter.Interpreted.ForwardCommand, Interpreter.Interpreted.ForwardSpeed);

    internal (MotionCommand Command, float Speed) Turn => (Interpreter.Interpreted.TurnCommand, Interpreter.Interpreted.TurnSpeed);

    internal (MotionCommand Command, float Speed) Sidestep =>
        (Interpreter.Interpreted.SidestepCommand, Interpreter.Interpreted.SidestepSpeed);

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
        if (before && !on) Told.LeaveGround();
        else if (!before && on) Told.HitGround();
    }

    /// <summary>How often the body was told to stop following a server's places.</summary>
    internal int InterpolationStops { get; private set; }

    public void StopInterpolating() => InterpolationStops++;

    /// <summary>The first words that the MoveToState sent last has after its header: the state asked for.</summary>
    internal string SentWords(int bytes)
    {
        byte[] message = orders.Sent[^1];
        Assert.Equal(0xF61Cu, BinaryPrimitives.ReadUInt32LittleEndian(message.AsSpan(8)));
        return Convert.ToHexString(message.AsSpan(12, bytes));
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

    /// <summary>What the server has said by now arrives.</summary>
    internal void Hear() => Server.Receive(Now, Messages);

    /// <summary>A server says something, and it arrives at once.</summary>
    internal void Say<T>(in T message)
        where T : IMessage<T>
    {
        orders.Say(message);
        orders.Receive(Now, Messages);
    }

    /// <summary>A server orders a state.</summary>
    internal void Order(MotionCommand forward, float speed = 1f) => Say(new UpdateMotion(
        Id, 1, ++movementStamp, ++serverControlStamp, Autonomous: false,
        MovementData.Motion(0, new WireInterpretedMotion(forwardCommand: (ushort)forward, forwardSpeed: speed))));

    /// <summary>A server repeats what the player asked for.</summary>
    internal void Echo(in WireInterpretedMotion state) => Say(new UpdateMotion(
        Id, 1, ++movementStamp, serverControlStamp, Autonomous: true, MovementData.Motion(0, state)));

    private IBodyMovement Told => Movement;

    private void Animate()
    {
        Frame offset = Frame.Identity;
        Told.AccumulateRootMotion((float)FrameTime, ref offset);
        Movement.Animation!.ProcessHooks(null);
        Told.UseTime();
    }
}
