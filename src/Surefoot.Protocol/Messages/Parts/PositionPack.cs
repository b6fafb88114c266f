using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>A place as a server tells it, with what goes with it (specification 08, 6.3).</summary>
/// <remarks>Retail: PositionPack::UnPack @0x00516740.</remarks>
public readonly record struct PositionPack
{
    private const uint HasVelocity = 0x01, HasPlacement = 0x02, HasContact = 0x04, NoW = 0x08, NoX = 0x10, NoY = 0x20, NoZ = 0x40;

    /// <summary>A place; components of the rotation that are exactly zero are left out.</summary>
    /// <param name="position">Where.</param>
    /// <param name="contact">The object stands on the ground.</param>
    /// <param name="instance">Which life of the object.</param>
    /// <param name="positionStamp">Number of this position.</param>
    /// <param name="teleport">Last teleport.</param>
    /// <param name="forcePosition">Last correction of a player's position.</param>
    /// <param name="velocity">Velocity in m/s; nobody looks at it.</param>
    /// <param name="placement">Placement frame.</param>
    public PositionPack(
        in WirePosition position,
        bool contact,
        ushort instance,
        ushort positionStamp,
        ushort teleport,
        ushort forcePosition,
        Vector3? velocity = null,
        uint? placement = null)
        : this(
            (contact ? HasContact : 0) | (velocity is null ? 0 : HasVelocity) | (placement is null ? 0 : HasPlacement)
                | Absent(position.Orientation.W, NoW) | Absent(position.Orientation.X, NoX)
                | Absent(position.Orientation.Y, NoY) | Absent(position.Orientation.Z, NoZ),
            position)
    {
        Velocity = velocity ?? default;
        Placement = placement ?? 0;
        Instance = instance;
        PositionStamp = positionStamp;
        Teleport = teleport;
        ForcePosition = forcePosition;
    }

    private PositionPack(uint flags, in WirePosition position)
    {
        Flags = flags;
        Position = position;
    }

    /// <summary>Where; a component of the rotation that was left out is 0.</summary>
    public WirePosition Position { get; }

    /// <summary>The object stands on the ground.</summary>
    public bool Contact => (Flags & HasContact) != 0;

    /// <summary>Velocity in m/s, 0 where it was left out. Retail never looks at it.</summary>
    public Vector3 Velocity { get; private init; }

    /// <summary>Placement frame, 0 where it was left out.</summary>
    public uint Placement { get; private init; }

    /// <summary>Which life of the object.</summary>
    public ushort Instance { get; private init; }

    /// <summary>Number of this position.</summary>
    public ushort PositionStamp { get; private init; }

    /// <summary>Last teleport.</summary>
    public ushort Teleport { get; private init; }

    /// <summary>Last correction of a player's position.</summary>
    public ushort ForcePosition { get; private init; }

    /// <summary>What is there and what was left out.</summary>
    internal uint Flags { get; }

    internal static PositionPack Read(ref WireReader reader)
    {
        uint flags = reader.ReadUInt32(), cell = reader.ReadUInt32();
        Vector3 origin = reader.ReadVector3();
        float w = Component(ref reader, flags & NoW), x = Component(ref reader, flags & NoX);
        float y = Component(ref reader, flags & NoY), z = Component(ref reader, flags & NoZ);
        return new PositionPack(flags, new WirePosition(cell, origin, new Quaternion(x, y, z, w)))
        {
            Velocity = (flags & HasVelocity) != 0 ? reader.ReadVector3() : default,
            Placement = (flags & HasPlacement) != 0 ? reader.ReadUInt32() : 0,
            Instance = reader.ReadUInt16(),
            PositionStamp = reader.ReadUInt16(),
            Teleport = reader.ReadUInt16(),
            ForcePosition = reader.ReadUInt16(),
        };

        static float Component(ref WireReader reader, uint absent) => absent != 0 ? 0 : reader.ReadSingle();
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Flags);
        writer.WriteUInt32(Position.Cell);
        writer.WriteVector3(Position.Origin);
        Component(ref writer, Flags & NoW, Position.Orientation.W);
        Component(ref writer, Flags & NoX, Position.Orientation.X);
        Component(ref writer, Flags & NoY, Position.Orientation.Y);
        Component(ref writer, Flags & NoZ, Position.Orientation.Z);
        if ((Flags & HasVelocity) != 0)
            writer.WriteVector3(Velocity);
        if ((Flags & HasPlacement) != 0)
            writer.WriteUInt32(Placement);
        writer.WriteUInt16(Instance);
        writer.WriteUInt16(PositionStamp);
        writer.WriteUInt16(Teleport);
        writer.WriteUInt16(ForcePosition);

        static void Component(ref WireWriter writer, uint absent, float value)
        {
            if (absent == 0)
                writer.WriteSingle(value);
        }
    }

    private static uint Absent(float component, uint flag) => component == 0 ? flag : 0;
}
