using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>What a transition asks of the world it moves through.</summary>
internal interface ICellWorld
{
    /// <summary>What the world does without because its record is missing or cannot be read.</summary>
    LeftOutList LeftOut { get; }

    /// <summary>Who may enter guarded cells; without it no player enters one.</summary>
    IMoveRestrictions? Restrictions { get; }

    /// <summary>The loaded cell with this id, or null.</summary>
    ObjCell? GetVisible(uint cellId);

    /// <summary>
    /// Rebuilds a list around spheres: the owner's cell, or the squares of land under the spheres, and every cell they reach from there.
    /// The home is the first room that contains the centre of sphere 0, else the last square of land that does.
    /// </summary>
    /// <param name="array">The list.</param>
    /// <param name="position">Cell and frame of the spheres' owner; its block is the one the spheres are in.</param>
    /// <param name="spheres">Spheres, block coordinates.</param>
    /// <param name="wantHome">Looks for the home, when the owner's own cell is loaded.</param>
    /// <param name="home">Becomes the home, null for none; without <paramref name="wantHome"/> it is left as it is.</param>
    /// <remarks>Retail: CObjCell::find_cell_list @0x0052B960; specification 03, 4.8.4.</remarks>
    void FindCellList(CellArray array, in Position position, ReadOnlySpan<Sphere> spheres, bool wantHome, ref ObjCell? home);

    /// <summary>
    /// Finds the cell a position belongs to, correcting its id and, outdoors, its coordinates. False when there is none; the cell may
    /// also be null when it is known but not loaded.
    /// </summary>
    /// <param name="position">The position to put right.</param>
    /// <param name="center">Centre of the body's first sphere in its own frame.</param>
    /// <param name="cell">The cell, null when it is not loaded.</param>
    /// <remarks>Retail: CPhysicsObj::AdjustPosition @0x00511D80; specification 02, 4.16.</remarks>
    bool AdjustPosition(ref Position position, in Vector3 center, out ObjCell? cell);

    /// <summary>Lists an object in exactly these cells.</summary>
    /// <remarks>Retail: CPhysicsObj::add_shadows_to_cells @0x00514AE0 after remove_shadows_from_cells.</remarks>
    void PlaceShadows(WorldObject item, CellArray cells);

    /// <summary>Lists an object in no cell.</summary>
    /// <remarks>Retail: CPhysicsObj::remove_shadows_from_cells @0x00511230.</remarks>
    void RemoveShadows(WorldObject item);

    /// <summary>Lists an object in every cell that its shape reaches from where it is.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_cross_cells @0x00515230.</remarks>
    void CalcCrossCells(WorldObject item);

    /// <summary>Does any other body overlap this object where it stands?</summary>
    /// <remarks>Retail: CPhysicsObj::ethereal_check_for_collisions @0x00510A40.</remarks>
    bool AnyOverlaps(WorldObject item);
}
