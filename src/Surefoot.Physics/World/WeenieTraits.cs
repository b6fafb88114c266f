namespace Surefoot.Physics.World;

/// <summary>What a server says of an object that matters to collisions; <see cref="None"/> is an object without a weenie.</summary>
[Flags]
public enum WeenieTraits
{
    /// <summary>No weenie.</summary>
    None = 0,

    /// <summary>A weenie with no other trait.</summary>
    Present = 0x1,

    /// <summary>A creature.</summary>
    Creature = 0x2,

    /// <summary>A player.</summary>
    Player = 0x4,

    /// <summary>A player killer.</summary>
    PK = 0x8,

    /// <summary>A player killer lite.</summary>
    PKLite = 0x10,

    /// <summary>A player that others do not pass.</summary>
    Impenetrable = 0x20,

    /// <summary>A hook.</summary>
    Hook = 0x40,

    /// <summary>A storage chest.</summary>
    Storage = 0x80,

    /// <summary>A corpse.</summary>
    Corpse = 0x100,
}
