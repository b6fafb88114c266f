using System.Buffers.Binary;
using System.Numerics;
using System.Text;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>Writes the frames that a server sends.</summary>
internal static class ServerFrames
{
    public const int WelcomeLength = 30;
    public const int PoseLength = 103;
    public const int EventLength = 18;
    public const int OthersHeaderLength = 11;
    public const int OtherLength = 52;
    public const int BodiesHeaderLength = 11;
    public const int BodyLength = 56;
    public const int TouchesHeaderLength = 2;
    public const int TouchLength = 20;
    public const int MovingHeaderLength = 11;
    public const int MovingLength = 40;
    public const int WalkHeaderLength = 9;

    /// <summary>Length of a sentence before its text, bytes.</summary>
    public const int SentenceHeaderLength = 5;
    public const int TruthHeaderLength = 11;
    public const int TruePlaceLength = 24;

    private const int LongestName = 255;

    /// <summary>
    /// <c>u8 kind, u8 version, u32 player, u16 run, u16 jump, u32 burden, u32 capacity, u16 max skill, u32 max burden, u16 places, f32
    /// quantum</c>.
    /// </summary>
    public static byte[] Welcome(uint player, PlayerSettings settings, int burdenCapacity, int places, float quantum)
    {
        byte[] bytes = new byte[WelcomeLength];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Welcome);
        to.U8(WireLimits.Version);
        to.U32(player);
        to.U16((ushort)settings.RunSkill);
        to.U16((ushort)settings.JumpSkill);
        to.U32((uint)settings.Burden);
        to.U32((uint)burdenCapacity);
        to.U16(WireLimits.MaxSkill);
        to.U32(WireLimits.MaxBurden);
        to.U16((ushort)places);
        to.F32(quantum);
        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, u8 teleports, u16 flags, u32 tick, u32 input sequence taken, f64 time, u32 cell, f32[3] position, f32 yaw, f32[3]
    /// velocity, f32[4] contact plane, f32 speed over ground, f32 charge, f32 quantum, f32 run rate, u32 forward command, f32 forward, f32
    /// sidestep, f32 turn, u16 players, u8 walks</c>.
    /// </summary>
    public static byte[] Pose(in PlayerPose pose, uint tick, uint sequence, int players)
    {
        byte[] bytes = new byte[PoseLength];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Pose);
        to.U8(pose.Teleports);
        to.U16((ushort)pose.Flags);
        to.U32(tick);
        to.U32(sequence);
        to.F64(pose.Time);
        to.U32(pose.CellId);
        to.Vector(pose.Position);
        to.F32(pose.Yaw);
        to.Vector(pose.Velocity);
        to.Vector(pose.ContactPlane.Normal);
        to.F32(pose.ContactPlane.D);
        to.F32(pose.Speed);
        to.F32(pose.Charge);
        to.F32(pose.Quantum);
        to.F32(pose.RunRate);
        to.U32(pose.ForwardCommand);
        to.F32(pose.ForwardSpeed);
        to.F32(pose.SidestepSpeed);
        to.F32(pose.TurnSpeed);
        to.U16((ushort)players);
        to.U8(pose.Walks);
        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, f64 time, u16 count</c>, then for each <c>u32 player, u8 teleports, u8 0, u16 flags, f32 charge, u32 cell, f32[3]
    /// position, f32 yaw, f32[3] velocity, f32 forward, f32 sidestep</c> (the last two are the commands' speeds).
    /// </summary>
    public static byte[] Others(double time, IReadOnlyList<(uint Id, PlayerPose Pose)> players)
    {
        byte[] bytes = new byte[OthersHeaderLength + (players.Count * OtherLength)];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Others);
        to.F64(time);
        to.U16((ushort)players.Count);
        foreach ((uint id, PlayerPose pose) in players)
        {
            to.U32(id);
            to.U8(pose.Teleports);
            to.U8(0);
            to.U16((ushort)pose.Flags);
            to.F32(pose.Charge);
            to.U32(pose.CellId);
            to.Vector(pose.Position);
            to.F32(pose.Yaw);
            to.Vector(pose.Velocity);
            to.F32(pose.ForwardSpeed);
            to.F32(pose.SidestepSpeed);
        }

        return bytes;
    }

    /// <summary><c>u8 kind, u8 event, f64 time, f32 value, u32 code</c>.</summary>
    public static byte[] Event(in PlayerEvent happened)
    {
        byte[] bytes = new byte[EventLength];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Event);
        to.U8((byte)happened.Kind);
        to.F64(happened.Time);
        to.F32(happened.Value);
        to.U32(happened.Code);
        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, f64 time, u16 count</c>, then for each <c>u32 body, u8 kind, u8 flags, u8 length of the name, u8 0, u32 cell, f32[3]
    /// position, f32 yaw, f32[3] velocity, f32 scale, f32[3] size</c> and its name in UTF-8.
    /// </summary>
    public static byte[] Bodies(double time, IReadOnlyList<BodyPose> bodies)
    {
        byte[] bytes = new byte[BodiesHeaderLength + bodies.Sum(body => BodyLength + NameLength(body.Name))];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Bodies);
        to.F64(time);
        to.U16((ushort)bodies.Count);
        foreach (BodyPose body in bodies)
        {
            to.U32(body.Id);
            to.U8((byte)body.Kind);
            to.U8((byte)body.Flags);
            to.U8((byte)NameLength(body.Name));
            to.U8(0);
            to.U32(body.CellId);
            to.Vector(body.Position);
            to.F32(body.Yaw);
            to.Vector(body.Velocity);
            to.F32(body.Scale);
            to.Vector(body.Size);
            to.Text(body.Name);
        }

        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, u8 count</c>, then for each <c>u8 1 for what is stood on, u8 kind of thing, u8 length of the name, u8 0, u32 id, f32[3]
    /// normal</c> and its name in UTF-8.
    /// </summary>
    public static byte[] Touches(IReadOnlyList<Touch> touches)
    {
        int count = Math.Min(touches.Count, byte.MaxValue);
        byte[] bytes = new byte[TouchesHeaderLength + touches.Take(count).Sum(touch => TouchLength + NameLength(touch.Name))];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Touches);
        to.U8((byte)count);
        foreach (Touch touch in touches.Take(count))
        {
            to.U8(touch.IsFooting ? (byte)1 : (byte)0);
            to.U8((byte)touch.Kind);
            to.U8((byte)NameLength(touch.Name));
            to.U8(0);
            to.U32(touch.Id);
            to.Vector(touch.Normal);
            to.Text(touch.Name);
        }

        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, f64 time, u16 count</c>, then for each <c>u16 landblock, u16 object, u16 part, u16 0, f32[3] position, f32[4] rotation
    /// (x, y, z, w), f32 scale</c>.
    /// </summary>
    public static byte[] Moving(double time, IReadOnlyList<MovingPart> parts)
    {
        int count = Math.Min(parts.Count, ushort.MaxValue);
        byte[] bytes = new byte[MovingHeaderLength + (count * MovingLength)];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Moving);
        to.F64(time);
        to.U16((ushort)count);
        foreach (MovingPart part in parts.Take(count))
        {
            to.U16(part.Block);
            to.U16(part.Object);
            to.U16(part.Part);
            to.U16(0);
            to.Vector(part.Position);
            to.F32(part.Rotation.X);
            to.F32(part.Rotation.Y);
            to.F32(part.Rotation.Z);
            to.F32(part.Rotation.W);
            to.F32(part.Scale);
        }

        return bytes;
    }

    /// <summary><c>u8 kind, f64 time, u16 count</c>, then for each <c>u32 id, u32 cell, f32[3] position, f32 yaw</c>.</summary>
    public static byte[] Truth(double time, IReadOnlyList<TruePlace> places)
    {
        byte[] bytes = new byte[TruthHeaderLength + (places.Count * TruePlaceLength)];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Truth);
        to.F64(time);
        to.U16((ushort)places.Count);
        foreach (TruePlace place in places)
        {
            to.U32(place.Id);
            to.U32(place.CellId);
            to.Vector(place.Position);
            to.F32(place.Yaw);
        }

        return bytes;
    }

    /// <summary>
    /// <c>u8 kind, u32 length of the command, u32 length of what is left out</c>, and both in UTF-8, the command first.
    /// </summary>
    public static byte[] Walk(in WalkReport walk)
    {
        int command = Encoding.UTF8.GetByteCount(walk.Command), leftOut = Encoding.UTF8.GetByteCount(walk.LeftOut);
        byte[] bytes = new byte[WalkHeaderLength + command + leftOut];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Walk);
        to.U32((uint)command);
        to.U32((uint)leftOut);
        Encoding.UTF8.GetBytes(walk.Command, bytes.AsSpan(WalkHeaderLength));
        Encoding.UTF8.GetBytes(walk.LeftOut, bytes.AsSpan(WalkHeaderLength + command));
        return bytes;
    }

    /// <summary><c>u8 kind, u32 length</c>, and the sentence in UTF-8.</summary>
    public static byte[] Sentence(string text)
    {
        int length = Encoding.UTF8.GetByteCount(text);
        byte[] bytes = new byte[SentenceHeaderLength + length];
        Writer to = new(bytes);
        to.U8((byte)FrameKind.Sentence);
        to.U32((uint)length);
        Encoding.UTF8.GetBytes(text, bytes.AsSpan(SentenceHeaderLength));
        return bytes;
    }

    /// <summary>Bytes of a name on the wire; one that is too long is left out.</summary>
    private static int NameLength(string name) => Encoding.UTF8.GetByteCount(name) is <= LongestName and int length ? length : 0;

    private ref struct Writer(Span<byte> bytes)
    {
        private Span<byte> rest = bytes;

        public void U8(byte value)
        {
            rest[0] = value;
            rest = rest[1..];
        }

        public void U16(ushort value)
        {
            BinaryPrimitives.WriteUInt16LittleEndian(rest, value);
            rest = rest[2..];
        }

        public void U32(uint value)
        {
            BinaryPrimitives.WriteUInt32LittleEndian(rest, value);
            rest = rest[4..];
        }

        public void F32(float value)
        {
            BinaryPrimitives.WriteSingleLittleEndian(rest, value);
            rest = rest[4..];
        }

        public void F64(double value)
        {
            BinaryPrimitives.WriteDoubleLittleEndian(rest, value);
            rest = rest[8..];
        }

        public void Text(string value)
        {
            if (NameLength(value) == 0) return;
            rest = rest[Encoding.UTF8.GetBytes(value, rest)..];
        }

        public void Vector(Vector3 value)
        {
            F32(value.X);
            F32(value.Y);
            F32(value.Z);
        }
    }
}
