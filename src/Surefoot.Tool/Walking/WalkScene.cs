using Surefoot.DemoWorld;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Tool.Commands;

namespace Surefoot.Tool.Walking;

/// <summary>A place to begin at.</summary>
/// <param name="Name">Its name, or the words it was given in.</param>
/// <param name="Place">Where, and facing where.</param>
internal sealed record ScenePlace(string Name, Place Place);

/// <summary>A simulation over a folder, or over the demo world, whose places have names.</summary>
internal sealed class WalkScene : IDisposable
{
    private readonly bool isDemo;

    private WalkScene(Simulation simulation, bool isDemo)
    {
        Simulation = simulation;
        this.isDemo = isDemo;
    }

    internal Simulation Simulation { get; }

    /// <summary>Opens a folder, or the demo world without one.</summary>
    internal static WalkScene Open(DirectoryInfo? folder) =>
        new(Simulation.Open(folder?.FullName ?? DemoWorldCache.GetOrCreate(notice: CommonOptions.Say)), folder is null);

    /// <summary>Finds a named place of the demo world, or reads one that is given as a cell and metres.</summary>
    /// <exception cref="UsageException">There is no such name, or the words are no place.</exception>
    /// <param name="text">The name, or the cell and metres.</param>
    /// <param name="option">The option that the words were given for.</param>
    internal ScenePlace FindPlace(string text, string option = "--at")
    {
        if (text.StartsWith("0x", StringComparison.OrdinalIgnoreCase)) return new ScenePlace(text, ParsePlace(text, option));
        if (!isDemo)
        {
            string instead = $"with --dats give a cell and metres, for example {option} 0xA9B40001,12,12,0";
            throw new UsageException($"{option} '{text}': named places belong to the demo world; {instead}.");
        }

        if (!DemoPlaces.TryFind(text, out NamedPlace place))
        {
            string names = string.Join(", ", DemoPlaces.Resembling(text));
            throw new UsageException(
                $"{option} '{text}': there is no such place. Did you mean {names}? 'surefoot demo places' lists them all.");
        }

        return new ScenePlace(place.Name, new Position(place.CellId, new Frame(place.Origin, place.Orientation)));
    }

    /// <summary>Height of the loaded terrain at a place of the map, metres.</summary>
    internal double? GroundHeight(double east, double north)
    {
        int column = (int)Math.Floor(east / CellIds.BlockSize), row = (int)Math.Floor(north / CellIds.BlockSize);
        if (column is < 0 or > 254 || row is < 0 or > 254) return null;
        Landblock? block = Simulation.World.FindLandblock(((uint)column << 24) | ((uint)row << 16) | 1);
        float x = (float)(east - (column * CellIds.BlockSize)), y = (float)(north - (row * CellIds.BlockSize));
        return block is not null && block.Terrain.TryGetHeight(x, y, out float height) ? height : null;
    }

    public void Dispose() => Simulation.Dispose();

    private static Place ParsePlace(string text, string option)
    {
        try
        {
            return Place.Parse(text);
        }
        catch (FormatException e)
        {
            throw new UsageException($"{option} {e.Message}");
        }
    }
}
