using Surefoot.Server;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Wire;

/// <summary>
/// First byte of every frame between a page and the server. All numbers are little-endian; lengths are fixed by the kind.
/// </summary>
internal enum FrameKind : byte
{
    /// <summary>Page → server: <c>u8 keys, u32 sequence</c>.</summary>
    Input = 0x01,

    /// <summary>Page → server: <c>u16 run skill, u16 jump skill, u32 burden</c>.</summary>
    Settings = 0x02,

    /// <summary>Page → server: <c>u16 place</c>, an index into the list of places.</summary>
    Goto = 0x03,

    /// <summary>Page → server, nothing more: open or close the nearest door within reach.</summary>
    Use = 0x04,

    /// <summary>
    /// Page → server: <c>u8 buttons, f32 right</c>: the pointer's buttons held (<see cref="PointerButtons"/>), and how far it moved
    /// to the right, counts.
    /// </summary>
    Pointer = 0x05,

    /// <summary>Page → server: <c>u8</c>, 1 when the right button turns the player, 0 when not.</summary>
    MouseTurning = 0x06,

    /// <summary>Page → server, nothing more: run ahead without a key from now on, or no longer.</summary>
    AutoRun = 0x07,

    /// <summary>Page → server, nothing more: the keyboard is elsewhere, and every key counts as let go.</summary>
    FocusLost = 0x08,

    /// <summary>
    /// Page → server: <c>u32 cell, f32[3] position, f32 yaw</c>: be there; a height of NaN means on the ground. Answered by a
    /// pose with another count of teleports, or by the event <see cref="PlayerEventKind.PlaceRefused"/>.
    /// </summary>
    PlaceAt = 0x09,

    /// <summary>Page → server, nothing more: say what the player did last. Answered by <see cref="Walk"/>.</summary>
    AskWalk = 0x0A,

    /// <summary>
    /// Page → server: <c>u16 delay, u16 jitter, u16 loss, u8 truth</c>: how bad the network is over which it hears of others,
    /// milliseconds and thousandths, and 1 when it wants to know where they are in truth.
    /// </summary>
    Network = 0x0B,

    /// <summary>Page → server: <c>u32 body, u8 wish</c>: what a creature is to do (<see cref="CreatureWish"/>).</summary>
    Creature = 0x0C,

    /// <summary>Server → page, once and first; see <see cref="ServerFrames.Welcome"/>.</summary>
    Welcome = 0x81,

    /// <summary>Server → page: the page's own player after a tick; see <see cref="ServerFrames.Pose"/>.</summary>
    Pose = 0x82,

    /// <summary>
    /// Server → page: all other players after a tick; who is not listed is gone; see <see cref="ServerFrames.Others"/>.
    /// </summary>
    Others = 0x83,

    /// <summary>Server → page: something that happened to the page's own player; see <see cref="ServerFrames.Event"/>.</summary>
    Event = 0x84,

    /// <summary>
    /// Server → page: the bodies near the page's player that are no players, whenever one of them changed and every
    /// <see cref="WireLimits.RepeatEvery"/> ticks; who is not listed is gone or far; see <see cref="ServerFrames.Bodies"/>.
    /// </summary>
    Bodies = 0x85,

    /// <summary>
    /// Server → page: what the page's player stands on and touches; sent as <see cref="Bodies"/>; see <see cref="ServerFrames.Touches"/>.
    /// </summary>
    Touches = 0x86,

    /// <summary>
    /// Server → page: the parts near the page's player that animations move; sent as <see cref="Bodies"/>. What is not listed is far and
    /// stays as it was; see <see cref="ServerFrames.Moving"/>.
    /// </summary>
    Moving = 0x87,

    /// <summary>Server → page: what its player did last, as a command; see <see cref="ServerFrames.Walk"/>.</summary>
    Walk = 0x88,

    /// <summary>
    /// Server → page: where the others are in truth, after each tick, for a page that wants to know; see
    /// <see cref="ServerFrames.Truth"/>.
    /// </summary>
    Truth = 0x89,

    /// <summary>Server → page: a sentence that a person should read; see <see cref="ServerFrames.Sentence"/>.</summary>
    Sentence = 0x8A,
}

/// <summary>The keys a player holds.</summary>
[Flags]
internal enum PlayerKeys : byte
{
    None = 0,
    Forward = 1,
    Back = 2,
    TurnLeft = 4,
    TurnRight = 8,
    SidestepLeft = 16,
    SidestepRight = 32,
    Walk = 64,
    Jump = 128,
}

/// <summary>The pointer's buttons, as a browser numbers them.</summary>
[Flags]
internal enum PointerButtons : byte
{
    None = 0,
    Left = 1,
    Right = 2,
}

/// <summary>Bounds of what a page may ask; the page is told them in the welcome.</summary>
internal static class WireLimits
{
    /// <summary>Version of the frames; a page of another version reloads itself.</summary>
    public const byte Version = 8;

    /// <summary>Longest frame a page sends, bytes.</summary>
    public const int LongestClientFrame = 21;

    /// <summary>Farthest that a pointer moves between two frames, counts.</summary>
    public const float MaxPointerMove = 10_000f;

    /// <summary>Seconds from one tick of the physics to the next.</summary>
    public const float Quantum = (float)WorldTime.Quantum;

    /// <summary>Ticks after which what has not changed is said again: a page that is slow to read loses frames.</summary>
    public const int RepeatEvery = 30;

    /// <summary>Longest delay and jitter, milliseconds.</summary>
    public const ushort MaxDelay = 1000;

    /// <summary>Highest loss, thousandths.</summary>
    public const ushort MaxLoss = 500;

    /// <summary>Highest skill.</summary>
    public const ushort MaxSkill = 1000;

    /// <summary>Highest burden, burden units. Three times the capacity of strength 100: past 2 × nobody jumps or runs.</summary>
    public const uint MaxBurden = 45_000;
}
