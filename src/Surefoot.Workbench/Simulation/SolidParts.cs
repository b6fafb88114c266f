using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;

namespace Surefoot.Workbench.Simulation;

/// <summary>The parts of an object whose polygons stop bodies, where they are now.</summary>
internal static class SolidParts
{
    /// <summary>The collision polygons of each such part, the part's frame in the object's landblock, and the part's scale.</summary>
    /// <param name="item">The object.</param>
    public static IEnumerable<(PolygonSet Polygons, Frame Frame, float Scale)> Of(WorldObject item)
    {
        if (item.Setup is not { } setup) yield break;
        for (int i = 0; i < item.PlacedPartCount; i++)
        {
            SetupPart part = setup.Parts[i];
            if (part.Mesh.Physics is not { } tree) continue;
            yield return (tree.Polygons, item.PartFrame(i), part.DefaultScale.Z * item.Scale);
        }
    }
}
