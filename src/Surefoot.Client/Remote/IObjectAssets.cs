using System.Diagnostics.CodeAnalysis;
using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client;

/// <summary>Where the shapes and motions of objects come from.</summary>
public interface IObjectAssets
{
    /// <summary>Finds a shape.</summary>
    /// <param name="id">Id of a setup, 0x02…, or of a mesh, 0x01…</param>
    /// <param name="setup">The shape.</param>
    /// <returns>False when it is missing or cannot be read.</returns>
    bool TryGetSetup(uint id, [NotNullWhen(true)] out SetupAsset? setup);

    /// <summary>Finds a motion table.</summary>
    /// <param name="id">Its id, 0x09…</param>
    /// <param name="setup">The shape that moves by it.</param>
    /// <param name="table">The motions.</param>
    /// <returns>False when it is missing or cannot be read.</returns>
    bool TryGetMotions(uint id, SetupAsset setup, [NotNullWhen(true)] out MotionTableAsset? table);
}

/// <summary>Shapes and motions from dat files, each read once.</summary>
/// <param name="cache">Shapes; may be shared.</param>
/// <param name="leftOut">Where animations that are missing are listed, usually <see cref="PhysicsWorld.LeftOut"/>.</param>
/// <param name="movesHands">
/// Motion tables of shapes that can hold things come with the places of the parts, so that what is held moves with the hand; they take
/// much more memory then. Without, it stays where the resting hand is. Shapes that are run into part by part, such as doors, get them in
/// any case.
/// </param>
public sealed class DatObjectAssets(PhysicsDataCache cache, LeftOutList? leftOut = null, bool movesHands = true) : IObjectAssets
{
    private readonly Dictionary<(uint Id, bool WithParts), MotionTableAsset> tables = [];

    /// <inheritdoc/>
    public bool TryGetSetup(uint id, [NotNullWhen(true)] out SetupAsset? setup)
    {
        setup = null;
        // Other records cannot be a shape, whatever their bytes are.
        if (id >> 24 is not (0x01 or 0x02)) return false;
        try
        {
            setup = cache.GetSetup(id);
            return true;
        }
        catch (Exception e) when (e is DatRecordMissingException or DatFormatException)
        {
            return false;
        }
    }

    /// <inheritdoc/>
    public bool TryGetMotions(uint id, SetupAsset setup, [NotNullWhen(true)] out MotionTableAsset? table)
    {
        ArgumentNullException.ThrowIfNull(setup);
        bool withParts = setup.HasPhysicsBsp || (movesHands && !setup.HoldingLocations.IsEmpty);
        if (tables.TryGetValue((id, withParts), out table)) return true;
        if (id >> 24 != 0x09) return false;
        try
        {
            table = MotionTableLoader.Load(cache.Source, id, withParts, leftOut);
        }
        catch (Exception e) when (e is DatRecordMissingException or DatFormatException)
        {
            return false;
        }

        tables.Add((id, withParts), table);
        return true;
    }
}
