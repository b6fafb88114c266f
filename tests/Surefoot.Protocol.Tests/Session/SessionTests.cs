using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Captures;
using Surefoot.Protocol.Tests.Support;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Session;

/// <summary>A client's session with a server's over a good network, in simulated time.</summary>
public class SessionTests
{
    private static readonly NetworkQuality Good = new(delay: 0.05);

    [Fact, Behaviour("protocol.session.login", "08, 3")]
    public void A_client_logs_in_makes_a_character_enters_leaves_and_says_goodbye()
    {
        var network = new SimulatedNetwork(1, Good);
        ClientSession client = network.Client;
        client.Connect(0);
        Assert.True(network.RunUntil(() => client.State == SessionState.CharacterSelect, 5));
        network.Run(0.5);
        Assert.Equal("Test", client.Server?.Name);
        Assert.Equal("walker", client.Characters?.Account);

        client.CreateCharacter(new CharacterCreate { Name = "Alma" });
        Assert.True(network.RunUntil(() => client.Creation is not null, 5));
        Assert.Equal(new CharacterEntry(ScriptedServer.Character, "Alma", 0), Assert.Single(client.Characters!.Value.Characters));

        client.EnterWorld(ScriptedServer.Character);
        Assert.True(network.RunUntil(() => client.State == SessionState.InWorld, 5));
        Assert.Equal(ScriptedServer.Character, client.Player);

        client.LogOff();
        Assert.True(network.RunUntil(() => client.State == SessionState.CharacterSelect, 5));
        client.Close();
        network.Run(0.5);
        Assert.Equal(ServerLinkState.Terminating, network.Server.Link!.State);
        network.Run(2);
        Assert.Equal(ServerLinkState.Ended, network.Server.Link.State);
        Assert.Equal(
            [
                SessionState.LoggingIn, SessionState.CharacterSelect, SessionState.InWorld, SessionState.CharacterSelect,
            ],
            network.Received.States);
        Assert.Equal(
            [
                new MessageId(Opcode.DddInterrogationResponse), new MessageId(Opcode.DddEnd), new MessageId(Opcode.CharacterCreate),
                new MessageId(Opcode.CharacterEnterWorldRequest), new MessageId(Opcode.CharacterEnterWorld),
                new MessageId(Opcode.CharacterLogOff),
            ],
            network.Server.Received.Select(IdOf));
    }

    [Fact, Behaviour("protocol.session.login-retry", "08, 2.7")]
    public void A_login_request_is_repeated_every_two_seconds_until_nobody_has_answered_for_thirty()
    {
        var sent = new SentDatagrams();
        var client = new ClientSession(new ClientSessionOptions { Account = "walker", Password = "testpass" }, sent);
        var received = new ReceivedMessages();
        client.Connect(0);
        List<double> times = [];
        for (double now = 0; now < 31; now += 1.0 / 64)
        {
            client.Update(now, received);
            times.AddRange(sent.Take().Select(_ => now));
        }

        Assert.Equal([0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30], times);
        Assert.Equal(SessionState.Failed, client.State);
        Assert.Equal(SessionFailureKind.NoAnswer, client.Failure?.Kind);
    }

    [Fact, Behaviour("protocol.session.connect-response-until-heard", "08, 3.3")]
    public void A_connect_response_is_repeated_every_third_of_a_second_until_the_password_is_checked()
    {
        var network = new SimulatedNetwork(1, new NetworkQuality(0.02), server: sink => new ScriptedServer(sink) { VerifyTime = 1.1 });
        network.Client.Connect(0);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.CharacterSelect, 5));
        Assert.InRange(network.Now, 1.1, 1.6);
        Assert.InRange(network.Server.Link!.Statistics.Dropped(DropReason.Unexpected), 3, 4);
    }

    [Fact, Behaviour("protocol.session.wrong-password", "08, 3.2 and 8.2")]
    public void A_wrong_password_is_told_in_one_sentence()
    {
        var options = new ClientSessionOptions { Account = "walker", Password = "wrong" };
        var network = new SimulatedNetwork(1, Good, options);
        network.Client.Connect(0);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.Failed, 5));
        Assert.Equal(SessionFailureKind.LoginRefused, network.Client.Failure?.Kind);
        Assert.Equal(
            "The server refused the login: because the password entered for this account was not correct.",
            network.Client.Failure?.Sentence);
        Assert.DoesNotContain("wrong", options.ToString(), StringComparison.Ordinal);
    }

    [Fact, Behaviour("protocol.session.wrong-version", "08, 3.2")]
    public void A_version_that_the_server_does_not_take_is_told_although_nothing_can_be_checked()
    {
        Capture capture = RecordedSessions.Load("wrong-version");
        var options = new ClientSessionOptions { Account = "walker", Password = "x", Version = "1801" };
        var client = new ClientSession(options, new SentDatagrams());
        var received = new ReceivedMessages();
        client.Connect(0);
        client.Receive(capture.Datagrams[1].Bytes, 0.1, received);
        Assert.Equal(SessionFailureKind.VersionRefused, client.Failure?.Kind);
        Assert.StartsWith(
            "The server does not take version 1801: because your client is not the correct version for this server.",
            client.Failure?.Sentence,
            StringComparison.Ordinal);
    }

    [Fact, Behaviour("protocol.session.unchecked-words-are-refusals-only", "08, 3.2")]
    public void Before_a_session_is_known_nothing_but_refusals_is_believed()
    {
        Capture capture = RecordedSessions.Load("enter");
        var client = new ClientSession(new ClientSessionOptions { Account = "walker", Password = "x" }, new SentDatagrams());
        var received = new ReceivedMessages();
        client.Connect(0);
        foreach (CapturedDatagram captured in capture.Datagrams.Where(d => d.Direction == WireDirection.ServerToClient).Skip(1))
            client.Receive(captured.Bytes, captured.Time, received);
        Assert.Empty(received.All);
        Assert.Equal(SessionState.Connecting, client.State);
    }

    [Theory]
    [InlineData(1, SessionFailureKind.AccountInUse)]
    [InlineData(4, SessionFailureKind.ServerClosing)]
    [InlineData(9, SessionFailureKind.AccountUnknown)]
    [InlineData(0x0A, SessionFailureKind.AccountUnknown)]
    [InlineData(0x15, SessionFailureKind.ServerFull)]
    [InlineData(0x77, SessionFailureKind.LoginRefused)]
    [Behaviour("protocol.session.login-refused", "08, 3.5 and 8.2")]
    public void A_login_that_is_refused_by_number_says_why(int code, SessionFailureKind kind)
    {
        var network = new SimulatedNetwork(
            1, Good, server: sink => new ScriptedServer(sink) { Judge = _ => new CharacterError((uint)code) });
        network.Client.Connect(0);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.Failed, 5));
        Assert.Equal(kind, network.Client.Failure?.Kind);
    }

    [Theory]
    [InlineData(0x0D, SessionFailureKind.CharacterInWorld)]
    [InlineData(0x0F, SessionFailureKind.CharacterRefused)]
    [InlineData(0x15, SessionFailureKind.ServerFull)]
    [Behaviour("protocol.session.entering-refused", "08, 3.5")]
    public void A_character_that_cannot_enter_leaves_the_session_at_the_choice_of_characters(int code, SessionFailureKind kind)
    {
        var network = new SimulatedNetwork(1, Good);
        network.Client.Connect(0);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.CharacterSelect, 5));
        network.Server.EnterError = (uint)code;
        network.Client.EnterWorld(ScriptedServer.Character);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.CharacterSelect, 5));
        Assert.Equal(kind, network.Client.Refusal?.Kind);

        network.Server.EnterError = null;
        network.Client.EnterWorld(ScriptedServer.Character);
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.InWorld, 5));
        Assert.Null(network.Client.Refusal);
    }

    [Fact, Behaviour("protocol.session.thrown-out", "08, 3.5")]
    public void An_account_that_is_thrown_out_of_the_world_hears_why()
    {
        var network = new SimulatedNetwork(1, Good);
        network.EnterWorld();
        network.Server.Send(new AccountBanned(7200, "bad manners"));
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.Failed, 5));
        Assert.Equal(
            new SessionFailure(SessionFailureKind.AccountBanned, "The account is banned for 2 hours: bad manners."),
            network.Client.Failure);
    }

    [Fact, Behaviour("protocol.session.silence", "08, 2.7")]
    public void A_server_that_falls_silent_is_noticed_after_the_time_that_was_chosen()
    {
        var options = new ClientSessionOptions { Account = "walker", Password = "testpass", SilenceTimeout = 10 };
        var network = new SimulatedNetwork(1, Good, options);
        network.EnterWorld();
        network.Run(5);
        network.ServerDown = true;
        double since = network.Now;
        Assert.True(network.RunUntil(() => network.Client.State == SessionState.Failed, 15));
        Assert.InRange(network.Now - since, 7, 10.2);
        Assert.Equal(SessionFailureKind.Silent, network.Client.Failure?.Kind);
    }

    [Fact, Behaviour("protocol.session.clocks", "08, 2.6 and 8.4")]
    public void Clocks_and_echoes_go_both_ways()
    {
        var network = new SimulatedNetwork(1, Good);
        network.EnterWorld();
        network.Run(10);
        Assert.InRange(network.Client.RoundTrip!.Value, 0.1, 0.15);
        Assert.InRange(network.Client.ServerTime!.Value - network.Now, -0.07, 0);
        Assert.InRange(network.Client.SilentFor, 0, 2.2);
    }

    [Fact, Behaviour("protocol.session.objects-asked-for-again", "08, 4.3 and 5.6")]
    public void An_object_that_never_comes_is_asked_for_after_twenty_seconds_and_given_up_after_twenty_five()
    {
        var network = new SimulatedNetwork(1, Good);
        network.EnterWorld();
        network.Client.AwaitObject(0x80000001);
        network.Client.AwaitObject(0x80000002);
        network.Run(19);
        Assert.Empty(Requested(network));
        network.Client.ForgetObject(0x80000002);
        network.Run(3);
        Assert.Equal([0x80000001], Requested(network));
        network.Run(60);
        Assert.Single(Requested(network));
    }

    [Fact, Behaviour("protocol.session.objects-asked-for-are-bounded", "design.md, 7")]
    public void Ten_thousand_objects_that_never_come_are_not_all_remembered()
    {
        var requests = new ObjectRequests();
        for (uint guid = 0; guid < 10_000; guid++)
            requests.Await(guid, 0);
        Assert.Equal(ObjectRequests.Most, requests.Count);
        Assert.False(requests.TryTakeDue(26, out _));
        Assert.Equal(0, requests.Count);
    }

    [Fact, Behaviour("protocol.session.signs-of-life", "08, 2.6 and 5.6")]
    public void A_client_that_stands_still_pings_and_shows_a_sign_of_life_every_two_minutes()
    {
        var network = new SimulatedNetwork(1, Good);
        network.EnterWorld();
        network.Run(125);
        Assert.Single(network.Received.Of<PingResponse>());
        Assert.Equal(SessionState.InWorld, network.Client.State);
        Assert.Equal(0, network.Client.MissingPackets);
        Assert.Equal(1, network.Server.Link!.Statistics.Dropped(DropReason.Unexpected));
    }

    [Fact, Behaviour("protocol.session.connects-once", "design.md, 7")]
    public void A_session_out_of_turn_says_so_and_stays_as_it_is()
    {
        var network = new SimulatedNetwork(1, Good);
        Assert.Throws<InvalidOperationException>(() => network.Client.EnterWorld(1));
        Assert.Throws<InvalidOperationException>(network.Client.LogOff);
        Assert.False(network.Client.Send(new LoginComplete()));
        network.EnterWorld();
        Assert.Throws<InvalidOperationException>(() => network.Client.Connect(network.Now));
        Assert.Throws<InvalidOperationException>(() => network.Client.CreateCharacter(new CharacterCreate()));
        Assert.Equal(SessionState.InWorld, network.Client.State);
    }

    [Theory]
    [InlineData("", "testpass")]
    [InlineData("walker\u00e9", "testpass")]
    [InlineData("walker", "pass\u0000word")]
    [Behaviour("protocol.session.names-in-ascii", "08, 10")]
    public void Names_and_passwords_without_a_form_on_the_wire_are_refused_without_being_repeated(string account, string password)
    {
        ArgumentException refused = Assert.Throws<ArgumentException>(
            () => new ClientSessionOptions { Account = account, Password = password });
        Assert.DoesNotContain("word\u0000", refused.Message, StringComparison.Ordinal);
        Assert.DoesNotContain("pass\u0000", refused.Message, StringComparison.Ordinal);
    }

    private static uint[] Requested(SimulatedNetwork network)
        =>
        [
            .. network.Server.Received
                .Where(bytes => IdOf(bytes).Opcode == Opcode.ForceObjDesc)
                .Select(bytes => BitConverter.ToUInt32(bytes, 4)),
        ];

    private static MessageId IdOf(byte[] bytes) => WireMessage.TryParse(bytes, out WireMessage message) ? message.Id : default;
}
