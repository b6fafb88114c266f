using System.Numerics;
using Surefoot.Dats;
using Surefoot.Physics.World;

namespace Surefoot.Scenes;

/// <summary>A crowd of 200 humans in the meadow who run in circles and into each other.</summary>
internal sealed class CrowdRun : SceneRun
{
    private double now;

    internal CrowdRun(DatSet dats, float spacing)
        : base(dats)
    {
        Position south = Load("meadow", 2);
        south.Frame.Origin += new Vector3(0, -spacing * (Runners.CrowdSize / Runners.PerRow / 2), 0);
        Runners.Spawn(Engine, Human, Motions, south, Runners.CrowdSize, spacing);
    }

    /// <summary>One tick of all of them.</summary>
    public override void AdvanceQuantum() => Engine.Tick(now += Quantum + 1e-9);
}
