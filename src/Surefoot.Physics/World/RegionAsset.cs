using System.Collections.Concurrent;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.Physics.World;

/// <summary>
/// What all landblocks share: the heights their numbers stand for, and what grows on which ground. Immutable, shared by worlds and threads.
/// </summary>
/// <remarks>Retail: the parts of CRegionDesc that movement needs.</remarks>
public sealed class RegionAsset
{
    /// <summary>Greatest height of the ground, metres: 1000 for the sky less 200 for objects.</summary>
    internal const float MaxHeight = 800f;

    private readonly float[] heights = new float[Region.HeightCount];
    private readonly uint[][][] scenes = [];
    private readonly IDatSource? source;
    private readonly ConcurrentDictionary<uint, SceneAnswer> loaded = new();

    /// <summary>A region without scenery.</summary>
    /// <param name="heightTable">Up to 256 heights, metres; see <see cref="HeightTable"/>.</param>
    internal RegionAsset(ReadOnlySpan<float> heightTable)
    {
        for (int i = 0; i < Math.Min(heights.Length, heightTable.Length) && heightTable[i] is >= 0 and <= MaxHeight; i++)
            heights[i] = heightTable[i];
    }

    /// <summary>A region with the scenery of a record.</summary>
    /// <param name="record">The region.</param>
    /// <param name="source">Where the scenes come from.</param>
    internal RegionAsset(Region record, IDatSource source)
        : this(NotNull(record).HeightTable.AsSpan())
    {
        this.source = source;
        scenes = [.. record.TerrainTypes.Select(terrain => terrain.SceneTypes.Select(index => ScenesOf(record, index)).ToArray())];
    }

    /// <summary>Reads the region of the dat files.</summary>
    /// <exception cref="DatRecordMissingException">There is none.</exception>
    /// <exception cref="DatFormatException">It is malformed.</exception>
    public static RegionAsset Load(IDatSource source) => new(source.Read<Region>(DatIds.Region), source);

    /// <summary>
    /// The 256 heights, metres. They are taken from the file up to the first one outside 0 to <see cref="MaxHeight"/>; the rest is 0.
    /// </summary>
    /// <remarks>Retail: LandDefs::set_height_table @0x005A99E0.</remarks>
    public ReadOnlySpan<float> HeightTable => heights;

    /// <summary>Ids of the scenes that may stand on a kind of ground, empty for none.</summary>
    internal ReadOnlySpan<uint> ScenesOn(int terrainType, int sceneType) =>
        terrainType < scenes.Length && sceneType < scenes[terrainType].Length ? scenes[terrainType][sceneType] : default;

    /// <summary>A scene, or why there is none. Id 0 stands for none and is no fault.</summary>
    internal SceneAnswer FindScene(uint id) =>
        id == 0 || source is null ? default : loaded.GetOrAdd(id, static (key, from) => SceneAnswer.Read(from, key), source);

    private static uint[] ScenesOf(Region record, uint sceneType) =>
        sceneType < (uint)record.SceneTypes.Length ? [.. record.SceneTypes[(int)sceneType].SceneIds] : [];

    private static Region NotNull(Region record)
    {
        ArgumentNullException.ThrowIfNull(record);
        return record;
    }
}

/// <summary>A scene, or the fault that makes it unusable: its record is missing or cannot be read.</summary>
internal readonly record struct SceneAnswer(Scene? Scene, Exception? Fault)
{
    internal static SceneAnswer Read(IDatSource source, uint id)
    {
        try
        {
            return new SceneAnswer(source.Read<Scene>(id), null);
        }
        catch (Exception fault) when (fault is DatRecordMissingException or DatFormatException)
        {
            return new SceneAnswer(null, fault);
        }
    }
}
