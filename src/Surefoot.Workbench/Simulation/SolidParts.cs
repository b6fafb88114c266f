using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>A part of an object whose polygons stop bodies.</summary>
/// <param name="Index">Which part of the object.</param>
/// <param name="Polygons">Its collision polygons, in its own frame.</param>
/// <param name="Frame">Where it is now, in the object's landblock.</param>
/// <param name="Scale">Its scale.</param>
internal readonly record struct SolidPart(int Index, PolygonSet Polygons, Frame Frame, float Scale);

/// <summary>The solid parts of objects.</summary>
internal static class SolidParts
{
    /// <summary>The solid parts of an object, as they are now.</summary>
    public static IEnumerable<SolidPart> Of(WorldObject item)
    {
        if (item.Setup is not { } setup) yield break;
        for (int i = 0; i < item.PlacedPartCount; i++)
        {
            SetupPart part = setup.Parts[i];
            if (part.Mesh.Polygons.Count > 0)
                yield return new SolidPart(i, part.Mesh.Polygons, item.PartFrame(i), part.DefaultScale.Z * item.Scale);
        }
    }
}
