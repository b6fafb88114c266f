using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>Something that happens when an animation passes a frame (spec 07, 7.8).</summary>
/// <remarks>Retail: CAnimHook::UnPackHook @0x005271D0. Each hook ends on a multiple of 4 counted from the start of the record.</remarks>
[JsonDerivedType(typeof(NoOperationHook), nameof(AnimationHookType.NoOperation))]
[JsonDerivedType(typeof(SoundHook), nameof(AnimationHookType.Sound))]
[JsonDerivedType(typeof(SoundTableHook), nameof(AnimationHookType.SoundTable))]
[JsonDerivedType(typeof(AttackHook), nameof(AnimationHookType.Attack))]
[JsonDerivedType(typeof(AnimationDoneHook), nameof(AnimationHookType.AnimationDone))]
[JsonDerivedType(typeof(ReplaceObjectHook), nameof(AnimationHookType.ReplaceObject))]
[JsonDerivedType(typeof(EtherealHook), nameof(AnimationHookType.Ethereal))]
[JsonDerivedType(typeof(TransparentPartHook), nameof(AnimationHookType.TransparentPart))]
[JsonDerivedType(typeof(LuminousHook), nameof(AnimationHookType.Luminous))]
[JsonDerivedType(typeof(LuminousPartHook), nameof(AnimationHookType.LuminousPart))]
[JsonDerivedType(typeof(DiffuseHook), nameof(AnimationHookType.Diffuse))]
[JsonDerivedType(typeof(DiffusePartHook), nameof(AnimationHookType.DiffusePart))]
[JsonDerivedType(typeof(ScaleHook), nameof(AnimationHookType.Scale))]
[JsonDerivedType(typeof(CreateParticleHook), nameof(AnimationHookType.CreateParticle))]
[JsonDerivedType(typeof(DestroyParticleHook), nameof(AnimationHookType.DestroyParticle))]
[JsonDerivedType(typeof(StopParticleHook), nameof(AnimationHookType.StopParticle))]
[JsonDerivedType(typeof(NoDrawHook), nameof(AnimationHookType.NoDraw))]
[JsonDerivedType(typeof(DefaultScriptHook), nameof(AnimationHookType.DefaultScript))]
[JsonDerivedType(typeof(DefaultScriptPartHook), nameof(AnimationHookType.DefaultScriptPart))]
[JsonDerivedType(typeof(CallScriptHook), nameof(AnimationHookType.CallScript))]
[JsonDerivedType(typeof(TransparentHook), nameof(AnimationHookType.Transparent))]
[JsonDerivedType(typeof(SoundTweakedHook), nameof(AnimationHookType.SoundTweaked))]
[JsonDerivedType(typeof(SetOmegaHook), nameof(AnimationHookType.SetOmega))]
[JsonDerivedType(typeof(TextureVelocityHook), nameof(AnimationHookType.TextureVelocity))]
[JsonDerivedType(typeof(TextureVelocityPartHook), nameof(AnimationHookType.TextureVelocityPart))]
[JsonDerivedType(typeof(SetLightHook), nameof(AnimationHookType.SetLight))]
[JsonDerivedType(typeof(CreateBlockingParticleHook), nameof(AnimationHookType.CreateBlockingParticle))]
public abstract record AnimationHook
{
    internal const int LeastSize = 8;

    /// <summary>Which kind of hook this is.</summary>
    [JsonIgnore]
    public abstract AnimationHookType HookType { get; }

    /// <summary>Fires when playing: −1 backward, 0 both ways, 1 forward.</summary>
    public int Direction { get; init; }

    internal static AnimationHook Read(ref DatReader reader)
    {
        long start = reader.Position;
        var type = (AnimationHookType)reader.ReadUInt32();
        int direction = reader.ReadInt32();
        AnimationHook hook = ReadPayload(ref reader, type, start) with { Direction = direction };
        reader.Align4();
        return hook;
    }

    internal static void Write(DatWriter writer, AnimationHook hook)
    {
        writer.WriteUInt32((uint)hook.HookType);
        writer.WriteInt32(hook.Direction);
        hook.WritePayload(writer);
        writer.Align4();
    }

    /// <summary>Writes what follows type and direction.</summary>
    private protected virtual void WritePayload(DatWriter writer)
    {
    }

    private static AnimationHook ReadPayload(ref DatReader reader, AnimationHookType type, long start) => type switch
    {
        AnimationHookType.NoOperation => new NoOperationHook(),
        AnimationHookType.Sound => new SoundHook(reader.ReadUInt32()),
        AnimationHookType.SoundTable => new SoundTableHook(reader.ReadUInt32()),
        AnimationHookType.Attack => new AttackHook(
            reader.ReadUInt32(),
            reader.ReadSingle(),
            reader.ReadSingle(),
            reader.ReadSingle(),
            reader.ReadSingle(),
            reader.ReadSingle(),
            reader.ReadSingle()),
        AnimationHookType.AnimationDone => new AnimationDoneHook(),
        AnimationHookType.ReplaceObject => new ReplaceObjectHook(reader.ReadByte(), reader.ReadKnownTypeId(DatIds.GfxObjBase)),
        AnimationHookType.Ethereal => new EtherealHook(reader.ReadInt32()),
        AnimationHookType.TransparentPart => new TransparentPartHook(
            reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.Luminous => new LuminousHook(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.LuminousPart => new LuminousPartHook(
            reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.Diffuse => new DiffuseHook(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.DiffusePart => new DiffusePartHook(
            reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.Scale => new ScaleHook(reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.CreateParticle => new CreateParticleHook(
            reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadFrame(), reader.ReadUInt32()),
        AnimationHookType.DestroyParticle => new DestroyParticleHook(reader.ReadUInt32()),
        AnimationHookType.StopParticle => new StopParticleHook(reader.ReadUInt32()),
        AnimationHookType.NoDraw => new NoDrawHook(reader.ReadUInt32()),
        AnimationHookType.DefaultScript => new DefaultScriptHook(),
        AnimationHookType.DefaultScriptPart => new DefaultScriptPartHook(reader.ReadUInt32()),
        AnimationHookType.CallScript => new CallScriptHook(reader.ReadUInt32(), reader.ReadSingle()),
        AnimationHookType.Transparent => new TransparentHook(reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.SoundTweaked => new SoundTweakedHook(
            reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.SetOmega => new SetOmegaHook(reader.ReadVector3()),
        AnimationHookType.TextureVelocity => new TextureVelocityHook(reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.TextureVelocityPart => new TextureVelocityPartHook(
            reader.ReadUInt32(), reader.ReadSingle(), reader.ReadSingle()),
        AnimationHookType.SetLight => new SetLightHook(reader.ReadInt32()),
        AnimationHookType.CreateBlockingParticle => new CreateBlockingParticleHook(
            reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadFrame(), reader.ReadUInt32()),
        _ => throw reader.Error($"animation hook of unknown type 0x{(uint)type:X}", start),
    };
}
