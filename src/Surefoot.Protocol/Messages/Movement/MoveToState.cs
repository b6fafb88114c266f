namespace Surefoot.Protocol.Messages;

/// <summary>The player's keys changed what is asked of the body (specification 08, 5.3).</summary>
/// <param name="Motion">What is asked.</param>
/// <param name="Position">Where the body is.</param>
/// <param name="Stamps">The player's stored timestamps.</param>
/// <param name="Contact">It stands on ground that it can walk on.</param>
/// <param name="StandingLongJump">It charges a standing long jump.</param>
/// <remarks>Retail: MoveToStatePack::Pack @0x005168F0.</remarks>
public readonly record struct MoveToState(
    WireRawMotion Motion,
    WirePosition Position,
    MovementStamps Stamps,
    bool Contact,
    bool StandingLongJump) : IGameAction<MoveToState>
{
    private const byte HasContact = 1, LongJump = 2;

    static GameActionType IGameAction<MoveToState>.Type => GameActionType.MoveToState;

    static MoveToState IMessage<MoveToState>.Read(ref WireReader reader)
    {
        WireRawMotion motion = WireRawMotion.Read(ref reader);
        WirePosition position = WirePosition.Read(ref reader);
        MovementStamps stamps = MovementStamps.Read(ref reader);
        byte bits = reader.ReadByte();
        reader.Align4();
        return new MoveToState(motion, position, stamps, (bits & HasContact) != 0, (bits & LongJump) != 0);
    }

    void IMessage<MoveToState>.Write(ref WireWriter writer)
    {
        Motion.Write(ref writer);
        Position.Write(ref writer);
        Stamps.Write(ref writer);
        writer.WriteByte((byte)((Contact ? HasContact : 0) | (StandingLongJump ? LongJump : 0)));
        writer.Align4();
    }
}
