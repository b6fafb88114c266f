using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Records;

/// <summary>The region with its height table, terrain types and scene types.</summary>
internal static class RegionRecords
{
    /// <summary>The region. Every terrain lists the same scene types, so that scenery bits mean the same on all of them.</summary>
    public static Region Region() => new()
    {
        Id = DatIds.Region,
        Name = "Surefoot Demo",
        HeightTable = DemoHeightTable.Heights,
        Time = new() { DayLength = 7620, DaysPerYear = 360, YearName = "P.Y." },
        Parts = RegionParts.Scenes,
        SceneTypes =
            [
                new(SceneType.NoSound, []),
                new(SceneType.NoSound, [DemoIds.WoodScene]),
                new(SceneType.NoSound, [DemoIds.RockScene]),
                new(SceneType.NoSound, [DemoIds.ShrubScene]),
            ],
        TerrainTypes =
            [
                .. Enumerable.Range(0, TerrainKinds.Count).Select(kind =>
                    new TerrainType(TerrainKinds.NameOf(kind), TerrainKinds.ColourOf((TerrainKind)kind), [0, 1, 2, 3])),
            ],
    };
}
