namespace Surefoot.Protocol.Messages;

/// <summary>A one-shot motion inside a motion state: 8 bytes (specification 08, 5.3 and 6.4).</summary>
/// <param name="Command">Low word of the command.</param>
/// <param name="Stamp">Number of the action, 15 bits.</param>
/// <param name="Autonomous">The object's own player asked for it.</param>
/// <param name="Speed">Factor on the animation's speed.</param>
public readonly record struct MotionAction(ushort Command, ushort Stamp, bool Autonomous, float Speed)
{
    /// <summary>A stamp of 15 bits is newer than another one, around the wrap.</summary>
    /// <remarks>Retail: CMotionInterp::move_to_interpreted_state @0x005289C0.</remarks>
    public static bool IsNewer(int stored, int incoming)
    {
        int last = stored & 0x7FFF, next = incoming & 0x7FFF;
        return Math.Abs(next - last) <= 0x3FFF ? last < next : next < last;
    }

    internal static MotionAction Read(ref WireReader reader)
    {
        ushort command = reader.ReadUInt16(), stamp = reader.ReadUInt16();
        return new MotionAction(command, (ushort)(stamp & 0x7FFF), (stamp & 0x8000) != 0, reader.ReadSingle());
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt16(Command);
        writer.WriteUInt16((ushort)((Stamp & 0x7FFF) | (Autonomous ? 0x8000 : 0)));
        writer.WriteSingle(Speed);
    }
}
