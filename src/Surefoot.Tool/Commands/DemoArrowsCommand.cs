using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot demo arrows</c>: has the archer and the trap of the butts shoot, and says what each missile hits.</summary>
internal static class DemoArrowsCommand
{
    private const double Tick = (1.0 / 30) + 1e-9, LongestSeconds = 3600;
    private const uint FirstSpawned = 0x80000001;

    internal static Command Create(JsonSerializerOptions json)
    {
        Option<double> seconds = new("--seconds") { Description = "How long they shoot, simulated.", DefaultValueFactory = _ => 6 };
        Option<bool> asJson = new("--json") { Description = "Print one JSON object." };
        Command command = new("arrows",
            "Has the archer and the spell trap of the demo world shoot, and says what each missile hits.\n\n" +
            "Example:\n  surefoot demo arrows --seconds 10") { seconds, asJson };
        command.SetAction(parsed =>
        {
            double time = parsed.GetValue(seconds);
            if (!(time > 0 && time <= LongestSeconds))
                throw new UsageException($"--seconds {time}: give a number above 0, at most {LongestSeconds}.");
            using Simulation simulation = Simulation.Open(DemoWorldCache.GetOrCreate(notice: CommonOptions.Say));
            List<Hit> hits = Shoot(simulation, time, out int shots);
            if (parsed.GetValue(asJson)) Console.Out.WriteLine(JsonSerializer.Serialize(new { Shots = shots, Hits = hits }, json));
            else Print(hits, shots);
            return ExitCode.Done;
        });
        return command;
    }

    private static List<Hit> Shoot(Simulation simulation, double seconds, out int shots)
    {
        PhysicsEngine engine = simulation.Engine;
        Dictionary<uint, string> names = Spawn(simulation);
        Missiles missiles = new(engine);
        Dictionary<uint, (string Shooter, double Since)> flights = [];
        double[] next = new double[DemoShooters.All.Length];
        List<Hit> hits = [];
        shots = 0;
        for (int frame = 1; frame * Tick <= seconds; frame++)
        {
            double now = frame * Tick;
            for (int i = 0; i < next.Length; i++)
            {
                if (now < next[i]) continue;
                DemoShooter shooter = DemoShooters.All[i];
                next[i] = now + shooter.Period;
                Position muzzle = new(shooter.CellId, shooter.Origin);
                SetupAsset shape = simulation.Assets.GetSetup(shooter.SetupId);
                if (missiles.Launch(shape, muzzle, shooter.Velocity, shooter.Falls) is not { } missile) continue;
                flights[missile.Id] = (shooter.Name, now);
                shots++;
            }

            engine.Tick(now);
            while (missiles.TryTakeHit(out MissileHit hit))
            {
                (string name, double since) = flights[hit.MissileId];
                Position place = hit.Impact.Place;
                hits.Add(new Hit(
                    Math.Round(hit.Time, 3), name, Math.Round(hit.Time - since, 3), names.GetValueOrDefault(hit.ObjectId, "environment"),
                    $"{place.CellId:X8}", Numbers(place.Frame.Origin), Numbers(hit.Impact.Normal)));
            }

            missiles.Update();
        }

        return hits;
    }

    /// <summary>Those who stand at the butts, by the ids of their bodies.</summary>
    private static Dictionary<uint, string> Spawn(Simulation simulation)
    {
        Dictionary<uint, string> names = [];
        foreach (DemoShooter shooter in DemoShooters.All)
            simulation.World.EnsureLoadedAround(new Position(shooter.CellId, shooter.Origin), 1);
        foreach (DemoSpawn spawn in DemoSpawns.All)
        {
            if (spawn.Kind != DemoSpawnKind.Guard || simulation.World.FindLandblock(spawn.CellId) is null) continue;
            uint id = FirstSpawned + (uint)names.Count;
            DemoBodies.Spawn(simulation.Engine, simulation.Assets, spawn, id);
            names[id] = spawn.Name;
        }

        return names;
    }

    private static void Print(List<Hit> hits, int shots)
    {
        foreach (Hit hit in hits)
        {
            Console.Out.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"{hit.Time,7:0.000} s  {hit.Shooter,-12} after {hit.Flight:0.000} s  {hit.Target,-16} 0x{hit.Cell} " +
                $"({string.Join(", ", hit.Position)})  normal ({string.Join(", ", hit.Normal)})"));
        }

        Console.Out.WriteLine($"{shots} shots, {hits.Count} hits");
    }

    private static double[] Numbers(System.Numerics.Vector3 v) => [Math.Round(v.X, 3), Math.Round(v.Y, 3), Math.Round(v.Z, 3)];

    /// <summary>A hit as it is printed: seconds, metres in the landblock, and the normal of what was hit.</summary>
    private sealed record Hit(
        double Time, string Shooter, double Flight, string Target, string Cell, double[] Position, double[] Normal);
}
