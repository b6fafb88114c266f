using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>An object of the world that clients are told of.</summary>
/// <param name="stage">The world.</param>
internal abstract class WorldItem(WorldStage stage)
{
    /// <summary>Its body.</summary>
    public abstract PhysicsBody Body { get; }

    /// <summary>Its id.</summary>
    public uint Id => Body.Id;

    /// <summary>It is somewhere.</summary>
    public bool IsThere => Body.HasCell;

    /// <summary>Where it is.</summary>
    public Position Place => Body.Position;

    /// <summary>Which life of the object.</summary>
    public abstract ushort Instance { get; }

    /// <summary>Who knows it.</summary>
    public Audience Audience { get; } = new(stage);

    /// <summary>The cell in which it was when anybody looked last; 0 for nowhere.</summary>
    public uint SeenIn { get; set; }

    /// <summary>The world.</summary>
    protected WorldStage Stage { get; } = stage;

    /// <summary>All of it, for who does not know it yet.</summary>
    public abstract CreateObject Describe();

    /// <summary>A position as it travels.</summary>
    public static WirePosition WireOf(in Position place) => new(place.CellId, place.Frame.Origin, place.Frame.Rotation);

    /// <summary>The stamp after another one.</summary>
    protected static ushort Next(ushort stamp) => unchecked((ushort)(stamp + 1));
}
