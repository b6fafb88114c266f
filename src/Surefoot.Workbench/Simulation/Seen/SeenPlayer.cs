using Surefoot.Client;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Server;

namespace Surefoot.Workbench.Simulation;

/// <summary>A page's player as the other pages know it: by what its client says, and the server passes on.</summary>
internal sealed class SeenPlayer : ISeenObject
{
    private readonly LocalPlayer player;
    private readonly SetupAsset shape;
    private readonly string name;

    /// <summary>A player that has come into the world.</summary>
    /// <param name="player">The player.</param>
    /// <param name="shape">Its shape.</param>
    /// <param name="name">Its name.</param>
    /// <param name="runRate">Its server's run rate.</param>
    public SeenPlayer(LocalPlayer player, SetupAsset shape, string name, float runRate)
    {
        this.player = player;
        this.shape = shape;
        this.name = name;
        Broadcast = new PlayerBroadcast(player.Body.Id, WireOf(player.Body.Position), Audience, runRate)
        {
            Detail = BroadcastDetail.Full,
        };
    }

    /// <summary>What its client says goes here.</summary>
    public PlayerBroadcast Broadcast { get; }

    /// <inheritdoc/>
    public uint Id => player.Body.Id;

    /// <inheritdoc/>
    public bool IsThere => player.Body.HasCell;

    /// <inheritdoc/>
    public Position Place => player.Body.Position;

    /// <inheritdoc/>
    public Audience Audience { get; } = new();

    /// <inheritdoc/>
    public CreateObject Describe() => Broadcast.Describe(shape.Id, shape.DefaultMotionTableId, name);

    /// <summary>The server has put the player somewhere else, where it is at once.</summary>
    public void Teleported(double now)
    {
        Broadcast.Teleport(WireOf(Place), now);
        Broadcast.EndTeleport();
    }

    /// <summary>A position as it goes over the wire.</summary>
    public static WirePosition WireOf(in Position place) => new(place.CellId, place.Frame.Origin, place.Frame.Rotation);
}
