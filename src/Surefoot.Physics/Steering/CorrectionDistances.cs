using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>How far a body may be from where a server says it is; the cell it is in decides.</summary>
internal static class CorrectionDistances
{
    /// <summary>Metres from which on a body is put to a position instead of moving there.</summary>
    /// <remarks>Retail: CPhysicsObj::GetAutonomyBlipDistance @0x0050EB70.</remarks>
    internal static float Blip(uint cellId, bool isLocalPlayer) => CellIds.IsOutdoor(cellId) ? 100f : isLocalPlayer ? 25f : 20f;

    /// <summary>Metres of path after which a leash brakes.</summary>
    /// <remarks>Retail: CPhysicsObj::GetStartConstraintDistance @0x0050EBC0.</remarks>
    internal static float LeashStart(uint cellId) => CellIds.IsOutdoor(cellId) ? 10f : 5f;

    /// <summary>Metres of path after which a leash holds.</summary>
    /// <remarks>Retail: CPhysicsObj::GetMaxConstraintDistance @0x0050EC10.</remarks>
    internal static float LeashMax(uint cellId) => CellIds.IsOutdoor(cellId) ? 50f : 20f;
}
