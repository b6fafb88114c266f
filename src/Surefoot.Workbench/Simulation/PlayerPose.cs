using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>The values a person moves sliders for.</summary>
/// <param name="RunSkill">Run skill.</param>
/// <param name="JumpSkill">Jump skill.</param>
/// <param name="Burden">Burden, burden units.</param>
internal readonly record struct PlayerSettings(int RunSkill, int JumpSkill, int Burden)
{
    /// <summary>What a player starts with.</summary>
    public static PlayerSettings Default => new(300, 250, 0);
}

/// <summary>Facts about a pose, as bits on the wire.</summary>
[Flags]
internal enum PoseFlags : ushort
{
    None = 0,
    Contact = 1,
    OnWalkable = 2,

    /// <summary>The jump key is held and the bar fills.</summary>
    Charging = 4,

    /// <summary>Standing, charging a jump that movement keys only aim.</summary>
    StandingLongJump = 8,

    /// <summary>The ground under the feet is water.</summary>
    InWater = 16,

    /// <summary>The cell is not loaded.</summary>
    Nowhere = 32,

    /// <summary>The cell is a room from which the land is not seen.</summary>
    Enclosed = 64,
}

/// <summary>A player as the last tick of the physics left it.</summary>
/// <param name="Time">Time of that tick, seconds of the server's clock.</param>
/// <param name="CellId">Cell, 0xXXYYCCCC; the high half names the landblock in whose coordinates the position is.</param>
/// <param name="Position">Metres in the landblock: x east, y north, z up.</param>
/// <param name="Yaw">Radians about z, counter-clockwise from north.</param>
/// <param name="Velocity">Metres a second over the last tick.</param>
/// <param name="Speed">Speed over ground, metres a second, averaged over the last ticks: single ticks carry whole animation frames.</param>
/// <param name="Flags">Contact and charge.</param>
/// <param name="ContactPlane">Plane touched, in the landblock's coordinates; only with <see cref="PoseFlags.Contact"/>.</param>
/// <param name="Charge">Jump bar, 0 to 1.</param>
/// <param name="Quantum">Duration of the last tick, seconds.</param>
/// <param name="RunRate">Run rate that the motion interpreter uses now; run speed is 4 × it.</param>
/// <param name="ForwardCommand">Interpreted forward command.</param>
/// <param name="ForwardSpeed">Its signed speed factor.</param>
/// <param name="SidestepSpeed">Signed factor, right is positive, 0 when not sidestepping.</param>
/// <param name="TurnSpeed">Signed factor, right is positive, 0 when not turning.</param>
/// <param name="Teleports">Counts placements, modulo 256: poses with different counts are not joined by a line.</param>
/// <param name="Walks">Counts walks begun, modulo 256: see <see cref="WalkRecorder"/>.</param>
internal readonly record struct PlayerPose(
    double Time,
    uint CellId,
    Vector3 Position,
    float Yaw,
    Vector3 Velocity,
    float Speed,
    PoseFlags Flags,
    Plane ContactPlane,
    float Charge,
    float Quantum,
    float RunRate,
    uint ForwardCommand,
    float ForwardSpeed,
    float SidestepSpeed,
    float TurnSpeed,
    byte Teleports,
    byte Walks = 0)
{
    /// <summary>The heading of a position as the page takes it: radians counter-clockwise from north.</summary>
    public static float YawOf(in Position position) => (float)(-position.Frame.Heading * Math.PI / 180.0);
}

/// <summary>What can happen to a player between two poses.</summary>
internal enum PlayerEventKind : byte
{
    /// <summary>Value: extent 0 to 1.</summary>
    Jumped = 1,

    /// <summary>Value: speed downwards, metres a second.</summary>
    Landed = 2,

    /// <summary>Code: the motion interpreter's error.</summary>
    JumpRefused = 3,

    /// <summary>The server answered with a run rate. Value: the rate.</summary>
    RunRateChanged = 4,

    /// <summary>The player is where it was, because nobody can be at the place asked for. Code: the <see cref="PlaceRefusal"/>.</summary>
    PlaceRefused = 5,
}

/// <summary>Something that happened to a player.</summary>
/// <param name="Kind">What.</param>
/// <param name="Time">When, seconds of the server's clock.</param>
/// <param name="Value">See <see cref="PlayerEventKind"/>.</param>
/// <param name="Code">See <see cref="PlayerEventKind"/>.</param>
internal readonly record struct PlayerEvent(PlayerEventKind Kind, double Time, float Value = 0, uint Code = 0);
