using System.Numerics;

namespace Surefoot.Protocol.Messages;

/// <summary>What a server orders (specification 08, 6.4). Other numbers are possible; nothing but their style is applied.</summary>
public enum MovementType : byte
{
    /// <summary>A motion state.</summary>
    InterpretedMotion = 0,

    /// <summary>Go to an object.</summary>
    MoveToObject = 6,

    /// <summary>Go to a place.</summary>
    MoveToPosition = 7,

    /// <summary>Turn towards an object.</summary>
    TurnToObject = 8,

    /// <summary>Turn to a heading.</summary>
    TurnToHeading = 9,
}

/// <summary>A movement that a server orders. Which values count depends on <see cref="Type"/>; the others are zero.</summary>
/// <remarks>Retail: MovementManager::unpack_movement @0x00524440.</remarks>
public readonly record struct MovementData
{
    private const byte StickTo = 1, LongJump = 2;

    private MovementData(MovementType type, byte motionFlags, ushort style)
    {
        Type = type;
        MotionFlags = motionFlags;
        Style = style;
    }

    /// <summary>What is ordered.</summary>
    public MovementType Type { get; }

    /// <summary>Low word of the stance; 0 says nothing of it.</summary>
    public ushort Style { get; }

    /// <summary>Type 0: what the body does.</summary>
    public WireInterpretedMotion State { get; private init; }

    /// <summary>Type 0: the body charges a standing long jump.</summary>
    public bool StandingLongJump => (MotionFlags & LongJump) != 0;

    /// <summary>Type 0: the object to stick to, or 0. Types 6 and 8: the target.</summary>
    public uint Target { get; private init; }

    /// <summary>Types 6 and 7: cell of the target's place.</summary>
    public uint Cell { get; private init; }

    /// <summary>Types 6 and 7: the target's place, metres in its landblock.</summary>
    public Vector3 Origin { get; private init; }

    /// <summary>Types 6 and 7: how to go. Types 8 and 9: bits, speed and heading only.</summary>
    public MoveToParams Parameters { get; private init; }

    /// <summary>Types 6 and 7: the body's run rate.</summary>
    public float RunRate { get; private init; }

    /// <summary>Type 8: heading in degrees to turn to when the target is unknown.</summary>
    public float DesiredHeading { get; private init; }

    /// <summary>1: an object to stick to follows the state; 2: standing long jump.</summary>
    internal byte MotionFlags { get; }

    /// <summary>Type 0.</summary>
    public static MovementData Motion(ushort style, in WireInterpretedMotion state, uint stickTo = 0, bool standingLongJump = false)
        => new(MovementType.InterpretedMotion, (byte)((stickTo != 0 ? StickTo : 0) | (standingLongJump ? LongJump : 0)), style)
        {
            State = state,
            Target = stickTo,
        };

    /// <summary>Type 6.</summary>
    public static MovementData MoveToObject(
        ushort style, uint target, uint cell, Vector3 origin, in MoveToParams parameters, float runRate)
        => new(MovementType.MoveToObject, 0, style)
        {
            Target = target,
            Cell = cell,
            Origin = origin,
            Parameters = parameters,
            RunRate = runRate,
        };

    /// <summary>Type 7.</summary>
    public static MovementData MoveToPosition(ushort style, uint cell, Vector3 origin, in MoveToParams parameters, float runRate)
        => new(MovementType.MoveToPosition, 0, style) { Cell = cell, Origin = origin, Parameters = parameters, RunRate = runRate };

    /// <summary>Type 8.</summary>
    public static MovementData TurnToObject(ushort style, uint target, float desiredHeading, uint bits, float speed, float finalHeading)
        => new(MovementType.TurnToObject, 0, style)
        {
            Target = target,
            DesiredHeading = desiredHeading,
            Parameters = new MoveToParams(bits, 0, 0, 0, speed, 0, finalHeading),
        };

    /// <summary>Type 9.</summary>
    public static MovementData TurnToHeading(ushort style, uint bits, float speed, float heading)
        => new(MovementType.TurnToHeading, 0, style) { Parameters = new MoveToParams(bits, 0, 0, 0, speed, 0, heading) };

    internal static MovementData Read(ref WireReader reader)
    {
        var head = new MovementData((MovementType)reader.ReadByte(), reader.ReadByte(), reader.ReadUInt16());
        switch (head.Type)
        {
            case MovementType.InterpretedMotion:
                WireInterpretedMotion state = WireInterpretedMotion.Read(ref reader);
                return head with { State = state, Target = (head.MotionFlags & StickTo) != 0 ? reader.ReadUInt32() : 0 };
            case MovementType.MoveToObject:
                return ReadMoveTo(head with { Target = reader.ReadUInt32() }, ref reader);
            case MovementType.MoveToPosition:
                return ReadMoveTo(head, ref reader);
            case MovementType.TurnToObject:
                return head with
                {
                    Target = reader.ReadUInt32(),
                    DesiredHeading = reader.ReadSingle(),
                    Parameters = MoveToParams.ReadTurn(ref reader),
                };
            case MovementType.TurnToHeading:
                return head with { Parameters = MoveToParams.ReadTurn(ref reader) };
            default:
                return head;
        }
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteByte((byte)Type);
        writer.WriteByte(MotionFlags);
        writer.WriteUInt16(Style);
        switch (Type)
        {
            case MovementType.InterpretedMotion:
                State.Write(ref writer);
                if ((MotionFlags & StickTo) != 0)
                    writer.WriteUInt32(Target);
                break;
            case MovementType.MoveToObject:
                writer.WriteUInt32(Target);
                WriteMoveTo(ref writer);
                break;
            case MovementType.MoveToPosition:
                WriteMoveTo(ref writer);
                break;
            case MovementType.TurnToObject:
                writer.WriteUInt32(Target);
                writer.WriteSingle(DesiredHeading);
                Parameters.WriteTurn(ref writer);
                break;
            case MovementType.TurnToHeading:
                Parameters.WriteTurn(ref writer);
                break;
        }
    }

    private static MovementData ReadMoveTo(in MovementData head, ref WireReader reader) => head with
    {
        Cell = reader.ReadUInt32(),
        Origin = reader.ReadVector3(),
        Parameters = MoveToParams.Read(ref reader),
        RunRate = reader.ReadSingle(),
    };

    private void WriteMoveTo(ref WireWriter writer)
    {
        writer.WriteUInt32(Cell);
        writer.WriteVector3(Origin);
        Parameters.Write(ref writer);
        writer.WriteSingle(RunRate);
    }
}
