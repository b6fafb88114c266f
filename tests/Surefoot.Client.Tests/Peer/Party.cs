using System.Diagnostics;
using System.Globalization;
using System.Net;
using System.Numerics;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Tool.Walking;

namespace Surefoot.Client.Tests.Peer;

/// <summary>Players on one server, whose frames one thread brings about: 60 a second of real time.</summary>
internal sealed class Party(IGameServer server) : IDisposable
{
    internal const string Password = "testpass";
    private const double FrameTime = 1.0 / 60;

    /// <summary>Asked for first: without a server the test is skipped here.</summary>
    private readonly IPEndPoint address = server.Address;

    private readonly Stopwatch watch = Stopwatch.StartNew();
    private readonly List<OnlinePlayer> players = [];
    private DatSet? dats;
    private PhysicsDataCache? assets;

    internal double Now => watch.Elapsed.TotalSeconds;

    /// <summary>Shapes and records, one set for all players.</summary>
    internal PhysicsDataCache Assets => assets ??= new PhysicsDataCache(dats ??= DatSet.Open(server.Dats));

    /// <summary>Letters that no account or character has had.</summary>
    internal static string NewName(string start) => start + new string(Random.Shared.GetItems<char>("abcdefghijklmnopqrstuvwxyz", 8));

    /// <summary>Begins to log in.</summary>
    internal OnlinePlayer Connect(string account, string password = Password, string version = LoginRequest.LiveVersion)
    {
        OnlinePlayer player = new(
            address, Assets, new ClientSessionOptions { Account = account, Password = password, Version = version });
        players.Add(player);
        return player;
    }

    /// <summary>Logs in, makes a character if the account has none, enters the world and stands there.</summary>
    internal OnlinePlayer Enter(string? account = null)
    {
        OnlinePlayer player = Connect(account ?? NewName("a"));
        Reach(player, SessionState.CharacterSelect);
        if (player.Session.Characters!.Value.Characters.Count == 0) Create(player, NewName("N"));
        Enter(player, player.Session.Characters!.Value.Characters[0].Guid);
        return player;
    }

    /// <summary>Enters the world on the server's own account, which somebody may have left a moment ago.</summary>
    internal OnlinePlayer EnterAsAdministrator()
    {
        for (int i = 0; i < 5; i++)
        {
            OnlinePlayer player = Connect(server.Administrator);
            bool isIn = Until(() => player.Session.State is SessionState.CharacterSelect or SessionState.Failed)
                && player.Session.State == SessionState.CharacterSelect;
            if (isIn && player.Session.Characters!.Value.Characters.Count == 0) Create(player, NewName("N"));
            if (isIn && TryEnter(player, player.Session.Characters!.Value.Characters[0].Guid)) return player;
            Leave(player);
            Thread.Sleep(4500);
        }

        throw new InvalidOperationException("The administrator's account stays in use.");
    }

    private bool TryEnter(OnlinePlayer player, uint guid)
    {
        player.EnterWorld(guid);
        Until(() => player.Session.State != SessionState.Entering);
        if (player.Session.State != SessionState.InWorld) return false;
        AwaitArrival(player);
        return true;
    }

    /// <summary>Goes where a command takes it, and stands there.</summary>
    internal void Teleport(OnlinePlayer player, string place)
    {
        Assert.True(DemoPlaces.TryFind(place, out NamedPlace named));
        Teleport(player, named.CellId, named.Origin, named.Orientation);
    }

    /// <inheritdoc cref="Teleport(OnlinePlayer, string)"/>
    internal void Teleport(OnlinePlayer player, uint cell, Vector3 origin, Quaternion facing)
    {
        int before = player.Heard<PlayerTeleport>().Count();
        player.Session.Send(new Talk(string.Create(CultureInfo.InvariantCulture,
            $"@teleloc 0x{cell:X8} {origin.X} {origin.Y} {origin.Z} {facing.W} {facing.X} {facing.Y} {facing.Z}")));
        Assert.True(Until(() => player.Heard<PlayerTeleport>().Count() > before), "no teleport came");
        AwaitArrival(player);
    }

    /// <summary>Makes a character.</summary>
    /// <returns>What the server answers: 1 when it was made.</returns>
    internal uint Create(OnlinePlayer player, string name)
    {
        player.Session.CreateCharacter(NewCharacter.Named(name));
        Assert.True(Until(() => player.Session.Creation is not null), "no answer to the creation");
        return player.Session.Creation!.Value.Result;
    }

    internal void Enter(OnlinePlayer player, uint guid)
    {
        player.EnterWorld(guid);
        Reach(player, SessionState.InWorld);
        AwaitArrival(player);
    }

    private void AwaitArrival(OnlinePlayer player)
    {
        Assert.True(
            Until(() => player.Game is { IsPlaying: true, Player.Body: { OnWalkable: true } body } && !body.State.Has(PhysicsState.Hidden)),
            $"not let into the world: {player.Game?.Fault}");
        Wait(0.5);
    }

    internal void Reach(OnlinePlayer player, SessionState state) => Assert.True(
        Until(() => player.Session.State == state), $"{state} wanted, {player.Session.State} reached: {player.Session.Failure?.Sentence}");

    /// <summary>Lets real time pass until something holds.</summary>
    /// <returns>False when it did not within the time.</returns>
    internal bool Until(Func<bool> holds, double seconds = 20)
    {
        double end = Now + seconds;
        while (!holds() && Now < end) Frame();
        return holds();
    }

    internal void Wait(double seconds) => Until(() => false, seconds);

    /// <summary>Has a player's hands do what a script says; the keys are free afterwards.</summary>
    internal void Walk(OnlinePlayer player, string script)
    {
        double next = Now;
        foreach (WalkLeg leg in WalkScript.Parse(script))
        {
            player.Keys = leg.Keys;
            next += leg.Seconds;
            while (Now < next) Frame();
        }

        player.Keys = MovementKeys.None;
        Frame();
    }

    /// <summary>The player stands, and the server has been told where and has answered.</summary>
    internal void Settle(OnlinePlayer player)
    {
        Assert.True(Until(() => player.Player.Body is { OnWalkable: true } body && body.Velocity == default), "never stands");
        Wait(1.5);
    }

    /// <summary>Leaves the world, as one should: the account and the character are free afterwards.</summary>
    internal void LogOff(OnlinePlayer player)
    {
        player.Session.LogOff();
        Reach(player, SessionState.CharacterSelect);
    }

    /// <summary>Says goodbye; the account is in use for a while yet.</summary>
    internal void Leave(OnlinePlayer player)
    {
        player.Dispose();
        players.Remove(player);
    }

    public void Dispose()
    {
        foreach (OnlinePlayer player in players) player.Dispose();
        dats?.Dispose();
    }

    private void Frame()
    {
        double now = Now;
        foreach (OnlinePlayer player in players) player.Update(now);
        double left = FrameTime - (Now - now);
        if (left > 0) Thread.Sleep(TimeSpan.FromSeconds(left));
    }
}
