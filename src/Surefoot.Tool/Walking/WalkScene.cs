using System.Globalization;
using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool.Walking;

/// <summary>A place to begin at.</summary>
/// <param name="Name">Its name, or the words it was given in.</param>
/// <param name="Position">Where, and facing where.</param>
internal sealed record ScenePlace(string Name, Position Position);

/// <summary>Opened dat files, a world over them, and what a player is made of.</summary>
internal sealed class WalkScene : IDisposable
{
    /// <summary>Blocks kept loaded around the body: one more than retail's ring, so that the ring is always whole.</summary>
    internal const int LoadRadius = 2;

    internal const uint PlayerId = 0x50000001;

    /// <summary>Retail's human setup; the demo world has one under the same id.</summary>
    private const uint HumanSetup = 0x02000001;

    private readonly DatSet dats;
    private readonly bool isDemo;
    private uint followedBlock;

    private WalkScene(DatSet dats, bool isDemo)
    {
        this.dats = dats;
        this.isDemo = isDemo;
        Cache = new PhysicsDataCache(dats);
        World = new PhysicsWorld(Cache);
    }

    internal PhysicsDataCache Cache { get; }

    internal PhysicsWorld World { get; }

    internal SetupAsset PlayerSetup => Cache.GetSetup(HumanSetup);

    internal MotionTableAsset PlayerMotions => MotionTableLoader.LoadFor(dats, PlayerSetup, leftOut: World.LeftOut);

    /// <summary>Opens a folder, or the demo world without one.</summary>
    internal static WalkScene Open(DirectoryInfo? folder) =>
        new(DatSet.Open(folder?.FullName ?? DemoWorldCache.GetOrCreate(notice: CommonOptions.Say)), folder is null);

    /// <summary>Opens a folder and loads every landblock there is.</summary>
    internal static WalkScene OpenWhole(DirectoryInfo folder)
    {
        WalkScene scene = new(DatSet.Open(folder.FullName), isDemo: false);
        foreach (uint id in scene.dats.IdsOf(DatRecordType.LandBlock)) scene.World.LoadLandblock(id);
        return scene;
    }

    /// <summary>Keeps the blocks around a place loaded.</summary>
    internal void Follow(in Position position)
    {
        uint block = CellIds.BlockOf(position.CellId);
        if (block == followedBlock) return;
        followedBlock = block;
        World.EnsureLoadedAround(position, LoadRadius);
    }

    /// <summary>Finds a named place of the demo world, or reads <c>0xCELL,x,y,z[,heading]</c>, and loads what is around it.</summary>
    /// <exception cref="UsageException">There is no such place.</exception>
    internal ScenePlace FindPlace(string text)
    {
        if (text.StartsWith("0x", StringComparison.OrdinalIgnoreCase)) return Existing(ParsePlace(text));
        if (!isDemo) throw new UsageException($"--at '{text}': named places belong to the demo world; with --dats give a cell and metres, for example --at 0xA9B40001,12,12,0.");
        if (!DemoPlaces.TryFind(text, out NamedPlace place))
            throw new UsageException($"--at '{text}': there is no such place. Did you mean {string.Join(", ", DemoPlaces.Resembling(text))}? 'surefoot demo places' lists them all.");
        return new ScenePlace(place.Name, new Position(place.CellId, new Frame(place.Origin, place.Orientation)));
    }

    /// <summary>The place, with its cell put right for its metres, if these files have such a cell.</summary>
    private ScenePlace Existing(ScenePlace place)
    {
        Position position = place.Position;
        Follow(position);
        uint asked = position.CellId;
        string where = CellIds.IsOutdoor(asked) ? "that land" : "that room";
        if (CellIds.IsOutdoor(asked) && !position.AdjustToOutside())
            throw new UsageException($"--at '{place.Name}' is outside the map, which ends at landblock FEFE.");
        if (World.GetVisible(position.CellId) is null)
            throw new UsageException($"--at '{place.Name}': {dats.Folder} has no cell 0x{position.CellId:X8}; {where} does not exist there. 'surefoot dats list' shows what does.");
        return place with { Position = position };
    }

    /// <summary>Height of the loaded terrain at a place of the map, metres.</summary>
    internal double? GroundHeight(double east, double north)
    {
        int column = (int)Math.Floor(east / CellIds.BlockSize), row = (int)Math.Floor(north / CellIds.BlockSize);
        if (column is < 0 or > 254 || row is < 0 or > 254) return null;
        Landblock? block = World.FindLandblock(((uint)column << 24) | ((uint)row << 16) | 1);
        float x = (float)(east - (column * CellIds.BlockSize)), y = (float)(north - (row * CellIds.BlockSize));
        return block is not null && block.Terrain.TryGetHeight(x, y, out float height) ? height : null;
    }

    public void Dispose() => dats.Dispose();

    private static ScenePlace ParsePlace(string text)
    {
        string[] parts = text.Split(',');
        float[] numbers = new float[parts.Length - 1];
        bool good = parts.Length is 4 or 5 && uint.TryParse(parts[0].AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out _);
        for (int i = 1; good && i < parts.Length; i++)
            good = float.TryParse(parts[i], NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i - 1]) && float.IsFinite(numbers[i - 1]);
        if (!good) throw new UsageException($"--at '{text}' is not a cell and metres: for example --at 0xA9B40001,12,12,0 or with a heading in degrees 0xA9B40001,12,12,0,90.");
        uint cell = uint.Parse(parts[0].AsSpan(2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
        if ((cell & 0xFFFF) >= 0xFFFE) throw new UsageException($"--at '{text}': 0x{cell:X8} is the id of a landblock's record, not of a cell: give one of its cells, for example 0x{(cell & 0xFFFF0000) | 1:X8}.");
        if (!CellIds.HasValidIndex(cell)) throw new UsageException($"--at '{text}': 0x{cell:X8} cannot name a cell: its low half is 0001 to 0040 outdoors, 0100 to FFFD indoors.");
        Frame frame = new(new Vector3(numbers[0], numbers[1], numbers[2]), Quaternion.Identity);
        if (numbers.Length == 4) frame.SetHeading(numbers[3]);
        return new ScenePlace(text, new Position(cell, frame));
    }
}
