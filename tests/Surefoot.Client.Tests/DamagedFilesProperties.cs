using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>Bytes of the demo world's files flipped anywhere: what cannot be read costs only itself.</summary>
public sealed class DamagedFilesProperties : IDisposable
{
    private const uint Middle = 0xA9B40001;
    private const int Radius = 2;
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-flipped");

    public void Dispose() => folder.Delete(recursive: true);

    [Fact, Behaviour("world.left-out.flipped-bytes", "spec/07, 9.1; design.md, decision 7")]
    public void Whatever_bytes_are_flipped_the_world_loads_what_it_can_and_its_sound_blocks_are_as_in_a_sound_world()
    {
        DemoWorldBuilder.Write(folder.FullName);
        string cellFile = Path.Combine(folder.FullName, DatSet.CellName), portalFile = Path.Combine(folder.FullName, DatSet.PortalName);
        byte[] cell = File.ReadAllBytes(cellFile), portal = File.ReadAllBytes(portalFile);
        Dictionary<uint, string> sound = Load(out int records);
        Assert.Equal(25, sound.Count);
        int damagedWorlds = 0;
        for (int seed = 0; seed < Fuzz.Cases(250); seed++)
        {
            Random random = new(seed);
            bool inCells = random.Next(2) == 0;
            File.WriteAllBytes(cellFile, inCells ? Flip(cell, random) : cell);
            File.WriteAllBytes(portalFile, inCells ? portal : Flip(portal, random));
            Dictionary<uint, string> found;
            int left;
            try
            {
                found = Load(out left);
            }
            catch (Exception refused) when (refused is DatFormatException or DatRecordMissingException or DatFolderException)
            {
                // No world is made of a file that is no dat file, or without a region: opening says so.
                continue;
            }

            if (found.Count < 25 || found.Any(block => block.Value != sound[block.Key])) damagedWorlds++;
            // The directory's nodes lie among the records; a lost node takes all its records with it.
            if (!inCells || left != records) continue;
            // A few bytes lie in a few records: most blocks are as they were, whatever became of their neighbours.
            Assert.True(found.Count(block => block.Value == sound.GetValueOrDefault(block.Key)) >= 25 - (2 * Flips), $"seed {seed}: {found.Count} blocks");
        }

        Assert.True(damagedWorlds > 0, "no flip has damaged anything");
    }

    private const int Flips = 4;

    private static byte[] Flip(byte[] whole, Random random)
    {
        // The header and the directory behind it are the container's; its tests are in Surefoot.Dats.Tests.
        byte[] damaged = (byte[])whole.Clone();
        for (int i = 0; i < Flips; i++) damaged[random.Next(1024, damaged.Length)] ^= (byte)random.Next(1, 256);
        return damaged;
    }

    /// <summary>Loads around the middle and describes each block: ground, rooms, objects and their places.</summary>
    private Dictionary<uint, string> Load(out int records)
    {
        using DatSet dats = DatSet.Open(folder.FullName);
        records = dats.Files.Sum(file => file.Ids.Count);
        PhysicsWorld world = new(new PhysicsDataCache(dats));
        world.EnsureLoadedAround(new Position(Middle, default), Radius);
        return world.Landblocks.ToDictionary(block => block.Id, Describe);
    }

    private static string Describe(Landblock block)
    {
        HashCode ground = default;
        for (int square = 1; square <= 64; square++)
            foreach (float offset in (ReadOnlySpan<float>)[1, 12, 23])
                if (block.Terrain.TryGetHeight(((square - 1) / 8 * 24) + offset, ((square - 1) % 8 * 24) + 5, out float height)) ground.Add(height);
        IEnumerable<string> objects = block.StaticObjects.Select(item => $"{item.Setup?.Id:X8}@{item.Position}");
        return $"{ground.ToHashCode():X8} {block.Cells.Count()} {string.Join(' ', objects)}";
    }
}
