using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>A door: used it opens, and after a while it closes by itself.</summary>
/// <remarks>Specification 08, 5.7 and 8.6.</remarks>
internal sealed class DoorItem : WorldItem
{
    /// <summary>From how far it is used, metres.</summary>
    public const float UseRadius = 2f;

    private const double OpenFor = 30;
    private const uint MiscellaneousType = 0x80, Door = 0x1000, Stuck = 0x4, Usable = 0x20;
    private const ushort NonCombat = 0x3D, On = 0x0B, Off = 0x0C;

    private readonly WorldSpawn spawn;
    private readonly SetupAsset shape;
    private ObjectStamps stamps = new(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1);
    private double closesAt = double.PositiveInfinity;
    private PhysicsState told;

    public DoorItem(WorldStage stage, uint id, WorldSpawn spawn, SetupAsset shape)
        : base(stage)
    {
        this.spawn = spawn;
        this.shape = shape;
        Body = stage.Engine.CreateBody(id, shape, PhysicsState.ReportCollisions, WeenieTraits.Present);
        told = Body.State;
    }

    public override PhysicsBody Body { get; }

    public override ushort Instance => stamps.Instance;

    /// <summary>It lets everybody through.</summary>
    public bool IsOpen => (Body.State & PhysicsState.Ethereal) != 0;

    /// <summary>Somebody uses it: it opens, or closes again.</summary>
    public void Use(double now)
    {
        if (IsOpen)
        {
            Close();
            return;
        }

        TellMotion(On);
        Body.SetEthereal(true);
        closesAt = now + OpenFor;
        TellState();
    }

    /// <summary>Looks after it; after the world's tick.</summary>
    public void Update(double now)
    {
        if (!IsThere)
        {
            if (Body is { IsLost: false } && Stage.IsLoaded(spawn.Place)) Body.EnterWorld(spawn.Place);
            return;
        }

        if (now >= closesAt) Close();

        // A door that would catch somebody stays open until they are out: the body looks at each tick whether it may be solid again.
        if (told != Body.State) TellState();
    }

    public override CreateObject Describe() => new(new ObjectDescription(
        Id, new ModelData(),
        new PhysicsDescription
        {
            State = (uint)Body.State,
            Setup = shape.Id,
            MotionTable = shape.DefaultMotionTableId == 0 ? null : shape.DefaultMotionTableId,
            Movement = Doing(IsOpen ? On : Off),
            Position = WireOf(Body.Position),
            Stamps = stamps,
        },
        new WeenieDescription
        {
            Name = spawn.Name,
            ItemType = MiscellaneousType,
            Description = Door | Stuck,
            Useability = Usable,
            UseRadius = UseRadius,
        }));

    private static MovementData Doing(ushort command) =>
        MovementData.Motion(NonCombat, new WireInterpretedMotion(forwardCommand: command));

    private void Close()
    {
        closesAt = double.PositiveInfinity;
        TellMotion(Off);
        Body.SetEthereal(false);
    }

    private void TellMotion(ushort command)
    {
        stamps = stamps with { Movement = Next(stamps.Movement), ServerControlledMove = Next(stamps.ServerControlledMove) };
        Audience.Tell(new UpdateMotion(Id, Instance, stamps.Movement, stamps.ServerControlledMove, false, Doing(command)));
    }

    private void TellState()
    {
        told = Body.State;
        stamps = stamps with { State = Next(stamps.State) };
        Audience.Tell(new SetState(Id, (uint)told, Instance, stamps.State));
    }
}
