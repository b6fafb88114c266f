using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Authority;

/// <summary>The demo world's files, and engines over them: one for a client and one for its server.</summary>
internal sealed class AuthorityWorld : IDisposable
{
    private const uint HumanSetup = 0x02000001, FirstSpawn = 0x80000001;

    private readonly DatSet dats;
    private readonly RegionAsset region;

    internal AuthorityWorld(string folder)
    {
        dats = DatSet.Open(folder);
        Assets = new PhysicsDataCache(dats);
        region = RegionAsset.Load(dats);
        Human = Assets.GetSetup(HumanSetup);
        Motions = MotionTableLoader.LoadFor(dats, Human);
    }

    internal PhysicsDataCache Assets { get; }

    internal SetupAsset Human { get; }

    internal MotionTableAsset Motions { get; }

    /// <summary>A named place; metres to its right, ahead of it and above it, degrees to the right.</summary>
    internal static Position PlaceOf(string name, float right = 0, float ahead = 0, float turn = 0, float up = 0)
    {
        if (!DemoPlaces.TryFind(name, out NamedPlace place)) throw new InvalidDataException($"The demo world has no place '{name}'.");
        return Beside(new Position(place.CellId, new Frame(place.Origin, place.Orientation)), right, ahead, turn, up);
    }

    /// <summary>A place beside another one.</summary>
    internal static Position Beside(Position place, float right, float ahead, float turn = 0, float up = 0)
    {
        place.Frame.Origin = place.Frame.LocalToGlobal(new(right, ahead, up));
        place.Frame.SetHeading((float)((place.Frame.Heading + turn + 720) % 360));
        if (CellIds.IsOutdoor(place.CellId)) place.AdjustToOutside();
        return place;
    }

    /// <summary>An engine with all that the demo world has spawned, each standing where it was put.</summary>
    internal PhysicsEngine CreateEngine()
    {
        PhysicsEngine engine = new(Assets, new PhysicsEngineOptions { Region = region });
        uint id = FirstSpawn;
        foreach (DemoSpawn spawn in DemoSpawns.All)
        {
            engine.World.EnsureLoadedAround(new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)), 0);
            DemoBodies.Spawn(engine, Assets, spawn, id++);
        }

        return engine;
    }

    public void Dispose() => dats.Dispose();
}
