using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;

namespace Surefoot.Workbench.Simulation;

/// <summary>The places that are offered when nobody names others.</summary>
internal static class KnownPlaces
{
    // Seventy degrees.
    private const float Aside = 1.22f;

    /// <summary>The demo world's own.</summary>
    public static IReadOnlyList<WorkbenchPlace> Demo() =>
    [
        .. DemoPlaces.All.Select(place => new WorkbenchPlace(
            place.Title, place.CellId, place.Origin, -place.Heading * MathF.PI / 180f, place.WhatToTry, LookFrom(place))),
    ];

    /// <summary>Towns of the retail world, on whatever ground the files have there.</summary>
    public static IReadOnlyList<WorkbenchPlace> Retail() =>
    [
        Town("Holtburg", 0xA9B40019, 84, 7),
        Town("Shoushi", 0xDA55001D, 85, 107),
        Town("Yaraq", 0x7D64000D, 33, 98),
        Town("Cragstone", 0xBB9F0040, 180, 180),
        Town("Eastham", 0xCE940035, 150, 100),
        Town("Arwic", 0xC6A90009, 30, 12),
        Town("Rithwic", 0xC98C0028, 110, 180),
        Town("Glenden Wood", 0xA0A40025, 108, 108),
    ];

    /// <summary>The middle of the first landblock that can be loaded, for files that have none of the places asked for.</summary>
    /// <param name="dats">The files.</param>
    /// <param name="loads">Whether a landblock can be loaded.</param>
    /// <exception cref="DatFolderException">There is no such landblock.</exception>
    public static WorkbenchPlace Somewhere(DatSet dats, Func<uint, bool> loads)
    {
        uint record = dats.IdsOf(DatRecordType.LandBlock).FirstOrDefault(loads);
        if (record == 0) throw new DatFolderException(dats.Folder, $"'{dats.Folder}' has no landblock to stand on");
        return Town("Somewhere", (record & 0xFFFF0000) | 0x25, 108, 108);
    }

    /// <summary>Slopes are looked at from the right, where their rise is seen in profile.</summary>
    private static float LookFrom(NamedPlace place)
    {
        bool isSlope = place.Name.StartsWith("slope-", StringComparison.Ordinal) ||
            place.Name.StartsWith("wedge-", StringComparison.Ordinal);
        // The wall is on the right there.
        if (place.Name == "wall-and-slope") return -Aside;
        return isSlope || place.Name is "foot-of-the-mountain" or "cliff-foot" ? Aside : 0;
    }

    private static WorkbenchPlace Town(string name, uint cellId, float x, float y) => new(name, cellId, new Vector3(x, y, float.NaN), 0);
}
