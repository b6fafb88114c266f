using System.Numerics;
using System.Text.Json.Serialization;

namespace Surefoot.Dats.Records;

/// <summary>Nothing.</summary>
public sealed record NoOperationHook : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.NoOperation;
}

/// <summary>Plays a sound.</summary>
/// <param name="WaveId">The wave.</param>
public sealed record SoundHook(uint WaveId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Sound;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(WaveId);
}

/// <summary>Plays a sound of the object's sound table.</summary>
/// <param name="SoundType">Entry of the table.</param>
public sealed record SoundTableHook(uint SoundType) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.SoundTable;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(SoundType);
}

/// <summary>The area that an attack strikes, metres, in object coordinates.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="LeftX">Left edge, x.</param>
/// <param name="LeftY">Left edge, y.</param>
/// <param name="RightX">Right edge, x.</param>
/// <param name="RightY">Right edge, y.</param>
/// <param name="Radius">Metres.</param>
/// <param name="Height">Metres.</param>
public sealed record AttackHook(uint Part, float LeftX, float LeftY, float RightX, float RightY, float Radius, float Height) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Attack;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(Part);
        writer.WriteSingle(LeftX);
        writer.WriteSingle(LeftY);
        writer.WriteSingle(RightX);
        writer.WriteSingle(RightY);
        writer.WriteSingle(Radius);
        writer.WriteSingle(Height);
    }
}

/// <summary>The animation is done; retail drops it.</summary>
public sealed record AnimationDoneHook : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.AnimationDone;
}

/// <summary>Exchanges the shape of a part.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="GfxObjId">The new shape.</param>
public sealed record ReplaceObjectHook(byte Part, uint GfxObjId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.ReplaceObject;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteByte(Part);
        writer.WriteKnownTypeId(GfxObjId, DatIds.GfxObjBase);
    }
}

/// <summary>Makes the object ethereal or solid.</summary>
/// <param name="Ethereal">Non-zero for ethereal.</param>
public sealed record EtherealHook(int Ethereal) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Ethereal;

    private protected override void WritePayload(DatWriter writer) => writer.WriteInt32(Ethereal);
}

/// <summary>Fades a part.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record TransparentPartHook(uint Part, float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.TransparentPart;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(Part);
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Changes luminosity.</summary>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record LuminousHook(float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Luminous;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Changes the luminosity of a part.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record LuminousPartHook(uint Part, float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.LuminousPart;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(Part);
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Changes diffuse light.</summary>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record DiffuseHook(float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Diffuse;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Changes the diffuse light of a part.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record DiffusePartHook(uint Part, float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.DiffusePart;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(Part);
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Changes the object's scale.</summary>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record ScaleHook(float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Scale;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Starts a particle emitter.</summary>
/// <param name="EmitterInfoId">The emitter's description.</param>
/// <param name="Part">Index of the part.</param>
/// <param name="Offset">In the part's coordinates; metres.</param>
/// <param name="EmitterId">Number to stop it by.</param>
public sealed record CreateParticleHook(uint EmitterInfoId, uint Part, DatFrame Offset, uint EmitterId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.CreateParticle;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(EmitterInfoId);
        writer.WriteUInt32(Part);
        writer.WriteFrame(Offset);
        writer.WriteUInt32(EmitterId);
    }
}

/// <summary>Removes a particle emitter.</summary>
/// <param name="EmitterId">Its number.</param>
public sealed record DestroyParticleHook(uint EmitterId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.DestroyParticle;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(EmitterId);
}

/// <summary>Stops a particle emitter.</summary>
/// <param name="EmitterId">Its number.</param>
public sealed record StopParticleHook(uint EmitterId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.StopParticle;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(EmitterId);
}

/// <summary>Hides or shows the object.</summary>
/// <param name="NoDraw">Non-zero hides.</param>
public sealed record NoDrawHook(uint NoDraw) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.NoDraw;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(NoDraw);
}

/// <summary>Runs the object's default script.</summary>
public sealed record DefaultScriptHook : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.DefaultScript;
}

/// <summary>Runs the default script of a part.</summary>
/// <param name="Part">Index of the part.</param>
public sealed record DefaultScriptPartHook(uint Part) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.DefaultScriptPart;

    private protected override void WritePayload(DatWriter writer) => writer.WriteUInt32(Part);
}

/// <summary>Runs a physics script.</summary>
/// <param name="ScriptId">The script.</param>
/// <param name="Pause">Seconds before it.</param>
public sealed record CallScriptHook(uint ScriptId, float Pause) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.CallScript;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(ScriptId);
        writer.WriteSingle(Pause);
    }
}

/// <summary>Fades the object.</summary>
/// <param name="Start">From.</param>
/// <param name="End">To.</param>
/// <param name="Time">Seconds.</param>
public sealed record TransparentHook(float Start, float End, float Time) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.Transparent;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteSingle(Start);
        writer.WriteSingle(End);
        writer.WriteSingle(Time);
    }
}

/// <summary>Plays a sound now and then.</summary>
/// <param name="WaveId">The wave.</param>
/// <param name="Probability">0 to 1.</param>
/// <param name="Priority">Its priority.</param>
/// <param name="Volume">0 to 1.</param>
public sealed record SoundTweakedHook(uint WaveId, float Probability, float Priority, float Volume) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.SoundTweaked;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(WaveId);
        writer.WriteSingle(Probability);
        writer.WriteSingle(Priority);
        writer.WriteSingle(Volume);
    }
}

/// <summary>Sets the angular velocity.</summary>
/// <param name="Omega">rad/s.</param>
public sealed record SetOmegaHook(Vector3 Omega) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.SetOmega;

    private protected override void WritePayload(DatWriter writer) => writer.WriteVector3(Omega);
}

/// <summary>Moves the object's textures.</summary>
/// <param name="U">Widths a second.</param>
/// <param name="V">Heights a second.</param>
public sealed record TextureVelocityHook(float U, float V) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.TextureVelocity;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteSingle(U);
        writer.WriteSingle(V);
    }
}

/// <summary>Moves the textures of a part.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="U">Widths a second.</param>
/// <param name="V">Heights a second.</param>
public sealed record TextureVelocityPartHook(uint Part, float U, float V) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.TextureVelocityPart;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(Part);
        writer.WriteSingle(U);
        writer.WriteSingle(V);
    }
}

/// <summary>Switches the lights.</summary>
/// <param name="On">Non-zero for on.</param>
public sealed record SetLightHook(int On) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.SetLight;

    private protected override void WritePayload(DatWriter writer) => writer.WriteInt32(On);
}

/// <summary>Starts a particle emitter unless one with its number runs.</summary>
/// <param name="EmitterInfoId">The emitter's description.</param>
/// <param name="Part">Index of the part.</param>
/// <param name="Offset">In the part's coordinates; metres.</param>
/// <param name="EmitterId">Number to stop it by.</param>
public sealed record CreateBlockingParticleHook(uint EmitterInfoId, uint Part, DatFrame Offset, uint EmitterId) : AnimationHook
{
    /// <inheritdoc/>
    [JsonIgnore]
    public override AnimationHookType HookType => AnimationHookType.CreateBlockingParticle;

    private protected override void WritePayload(DatWriter writer)
    {
        writer.WriteUInt32(EmitterInfoId);
        writer.WriteUInt32(Part);
        writer.WriteFrame(Offset);
        writer.WriteUInt32(EmitterId);
    }
}
