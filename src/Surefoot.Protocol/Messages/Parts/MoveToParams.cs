namespace Surefoot.Protocol.Messages;

/// <summary>How to go somewhere: 28 bytes (specification 08, 6.4).</summary>
/// <param name="Bits">0x1 can walk, 0x2 can run, 0x4 can sidestep, 0x8 can walk backwards, 0x10 can charge, 0x20 fail walk, 0x40 use final
/// heading, 0x80 sticky, 0x100 move away, 0x200 move towards, 0x400 use spheres, 0x800 set hold key, 0x1000 autonomous, 0x2000 modify raw
/// state, 0x4000 modify interpreted state, 0x8000 cancel move-to, 0x10000 stop completely, 0x20000 disable jump during link.</param>
/// <param name="DistanceToObject">How near to come, metres.</param>
/// <param name="MinDistance">How far to flee, metres.</param>
/// <param name="FailDistance">How far the target may be, metres.</param>
/// <param name="Speed">Factor on the speed.</param>
/// <param name="WalkRunThreshold">Distance below which it walks, metres.</param>
/// <param name="DesiredHeading">Heading at the end, degrees.</param>
/// <remarks>Retail: MovementParameters::UnPackNet @0x0052AC50.</remarks>
public readonly record struct MoveToParams(
    uint Bits,
    float DistanceToObject,
    float MinDistance,
    float FailDistance,
    float Speed,
    float WalkRunThreshold,
    float DesiredHeading)
{
    internal static MoveToParams Read(ref WireReader reader) => new(
        reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle(),
        reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Bits);
        writer.WriteSingle(DistanceToObject);
        writer.WriteSingle(MinDistance);
        writer.WriteSingle(FailDistance);
        writer.WriteSingle(Speed);
        writer.WriteSingle(WalkRunThreshold);
        writer.WriteSingle(DesiredHeading);
    }

    /// <summary>The short form of a turn: bits, speed, desired heading.</summary>
    internal static MoveToParams ReadTurn(ref WireReader reader)
        => new(reader.ReadUInt32(), 0, 0, 0, reader.ReadSingle(), 0, reader.ReadSingle());

    internal void WriteTurn(ref WireWriter writer)
    {
        writer.WriteUInt32(Bits);
        writer.WriteSingle(Speed);
        writer.WriteSingle(DesiredHeading);
    }
}
