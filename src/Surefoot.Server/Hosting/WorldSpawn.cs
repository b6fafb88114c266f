using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>What a thing does that a <see cref="WorldServer"/> spawns.</summary>
public enum WorldSpawnKind
{
    /// <summary>A creature: it stands at its place, or strays around it.</summary>
    Creature,

    /// <summary>A creature that chases players who come near, until they are far away again.</summary>
    Hunter,

    /// <summary>A door: it opens when it is used, and closes by itself.</summary>
    Door,
}

/// <summary>A thing that a <see cref="WorldServer"/> spawns.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">What it does.</param>
/// <param name="SetupId">Its shape, 0x02…</param>
/// <param name="Place">Where it belongs.</param>
/// <param name="WanderRadius">How far it strays, metres; 0 when it does not.</param>
public sealed record WorldSpawn(string Name, WorldSpawnKind Kind, uint SetupId, Position Place, float WanderRadius = 0);
