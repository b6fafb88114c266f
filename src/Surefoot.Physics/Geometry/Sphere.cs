using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>A sphere: centre and radius in metres.</summary>
/// <param name="Center">Centre, in the frame the context names.</param>
/// <param name="Radius">Radius, metres.</param>
public record struct Sphere(Vector3 Center, float Radius);
