using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

/// <summary>The ten lines of the README are these; they compile, and they run.</summary>
public sealed class ReadmeSampleTests
{
    private const string Mark = "// sample";

    [Fact]
    [Behaviour("docs.readme.sample-runs", "README, Embed it")]
    public void The_sample_of_the_readme_runs_and_is_what_the_readme_shows()
    {
        double now = 0;
        string folder = Directory.CreateTempSubdirectory("surefoot-readme-").FullName;
        DemoWorldBuilder.Write(folder);
        NamedPlace place = DemoPlaces.All[0];
        try
        {
            // sample
            using var dats = DatSet.Open(folder);                              // client_portal.dat and client_cell_1.dat
            var cache = new PhysicsDataCache(dats);                            // shared by any number of worlds and threads
            var world = new PhysicsWorld(cache);
            var start = new Position(place.CellId, place.Origin);
            world.EnsureLoadedAround(start, radius: 1);                        // landblocks around the place
            var engine = new PhysicsEngine(world);
            var human = cache.GetSetup(0x02000001);
            var motions = MotionTableLoader.Load(dats, human.DefaultMotionTableId);
            var server = new LoopbackServer(0x50000001, new CharacterStats(RunSkill: 300, JumpSkill: 250), now);
            var player = LocalPlayer.Spawn(engine, 0x50000001, human, motions, start, server)!;
            for (int frame = 0; frame < 120; frame++, now += 1.0 / 60)
            {
                player.Update(MovementKeys.Forward, now);                      // keys held, seconds
                engine.Tick(now);                                              // then draw player.Body.Position
            }

            // sample
            Assert.True(start.DistanceTo(player.Body.Position) > 10);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }

        string[] source = File.ReadAllLines(Repository.PathOf("tests", "Surefoot.Client.Tests", "ReadmeSampleTests.cs"));
        int first = Array.FindIndex(source, line => line.Trim() == Mark), last = Array.FindLastIndex(source, line => line.Trim() == Mark);
        string[] sample = [.. source[(first + 1)..last].Select(line => line.Trim()).Where(line => line.Length > 0)];
        string[] readme = [.. File.ReadAllLines(Repository.PathOf("README.md")).Select(line => line.Trim())];
        Assert.All(sample, line => Assert.Contains(line, readme));
    }
}
