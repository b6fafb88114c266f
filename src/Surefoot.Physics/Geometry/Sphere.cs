using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>A sphere: centre and radius in metres.</summary>
/// <param name="Center">Centre, in the frame the context names.</param>
/// <param name="Radius">Radius, metres.</param>
public record struct Sphere(Vector3 Center, float Radius)
{
    internal readonly void ThrowIfBad(string name)
    {
        if (!RetailMath.IsFinite(Center)) throw new ArgumentException("The centre of a sphere is not finite.", name);
        if (!(Radius > 0) || !float.IsFinite(Radius))
            throw new ArgumentException("The radius of a sphere is not a positive finite number.", name);
    }
}
