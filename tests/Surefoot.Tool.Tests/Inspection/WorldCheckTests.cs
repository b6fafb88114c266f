using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.World;
using Surefoot.Tool.Inspection;

namespace Surefoot.Tool.Tests.Inspection;

/// <summary>What <c>surefoot dats verify</c> says of a folder beyond its records.</summary>
public sealed class WorldCheckTests
{
    private const uint Room = 0xA9B40101;

    [Theory, Behaviour("tool.dats.region-kind", "spec/07, 7.15")]
    [InlineData(null, "either kind (nothing in the sky tells)")]
    [InlineData(true, "August 2012 or later (nine words a sky object)")]
    [InlineData(false, "before August 2012 (eight words a sky object)")]
    public void Verifying_says_which_kind_of_region_the_files_have(bool? hasScripts, string kind)
    {
        WorldCheck check = CheckMini(portal =>
        {
            SkyObject moon = new(0, 1, 90, 180, 0, 0, 0x01001348, 0, 0);
            SkyDescription sky = new(1, 20, [new DayGroup(1, "Sunny", [moon], [])]) { HasScripts = hasScripts ?? true };
            portal.Put(new Region
            {
                Id = DatIds.Region,
                HeightTable = [.. new float[Region.HeightCount]],
                Parts = RegionParts.Scenes | (hasScripts is null ? 0 : RegionParts.Sky),
                Sky = hasScripts is null ? null : sky,
            });
        });
        Assert.Equal((kind, true, true), (check.Region, check.HasRegion, check.IsComplete));
    }

    [Fact, Behaviour("tool.dats.no-region", "spec/07, 9.1")]
    public void Without_a_region_no_landblock_is_loaded_and_verifying_says_why()
    {
        WorldCheck check = CheckMini(portal => portal.Delete(DatIds.Region));
        Assert.False(check.HasRegion);
        Assert.False(check.IsComplete);
        Assert.Contains("0x13000000 is not in the dat files", check.Region, StringComparison.Ordinal);
    }

    [Fact, Behaviour("tool.dats.left-out", "spec/07, 9.1")]
    public void Verifying_lists_what_a_world_leaves_out_of_every_landblock()
    {
        WorldCheck check = CheckMini(_ => { }, cell =>
        {
            cell.Put(Room, [1, 2, 3]);
            cell.Put(0xA8B3FFFF, [1, 2, 3]);
        });
        Assert.Equal([(LeftOutKind.Landblock, 0xA8B3FFFF), (LeftOutKind.Room, Room)], check.LeftOut.Select(item => (item.Kind, item.Id)));
        Assert.All(check.LeftOut, item => Assert.Equal(DatSet.CellName, Path.GetFileName(item.File)));
        Assert.False(check.IsComplete);
    }

    private static WorldCheck CheckMini(Action<DatFileEditor> changePortal, Action<DatFileEditor>? changeCell = null)
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-check");
        try
        {
            foreach (string file in Directory.GetFiles(Repository.PathOf("tests", "data", "dat-samples", "mini"), "*.dat"))
                File.Copy(file, Path.Combine(folder.FullName, Path.GetFileName(file)));
            Change(DatSet.PortalName, changePortal);
            if (changeCell is not null) Change(DatSet.CellName, changeCell);
            using DatSet dats = DatSet.Open(folder.FullName);
            return WorldCheck.Of(dats, (_, _) => { }, CancellationToken.None);
        }
        finally
        {
            folder.Delete(recursive: true);
        }

        void Change(string name, Action<DatFileEditor> change)
        {
            using DatFileEditor editor = DatFileEditor.Open(Path.Combine(folder.FullName, name));
            change(editor);
            editor.Complete();
        }
    }
}
