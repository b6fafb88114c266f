using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>An object held by another one.</summary>
/// <param name="Guid">The other object: the holder, or what is held.</param>
/// <param name="Location">Number of the holder's holding location.</param>
public readonly record struct HoldingLink(uint Guid, uint Location);

/// <summary>How an object is to be simulated (specification 08, 6.5). What is null is not said.</summary>
/// <remarks>Retail: PhysicsDesc::UnPack @0x0051DDD0.</remarks>
public sealed record PhysicsDescription
{
    private const uint HasSetup = 0x1, HasMotionTable = 0x2, HasVelocity = 0x4, HasAcceleration = 0x8, HasOmega = 0x10, HasParent = 0x20,
        HasChildren = 0x40, HasScale = 0x80, HasFriction = 0x100, HasElasticity = 0x200, HasSoundTable = 0x800, HasScriptTable = 0x1000,
        HasDefaultScript = 0x2000, HasDefaultScriptIntensity = 0x4000, HasPosition = 0x8000, HasMovement = 0x10000, HasPlacement = 0x20000,
        HasTranslucency = 0x40000, WithField = 0x7FBFF;

    /// <summary>Physics state word (specification 08, 6.2).</summary>
    public uint State { get; init; }

    /// <summary>What it does. With it there is no <see cref="Placement"/>.</summary>
    public MovementData? Movement { get; init; }

    /// <summary>Goes with <see cref="Movement"/>: its own player asked for it.</summary>
    public uint Autonomous { get; init; }

    /// <summary>Placement frame.</summary>
    public uint? Placement { get; init; }

    /// <summary>Where it is.</summary>
    public WirePosition? Position { get; init; }

    /// <summary>Id of the motion table.</summary>
    public uint? MotionTable { get; init; }

    /// <summary>Id of the sound table.</summary>
    public uint? SoundTable { get; init; }

    /// <summary>Id of the physics script table.</summary>
    public uint? ScriptTable { get; init; }

    /// <summary>Id of the setup.</summary>
    public uint? Setup { get; init; }

    /// <summary>Who holds it.</summary>
    public HoldingLink? Parent { get; init; }

    /// <summary>What it holds.</summary>
    public ValueList<HoldingLink>? Children { get; init; }

    /// <summary>Factor on its size.</summary>
    public float? Scale { get; init; }

    /// <summary>0 to 1.</summary>
    public float? Friction { get; init; }

    /// <summary>0 to 0.1.</summary>
    public float? Elasticity { get; init; }

    /// <summary>0 is solid, 1 invisible.</summary>
    public float? Translucency { get; init; }

    /// <summary>m/s.</summary>
    public Vector3? Velocity { get; init; }

    /// <summary>m/s².</summary>
    public Vector3? Acceleration { get; init; }

    /// <summary>Radians a second.</summary>
    public Vector3? Omega { get; init; }

    /// <summary>Script that it plays by itself.</summary>
    public uint? DefaultScript { get; init; }

    /// <summary>How strongly it plays it.</summary>
    public float? DefaultScriptIntensity { get; init; }

    /// <summary>The nine timestamps.</summary>
    public ObjectStamps Stamps { get; init; }

    /// <summary>The flags word.</summary>
    internal uint Flags
        => OtherFlags
            | Flag(Movement, HasMovement) | Flag(Placement, HasPlacement) | Flag(Position, HasPosition) | Flag(MotionTable, HasMotionTable)
            | Flag(SoundTable, HasSoundTable) | Flag(ScriptTable, HasScriptTable) | Flag(Setup, HasSetup) | Flag(Parent, HasParent)
            | Flag(Children, HasChildren) | Flag(Scale, HasScale) | Flag(Friction, HasFriction) | Flag(Elasticity, HasElasticity)
            | Flag(Translucency, HasTranslucency) | Flag(Velocity, HasVelocity) | Flag(Acceleration, HasAcceleration)
            | Flag(Omega, HasOmega) | Flag(DefaultScript, HasDefaultScript) | Flag(DefaultScriptIntensity, HasDefaultScriptIntensity);

    /// <summary>Flags that were set and say nothing: those without a field, that of an empty movement, that of a placement beside a
    /// movement.</summary>
    internal uint OtherFlags { get; init; }

    internal static PhysicsDescription Read(ref WireReader reader)
    {
        uint flags = reader.ReadUInt32(), state = reader.ReadUInt32();
        MovementData? movement = null;
        uint autonomous = 0;
        bool hasMovement = (flags & HasMovement) != 0;
        if (hasMovement && reader.ReadUInt32() is var length and not 0)
        {
            movement = ReadMovement(ref reader, length);
            autonomous = reader.ReadUInt32();
        }

        return new PhysicsDescription
        {
            State = state,
            Movement = movement,
            Autonomous = autonomous,
            Placement = hasMovement ? null : Number(ref reader, flags & HasPlacement),
            Position = (flags & HasPosition) != 0 ? WirePosition.Read(ref reader) : null,
            MotionTable = Number(ref reader, flags & HasMotionTable),
            SoundTable = Number(ref reader, flags & HasSoundTable),
            ScriptTable = Number(ref reader, flags & HasScriptTable),
            Setup = Number(ref reader, flags & HasSetup),
            Parent = (flags & HasParent) != 0 ? ReadLink(ref reader) : null,
            Children = (flags & HasChildren) != 0 ? reader.ReadList(8, ReadLink) : null,
            Scale = Factor(ref reader, flags & HasScale),
            Friction = Factor(ref reader, flags & HasFriction),
            Elasticity = Factor(ref reader, flags & HasElasticity),
            Translucency = Factor(ref reader, flags & HasTranslucency),
            Velocity = Vector(ref reader, flags & HasVelocity),
            Acceleration = Vector(ref reader, flags & HasAcceleration),
            Omega = Vector(ref reader, flags & HasOmega),
            DefaultScript = Number(ref reader, flags & HasDefaultScript),
            DefaultScriptIntensity = Factor(ref reader, flags & HasDefaultScriptIntensity),
            Stamps = ReadStamps(ref reader),
            OtherFlags = (flags & ~WithField) | (hasMovement ? flags & HasPlacement : 0) | (movement is null ? flags & HasMovement : 0),
        };
    }

    internal void Write(ref WireWriter writer)
    {
        uint flags = Flags;
        writer.WriteUInt32(flags);
        writer.WriteUInt32(State);
        if ((flags & HasMovement) != 0)
            WriteMovement(ref writer);
        else
            Number(ref writer, Placement);
        Position?.Write(ref writer);
        Number(ref writer, MotionTable);
        Number(ref writer, SoundTable);
        Number(ref writer, ScriptTable);
        Number(ref writer, Setup);
        if (Parent is { } parent)
            WriteLink(ref writer, parent);
        if (Children is { } children)
            writer.WriteList(children, WriteLink);
        Factor(ref writer, Scale);
        Factor(ref writer, Friction);
        Factor(ref writer, Elasticity);
        Factor(ref writer, Translucency);
        Vector(ref writer, Velocity);
        Vector(ref writer, Acceleration);
        Vector(ref writer, Omega);
        Number(ref writer, DefaultScript);
        Factor(ref writer, DefaultScriptIntensity);
        Stamps.Write(ref writer);
        writer.Align4();
    }

    private static ObjectStamps ReadStamps(ref WireReader reader)
    {
        ObjectStamps stamps = ObjectStamps.Read(ref reader);
        reader.Align4();
        return stamps;
    }

    private static MovementData ReadMovement(ref WireReader reader, uint length)
    {
        if (length > reader.Remaining)
        {
            reader.Fail(WireFault.Truncated);
            return default;
        }

        var inner = new WireReader(reader.ReadBytes((int)length));
        MovementData movement = MovementData.Read(ref inner);
        if (inner.Fault != WireFault.None)
            reader.Fail(inner.Fault);
        return movement;
    }

    private void WriteMovement(ref WireWriter writer)
    {
        int start = writer.Position;
        writer.WriteUInt32(0);
        if (Movement is not { } movement)
            return;

        movement.Write(ref writer);
        writer.PatchUInt32(start, (uint)(writer.Position - start - 4));
        writer.WriteUInt32(Autonomous);
    }

    private static HoldingLink ReadLink(ref WireReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32());

    private static void WriteLink(ref WireWriter writer, HoldingLink link)
    {
        writer.WriteUInt32(link.Guid);
        writer.WriteUInt32(link.Location);
    }

    private static uint Flag<T>(T? value, uint flag)
        where T : struct => value is null ? 0 : flag;

    private static uint? Number(ref WireReader reader, uint flag) => flag != 0 ? reader.ReadUInt32() : null;

    private static float? Factor(ref WireReader reader, uint flag) => flag != 0 ? reader.ReadSingle() : null;

    private static Vector3? Vector(ref WireReader reader, uint flag) => flag != 0 ? reader.ReadVector3() : null;

    private static void Number(ref WireWriter writer, uint? value)
    {
        if (value is { } number)
            writer.WriteUInt32(number);
    }

    private static void Factor(ref WireWriter writer, float? value)
    {
        if (value is { } factor)
            writer.WriteSingle(factor);
    }

    private static void Vector(ref WireWriter writer, Vector3? value)
    {
        if (value is { } vector)
            writer.WriteVector3(vector);
    }
}
