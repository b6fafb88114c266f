using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>The body jumped (specification 08, 5.4).</summary>
/// <param name="Extent">Charge, 0.001 to 1.</param>
/// <param name="Velocity">Velocity after the jump in the body's own axes, m/s.</param>
/// <param name="Position">Where the body is.</param>
/// <param name="Stamps">The player's stored timestamps.</param>
/// <remarks>Retail: JumpPack::Pack @0x00516D10.</remarks>
public readonly record struct Jump(float Extent, Vector3 Velocity, WirePosition Position, MovementStamps Stamps) : IGameAction<Jump>
{
    static GameActionType IGameAction<Jump>.Type => GameActionType.Jump;

    static Jump IMessage<Jump>.Read(ref WireReader reader)
    {
        var jump = new Jump(reader.ReadSingle(), reader.ReadVector3(), WirePosition.Read(ref reader), MovementStamps.Read(ref reader));
        reader.Align4();
        return jump;
    }

    void IMessage<Jump>.Write(ref WireWriter writer)
    {
        writer.WriteSingle(Extent);
        writer.WriteVector3(Velocity);
        Position.Write(ref writer);
        Stamps.Write(ref writer);
        writer.Align4();
    }
}
