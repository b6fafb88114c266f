using System.Collections.Immutable;
using System.Numerics;

namespace Surefoot.Dats.Records;

/// <summary>Bits of <see cref="Setup.Flags"/>.</summary>
[Flags]
public enum SetupFlags : uint
{
    /// <summary>None.</summary>
    None = 0,

    /// <summary>Parent parts follow.</summary>
    HasParents = 1,

    /// <summary>Default scales follow.</summary>
    HasScales = 2,

    /// <summary>Allows a free heading.</summary>
    AllowFreeHeading = 4,

    /// <summary>The parts collide by their trees instead of the setup's cylinders and spheres (spec 06).</summary>
    HasPhysicsBsp = 8,
}

/// <summary>A place on a part where something is held or connected.</summary>
/// <param name="Location">1 right hand, 2 left hand, 3 shield, 4 belt, 5 quiver, 6 heraldry, 7 mouth, 8 left weapon,
/// 9 left unarmed.</param>
/// <param name="Part">Index of the part.</param>
/// <param name="Frame">In the part's coordinates.</param>
public readonly record struct SetupLocation(uint Location, uint Part, DatFrame Frame);

/// <summary>How the parts stand by default or in a placement.</summary>
/// <param name="Placement">0 default, 0x65 resting and so on (spec 07, 7.6).</param>
/// <param name="Frame">The parts.</param>
public sealed record PlacementFrame(uint Placement, AnimFrame Frame);

/// <summary>A light of an object.</summary>
/// <param name="Type">Retail's type; other readers use it as a key.</param>
/// <param name="Frame">In object coordinates.</param>
/// <param name="Color">Its colour.</param>
/// <param name="Intensity">Its intensity.</param>
/// <param name="Falloff">Metres.</param>
/// <param name="ConeAngle">Radians; 0 for a point light.</param>
public readonly record struct SetupLight(uint Type, DatFrame Frame, DatColor Color, float Intensity, float Falloff, float ConeAngle);

/// <summary>0x02: parts, collision shapes and heights of an object (spec 07, 7.6).</summary>
/// <remarks>Retail: CSetup::UnPack @0x00520C50.</remarks>
public sealed class Setup : DatRecord, IDatRecord<Setup>
{
    /// <summary>No parent, in <see cref="ParentParts"/>.</summary>
    public const uint NoParent = 0xFFFFFFFF;

    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Setup;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>What is stored and how the object collides.</summary>
    public SetupFlags Flags { get; init; }

    /// <summary>GfxObj id of each part.</summary>
    public ImmutableArray<uint> PartIds { get; init; } = [];

    /// <summary>Parent of each part; empty without <see cref="SetupFlags.HasParents"/>.</summary>
    public ImmutableArray<uint> ParentParts { get; init; } = [];

    /// <summary>Scale of each part; empty without <see cref="SetupFlags.HasScales"/>.</summary>
    public ImmutableArray<Vector3> DefaultScales { get; init; } = [];

    /// <summary>Where things are held.</summary>
    public ImmutableArray<SetupLocation> HoldingLocations { get; init; } = [];

    /// <summary>Where things are connected.</summary>
    public ImmutableArray<SetupLocation> ConnectionPoints { get; init; } = [];

    /// <summary>How the parts stand.</summary>
    public ImmutableArray<PlacementFrame> PlacementFrames { get; init; } = [];

    /// <summary>Collision cylinders in object coordinates.</summary>
    public ImmutableArray<DatCylSphere> CylSpheres { get; init; } = [];

    /// <summary>Collision spheres in object coordinates.</summary>
    public ImmutableArray<DatSphere> Spheres { get; init; } = [];

    /// <summary>Height of the object; metres.</summary>
    public float Height { get; init; }

    /// <summary>Radius of the object; metres.</summary>
    public float Radius { get; init; }

    /// <summary>Highest step it climbs; metres.</summary>
    public float StepUpHeight { get; init; }

    /// <summary>Deepest step it goes down without falling; metres.</summary>
    public float StepDownHeight { get; init; }

    /// <summary>For sorting by distance.</summary>
    public DatSphere SortingSphere { get; init; }

    /// <summary>For picking with the mouse.</summary>
    public DatSphere SelectionSphere { get; init; }

    /// <summary>Lights.</summary>
    public ImmutableArray<SetupLight> Lights { get; init; } = [];

    /// <summary>Animation it plays by itself; 0 none.</summary>
    public uint DefaultAnimationId { get; init; }

    /// <summary>Physics script; 0 none.</summary>
    public uint DefaultScriptId { get; init; }

    /// <summary>Motion table; 0 none.</summary>
    public uint DefaultMotionTableId { get; init; }

    /// <summary>Sound table; 0 none.</summary>
    public uint DefaultSoundTableId { get; init; }

    /// <summary>Physics script table; 0 none.</summary>
    public uint DefaultScriptTableId { get; init; }

    /// <inheritdoc/>
    public static Setup Decode(ref DatReader reader)
    {
        uint id = reader.ReadId();
        var flags = (SetupFlags)reader.ReadUInt32();
        int parts = reader.ReadCount(4);
        var setup = new Setup
        {
            Id = id,
            Flags = flags,
            PartIds = reader.ReadUInt32Array(parts),
            ParentParts = reader.ReadUInt32Array(flags.HasFlag(SetupFlags.HasParents) ? parts : 0),
            DefaultScales = reader.ReadArray(flags.HasFlag(SetupFlags.HasScales) ? parts : 0, 12, static (ref r) => r.ReadVector3()),
            HoldingLocations = reader.ReadList(36, ReadLocation),
            ConnectionPoints = reader.ReadList(36, ReadLocation),
            PlacementFrames = ReadPlacements(ref reader, parts),
            CylSpheres = reader.ReadList(20, static (ref r) => new DatCylSphere(r.ReadVector3(), r.ReadSingle(), r.ReadSingle())),
            Spheres = reader.ReadList(16, static (ref r) => r.ReadSphere()),
            Height = reader.ReadSingle(),
            Radius = reader.ReadSingle(),
            StepUpHeight = reader.ReadSingle(),
            StepDownHeight = reader.ReadSingle(),
            SortingSphere = reader.ReadSphere(),
            SelectionSphere = reader.ReadSphere(),
            Lights = reader.ReadList(48, ReadLight),
            DefaultAnimationId = reader.ReadUInt32(),
            DefaultScriptId = reader.ReadUInt32(),
            DefaultMotionTableId = reader.ReadUInt32(),
            DefaultSoundTableId = reader.ReadUInt32(),
            DefaultScriptTableId = reader.ReadUInt32(),
        };
        reader.Align4();
        return setup;
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        int parts = PartIds.Length;
        RequirePerPart(ParentParts.Length, SetupFlags.HasParents);
        RequirePerPart(DefaultScales.Length, SetupFlags.HasScales);
        writer.WriteUInt32(Id);
        writer.WriteUInt32((uint)Flags);
        writer.WriteUInt32((uint)parts);
        writer.WriteUInt32Array(PartIds);
        writer.WriteUInt32Array(ParentParts);
        writer.WriteArray(DefaultScales, static (w, scale) => w.WriteVector3(scale));
        writer.WriteList(HoldingLocations, WriteLocation);
        writer.WriteList(ConnectionPoints, WriteLocation);
        writer.WriteUInt32((uint)PlacementFrames.Length);
        foreach (PlacementFrame placement in PlacementFrames)
        {
            writer.WriteUInt32(placement.Placement);
            placement.Frame.Write(writer, parts);
        }

        writer.WriteList(CylSpheres, static (w, cylinder) =>
        {
            w.WriteVector3(cylinder.LowPoint);
            w.WriteSingle(cylinder.Radius);
            w.WriteSingle(cylinder.Height);
        });
        writer.WriteList(Spheres, static (w, sphere) => w.WriteSphere(sphere));
        writer.WriteSingle(Height);
        writer.WriteSingle(Radius);
        writer.WriteSingle(StepUpHeight);
        writer.WriteSingle(StepDownHeight);
        writer.WriteSphere(SortingSphere);
        writer.WriteSphere(SelectionSphere);
        writer.WriteList(Lights, WriteLight);
        writer.WriteUInt32(DefaultAnimationId);
        writer.WriteUInt32(DefaultScriptId);
        writer.WriteUInt32(DefaultMotionTableId);
        writer.WriteUInt32(DefaultSoundTableId);
        writer.WriteUInt32(DefaultScriptTableId);
        writer.Align4();
    }

    private static SetupLocation ReadLocation(ref DatReader reader) => new(reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadFrame());

    private static void WriteLocation(DatWriter writer, SetupLocation location)
    {
        writer.WriteUInt32(location.Location);
        writer.WriteUInt32(location.Part);
        writer.WriteFrame(location.Frame);
    }

    private static ImmutableArray<PlacementFrame> ReadPlacements(ref DatReader reader, int parts)
    {
        var placements = ImmutableArray.CreateBuilder<PlacementFrame>(reader.ReadCount(8));
        while (placements.Count < placements.Capacity)
            placements.Add(new(reader.ReadUInt32(), AnimFrame.Read(ref reader, parts)));
        return placements.MoveToImmutable();
    }

    private static SetupLight ReadLight(ref DatReader reader) => new(
        reader.ReadUInt32(), reader.ReadFrame(), reader.ReadColor(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle());

    private static void WriteLight(DatWriter writer, SetupLight light)
    {
        writer.WriteUInt32(light.Type);
        writer.WriteFrame(light.Frame);
        writer.WriteColor(light.Color);
        writer.WriteSingle(light.Intensity);
        writer.WriteSingle(light.Falloff);
        writer.WriteSingle(light.ConeAngle);
    }

    private void RequirePerPart(int count, SetupFlags flag)
        => DatWriter.Require(
            count == (Flags.HasFlag(flag) ? PartIds.Length : 0),
            $"Setup 0x{Id:X8} has {count} values for {flag}, which fits neither its parts nor its flags.");
}
