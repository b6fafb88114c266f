using System.Numerics;

namespace Surefoot.Physics.Geometry;

/// <summary>An upright cylinder of a setup. Whatever the object's orientation, it stands along the world's z axis.</summary>
/// <param name="LowPoint">Centre of the bottom disc, in the frame the context names, metres.</param>
/// <param name="Radius">Radius, metres.</param>
/// <param name="Height">Height above the bottom disc, metres.</param>
/// <remarks>Retail: CCylSphere.</remarks>
public record struct CylSphere(Vector3 LowPoint, float Radius, float Height);
