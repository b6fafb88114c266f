using System.Collections.Immutable;
using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Buildings;
using Surefoot.DemoWorld.Land;
using Surefoot.DemoWorld.Records;

namespace Surefoot.DemoWorld.Placement;

/// <summary>All that a world contains and where: the land, what stands on it, places and spawns.</summary>
/// <remarks>Spots are in metres from the land's south-west corner, with absolute heights.</remarks>
internal sealed class WorldPlan
{
    // A human's lower sphere has a radius of 0.48 m about 0.475 m: at rest its feet are 5 mm above what carries it. On flat polygons
    // places must be exact: retail's placement does not push a body out that overlaps the floor under certain planes of a tree
    // (spec 04, 4.5, sphere_intersects_solid_poly).
    private const double FeetAboveFloor = 0.005;

    // On the very line between two squares of land a body may be said to be in either; places and spawns stand this far beside it.
    private const double BesideEdge = 0.01;

    private readonly SortedDictionary<uint, BlockContent> blocks = [];
    private readonly ImmutableArray<NamedPlace>.Builder places = ImmutableArray.CreateBuilder<NamedPlace>();
    private readonly ImmutableArray<DemoSpawn>.Builder spawns = ImmutableArray.CreateBuilder<DemoSpawn>();

    private readonly ImmutableArray<DemoShooter>.Builder shooters = ImmutableArray.CreateBuilder<DemoShooter>();

    private WorldPlan(DemoTerrain terrain) => Terrain = terrain;

    public DemoTerrain Terrain { get; }

    public ImmutableArray<NamedPlace> Places => places.ToImmutable();

    public ImmutableArray<DemoSpawn> Spawns => spawns.ToImmutable();

    public ImmutableArray<DemoShooter> Shooters => shooters.ToImmutable();

    /// <summary>Static objects and buildings with the upper halves of the cell ids of their blocks.</summary>
    public IEnumerable<(uint BlockId, StaticObject Thing)> Things
        => blocks.SelectMany(block => block.Value.Objects
            .Concat(block.Value.Buildings.Select(building => new StaticObject(building.ModelId, building.Frame)))
            .Select(thing => (block.Key, thing)));

    /// <summary>Plans the world of a seed.</summary>
    public static WorldPlan Create(uint seed)
    {
        var terrain = new DemoTerrain(seed);
        var plan = new WorldPlan(terrain);
        LandPlaces.AddTo(plan);
        Town.AddTo(plan);
        ObstaclePark.AddTo(plan);
        DungeonPlaces.AddTo(plan);
        Inhabitants.AddTo(plan);
        Mill.AddTo(plan);
        Archery.AddTo(plan);
        foreach (var place in plan.places)
            terrain.ClearSceneryAround(place);
        return plan;
    }

    /// <summary>A spot on the ground.</summary>
    public Spot Ground(double x, double y, double heading = 0)
        => new(x, y, Terrain.GroundAt(x, y).Position.Z, heading);

    /// <summary>Adds a static object at a spot whose z is absolute.</summary>
    public void AddObject(uint id, Spot spot)
    {
        var (block, local) = Localise(spot);
        blocks[block] = ContentOf(block) with { Objects = ContentOf(block).Objects.Add(new(id, local.ToFrame())) };
    }

    /// <summary>Adds a building with its rooms and gives the id of the first room's cell.</summary>
    public uint AddBuilding(uint shell, Interior interior, Spot spot)
    {
        var (block, local) = Localise(spot);
        var content = ContentOf(block);
        ushort firstCell = (ushort)(0x100 + content.Cells.Length);
        blocks[block] = content with
        {
            Buildings = content.Buildings.Add(new(shell, local.ToFrame(), 1, interior.WaysIn(firstCell))),
            Cells = content.Cells.AddRange(interior.Cells(block, firstCell, local)),
        };
        return block | firstCell;
    }

    /// <summary>Adds rooms without a building in a block that is not part of the land.</summary>
    public void AddDungeon(uint block, Interior interior, Spot local)
        => blocks[block] = ContentOf(block) with { Cells = [.. interior.Cells(block, 0x100, local)] };

    /// <summary>Adds a place outdoors with feet on the ground.</summary>
    public void AddPlace(string name, string title, double x, double y, double heading, string whatToTry)
    {
        var ground = Terrain.GroundAt(OffEdge(x), OffEdge(y));
        places.Add(new(name, title, ground.CellId, ground.Position with { Z = ground.RestHeight }, (float)heading, whatToTry));
    }

    /// <summary>Adds a place outdoors on top of something; the spot has the height of its surface.</summary>
    public void AddPlaceOn(string name, string title, Spot spot, string whatToTry)
    {
        spot = OffEdge(spot);
        places.Add(new(name, title, Terrain.GroundAt(spot.X, spot.Y).CellId, FeetOn(Localise(spot).Local), (float)spot.Heading, whatToTry));
    }

    /// <summary>Adds a place in a room; the spot lies on the floor. That of a place in the dungeon is in its block's coordinates.</summary>
    public void AddPlaceIn(uint cellId, string name, string title, Spot spot, string whatToTry)
    {
        var local = (cellId & 0xFFFF0000) == Dungeon.BlockId ? spot : Localise(spot).Local;
        places.Add(new(name, title, cellId, FeetOn(local), (float)spot.Heading, whatToTry));
    }

    /// <summary>Adds something to spawn outdoors.</summary>
    public void AddSpawn(string name, DemoSpawnKind kind, uint setup, Spot spot, double wanderRadius = 0)
    {
        spot = OffEdge(spot);
        spawns.Add(
            new(name, kind, setup, Terrain.GroundAt(spot.X, spot.Y).CellId, Localise(spot).Local.ToVector(), (float)spot.Heading,
                (float)wanderRadius));
    }

    /// <summary>Adds something that shoots arrows outdoors; the spot is its muzzle, with an absolute height.</summary>
    public void AddShooter(string name, Spot spot, float pitch, float speed, float period, bool falls)
    {
        spot = OffEdge(spot);
        shooters.Add(new(
            name, DemoIds.ArrowSetup, Terrain.GroundAt(spot.X, spot.Y).CellId, Localise(spot).Local.ToVector(), (float)spot.Heading, pitch,
            speed, period, falls));
    }

    /// <summary>All records of the cell file.</summary>
    public IEnumerable<DatRecord> CellRecords()
    {
        foreach (var (x, y) in DemoTerrain.Blocks)
            yield return LandRecords.Block(Terrain, x, y, blocks.ContainsKey(((uint)x << 24) | ((uint)y << 16)));
        yield return LandRecords.Sea(Dungeon.BlockId | 0xFFFF);
        foreach (var (block, content) in blocks)
        {
            yield return new LandBlockInfo
            {
                Id = block | 0xFFFE,
                CellCount = (uint)content.Cells.Length,
                Objects = content.Objects,
                Buildings = content.Buildings,
            };
            foreach (var cell in content.Cells)
                yield return cell;
        }
    }

    private static double OffEdge(double metres)
    {
        double edge = Math.Round(metres / Landform.CellSide) * Landform.CellSide;
        return Math.Abs(metres - edge) < BesideEdge ? edge + BesideEdge : metres;
    }

    private static Spot OffEdge(Spot spot) => spot with { X = OffEdge(spot.X), Y = OffEdge(spot.Y) };

    private static Vector3 FeetOn(Spot floor) => floor.At(0, 0, FeetAboveFloor).ToVector();

    // From the land's coordinates to those of the block under the spot.
    private static (uint Block, Spot Local) Localise(Spot spot)
    {
        int x = (int)Math.Floor(spot.X / DemoTerrain.BlockSide), y = (int)Math.Floor(spot.Y / DemoTerrain.BlockSide);
        uint block = ((uint)(DemoTerrain.FirstBlockX + x) << 24) | ((uint)(DemoTerrain.FirstBlockY + y) << 16);
        return (block, spot with { X = spot.X - (x * (double)DemoTerrain.BlockSide), Y = spot.Y - (y * (double)DemoTerrain.BlockSide) });
    }

    private BlockContent ContentOf(uint block) => blocks.TryGetValue(block, out var content) ? content : new([], [], []);

    private sealed record BlockContent(
        ImmutableArray<StaticObject> Objects, ImmutableArray<Building> Buildings, ImmutableArray<EnvCell> Cells);
}
