using System.Globalization;
using System.Numerics;
using System.Text.RegularExpressions;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Server;

namespace Surefoot.Client.Tests.Peer;

/// <content>Coming and going, refusals, corrections, and what the server thinks of a long walk.</content>
public abstract partial class ServerSuite
{
    /// <summary>Minutes of an honest walk where the server's own sweep judges it; the environment may ask for others.</summary>
    private static double Minutes => double.TryParse(
        Environment.GetEnvironmentVariable("SUREFOOT_ACE_MINUTES"), CultureInfo.InvariantCulture, out double minutes) ? minutes : 10;

    [Fact]
    [Behaviour("client.server.comes-back", "08, 3.5 and 3.6")]
    public void A_character_that_logs_off_and_in_again_stands_where_it_stood_in_a_new_life()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        party.Walk(player, "A 0.5; W 1");
        party.Settle(player);
        Position left = player.Position;
        uint guid = player.Id;
        ushort life = LivesOf(player)[^1];

        party.LogOff(player);
        Assert.Equal(guid, Assert.Single(player.Session.Characters!.Value.Characters).Guid);
        party.Enter(player, guid);
        Assert.InRange(Apart(left, player.Position), 0, Same);
        Assert.True(ObjectStamps.IsNewer(life, LivesOf(player)[^1]), "the life is not a new one");
        party.Walk(player, "W 1");
        party.Settle(player);
        AssertAgreed(player);

        static ushort[] LivesOf(OnlinePlayer player) => [.. player.Heard<CreateObject>()
            .Where(m => m.Object.Guid == player.Id).Select(m => m.Object.Physics.Stamps.Instance)];
    }

    [Fact]
    [Behaviour("client.server.forced-position", "08, 4.4, step 1 and 5.7 (z correction)")]
    public void A_correction_puts_the_player_where_the_server_wants_it_and_is_confirmed_at_once()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        party.Walk(player, "W 0.5");
        party.Settle(player);
        Position stood = player.Position;
        MovementStamps stamps = player.Sent.OfType<MoveToState>().Last().Stamps;
        Assert.Equal(0, stamps.ForcePosition);

        // Up by a jump that the player itself knows nothing of, and then a height that no jump reaches.
        WirePosition place = new(stood.CellId, stood.Frame.Origin, stood.Frame.Rotation);
        int sent = player.Sent.Count;
        player.Session.Send(new Jump(1, new Vector3(0, 0, 12), place, stamps));
        party.Wait(1.3);
        player.Session.Send(new AutonomousPosition(place with { Origin = place.Origin + new Vector3(0, 0, 15) }, stamps, Contact: false));
        Assert.True(
            party.Until(() => player.Heard<UpdatePosition>().Any(m => m.Guid == player.Id && m.Pack.ForcePosition > 0)), "no correction");
        party.Settle(player);
        Assert.InRange(Apart(stood, player.Position), 0, Same);
        AutonomousPosition confirmed = Assert.IsType<AutonomousPosition>(player.Sent[sent]);
        Assert.Equal(1, confirmed.Stamps.ForcePosition);
        AssertAgreed(player);
    }

    [Fact]
    [Behaviour("client.server.same-bits-offline", "design.md, decision 5: the same inputs give the same bits")]
    public void The_same_keys_at_the_same_times_without_a_server_give_the_same_places_bit_for_bit()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        CharacterStats stats = player.Player.Weenie.Stats;
        player.Record();
        party.Wait(0.3);
        party.Walk(player, "W 1.5; W+A 0.7; W+Space 0.5; W 0.8; Q 0.5; Shift+W 0.6; D 0.3; S 0.5; Space 0.2; Wait 1");
        OnlinePlayer.Frame[] frames = [.. player.Frames!];
        Assert.True(Apart(frames[0].Position, frames[^1].Position) > 5, "it did not run");

        PhysicsEngine engine = new(party.Assets);
        engine.World.EnsureLoadedAround(frames[0].Position, 2);
        engine.Tick(frames[0].Now);
        SetupAsset human = party.Assets.GetSetup(0x02000001);
        LocalPlayer offline = LocalPlayer.Spawn(
            engine, 1, human, MotionTableLoader.LoadFor(party.Assets.Source, human), frames[0].Position,
            new LoopbackServer(1, stats, frames[0].Now))!;
        engine.Player = offline.Body;
        int same = 0;
        foreach (OnlinePlayer.Frame frame in frames)
        {
            if (frame != frames[0]) engine.Tick(frame.Now);
            offline.Update(frame.Keys, frame.Now);
            if (offline.Body.Position != frame.Position) break;
            same++;
        }

        Assert.Equal(frames.Length, same);
    }

    [Fact]
    [Behaviour("client.server.honest-walk", "08, 5.7: the server's own sweep; 03, 4.3, find_transitional_position 5c")]
    public void In_a_long_honest_walk_the_servers_own_sweep_fails_only_over_less_than_its_tolerance()
    {
        using Party party = new(server);
        OnlinePlayer player = party.Enter();
        int before = server.FailedTransitions(0)?.Length ?? 0;
        double minutes = server.FailedTransitions(0) is null ? 0.3 : Minutes;
        Random hands = new(7);
        string[] keys = ["W", "W+A", "W+D", "Shift+W", "Q", "E", "S", "A", "D", "Wait"];
        double end = party.Now + (minutes * 60);
        while (party.Now < end)
        {
            string key = keys[hands.Next(keys.Length)];
            party.Walk(player, string.Create(CultureInfo.InvariantCulture, $"{key} {0.2 + (1.8 * hands.NextDouble()):0.00}"));
            if (hands.Next(6) == 0) party.Walk(player, "W+Space 0.4; W 0.6");
        }

        party.Settle(player);
        AssertAgreed(player);
        Assert.All(server.FailedTransitions(before) ?? [], line => Assert.True(IsTooShortToSweep(line), line));
        Assert.Equal(0, player.Player.UnreadableMessages);
        Assert.Equal(SessionState.InWorld, player.Session.State);
    }

    [Fact]
    [Behaviour("client.server.wrong-password", "08, 3.2")]
    public void A_wrong_password_is_refused_in_one_sentence()
    {
        using Party party = new(server);
        string account = Party.NewName("pass");
        OnlinePlayer first = party.Connect(account);
        party.Reach(first, SessionState.CharacterSelect);
        party.Leave(first);
        party.Wait(4);
        Assert.Equal(SessionFailureKind.LoginRefused, Refused(party, party.Connect(account, "another")));
    }

    [Fact]
    [Behaviour("client.server.wrong-version", "08, 3.2")]
    public void A_wrong_version_is_refused_in_one_sentence()
    {
        using Party party = new(server);
        Assert.Equal(SessionFailureKind.VersionRefused, Refused(party, party.Connect(Party.NewName("old"), version: "1801")));
    }

    [Fact]
    [Behaviour("client.server.account-in-use", "08, 3.6")]
    public void An_account_in_use_ends_both_sessions_in_one_sentence()
    {
        using Party party = new(server);
        string account = Party.NewName("twice");
        OnlinePlayer older = party.Connect(account);
        party.Reach(older, SessionState.CharacterSelect);
        Assert.Equal(SessionFailureKind.AccountInUse, Refused(party, party.Connect(account)));
        Assert.Equal(SessionFailureKind.AccountInUse, Refused(party, older));
    }

    [Fact]
    [Behaviour("client.server.name-taken", "08, 3.4")]
    public void A_characters_name_that_is_taken_is_refused_and_another_one_is_accepted()
    {
        using Party party = new(server);
        string name = Party.NewName("N");
        OnlinePlayer first = party.Connect(Party.NewName("a")), second = party.Connect(Party.NewName("a"));
        party.Reach(first, SessionState.CharacterSelect);
        party.Reach(second, SessionState.CharacterSelect);
        Assert.Equal(1u, party.Create(first, name));
        Assert.Equal(3u, party.Create(second, name));
        party.Wait(1);
        Assert.Equal(1u, party.Create(second, Party.NewName("N")));
    }

    /// <summary>
    /// A place within the tolerance of the one before, as where a turn on the spot ends: by retail's own rule a sweep whose first step is
    /// shorter than that has failed.
    /// </summary>
    private static bool IsTooShortToSweep(string line)
    {
        float[][] places = [.. PlacePattern().Matches(line).Select(match => match.Groups[1].Value.Split(' ')
            .Select(word => float.Parse(word, CultureInfo.InvariantCulture)).ToArray())];
        return places is [[var x, var y, var z], [var u, var v, var w]] && new Vector3(x - u, y - v, z - w).Length() < 0.0002f;
    }

    [GeneratedRegex(@"\[(-?[\d.]+(?:E-?\d+)? -?[\d.]+(?:E-?\d+)? -?[\d.]+(?:E-?\d+)?)\]")]
    private static partial Regex PlacePattern();

    private static SessionFailureKind Refused(Party party, OnlinePlayer player)
    {
        party.Reach(player, SessionState.Failed);
        Assert.Matches(@"^[A-Z][^.\r\n]*\.$", player.Session.Failure!.Sentence);
        Assert.DoesNotContain(Party.Password, player.Session.Failure.Sentence, StringComparison.Ordinal);
        return player.Session.Failure.Kind;
    }
}
