using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Scenes;

/// <summary>A scene that goes on.</summary>
public abstract class SceneRun
{
    /// <summary>Seconds of a quantum.</summary>
    protected const float Quantum = 1f / 30;

    private const uint HumanSetup = 0x02000001;

    /// <summary>A world of which nothing is loaded yet.</summary>
    /// <param name="dats">The demo world's files.</param>
    private protected SceneRun(DatSet dats)
    {
        ArgumentNullException.ThrowIfNull(dats);
        Cache = new PhysicsDataCache(dats);
        Engine = new PhysicsEngine(Cache);
        Human = Cache.GetSetup(HumanSetup);
        Motions = MotionTableLoader.Load(dats, Human.DefaultMotionTableId);
    }

    /// <summary>The world's engine.</summary>
    public PhysicsEngine Engine { get; }

    private protected PhysicsWorld World => Engine.World;

    private protected PhysicsDataCache Cache { get; }

    private protected SetupAsset Human { get; }

    private protected MotionTableAsset Motions { get; }

    /// <summary>One quantum of 1/30 s.</summary>
    public abstract void AdvanceQuantum();

    /// <summary>A named place of the demo world, which is loaded around it.</summary>
    private protected Position Load(string name, int radius)
    {
        if (!DemoPlaces.TryFind(name, out NamedPlace place)) throw new ArgumentException($"There is no place {name}.", nameof(name));
        Position position = new(place.CellId, new Frame(place.Origin, place.Orientation));
        World.EnsureLoadedAround(position, radius);
        return position;
    }
}
