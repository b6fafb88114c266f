using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>The clients that know an object. A message is put into bytes once, however many they are.</summary>
/// <param name="stage">The world.</param>
internal sealed class Audience(WorldStage stage) : IAudience
{
    private readonly List<PlayerItem> players = [];

    /// <summary>They.</summary>
    public IReadOnlyList<PlayerItem> Players => players;

    /// <summary>The client whose own player it is; it is told too.</summary>
    public ClientConnection? Owner { get; set; }

    /// <summary>Somebody has been told of it.</summary>
    public void Add(PlayerItem player) => players.Add(player);

    /// <summary>Somebody is to forget it.</summary>
    public void Remove(PlayerItem player) => players.Remove(player);

    /// <inheritdoc/>
    public void Tell<T>(in T message)
        where T : IMessage<T>
    {
        if (!WireMessage.TryWrite(message, stage.Scratch, out int length)) return;
        ReadOnlySpan<byte> bytes = stage.Scratch.AsSpan(0, length);
        Owner?.Send(bytes, T.Group);
        foreach (PlayerItem player in players) player.Client.Send(bytes, T.Group);
    }
}
