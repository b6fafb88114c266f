namespace Surefoot.Dats;

/// <summary>Kinds of records (spec 07, section 6). Those that movement needs have a type in <c>Surefoot.Dats.Records</c>;
/// the others are carried as bytes.</summary>
public enum DatRecordType
{
    /// <summary>No kind has this id.</summary>
    Unknown,

    /// <summary>0xFFFF0001 of every file: which updates it contains.</summary>
    Iteration,

    /// <summary>0x01: a shape with its physics and drawing trees.</summary>
    GfxObj,

    /// <summary>0x02: parts, collision spheres and cylinders of an object.</summary>
    Setup,

    /// <summary>0x03: frames of the parts over time.</summary>
    Animation,

    /// <summary>0x04.</summary>
    Palette,

    /// <summary>0x05.</summary>
    SurfaceTexture,

    /// <summary>0x06 and 0x07: a texture.</summary>
    RenderSurface,

    /// <summary>0x08.</summary>
    Surface,

    /// <summary>0x09: which animations a style and motion play.</summary>
    MotionTable,

    /// <summary>0x0A.</summary>
    Wave,

    /// <summary>0x0D: the shapes of indoor cells.</summary>
    Environment,

    /// <summary>0x0E000002.</summary>
    CharGen,

    /// <summary>0x0E000003.</summary>
    VitalTable,

    /// <summary>0x0E000004.</summary>
    SkillTable,

    /// <summary>0x0E000007.</summary>
    ChatPoseTable,

    /// <summary>0x0E00000D.</summary>
    ObjectHierarchy,

    /// <summary>0x0E00000E.</summary>
    SpellTable,

    /// <summary>0x0E00000F.</summary>
    SpellComponentTable,

    /// <summary>0x0E000018.</summary>
    ExperienceTable,

    /// <summary>0x0E00001A.</summary>
    BadDataTable,

    /// <summary>0x0E00001D.</summary>
    ContractTable,

    /// <summary>0x0E00001E.</summary>
    TabooTable,

    /// <summary>0x0E00001F.</summary>
    FileToId,

    /// <summary>0x0E000020.</summary>
    NameFilterTable,

    /// <summary>0x0E01.</summary>
    QualityFilter,

    /// <summary>0x0E02.</summary>
    MonitoredProperties,

    /// <summary>0x0F.</summary>
    PaletteSet,

    /// <summary>0x10.</summary>
    ClothingTable,

    /// <summary>0x11.</summary>
    DegradeInfo,

    /// <summary>0x12: scenery objects and how they are strewn.</summary>
    Scene,

    /// <summary>0x13: heights, terrain and scene types of the land.</summary>
    Region,

    /// <summary>0x14.</summary>
    KeyMap,

    /// <summary>0x15.</summary>
    RenderTexture,

    /// <summary>0x16.</summary>
    RenderMaterial,

    /// <summary>0x17.</summary>
    MaterialModifier,

    /// <summary>0x18.</summary>
    MaterialInstance,

    /// <summary>0x19.</summary>
    RenderMesh,

    /// <summary>0x20.</summary>
    SoundTable,

    /// <summary>0x21, local file.</summary>
    UiLayout,

    /// <summary>0x22.</summary>
    EnumMapper,

    /// <summary>0x23 and 0x24, local file.</summary>
    StringTable,

    /// <summary>0x25.</summary>
    DataIdMapper,

    /// <summary>0x26.</summary>
    ActionMap,

    /// <summary>0x27.</summary>
    DualDataIdMapper,

    /// <summary>0x30.</summary>
    CombatTable,

    /// <summary>0x31.</summary>
    LanguageString,

    /// <summary>0x32.</summary>
    ParticleEmitter,

    /// <summary>0x33.</summary>
    PhysicsScript,

    /// <summary>0x34.</summary>
    PhysicsScriptTable,

    /// <summary>0x38.</summary>
    MutateFilter,

    /// <summary>0x39000001.</summary>
    MasterProperty,

    /// <summary>0x40.</summary>
    Font,

    /// <summary>0x41, local file.</summary>
    StringState,

    /// <summary>0x78 to 0x7F.</summary>
    PropertyDescriptions,

    /// <summary>XXYYFFFF of the cell file: terrain words and heights.</summary>
    LandBlock,

    /// <summary>XXYYFFFE of the cell file: objects and buildings of a block.</summary>
    LandBlockInfo,

    /// <summary>XXYY0100 to XXYYFFFD of the cell file: one indoor cell.</summary>
    EnvCell,
}
