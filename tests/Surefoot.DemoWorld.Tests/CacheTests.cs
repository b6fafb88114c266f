using Surefoot.Dats;

namespace Surefoot.DemoWorld.Tests;

public sealed class CacheTests : IDisposable
{
    private readonly string folder = Directory.CreateTempSubdirectory("surefoot-cache-").FullName;
    private readonly string? before = Environment.GetEnvironmentVariable(DemoWorldCache.FolderVariable);

    public CacheTests() => Environment.SetEnvironmentVariable(DemoWorldCache.FolderVariable, folder);

    public void Dispose()
    {
        Environment.SetEnvironmentVariable(DemoWorldCache.FolderVariable, before);
        Directory.Delete(folder, recursive: true);
    }

    [Fact, Behaviour("demo-world.cache.writes-once", "design.md, Two commands")]
    public void A_world_is_written_once_and_then_found()
    {
        string first = DemoWorldCache.GetOrCreate();
        Assert.StartsWith(folder, first);
        var written = File.GetLastWriteTimeUtc(Path.Combine(first, DatSet.CellName));
        var steps = new List<DemoWorldProgress>();
        Assert.Equal(first, DemoWorldCache.GetOrCreate(progress: new Listener(steps)));
        Assert.Empty(steps);
        Assert.Equal(written, File.GetLastWriteTimeUtc(Path.Combine(first, DatSet.CellName)));
        Assert.NotEqual(first, DemoWorldCache.GetOrCreate(seed: 5));
    }

    [Fact, Behaviour("demo-world.cache.survives-a-race", "design.md, Two commands")]
    public async Task Several_callers_at_once_get_one_whole_world()
    {
        string[] folders = await Task.WhenAll(
            Enumerable.Range(0, 8)
                .Select(_ => Task.Run(() => DemoWorldCache.GetOrCreate(seed: 77), TestContext.Current.CancellationToken)));
        Assert.Single(folders.Distinct());
        using var dats = DatSet.Open(folders[0]);
        Assert.Equal(101, dats.IdsOf(DatRecordType.LandBlock).Count());
        Assert.Single(Directory.GetDirectories(DemoWorldCache.Root));
    }

    [Fact, Behaviour("demo-world.cache.falls-back", "what a read-only or missing cache folder does")]
    public void A_cache_that_cannot_be_written_to_is_replaced_by_a_temporary_folder_and_says_how_to_choose()
    {
        string blocked = Path.Combine(folder, "a-file");
        File.WriteAllText(blocked, "in the way");
        Environment.SetEnvironmentVariable(DemoWorldCache.FolderVariable, blocked);
        List<string> said = [];
        string world = DemoWorldCache.GetOrCreate(notice: said.Add);
        Assert.StartsWith(Path.GetTempPath(), world);
        using var dats = DatSet.Open(world);
        Assert.Equal(101, dats.IdsOf(DatRecordType.LandBlock).Count());
        Assert.Contains("SUREFOOT_CACHE", Assert.Single(said));
        Assert.Contains(blocked, said[0]);
    }

    [Fact, Behaviour("demo-world.write.several-at-once", "three writers into one folder at the same time")]
    public async Task Several_writers_into_one_folder_all_succeed()
    {
        string target = Path.Combine(folder, "shared");
        await Task.WhenAll(
            Enumerable.Range(0, 3).Select(_ => Task.Run(() => DemoWorldBuilder.Write(target), TestContext.Current.CancellationToken)));
        using var dats = DatSet.Open(target);
        Assert.Equal(101, dats.IdsOf(DatRecordType.LandBlock).Count());
        Assert.Equal(3, Directory.GetFiles(target).Length);
    }

    [Fact, Behaviour("demo-world.cache.repairs-damage", "design.md, Two commands")]
    public void A_world_that_lost_a_file_is_written_again()
    {
        string world = DemoWorldCache.GetOrCreate();
        File.Delete(Path.Combine(world, DatSet.CellName));
        Assert.Equal(world, DemoWorldCache.GetOrCreate());
        Assert.True(File.Exists(Path.Combine(world, DatSet.CellName)));
    }

    [Fact, Behaviour("demo-world.cache.reports-progress", "design.md, Two commands")]
    public void Writing_tells_how_far_it_is()
    {
        var steps = new List<DemoWorldProgress>();
        DemoWorldCache.GetOrCreate(seed: 3, new Listener(steps));
        Assert.Equal(0.0, steps[0].Share);
        Assert.Equal(1.0, steps[^1].Share);
        Assert.Equal(steps.Select(step => step.Share).Order(), steps.Select(step => step.Share));
    }

    private sealed class Listener(List<DemoWorldProgress> steps) : IProgress<DemoWorldProgress>
    {
        public void Report(DemoWorldProgress value) => steps.Add(value);
    }
}
