using System.Numerics;
using Surefoot.Dats.Records;

namespace Surefoot.Physics.Assets;

/// <summary>The shape of rooms: what stops a body, what the room contains, and where its portals are. Immutable and shared.</summary>
/// <remarks>Retail: the collision side of CCellStruct.</remarks>
internal sealed class CellStructAsset
{
    private readonly ushort[] portalKeys;

    private CellStructAsset(PhysicsBsp physics, CellBsp cell, PolygonSet portals, ushort[] portalKeys)
    {
        Physics = physics;
        Cell = cell;
        Portals = portals;
        this.portalKeys = portalKeys;
    }

    /// <summary>The collision tree.</summary>
    public PhysicsBsp Physics { get; }

    /// <summary>The containment tree.</summary>
    public CellBsp Cell { get; }

    /// <summary>The portal polygons, in the order of the structure's portal list.</summary>
    public PolygonSet Portals { get; }

    /// <summary>
    /// Position in <see cref="Portals"/> of the polygon that a cell portal names. The name is a key, the only one in these files that is
    /// not a position; the first portal with it counts.
    /// </summary>
    /// <remarks>Retail: CCellStruct::get_portal @0x005338B0.</remarks>
    /// <returns>False when there is none: the cell that names it cannot be used.</returns>
    public bool TryFindPortal(ushort polygonKey, out int portal)
    {
        portal = Array.IndexOf(portalKeys, polygonKey);
        return portal >= 0;
    }

    /// <summary>Flattens one structure of an environment.</summary>
    /// <param name="environment">The environment's record, for errors.</param>
    /// <param name="record">The structure.</param>
    /// <exception cref="Dats.DatFormatException">The record contradicts itself.</exception>
    internal static CellStructAsset Build(CellEnvironment environment, CellStruct record)
    {
        RecordFlattener flattener = new(environment);
        Vector3[] vertices = flattener.Vertices(record.Vertices);
        DatPolygon[] portals = new DatPolygon[record.PortalPolygons.Length];
        for (int i = 0; i < portals.Length; i++)
        {
            int index = record.PortalPolygons[i];
            if (index >= record.Polygons.Length) throw flattener.Error($"portal {i} names polygon {index} of {record.Polygons.Length}");
            portals[i] = record.Polygons[index];
        }

        return new CellStructAsset(
            flattener.PhysicsTree(record.PhysicsTree, flattener.Polygons(record.PhysicsPolygons.AsSpan(), vertices, "physics")),
            RecordFlattener.CellTree(record.CellTree),
            flattener.Polygons(portals, vertices, "portal"),
            [.. portals.Select(p => p.Key)]);
    }
}

/// <summary>The shapes of rooms in one environment record. Immutable and shared.</summary>
/// <remarks>Retail: CEnvironment.</remarks>
internal sealed class EnvironmentAsset
{
    private readonly CellStructAsset[] structures;

    private EnvironmentAsset(uint id, CellStructAsset[] structures)
    {
        Id = id;
        this.structures = structures;
    }

    /// <summary>Id of the record, 0x0D…</summary>
    public uint Id { get; }

    /// <summary>The structures; a cell names one by its position.</summary>
    public ReadOnlySpan<CellStructAsset> Structures => structures;

    /// <summary>The structure at a position, or null.</summary>
    public CellStructAsset? this[int index] => (uint)index < (uint)structures.Length ? structures[index] : null;

    /// <summary>Flattens a record.</summary>
    internal static EnvironmentAsset Build(CellEnvironment record) =>
        new(record.Id, [.. record.Cells.Select(c => CellStructAsset.Build(record, c))]);
}
