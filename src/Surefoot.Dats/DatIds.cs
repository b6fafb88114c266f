namespace Surefoot.Dats;

/// <summary>What an id says (spec 07, section 6).</summary>
public static class DatIds
{
    /// <summary>The iteration record, in every file.</summary>
    public const uint Iteration = 0xFFFF0001;

    /// <summary>The region of the land.</summary>
    public const uint Region = 0x13000000;

    /// <summary>Lowest id of a GfxObj.</summary>
    public const uint GfxObjBase = 0x01000000;

    /// <summary>Lowest id of a Surface; an EnvCell stores the low word only.</summary>
    public const uint SurfaceBase = 0x08000000;

    /// <summary>Lowest id of an Environment; an EnvCell stores the low word only.</summary>
    public const uint EnvironmentBase = 0x0D000000;

    // Not in the cell file. Ascending, disjoint.
    private static readonly (uint First, uint Last, DatRecordType Type)[] Ranges =
    [
        (0x01000000, 0x0100FFFF, DatRecordType.GfxObj),
        (0x02000000, 0x0200FFFF, DatRecordType.Setup),
        (0x03000000, 0x0300FFFF, DatRecordType.Animation),
        (0x04000000, 0x0400FFFF, DatRecordType.Palette),
        (0x05000000, 0x05FFFFFF, DatRecordType.SurfaceTexture),
        (0x06000000, 0x07FFFFFF, DatRecordType.RenderSurface),
        (0x08000000, 0x0800FFFF, DatRecordType.Surface),
        (0x09000000, 0x0900FFFF, DatRecordType.MotionTable),
        (0x0A000000, 0x0A00FFFF, DatRecordType.Wave),
        (0x0D000000, 0x0D00FFFF, DatRecordType.Environment),
        (0x0E000002, 0x0E000002, DatRecordType.CharGen),
        (0x0E000003, 0x0E000003, DatRecordType.VitalTable),
        (0x0E000004, 0x0E000004, DatRecordType.SkillTable),
        (0x0E000007, 0x0E000007, DatRecordType.ChatPoseTable),
        (0x0E00000D, 0x0E00000D, DatRecordType.ObjectHierarchy),
        (0x0E00000E, 0x0E00000E, DatRecordType.SpellTable),
        (0x0E00000F, 0x0E00000F, DatRecordType.SpellComponentTable),
        (0x0E000018, 0x0E000018, DatRecordType.ExperienceTable),
        (0x0E00001A, 0x0E00001A, DatRecordType.BadDataTable),
        (0x0E00001D, 0x0E00001D, DatRecordType.ContractTable),
        (0x0E00001E, 0x0E00001E, DatRecordType.TabooTable),
        (0x0E00001F, 0x0E00001F, DatRecordType.FileToId),
        (0x0E000020, 0x0E000020, DatRecordType.NameFilterTable),
        (0x0E010000, 0x0E01FFFF, DatRecordType.QualityFilter),
        (0x0E020000, 0x0E02FFFF, DatRecordType.MonitoredProperties),
        (0x0F000000, 0x0F00FFFF, DatRecordType.PaletteSet),
        (0x10000000, 0x1000FFFF, DatRecordType.ClothingTable),
        (0x11000000, 0x1100FFFF, DatRecordType.DegradeInfo),
        (0x12000000, 0x1200FFFF, DatRecordType.Scene),
        (0x13000000, 0x1300FFFF, DatRecordType.Region),
        (0x14000000, 0x14FFFFFF, DatRecordType.KeyMap),
        (0x15000000, 0x15FFFFFF, DatRecordType.RenderTexture),
        (0x16000000, 0x16FFFFFF, DatRecordType.RenderMaterial),
        (0x17000000, 0x17FFFFFF, DatRecordType.MaterialModifier),
        (0x18000000, 0x18FFFFFF, DatRecordType.MaterialInstance),
        (0x19000000, 0x19FFFFFF, DatRecordType.RenderMesh),
        (0x20000000, 0x2000FFFF, DatRecordType.SoundTable),
        (0x21000000, 0x21FFFFFF, DatRecordType.UiLayout),
        (0x22000000, 0x22FFFFFF, DatRecordType.EnumMapper),
        (0x23000000, 0x24FFFFFF, DatRecordType.StringTable),
        (0x25000000, 0x25FFFFFF, DatRecordType.DataIdMapper),
        (0x26000000, 0x26FFFFFF, DatRecordType.ActionMap),
        (0x27000000, 0x27FFFFFF, DatRecordType.DualDataIdMapper),
        (0x30000000, 0x30FFFFFF, DatRecordType.CombatTable),
        (0x31000000, 0x31FFFFFF, DatRecordType.LanguageString),
        (0x32000000, 0x32FFFFFF, DatRecordType.ParticleEmitter),
        (0x33000000, 0x33FFFFFF, DatRecordType.PhysicsScript),
        (0x34000000, 0x34FFFFFF, DatRecordType.PhysicsScriptTable),
        (0x38000000, 0x38FFFFFF, DatRecordType.MutateFilter),
        (0x39000001, 0x39000001, DatRecordType.MasterProperty),
        (0x40000000, 0x400FFFFF, DatRecordType.Font),
        (0x41000000, 0x41FFFFFF, DatRecordType.StringState),
        (0x78000000, 0x7FFFFFFF, DatRecordType.PropertyDescriptions),
    ];

    /// <summary>The kind of a record, from its id and the kind of file it lies in: a cell id may equal a portal id.</summary>
    public static DatRecordType RecordTypeOf(uint id, DatFileKind file)
    {
        if (id == Iteration)
            return DatRecordType.Iteration;
        return file == DatFileKind.Cell ? CellTypeOf(id) : SharedTypeOf(id);
    }

    /// <summary>True for kinds that lie in the cell file.</summary>
    public static bool IsCellType(DatRecordType type)
        => type is DatRecordType.LandBlock or DatRecordType.LandBlockInfo or DatRecordType.EnvCell;

    /// <summary>Id of the land block record of block (x, y), each 0 to 0xFE, x counted from west and y from south.</summary>
    public static uint LandBlock(int x, int y) => ((uint)x << 24) | ((uint)y << 16) | 0xFFFF;

    private static DatRecordType CellTypeOf(uint id) => (id & 0xFFFF) switch
    {
        0xFFFF => DatRecordType.LandBlock,
        0xFFFE => DatRecordType.LandBlockInfo,
        >= 0x0100 => DatRecordType.EnvCell,
        _ => DatRecordType.Unknown,
    };

    private static DatRecordType SharedTypeOf(uint id)
    {
        int low = 0, high = Ranges.Length - 1;
        while (low <= high)
        {
            int middle = (low + high) / 2;
            var range = Ranges[middle];
            if (id < range.First)
                high = middle - 1;
            else if (id > range.Last)
                low = middle + 1;
            else
                return range.Type;
        }

        return DatRecordType.Unknown;
    }
}
