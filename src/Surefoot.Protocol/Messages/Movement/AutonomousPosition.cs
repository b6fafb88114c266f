namespace Surefoot.Protocol.Messages;

/// <summary>Where the player's body is, told now and then while it stands (specification 08, 5.5).</summary>
/// <param name="Position">Where the body is.</param>
/// <param name="Stamps">The player's stored timestamps.</param>
/// <param name="Contact">It stands on ground that it can walk on.</param>
/// <remarks>Retail: AutonomousPositionPack::Pack @0x00516AF0.</remarks>
public readonly record struct AutonomousPosition(
    WirePosition Position,
    MovementStamps Stamps,
    bool Contact) : IGameAction<AutonomousPosition>
{
    static GameActionType IGameAction<AutonomousPosition>.Type => GameActionType.AutonomousPosition;

    static AutonomousPosition IMessage<AutonomousPosition>.Read(ref WireReader reader)
    {
        var message = new AutonomousPosition(WirePosition.Read(ref reader), MovementStamps.Read(ref reader), reader.ReadByte() != 0);
        reader.Align4();
        return message;
    }

    void IMessage<AutonomousPosition>.Write(ref WireWriter writer)
    {
        Position.Write(ref writer);
        Stamps.Write(ref writer);
        writer.WriteByte(Contact ? (byte)1 : (byte)0);
        writer.Align4();
    }
}
