using System.Numerics;

namespace Surefoot.Workbench.Simulation;

/// <summary>What kind of thing a player touches.</summary>
internal enum TouchKind : byte
{
    /// <summary>Terrain; the id is the land cell's.</summary>
    Ground = 1,

    /// <summary>The outside of a building; the id is its model's.</summary>
    Building = 2,

    /// <summary>A room's floor, wall or ceiling; the id is the EnvCell's.</summary>
    Room = 3,

    /// <summary>A piece of scenery; the id is its setup's or mesh's.</summary>
    Scenery = 4,

    /// <summary>A static object; the id is its setup's or mesh's.</summary>
    Object = 5,

    /// <summary>A body that is no player; the id is the body's.</summary>
    Body = 6,

    /// <summary>A player; the id is the body's.</summary>
    Player = 7,
}

/// <summary>Something that a player stands on or touches.</summary>
/// <param name="IsFooting">It is what the player stands on.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Id">See <see cref="TouchKind"/>.</param>
/// <param name="Normal">Unit vector from it to the player: the contact plane's normal, or that of the surface touched.</param>
/// <param name="Name">Name of a body; empty for others, which have none.</param>
internal readonly record struct Touch(bool IsFooting, TouchKind Kind, uint Id, Vector3 Normal, string Name);
