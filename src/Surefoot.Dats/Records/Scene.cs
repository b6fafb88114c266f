using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>One object of a scene and how it is strewn (spec 07, 7.14; spec 05 says how it is placed).</summary>
/// <remarks>Retail: ObjectDesc::UnPack @0x005A6110.</remarks>
public readonly record struct SceneObject
{
    internal const int Size = 76;

    /// <summary>GfxObj or Setup.</summary>
    public uint ObjectId { get; init; }

    /// <summary>Base frame; metres.</summary>
    public DatFrame BaseFrame { get; init; }

    /// <summary>Share of places where it stands, 0 to 1.</summary>
    public float Frequency { get; init; }

    /// <summary>Greatest displacement east; metres.</summary>
    public float DisplaceX { get; init; }

    /// <summary>Greatest displacement north; metres.</summary>
    public float DisplaceY { get; init; }

    /// <summary>Least scale.</summary>
    public float MinScale { get; init; }

    /// <summary>Greatest scale.</summary>
    public float MaxScale { get; init; }

    /// <summary>Greatest turn; degrees.</summary>
    public float MaxRotation { get; init; }

    /// <summary>Least z of the ground's normal.</summary>
    public float MinSlope { get; init; }

    /// <summary>Greatest z of the ground's normal.</summary>
    public float MaxSlope { get; init; }

    /// <summary>Non-zero: aligned to the slope.</summary>
    public uint Align { get; init; }

    /// <summary>Non-zero: oriented to the slope.</summary>
    public uint Orient { get; init; }

    /// <summary>Non-zero: a server object, not drawn by the client.</summary>
    public uint WeenieObject { get; init; }

    internal static SceneObject Read(ref DatReader reader) => new()
    {
        ObjectId = reader.ReadUInt32(),
        BaseFrame = reader.ReadFrame(),
        Frequency = reader.ReadSingle(),
        DisplaceX = reader.ReadSingle(),
        DisplaceY = reader.ReadSingle(),
        MinScale = reader.ReadSingle(),
        MaxScale = reader.ReadSingle(),
        MaxRotation = reader.ReadSingle(),
        MinSlope = reader.ReadSingle(),
        MaxSlope = reader.ReadSingle(),
        Align = reader.ReadUInt32(),
        Orient = reader.ReadUInt32(),
        WeenieObject = reader.ReadUInt32(),
    };

    internal static void Write(DatWriter writer, SceneObject thing)
    {
        writer.WriteUInt32(thing.ObjectId);
        writer.WriteFrame(thing.BaseFrame);
        writer.WriteSingle(thing.Frequency);
        writer.WriteSingle(thing.DisplaceX);
        writer.WriteSingle(thing.DisplaceY);
        writer.WriteSingle(thing.MinScale);
        writer.WriteSingle(thing.MaxScale);
        writer.WriteSingle(thing.MaxRotation);
        writer.WriteSingle(thing.MinSlope);
        writer.WriteSingle(thing.MaxSlope);
        writer.WriteUInt32(thing.Align);
        writer.WriteUInt32(thing.Orient);
        writer.WriteUInt32(thing.WeenieObject);
    }
}

/// <summary>0x12: scenery (spec 07, 7.14).</summary>
/// <remarks>Retail: Scene::UnPack @0x005A6300.</remarks>
public sealed class Scene : DatRecord, IDatRecord<Scene>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Scene;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Its objects.</summary>
    public ImmutableArray<SceneObject> Objects { get; init; } = [];

    /// <inheritdoc/>
    public static Scene Decode(ref DatReader reader)
        => new() { Id = reader.ReadId(), Objects = reader.ReadList(SceneObject.Size, SceneObject.Read) };

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        writer.WriteList(Objects, SceneObject.Write);
    }
}
