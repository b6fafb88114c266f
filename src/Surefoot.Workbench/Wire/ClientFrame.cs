using System.Buffers.Binary;
using System.Numerics;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>One checked frame from a page. Only the fields of its kind are set.</summary>
internal readonly record struct ClientFrame(
    FrameKind Kind,
    PlayerKeys Keys = PlayerKeys.None,
    uint Sequence = 0,
    PlayerSettings Settings = default,
    int Place = 0,
    PointerButtons Buttons = PointerButtons.None,
    float Right = 0,
    bool On = false,
    uint Cell = 0,
    Vector3 Position = default,
    float Yaw = 0,
    NetworkQuality Network = default,
    uint Body = 0,
    CreatureWish Wish = CreatureWish.AsItLikes)
{
    /// <summary>Reads a frame. The bytes are untrusted: exact length, known kind, every value in its range, or false.</summary>
    /// <param name="bytes">One whole WebSocket message.</param>
    /// <param name="placeCount">Number of named places.</param>
    /// <param name="frame">The frame, when true.</param>
    public static bool TryParse(ReadOnlySpan<byte> bytes, int placeCount, out ClientFrame frame)
    {
        frame = default;
        if (bytes.IsEmpty) return false;
        ReadOnlySpan<byte> body = bytes[1..];
        switch ((FrameKind)bytes[0])
        {
            case FrameKind.Input when body.Length == 5:
                frame = new ClientFrame(FrameKind.Input, (PlayerKeys)body[0], BinaryPrimitives.ReadUInt32LittleEndian(body[1..]));
                return true;
            case FrameKind.Settings when body.Length == 8:
                ushort run = BinaryPrimitives.ReadUInt16LittleEndian(body);
                ushort jump = BinaryPrimitives.ReadUInt16LittleEndian(body[2..]);
                uint burden = BinaryPrimitives.ReadUInt32LittleEndian(body[4..]);
                if (run > WireLimits.MaxSkill || jump > WireLimits.MaxSkill || burden > WireLimits.MaxBurden) return false;
                frame = new ClientFrame(FrameKind.Settings, Settings: new PlayerSettings(run, jump, (int)burden));
                return true;
            case FrameKind.Goto when body.Length == 2:
                int place = BinaryPrimitives.ReadUInt16LittleEndian(body);
                if (place >= placeCount) return false;
                frame = new ClientFrame(FrameKind.Goto, Place: place);
                return true;
            case FrameKind.Pointer when body.Length == 5:
                float right = BinaryPrimitives.ReadSingleLittleEndian(body[1..]);
                if (body[0] > (byte)(PointerButtons.Left | PointerButtons.Right) || !(Math.Abs(right) <= WireLimits.MaxPointerMove))
                    return false;
                frame = new ClientFrame(FrameKind.Pointer, Buttons: (PointerButtons)body[0], Right: right);
                return true;
            case FrameKind.MouseTurning when body.Length == 1 && body[0] <= 1:
                frame = new ClientFrame(FrameKind.MouseTurning, On: body[0] == 1);
                return true;
            case FrameKind.PlaceAt when body.Length == 20:
                Vector3 position = new(Single(body, 4), Single(body, 8), Single(body, 12));
                float yaw = Single(body, 16);
                if (!float.IsFinite(position.X) || !float.IsFinite(position.Y) || float.IsInfinity(position.Z) || !float.IsFinite(yaw))
                    return false;
                frame = new ClientFrame(FrameKind.PlaceAt, Cell: BinaryPrimitives.ReadUInt32LittleEndian(body), Position: position,
                    Yaw: yaw);
                return true;
            case FrameKind.Network when body.Length == 7 && body[6] <= 1:
                ushort delay = BinaryPrimitives.ReadUInt16LittleEndian(body);
                ushort jitter = BinaryPrimitives.ReadUInt16LittleEndian(body[2..]);
                ushort loss = BinaryPrimitives.ReadUInt16LittleEndian(body[4..]);
                if (delay > WireLimits.MaxDelay || jitter > WireLimits.MaxDelay || loss > WireLimits.MaxLoss) return false;
                frame = new ClientFrame(
                    FrameKind.Network, On: body[6] == 1, Network: new NetworkQuality(delay / 1000.0, jitter / 1000.0, loss / 1000.0));
                return true;
            case FrameKind.Creature when body.Length == 5 && body[4] <= (byte)CreatureWish.Stand:
                frame = new ClientFrame(
                    FrameKind.Creature, Body: BinaryPrimitives.ReadUInt32LittleEndian(body), Wish: (CreatureWish)body[4]);
                return true;
            case FrameKind.Use or FrameKind.AutoRun or FrameKind.FocusLost or FrameKind.AskWalk when body.IsEmpty:
                frame = new ClientFrame((FrameKind)bytes[0]);
                return true;
            default:
                return false;
        }
    }

    private static float Single(ReadOnlySpan<byte> bytes, int at) => BinaryPrimitives.ReadSingleLittleEndian(bytes[at..]);
}
