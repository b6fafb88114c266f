using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Inspection;

/// <summary>What a world makes of files: its region, and what it has to leave out.</summary>
/// <param name="Region">The kind of the region, or why there is none, in words.</param>
/// <param name="HasRegion">There is a region that can be read; without one nothing can be loaded.</param>
/// <param name="LeftOut">What is left out when every landblock is loaded once.</param>
internal sealed record WorldCheck(string Region, bool HasRegion, LeftOutList LeftOut)
{
    /// <summary>Whether a world over these files has everything that they name.</summary>
    internal bool IsComplete => HasRegion && LeftOut.Total == 0;

    /// <summary>Loads every landblock, one after the other.</summary>
    /// <param name="set">The files.</param>
    /// <param name="report">Told how many of how many are done.</param>
    /// <param name="cancellation">Ends the walk.</param>
    internal static WorldCheck Of(DatSet set, Action<int, int> report, CancellationToken cancellation)
    {
        PhysicsWorld world;
        string region;
        try
        {
            region = KindOf(set.Read<Region>(DatIds.Region));
            world = new PhysicsEngine(new PhysicsDataCache(set)).World;
        }
        catch (Exception fault) when (fault is DatFormatException or DatRecordMissingException)
        {
            return new WorldCheck($"none, so no landblock was loaded: {fault.Message}", HasRegion: false, new LeftOutList());
        }

        uint[] blocks = [.. set.IdsOf(DatRecordType.LandBlock)];
        for (int i = 0; i < blocks.Length; i++)
        {
            cancellation.ThrowIfCancellationRequested();
            world.LoadLandblock(blocks[i]);
            world.UnloadLandblock(blocks[i]);
            report(i + 1, blocks.Length);
        }

        return new WorldCheck(region, HasRegion: true, world.LeftOut);
    }

    private static string KindOf(Region region)
    {
        if (region.Sky is not { } sky || sky.DayGroups.All(day => day.Objects.IsEmpty)) return "either kind (nothing in the sky tells)";
        return sky.HasScripts ? "August 2012 or later (nine words a sky object)" : "before August 2012 (eight words a sky object)";
    }
}
