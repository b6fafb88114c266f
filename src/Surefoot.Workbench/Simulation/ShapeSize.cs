using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Workbench.Simulation;

/// <summary>How large the shape is that stops others at a body.</summary>
internal static class ShapeSize
{
    /// <summary>Extent along the body's own axes, metres: of its parts' polygons, else of its cylinders, else of its spheres.</summary>
    /// <param name="setup">The body's shape.</param>
    /// <param name="scale">Its scale.</param>
    public static Vector3 Of(SetupAsset setup, float scale)
    {
        Vector3 least = new(float.PositiveInfinity), most = new(float.NegativeInfinity);
        if (setup.HasPhysicsBsp)
        {
            ReadOnlySpan<Frame> pose = setup.RestPose;
            for (int i = 0; i < Math.Min(setup.Parts.Length, pose.Length); i++)
            {
                foreach (Vector3 corner in setup.Parts[i].Mesh.Polygons.Corners)
                    Take(pose[i].LocalToGlobal(corner * setup.Parts[i].DefaultScale.Z), Vector3.Zero);
            }
        }
        else if (setup.Cylinders.Length > 0)
        {
            foreach (CylSphere cylinder in setup.Cylinders)
            {
                Vector3 half = new(cylinder.Radius, cylinder.Radius, cylinder.Height / 2);
                Take(cylinder.LowPoint + new Vector3(0, 0, half.Z), half);
            }
        }
        else
        {
            foreach (Sphere sphere in setup.Spheres) Take(sphere.Center, new Vector3(sphere.Radius));
        }

        return least.X <= most.X ? (most - least) * scale : Vector3.Zero;

        void Take(Vector3 center, Vector3 half)
        {
            least = Vector3.Min(least, center - half);
            most = Vector3.Max(most, center + half);
        }
    }
}
