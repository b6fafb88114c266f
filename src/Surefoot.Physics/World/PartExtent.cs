using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>How far one part of an object reaches, for finding the cells it is in.</summary>
/// <param name="Position">Cell and frame of the part.</param>
/// <param name="Box">Box of the mesh in the part's frame; retail leaves the part's scale out of it.</param>
/// <param name="Sphere">The mesh's physics sphere, or its drawing sphere when it has none.</param>
/// <param name="HasSphere">The mesh has either.</param>
/// <param name="Always2D">The mesh is drawn as a picture that faces the viewer.</param>
internal readonly record struct PartExtent(Position Position, BoundingBox Box, Sphere Sphere, bool HasSphere, bool Always2D)
{
    /// <summary>The box in the block coordinates of <paramref name="to"/>.</summary>
    /// <remarks>Retail: BBox::LocalToGlobal @0x005B2120.</remarks>
    public BoundingBox BoxInBlockOf(in Position to)
    {
        BoundingBox box = new(to.LocalToGlobal(Position, Box.Corner(0)), to.LocalToGlobal(Position, Box.Corner(0)));
        for (int i = 1; i < 8; i++) box.Include(to.LocalToGlobal(Position, Box.Corner(i)));
        return box;
    }

    /// <summary>The box in the local frame of <paramref name="to"/>.</summary>
    /// <remarks>Retail: BBox::LocalToLocal @0x005B1E60.</remarks>
    public BoundingBox BoxIn(in Position to)
    {
        BoundingBox box = new(to.LocalToLocal(Position, Box.Corner(0)), to.LocalToLocal(Position, Box.Corner(0)));
        for (int i = 1; i < 8; i++) box.Include(to.LocalToLocal(Position, Box.Corner(i)));
        return box;
    }
}
