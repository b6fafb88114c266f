using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Tests.Support;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>What was done on the page is done again by its command: in a time that the tests make up, and to the last bit.</summary>
public sealed class WalkAgainTests : IDisposable
{
    private readonly SimulatedWorld world = new(
        "Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, DemoSpawns.All);

    private double tick = 100, now = 100;

    public void Dispose() => world.Dispose();

    [Theory]
    [Behaviour("workbench.walk.again-to-the-last-bit", "design.md, The tool and decision 5")]
    [InlineData(0xA9B50032, 1)] // meadow
    [InlineData(0xA7B4000F, 2)] // runway
    [InlineData(0xABB50028, 3)] // slope of 60 degrees
    [InlineData(0xAAB20001, 4)] // hills
    [InlineData(0xACB7002E, 5)] // mountain top
    [InlineData(0xA7B2003E, 6)] // lake
    [InlineData(0xA8B50101, 7)] // stairs in a house
    [InlineData(0xA8B50003, 8)] // rooftop
    [InlineData(0xAAB5002C, 9)] // corners
    [InlineData(0xA8B7003C, 10)] // forest
    [InlineData(0x01200105, 11)] // pit in a dungeon
    public async Task The_command_goes_the_same_way_to_the_last_bit(uint cell, int seed)
    {
        Random random = new(seed);
        WorkbenchPlace start = world.Places.First(place => place.CellId == cell);
        IWorkbenchPlayer player = world.Join(1, new PlayerSettings(150 + (seed * 40), 300, 0), start, now);
        // What was done before a rest is not part of it, but how the player turned meanwhile is where it begins.
        Pass(1);
        Hold(player, PlayerKeys.TurnRight, 0.31 * seed);
        Pass(2.5);
        PlayerPose from = player.Pose;
        PlayerKeys[] chances =
        [
            PlayerKeys.Forward, PlayerKeys.TurnLeft, PlayerKeys.TurnRight, PlayerKeys.Jump, PlayerKeys.SidestepLeft, PlayerKeys.Walk,
            PlayerKeys.Back, PlayerKeys.SidestepRight,
        ];
        PlayerKeys held = PlayerKeys.Forward;
        List<PlayerPose> poses = [from];
        for (int change = 0; change < 40; change++)
        {
            if (change == 12) player.ToggleAutoRun(now);
            player.SetKeys(held, now);
            Pass(random.Next(1, 200) / 512.0, () => poses.Add(player.Pose));
            held ^= chances[random.Next(chances.Length)];
        }

        player.SetKeys(PlayerKeys.Forward, now);
        player.SetKeys(PlayerKeys.None, now);
        Pass(3, () => poses.Add(player.Pose));

        WalkReport walk = player.Walk;
        Assert.Equal("", walk.LeftOut);
        JsonElement again = await Command.JsonAsync(walk.Command);
        (uint Cell, Vector3 At)[] samples = [.. again.GetProperty("samples").EnumerateArray().Select(Spot)];
        Assert.True(samples.Length > 100, walk.Command);
        for (int i = 0; i < samples.Length; i++) Assert.Equal((poses[i].CellId, poses[i].Position), samples[i]);
        Assert.Equal((poses[^1].CellId, poses[^1].Position), samples[^1]);
        double heading = again.GetProperty("samples")[samples.Length - 1].GetProperty("heading").GetDouble();
        Assert.Equal(poses[^1].Yaw, (float)(-heading * Math.PI / 180));
        Assert.True(Vector3.Distance(poses[0].Position, poses[^1].Position) > 1, "somewhere else");
    }

    private void Hold(IWorkbenchPlayer player, PlayerKeys keys, double seconds)
    {
        player.SetKeys(keys, now);
        Pass(seconds);
        player.SetKeys(PlayerKeys.None, now);
    }

    private void Pass(double seconds, Action? ticked = null)
    {
        now = WorldTime.Floor(now + seconds);
        for (; tick + WorldTime.Quantum <= now; ticked?.Invoke()) world.Advance(tick += WorldTime.Quantum);
    }

    private static (uint Cell, Vector3 At) Spot(JsonElement sample)
    {
        JsonElement at = sample.GetProperty("position");
        uint cell = uint.Parse(sample.GetProperty("cell").GetString()!, NumberStyles.HexNumber, CultureInfo.InvariantCulture);
        return (cell, new Vector3(at[0].GetSingle(), at[1].GetSingle(), at[2].GetSingle()));
    }
}
