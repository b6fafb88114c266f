using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Assets;

/// <summary>One part of a setup.</summary>
/// <param name="Mesh">Its mesh.</param>
/// <param name="DefaultScale">Its scale in an object of scale 1, component by component.</param>
public readonly record struct SetupPart(GfxObjAsset Mesh, Vector3 DefaultScale);

/// <summary>A place on a setup where something is held.</summary>
/// <param name="Number">1 right hand, 2 left hand, 3 shield, 4 belt, 5 quiver, 6 heraldry, 7 mouth, 8 left weapon, 9 left unarmed.</param>
/// <param name="Part">Index of the part that holds it; one that there is not for the object itself.</param>
/// <param name="Frame">Where what is held is, seen from that part, metres.</param>
public readonly record struct HoldingLocation(uint Number, uint Part, Frame Frame);

/// <summary>
/// What movement needs of a setup: parts, spheres, cylinders, heights and steps, in metres at scale 1. Immutable and shared.
/// </summary>
/// <remarks>Retail: CSetup; specification 06.</remarks>
public sealed class SetupAsset
{
    private readonly SetupPart[] parts = [];
    private readonly Sphere[] spheres = [];
    private readonly CylSphere[] cylinders = [];
    private readonly HoldingLocation[] holdingLocations = [];
    private readonly Dictionary<uint, Frame[]> placements = [];
    private Frame[] defaultPlacement = [];
    private Frame[]? resting;

    internal SetupAsset()
    {
    }

    /// <summary>Id of the record: 0x02…, or 0x01… for a setup made up for one mesh.</summary>
    public uint Id { get; internal init; }

    /// <summary>The parts.</summary>
    public ReadOnlySpan<SetupPart> Parts
    {
        get => parts;
        internal init
        {
            parts = value.ToArray();
            HasPhysicsBsp = Array.Exists(parts, p => p.Mesh.Physics is not null);
        }
    }

    /// <summary>Collision spheres in the object's frame; the first is the foot.</summary>
    public ReadOnlySpan<Sphere> Spheres
    {
        get => spheres;
        internal init
        {
            spheres = value.ToArray();
            foreach (ref readonly Sphere sphere in value)
                SpheresReach = Math.Max(SpheresReach, RetailMath.Length(sphere.Center) + Math.Abs(sphere.Radius));
        }
    }

    /// <summary>No sphere reaches further than this from the object's origin, metres.</summary>
    internal double SpheresReach { get; private init; }

    /// <summary>Collision cylinders in the object's frame.</summary>
    public ReadOnlySpan<CylSphere> Cylinders
    {
        get => cylinders;
        internal init => cylinders = value.ToArray();
    }

    /// <summary>Where things are held.</summary>
    public ReadOnlySpan<HoldingLocation> HoldingLocations
    {
        get => holdingLocations;
        init => holdingLocations = value.ToArray();
    }

    /// <summary>Height.</summary>
    public float Height { get; internal init; }

    /// <summary>Radius.</summary>
    public float Radius { get; internal init; }

    /// <summary>Highest step climbed.</summary>
    public float StepUpHeight { get; internal init; }

    /// <summary>Deepest step descended.</summary>
    public float StepDownHeight { get; internal init; }

    /// <summary>
    /// Sphere around everything, by which things far away are ordered and moving objects without cylinders find their cells.
    /// </summary>
    public Sphere SortingSphere { get; internal init; }

    /// <summary>The body may turn freely in one sweep.</summary>
    public bool AllowFreeHeading { get; internal init; }

    /// <summary>Motion table an object of this setup starts with; 0 for none.</summary>
    public uint DefaultMotionTableId { get; internal init; }

    /// <summary>Animation that a static object of this setup plays for ever; 0 for none.</summary>
    public uint DefaultAnimationId { get; internal init; }

    /// <summary>
    /// Some part has a collision tree: an object that is made of this setup is then hit by its trees, and neither by cylinders nor by
    /// spheres, until a server's word says otherwise (<c>PhysicsState.HasPhysicsBsp</c>).
    /// </summary>
    /// <remarks>Retail: CPartArray::CacheHasPhysicsBSP. Never taken from the record's flag.</remarks>
    public bool HasPhysicsBsp { get; private init; }

    /// <summary>
    /// Frames of the parts in the object's frame when it is put down in some way; the default way where the asked one is missing, and no
    /// frames where that is missing too.
    /// </summary>
    /// <param name="placement">0 by default, <see cref="Resting"/> for things that lie about.</param>
    public ReadOnlySpan<Frame> Placement(uint placement) =>
        placement != 0 && placements.TryGetValue(placement, out Frame[]? frames) ? frames : defaultPlacement;

    /// <summary>The way in which every object is put down when it is made.</summary>
    public const uint Resting = 0x65;

    /// <summary>Frames of the parts of an object as it is made: <see cref="Placement"/> of <see cref="Resting"/>.</summary>
    /// <remarks>Retail: CPhysicsObj::InitObjectEnd @0x0050FFE0.</remarks>
    public ReadOnlySpan<Frame> RestPose => resting ?? defaultPlacement;

    /// <summary>Is there a way of putting the object down with this number?</summary>
    internal bool HasPlacement(uint placement) => placements.ContainsKey(placement);

    /// <summary>A shape made up of spheres, for balls, arrows and whatever the files do not have.</summary>
    /// <param name="id">An id of the maker's choice; it is what traces call the shape.</param>
    /// <param name="spheres">The spheres; the first is the foot. Bodies move by the first two.</param>
    /// <param name="stepUpHeight">Highest step climbed, metres.</param>
    /// <param name="stepDownHeight">Deepest step descended without leaving the ground, metres.</param>
    /// <exception cref="ArgumentException">
    /// There is no sphere, or a radius, a centre or a height is not finite, or negative, or a radius is 0.
    /// </exception>
    public static SetupAsset OfSpheres(uint id, ReadOnlySpan<Sphere> spheres, float stepUpHeight = 0f, float stepDownHeight = 0f)
    {
        if (spheres.IsEmpty) throw new ArgumentException("A shape of spheres has at least one.", nameof(spheres));
        foreach (ref readonly Sphere sphere in spheres) sphere.ThrowIfBad(nameof(spheres));
        ThrowIfNoHeight(stepUpHeight, nameof(stepUpHeight));
        ThrowIfNoHeight(stepDownHeight, nameof(stepDownHeight));
        return new SetupAsset { Id = id, Spheres = spheres, StepUpHeight = stepUpHeight, StepDownHeight = stepDownHeight };

        static void ThrowIfNoHeight(float height, string name)
        {
            if (!(height >= 0) || !float.IsFinite(height))
                throw new ArgumentException("The height of a step is negative or not finite.", name);
        }
    }

    /// <summary>The holding location with a number, the first of two.</summary>
    /// <returns>False when there is none.</returns>
    /// <remarks>Retail: CSetup::GetHoldingLocation @0x005213F0.</remarks>
    public bool TryGetHoldingLocation(uint number, out HoldingLocation location)
    {
        int index = Array.FindIndex(holdingLocations, l => l.Number == number);
        location = index < 0 ? default : holdingLocations[index];
        return index >= 0;
    }

    /// <summary>The setup that a mesh on its own stands for.</summary>
    /// <remarks>Retail: CSetup::makeSimpleSetup.</remarks>
    public static SetupAsset FromGfxObj(GfxObjAsset mesh)
    {
        ArgumentNullException.ThrowIfNull(mesh);
        return new SetupAsset
        {
            Id = mesh.Id,
            Parts = [new SetupPart(mesh, Vector3.One)],
            SortingSphere = mesh.AnySphere ?? default,
        }.With(0, [Frame.Identity]);
    }

    /// <summary>Flattens a record.</summary>
    /// <param name="record">The record.</param>
    /// <param name="meshes">Where the parts' meshes come from.</param>
    /// <exception cref="Dats.DatFormatException">A number of the record is not finite.</exception>
    internal static SetupAsset Build(Setup record, Func<uint, GfxObjAsset> meshes)
    {
        RecordFlattener check = new(record);
        SetupPart[] parts = new SetupPart[record.PartIds.Length];
        for (int i = 0; i < parts.Length; i++)
        {
            Vector3 scale = record.DefaultScales.IsDefaultOrEmpty ? Vector3.One : check.Finite(record.DefaultScales[i], "a default scale");
            parts[i] = new SetupPart(meshes(record.PartIds[i]), scale);
        }

        SetupAsset asset = new()
        {
            Id = record.Id,
            Parts = parts,
            Spheres = [.. record.Spheres.Select(s => check.Sphere(s, "a sphere"))],
            Cylinders = [.. record.CylSpheres.Select(c => check.Cylinder(c, "a cylinder"))],
            HoldingLocations =
            [
                .. record.HoldingLocations.Select(
                    l => new HoldingLocation(l.Location, l.Part, check.Frame(l.Frame, $"holding location {l.Location}"))),
            ],
            Height = check.Finite(record.Height, "the height"),
            Radius = check.Finite(record.Radius, "the radius"),
            StepUpHeight = check.Finite(record.StepUpHeight, "the step-up height"),
            StepDownHeight = check.Finite(record.StepDownHeight, "the step-down height"),
            SortingSphere = check.Sphere(record.SortingSphere, "the sorting sphere"),
            AllowFreeHeading = record.Flags.HasFlag(SetupFlags.AllowFreeHeading),
            DefaultMotionTableId = record.DefaultMotionTableId,
            DefaultAnimationId = record.DefaultAnimationId,
        };
        foreach (PlacementFrame placement in record.PlacementFrames)
            asset.With(placement.Placement, [.. placement.Frame.Parts.Select(f => check.Frame(f, $"placement {placement.Placement}"))]);
        return asset;
    }

    /// <summary>Where a part is, in the coordinates of the object's landblock.</summary>
    /// <param name="target">Where the object is there.</param>
    /// <param name="pose">Frame of the part in the object's frame at scale 1.</param>
    /// <param name="scale">The object's scale.</param>
    /// <remarks>Retail: CPartArray::UpdateParts, Frame::combine.</remarks>
    internal static Frame PlacePart(in Frame target, in Frame pose, float scale)
    {
        Frame scaled = pose;
        scaled.Origin = RetailMath.Scale(pose.Origin, scale);
        return Frame.Combine(target, scaled);
    }

    /// <summary>Adds a way of putting the object down, while the asset is being built; the first of two with one number counts.</summary>
    internal SetupAsset With(uint placement, Frame[] frames)
    {
        if (!placements.TryAdd(placement, frames)) return this;
        if (placement == 0) defaultPlacement = frames;
        else if (placement == Resting) resting = frames;
        return this;
    }
}
