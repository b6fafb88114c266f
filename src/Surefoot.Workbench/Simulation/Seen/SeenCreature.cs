using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Workbench.Simulation;

/// <summary>A creature as the pages know it: by the orders that its driver gives, and the places that it tells.</summary>
/// <param name="body">Its body.</param>
/// <param name="shape">Its shape.</param>
/// <param name="name">Its name.</param>
internal sealed class SeenCreature(PhysicsBody body, SetupAsset shape, string name) : ISeenObject, ICreatureListener
{
    private const uint CreatureType = 0x10, Attackable = 0x10, Stuck = 0x4;

    private MovementData order = MovementData.Motion(0, new WireInterpretedMotion());
    private ObjectStamps stamps = new(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1);

    /// <inheritdoc/>
    public uint Id => body.Id;

    /// <inheritdoc/>
    public bool IsThere => body.HasCell;

    /// <inheritdoc/>
    public Position Place => body.Position;

    /// <inheritdoc/>
    public Audience Audience { get; } = new();

    /// <summary>The stamps that its driver goes on from.</summary>
    public ObjectStamps Stamps => stamps;

    /// <inheritdoc/>
    public CreateObject Describe() => new(new ObjectDescription(
        body.Id,
        new ModelData(),
        new PhysicsDescription
        {
            State = (uint)body.State,
            Setup = shape.Id,
            MotionTable = shape.DefaultMotionTableId == 0 ? null : shape.DefaultMotionTableId,
            Movement = order,
            Position = SeenPlayer.WireOf(body.Position),
            Scale = body.Scale,
            Stamps = stamps,
        },
        new WeenieDescription { Name = name, ItemType = CreatureType, Description = Attackable | Stuck }));

    void ICreatureListener.OnMotion(CreatureDriver creature, in UpdateMotion message)
    {
        order = message.Movement;
        stamps = stamps with { Movement = message.MovementStamp, ServerControlledMove = message.ServerControlledMove };
        Audience.Tell(message);
    }

    void ICreatureListener.OnPosition(CreatureDriver creature, in UpdatePosition message)
    {
        stamps = stamps with { Position = message.Pack.PositionStamp };
        Audience.Tell(message);
    }
}
