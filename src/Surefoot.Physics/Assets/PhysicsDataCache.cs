using System.Buffers;
using System.Buffers.Binary;
using System.Collections.Concurrent;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.Physics.Assets;

/// <summary>
/// Builds collision assets from dat records, once for each id, and shares them. Assets are immutable: any number of worlds and threads may
/// use one cache.
/// </summary>
/// <remarks>Two threads that ask for a new id at the same moment may both build it; all callers get the same one.</remarks>
public sealed class PhysicsDataCache
{
    /// <summary>Where an animation record has its numbers of parts and frames.</summary>
    internal const long AnimationCounts = 8;

    private readonly ConcurrentDictionary<uint, GfxObjAsset> meshes = new();
    private readonly ConcurrentDictionary<uint, EnvironmentAsset> environments = new();
    private readonly ConcurrentDictionary<uint, SetupAsset> setups = new();
    private readonly ConcurrentDictionary<uint, AnimationAsset> animations = new();

    /// <summary>A cache over the dat files.</summary>
    public PhysicsDataCache(IDatSource source)
    {
        ArgumentNullException.ThrowIfNull(source);
        Source = source;
    }

    /// <summary>Where records come from.</summary>
    public IDatSource Source { get; }

    /// <summary>Number of assets built so far.</summary>
    internal int Count => meshes.Count + environments.Count + setups.Count + animations.Count;

    /// <summary>The mesh with an id 0x01…</summary>
    /// <exception cref="DatRecordMissingException">There is no such record.</exception>
    /// <exception cref="DatFormatException">
    /// The record is malformed: it names polygons or vertices that do not exist, or numbers that are not finite.
    /// </exception>
    public GfxObjAsset GetGfxObj(uint id) => GetGfxObj(id, null);

    /// <summary>The environment with an id 0x0D…</summary>
    /// <exception cref="DatRecordMissingException">There is no such record.</exception>
    /// <exception cref="DatFormatException">The record is malformed.</exception>
    internal EnvironmentAsset GetEnvironment(uint id) => environments.TryGetValue(id, out EnvironmentAsset? asset)
        ? asset
        : environments.GetOrAdd(id, EnvironmentAsset.Build(Source.Read<CellEnvironment>(id)));

    /// <summary>The setup with an id 0x02…, or the one that the mesh with an id 0x01… stands for.</summary>
    /// <exception cref="DatRecordMissingException">There is no such record, or a part's mesh is missing.</exception>
    /// <exception cref="DatFormatException">The record or a part's mesh is malformed.</exception>
    public SetupAsset GetSetup(uint id)
    {
        if (setups.TryGetValue(id, out SetupAsset? asset)) return asset;
        asset = (id >> 24) == 0x01
            ? SetupAsset.FromGfxObj(GetGfxObj(id))
            : SetupAsset.Build(Source.Read<Setup>(id), part => GetGfxObj(part, id));
        return setups.GetOrAdd(id, asset);
    }

    /// <summary>The animation that a setup plays by itself, with the places of its parts.</summary>
    /// <param name="id">Animation id, 0x03…</param>
    /// <param name="setupId">The setup that names it.</param>
    /// <exception cref="DatRecordMissingException">There is no such record.</exception>
    /// <exception cref="DatFormatException">The record is malformed, has no frames, or moves no parts.</exception>
    internal AnimationAsset GetDefaultAnimation(uint id, uint setupId)
    {
        if (animations.TryGetValue(id, out AnimationAsset? asset)) return asset;
        Animation record = Source.Read<Animation>(id, setupId);
        asset = AnimationAsset.Build(record, withParts: true);
        if (asset is null) throw new DatFormatException(record.File, id, AnimationCounts, "it has no frames");
        if (asset.PartFrames(0).IsEmpty) throw new DatFormatException(record.File, id, AnimationCounts, "it moves no parts");
        return animations.GetOrAdd(id, asset);
    }

    private GfxObjAsset GetGfxObj(uint id, uint? requestedBy)
    {
        if (meshes.TryGetValue(id, out GfxObjAsset? asset)) return asset;
        GfxObj record = Source.Read<GfxObj>(id, requestedBy);
        return meshes.GetOrAdd(id, GfxObjAsset.Build(record, IsAlways2D(record.DegradeId)));
    }

    /// <summary>
    /// Does the first level of a degrade record (u32 id, u32 count, then u32 mesh, u32 mode, … for each) have a mode other than 1? One that
    /// cannot be read counts as missing.
    /// </summary>
    private bool IsAlways2D(uint degradeId)
    {
        if (degradeId == 0 || !TryReadBytes(degradeId, out ReadOnlySequence<byte> bytes) || bytes.Length < 16) return false;
        Span<byte> head = stackalloc byte[16];
        bytes.Slice(0, 16).CopyTo(head);
        return BinaryPrimitives.ReadUInt32LittleEndian(head[4..]) > 0 && BinaryPrimitives.ReadUInt32LittleEndian(head[12..]) != 1;
    }

    private bool TryReadBytes(uint id, out ReadOnlySequence<byte> bytes)
    {
        try
        {
            return Source.TryRead(id, out bytes);
        }
        catch (DatFormatException)
        {
            bytes = default;
            return false;
        }
    }
}
