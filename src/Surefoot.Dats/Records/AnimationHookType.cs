namespace Surefoot.Dats.Records;

/// <summary>Types of <see cref="AnimationHook"/> (spec 07, 7.8).</summary>
public enum AnimationHookType : uint
{
    /// <summary><see cref="NoOperationHook"/>.</summary>
    NoOperation = 0x00,

    /// <summary><see cref="SoundHook"/>.</summary>
    Sound = 0x01,

    /// <summary><see cref="SoundTableHook"/>.</summary>
    SoundTable = 0x02,

    /// <summary><see cref="AttackHook"/>.</summary>
    Attack = 0x03,

    /// <summary><see cref="AnimationDoneHook"/>.</summary>
    AnimationDone = 0x04,

    /// <summary><see cref="ReplaceObjectHook"/>.</summary>
    ReplaceObject = 0x05,

    /// <summary><see cref="EtherealHook"/>.</summary>
    Ethereal = 0x06,

    /// <summary><see cref="TransparentPartHook"/>.</summary>
    TransparentPart = 0x07,

    /// <summary><see cref="LuminousHook"/>.</summary>
    Luminous = 0x08,

    /// <summary><see cref="LuminousPartHook"/>.</summary>
    LuminousPart = 0x09,

    /// <summary><see cref="DiffuseHook"/>.</summary>
    Diffuse = 0x0A,

    /// <summary><see cref="DiffusePartHook"/>.</summary>
    DiffusePart = 0x0B,

    /// <summary><see cref="ScaleHook"/>.</summary>
    Scale = 0x0C,

    /// <summary><see cref="CreateParticleHook"/>.</summary>
    CreateParticle = 0x0D,

    /// <summary><see cref="DestroyParticleHook"/>.</summary>
    DestroyParticle = 0x0E,

    /// <summary><see cref="StopParticleHook"/>.</summary>
    StopParticle = 0x0F,

    /// <summary><see cref="NoDrawHook"/>.</summary>
    NoDraw = 0x10,

    /// <summary><see cref="DefaultScriptHook"/>.</summary>
    DefaultScript = 0x11,

    /// <summary><see cref="DefaultScriptPartHook"/>.</summary>
    DefaultScriptPart = 0x12,

    /// <summary><see cref="CallScriptHook"/>.</summary>
    CallScript = 0x13,

    /// <summary><see cref="TransparentHook"/>.</summary>
    Transparent = 0x14,

    /// <summary><see cref="SoundTweakedHook"/>.</summary>
    SoundTweaked = 0x15,

    /// <summary><see cref="SetOmegaHook"/>.</summary>
    SetOmega = 0x16,

    /// <summary><see cref="TextureVelocityHook"/>.</summary>
    TextureVelocity = 0x17,

    /// <summary><see cref="TextureVelocityPartHook"/>.</summary>
    TextureVelocityPart = 0x18,

    /// <summary><see cref="SetLightHook"/>.</summary>
    SetLight = 0x19,

    /// <summary><see cref="CreateBlockingParticleHook"/>.</summary>
    CreateBlockingParticle = 0x1A,
}
