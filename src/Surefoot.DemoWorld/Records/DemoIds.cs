namespace Surefoot.DemoWorld;

/// <summary>Ids of the demo world's portal records that users meet.</summary>
public static class DemoIds
{
    /// <summary>Setup of a human: two spheres, step up 0.6 m, step down 1.5 m.</summary>
    public const uint HumanSetup = 0x02000001;

    /// <summary>Setup of a small creature, quick and on four legs: two spheres of radius 0.3 m.</summary>
    public const uint SmallCreatureSetup = 0x02000100;

    /// <summary>Setup of a large creature, slow and heavy: one cylinder of radius 0.8 m.</summary>
    public const uint LargeCreatureSetup = 0x02000101;

    /// <summary>Setup of a door that fills a house's doorway: 1.2 m by 2.2 m, with a physics tree.</summary>
    public const uint DoorSetup = 0x02000110;

    /// <summary>Setup of a windmill whose sails its default animation turns: 3.2 m square, 7 m high, with physics trees.</summary>
    public const uint WindmillSetup = 0x02000120;

    /// <summary>Setup of an arrow: one sphere of radius 0.1 m about its middle, which points along +y.</summary>
    public const uint ArrowSetup = 0x02000130;

    /// <summary>Motion table of a human.</summary>
    public const uint HumanMotionTable = 0x09000001;

    /// <summary>Motion table of the small creature.</summary>
    public const uint CreatureMotionTable = 0x09000002;

    /// <summary>Motion table of the large creature.</summary>
    public const uint HeavyCreatureMotionTable = 0x09000003;

    internal const uint WoodScene = 0x12000001, RockScene = 0x12000002, ShrubScene = 0x12000003;

    internal const uint TreeSetup = 0x02000200, PineSetup = 0x02000201, ShrubSetup = 0x02000202;

    internal const uint HouseEnvironment = 0x0D000001, DungeonEnvironment = 0x0D000002;
}
