using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance;

/// <summary>A folder of dat files of which every landblock is loaded.</summary>
internal sealed class WholeWorld : IDisposable
{
    private readonly DatSet dats;

    private WholeWorld(DatSet dats)
    {
        this.dats = dats;
        Cache = new PhysicsDataCache(dats);
        World = new PhysicsWorld(Cache);
        foreach (uint id in dats.IdsOf(DatRecordType.LandBlock)) World.LoadLandblock(id);
    }

    internal PhysicsDataCache Cache { get; }

    internal PhysicsWorld World { get; }

    internal static WholeWorld Open(DirectoryInfo folder) => new(DatSet.Open(folder.FullName));

    public void Dispose() => dats.Dispose();
}
