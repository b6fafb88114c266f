using System.Numerics;
using System.Text.Json;
using CsCheck;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>The samples are the ones that the page's own tests read, so that the two sides cannot drift apart.</summary>
public sealed class FrameTests
{
    private const int Places = 300;
    private static readonly JsonElement Samples = JsonDocument.Parse(
        File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "wire.samples.json"))).RootElement;

    private static readonly PlayerPose SamplePose = new(
        12.5, 0xA9B40025, new Vector3(100, -1.5f, 20), 1, new Vector3(3, -4, 2), 5,
        PoseFlags.Contact | PoseFlags.OnWalkable | PoseFlags.Charging,
        new Plane(0, 0.5f, 0.75f, -20), 0.125f, 0.0625f, 2.5f, 0x44000007, 2.5f, -0.5f, -1.5f, 5, 4);

    private static readonly BodyPose[] SampleBodies =
    [
        new(
            0x80000001, BodyKind.Wanderer, BodyFlags.Airborne, "creature", 0xA9B40025, new Vector3(100, -1.5f, 20), 1,
            new Vector3(3, -4, 2), 1.5f,
            new Vector3(0.5f, 0.75f, 2)),
        new(
            0x80000002, BodyKind.Door, BodyFlags.Open | BodyFlags.WaitsToClose, "door", 0xA8B50034, new Vector3(1, 2, 3), -0.5f,
            Vector3.Zero, 1,
            new Vector3(1.25f, 0.125f, 2.25f)),
    ];

    [Fact]
    [Behaviour("workbench.frames.page-and-server-agree", "design.md, Two commands")]
    public void Page_and_server_read_and_write_the_same_bytes()
    {
        Assert.True(ClientFrame.TryParse(Bytes("input"), Places, out ClientFrame input));
        Assert.Equal(new ClientFrame(FrameKind.Input, PlayerKeys.Jump | PlayerKeys.Forward | PlayerKeys.TurnLeft, 0x12345678), input);
        Assert.True(ClientFrame.TryParse(Bytes("settings"), Places, out ClientFrame settings));
        Assert.Equal(new PlayerSettings(300, 250, 7000), settings.Settings);
        Assert.True(ClientFrame.TryParse(Bytes("goto"), Places, out ClientFrame place));
        Assert.Equal(258, place.Place);
        Assert.True(ClientFrame.TryParse(Bytes("use"), Places, out ClientFrame use));
        Assert.Equal(new ClientFrame(FrameKind.Use), use);
        Assert.True(ClientFrame.TryParse(Bytes("pointer"), Places, out ClientFrame pointer));
        Assert.Equal(new ClientFrame(FrameKind.Pointer, Buttons: PointerButtons.Left | PointerButtons.Right, Right: -12.5f), pointer);
        Assert.True(ClientFrame.TryParse(Bytes("mouseTurning"), Places, out ClientFrame mouse));
        Assert.Equal(new ClientFrame(FrameKind.MouseTurning, On: true), mouse);
        Assert.True(ClientFrame.TryParse(Bytes("autoRun"), Places, out ClientFrame run));
        Assert.Equal(new ClientFrame(FrameKind.AutoRun), run);
        Assert.True(ClientFrame.TryParse(Bytes("focusLost"), Places, out ClientFrame lost));
        Assert.Equal(new ClientFrame(FrameKind.FocusLost), lost);

        Assert.True(ClientFrame.TryParse(Bytes("placeAt"), Places, out ClientFrame at));
        Assert.Equal(new ClientFrame(FrameKind.PlaceAt, Cell: 0xA9B40025, Position: new Vector3(100, -1.5f, 20), Yaw: 1), at);
        Assert.True(ClientFrame.TryParse(Bytes("placeOnGround"), Places, out ClientFrame onGround));
        Assert.Equal(at with { Position = at.Position with { Z = float.NaN } }, onGround);

        Assert.True(ClientFrame.TryParse(Bytes("network"), Places, out ClientFrame network));
        Assert.Equal(new ClientFrame(FrameKind.Network, On: true, Network: new NetworkQuality(0.2, 0.1, 0.05)), network);
        Assert.True(ClientFrame.TryParse(Bytes("creature"), Places, out ClientFrame creature));
        Assert.Equal(new ClientFrame(FrameKind.Creature, Body: 0x80000001, Wish: CreatureWish.Flee), creature);
        Assert.Equal(
            Bytes("truth"), ServerFrames.Truth(12.5, [new TruePlace(0x80000001, 0xA9B40025, new Vector3(100, -1.5f, 20), 1)]));
        Assert.True(ClientFrame.TryParse(Bytes("askWalk"), Places, out ClientFrame askWalk));
        Assert.Equal(new ClientFrame(FrameKind.AskWalk), askWalk);
        Assert.Equal(Bytes("walk"), ServerFrames.Walk(new WalkReport("W 3 ", "é.")));
        Assert.Equal(Bytes("sentence"), ServerFrames.Sentence("Aé"));
        Assert.Equal(Bytes("welcome"), ServerFrames.Welcome(7, new PlayerSettings(300, 250, 7000), 15_000, 9, 2));
        Assert.Equal(Bytes("pose"), ServerFrames.Pose(SamplePose, 9, 10, 3));
        Assert.Equal(Bytes("others"), ServerFrames.Others(12.5, [(2, SamplePose)]));
        Assert.Equal(Bytes("event"), ServerFrames.Event(new PlayerEvent(PlayerEventKind.JumpRefused, 12.5, 2, 73)));
        Assert.Equal(Bytes("bodies"), ServerFrames.Bodies(12.5, SampleBodies));
        Assert.Equal(
            Bytes("moving"),
            ServerFrames.Moving(12.5,
                [new MovingPart(0xA8B5, 3, 2, new Vector3(100, -1.5f, 20), new Quaternion(0, 0.5f, -0.5f, 0.75f), 1.5f)]));
        Assert.Equal(Bytes("touches"), ServerFrames.Touches(
            [
                new Touch(true, TouchKind.Room, 0xA8B50100, Vector3.UnitZ, ""),
                new Touch(false, TouchKind.Body, 0x80000001, new Vector3(0.5f, -0.25f, 0), "creature")]));
    }

    [Theory]
    [Behaviour("workbench.frames.refuses-malformed", "design.md")]
    [InlineData("")]
    [InlineData("00")]
    [InlineData("01")]
    [InlineData("01 01 000000")]
    [InlineData("01 01 00000000 00")]
    [InlineData("02 e903 0000 00000000")]
    [InlineData("02 0000 e903 00000000")]
    [InlineData("02 0000 0000 c9af0000")]
    [InlineData("02 0000 0000 ffffffff")]
    [InlineData("03 2c01")]
    [InlineData("03 ffff")]
    [InlineData("04 00")]
    [InlineData("05 04 00000000")]
    [InlineData("05 00 0000c07f")]
    [InlineData("05 00 0000807f")]
    [InlineData("05 00 01401cc6")]
    [InlineData("05 00 000000")]
    [InlineData("06")]
    [InlineData("06 02")]
    [InlineData("07 00")]
    [InlineData("08 00")]
    [InlineData("0a 00")]
    [InlineData("0b c800 6400 3200 02")]
    [InlineData("0b e903 6400 3200 00")]
    [InlineData("0b c800 e903 3200 00")]
    [InlineData("0b c800 6400 f501 00")]
    [InlineData("0b c800 6400 3200")]
    [InlineData("0c 01000080 04")]
    [InlineData("0c 01000080")]
    [InlineData("09 2500b4a9 0000c842 0000c0bf 0000a041")]
    [InlineData("09 2500b4a9 0000c07f 0000c0bf 0000a041 0000803f")]
    [InlineData("09 2500b4a9 0000c842 0000807f 0000a041 0000803f")]
    [InlineData("09 2500b4a9 0000c842 0000c0bf 0000807f 0000803f")]
    [InlineData("09 2500b4a9 0000c842 0000c0bf 0000a041 0000c07f")]
    [InlineData("81 01 07000000")]
    [InlineData("ff ffff ffff ffff ff")]
    public void A_frame_of_wrong_length_kind_or_range_is_refused(string hex) =>
        Assert.False(ClientFrame.TryParse(Convert.FromHexString(hex.Replace(" ", "", StringComparison.Ordinal)), Places, out _));

    [Fact]
    [Behaviour("workbench.frames.accepted-is-in-range", "design.md")]
    public void Whatever_the_bytes_an_accepted_frame_is_within_the_limits() =>
        Gen.Byte.Array[0, 24].Sample(
            bytes =>
            {
                if (bytes.Length > 0) bytes[0] &= 15;
                if (!ClientFrame.TryParse(bytes, Places, out ClientFrame frame)) return true;
                return bytes.Length <= WireLimits.LongestClientFrame && Math.Abs(frame.Right) <= WireLimits.MaxPointerMove &&
                    frame.Place is >= 0 and < Places
                    && float.IsFinite(frame.Position.X + frame.Position.Y + frame.Yaw) && !float.IsInfinity(frame.Position.Z)
                    && frame.Settings is { RunSkill: >= 0 and <= WireLimits.MaxSkill, JumpSkill: >= 0 and <= WireLimits.MaxSkill }
                    && frame.Settings.Burden >= 0 && frame.Settings.Burden <= WireLimits.MaxBurden;
            },
            iter: 20_000 * Fuzz);

    private static int Fuzz => int.TryParse(Environment.GetEnvironmentVariable("SUREFOOT_FUZZ"), out int times) && times > 0 ? times : 1;

    private static byte[] Bytes(string sample) =>
        Convert.FromHexString(Samples.GetProperty(sample).GetProperty("hex").GetString()!.Replace(" ", "", StringComparison.Ordinal));
}
