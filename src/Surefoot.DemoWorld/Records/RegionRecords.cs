using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Records;

/// <summary>The region with its height table and terrain types, and the scenes that it names.</summary>
internal static class RegionRecords
{
    /// <summary>Region and scenes.</summary>
    public static IEnumerable<DatRecord> All()
    {
        // Every terrain lists the same scene types, so that the scenery bits of a terrain word mean the same on all of them.
        yield return new Region
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
        yield return new Scene { Id = DemoIds.WoodScene };
        yield return new Scene { Id = DemoIds.RockScene };
        yield return new Scene { Id = DemoIds.ShrubScene };
    }
}
