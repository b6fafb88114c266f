using System.Numerics;

namespace Surefoot.Workbench.Simulation;

/// <summary>What a body is that is no player.</summary>
internal enum BodyKind : byte
{
    /// <summary>Stands and blocks.</summary>
    Guard = 1,

    /// <summary>A creature that walks about.</summary>
    Wanderer = 2,

    /// <summary>One of a crowd.</summary>
    Crowd = 3,

    /// <summary>A door.</summary>
    Door = 4,
}

/// <summary>Facts about a body, as bits on the wire.</summary>
[Flags]
internal enum BodyFlags : byte
{
    None = 0,

    /// <summary>A door that lets everybody through.</summary>
    Open = 1,

    /// <summary>It closes as soon as nobody is in it.</summary>
    WaitsToClose = 2,

    /// <summary>Touches no ground.</summary>
    Airborne = 4,
}

/// <summary>A body as the last tick of the physics left it.</summary>
/// <param name="Id">Its id in the physics.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Flags">Open, in the air.</param>
/// <param name="Name">Unique name.</param>
/// <param name="CellId">Cell, 0xXXYYCCCC.</param>
/// <param name="Position">Metres in the cell's landblock.</param>
/// <param name="Yaw">Radians about z, counter-clockwise from north. Bodies stand upright.</param>
/// <param name="Velocity">Metres a second over the last tick.</param>
/// <param name="Scale">Uniform scale.</param>
/// <param name="Size">Extent of its collision shape along its own axes, metres, scale included.</param>
internal readonly record struct BodyPose(
    uint Id, BodyKind Kind, BodyFlags Flags, string Name, uint CellId, Vector3 Position, float Yaw, Vector3 Velocity, float Scale,
    Vector3 Size);

/// <summary>Where a body is in truth, of which a page hears by messages.</summary>
/// <param name="Id">Id of the body, or of the player.</param>
/// <param name="CellId">Cell.</param>
/// <param name="Position">Metres in the landblock.</param>
/// <param name="Yaw">Radians about z, counter-clockwise from north.</param>
internal readonly record struct TruePlace(uint Id, uint CellId, Vector3 Position, float Yaw);
