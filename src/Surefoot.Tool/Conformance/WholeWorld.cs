using Surefoot.Dats;
using Surefoot.Physics;
using Surefoot.Physics.Assets;

namespace Surefoot.Tool.Conformance;

/// <summary>A folder of dat files of which every landblock is loaded.</summary>
internal sealed class WholeWorld : IDisposable
{
    private readonly DatSet dats;

    private WholeWorld(DatSet dats)
    {
        this.dats = dats;
        Cache = new PhysicsDataCache(dats);
        Engine = new PhysicsEngine(Cache);
        foreach (uint id in dats.IdsOf(DatRecordType.LandBlock)) Engine.World.LoadLandblock(id);
    }

    internal PhysicsDataCache Cache { get; }

    internal PhysicsEngine Engine { get; }

    internal static WholeWorld Open(DirectoryInfo folder) => new(DatSet.Open(folder.FullName));

    public void Dispose() => dats.Dispose();
}
