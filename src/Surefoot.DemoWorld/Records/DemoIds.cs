namespace Surefoot.DemoWorld;

/// <summary>Ids of the demo world's portal records that users meet.</summary>
public static class DemoIds
{
    /// <summary>Setup of a human: two spheres, step up 0.6 m, step down 1.5 m.</summary>
    public const uint HumanSetup = 0x02000001;

    /// <summary>Motion table of a human.</summary>
    public const uint HumanMotionTable = 0x09000001;

    /// <summary>Scene types, by their position in the region: nothing, a wood, rocks, shrubs.</summary>
    internal const uint WoodScene = 0x12000001, RockScene = 0x12000002, ShrubScene = 0x12000003;

    /// <summary>Solid-colour surfaces.</summary>
    internal const uint Skin = 0x08000001, Hair = 0x08000002, Shirt = 0x08000003, Trousers = 0x08000004, Boots = 0x08000005;
}
