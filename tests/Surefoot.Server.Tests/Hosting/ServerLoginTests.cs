using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

public sealed class ServerLoginTests(DemoGround ground) : IClassFixture<DemoGround>
{
    [Fact]
    [Behaviour("server.login.wrong-password", "spec/08, 8.2")]
    public void Another_password_than_that_of_the_first_login_is_refused()
    {
        SimulatedHost host = new(ground);
        TestClient first = host.Connect("anna", "one");
        Assert.True(host.RunUntil(() => first.Session.State == SessionState.CharacterSelect));
        first.Session.Close();
        host.Run(4);
        TestClient second = host.Connect("Anna", "another");
        Assert.True(host.RunUntil(() => second.Session.State == SessionState.Failed));
        Assert.Equal(SessionFailureKind.LoginRefused, second.Session.Failure!.Kind);
        Assert.DoesNotContain(host.Lines, line => line.Contains("another", StringComparison.Ordinal));

        TestClient third = host.Connect("ANNA", "one");
        Assert.True(host.RunUntil(() => third.Session.State == SessionState.CharacterSelect));
        Assert.Equal("anna", third.Session.Characters!.Value.Account);
    }

    [Fact]
    [Behaviour("server.login.version", "spec/08, 3.2 and 8.2")]
    public void Another_version_is_refused_without_a_session()
    {
        SimulatedHost host = new(ground);
        TestClient client = host.Connect("anna", change: options => options with { Version = "1801" });
        Assert.True(host.RunUntil(() => client.Session.State == SessionState.Failed, 3));
        Assert.Equal(SessionFailureKind.VersionRefused, client.Session.Failure!.Kind);
        host.Run(1.1);
        Assert.Equal((1, 0), (host.Server.Figures.RefusedLogins(LoginRefusal.Version), host.Server.Figures.Sessions));
    }

    [Fact]
    [Behaviour("server.login.account-in-use", "spec/08, 3.6 and 8.2")]
    public void An_account_in_use_ends_both_sessions_and_is_free_two_seconds_later()
    {
        SimulatedHost host = new(ground);
        TestClient first = host.Enter("anna", "Anna"), second = host.Connect("anna");
        Assert.True(host.RunUntil(() => first.Session.State == SessionState.Failed && second.Session.State == SessionState.Failed, 5));
        Assert.Equal(SessionFailureKind.AccountInUse, first.Session.Failure!.Kind);
        Assert.Equal(SessionFailureKind.AccountInUse, second.Session.Failure!.Kind);

        // Too soon: the two seconds begin anew.
        host.Run(1);
        TestClient third = host.Connect("anna");
        Assert.True(host.RunUntil(() => third.Session.State == SessionState.Failed, 5));
        host.Run(2.5);
        TestClient fourth = host.Connect("anna");
        fourth.EnterAs("Anna");
    }

    [Fact]
    [Behaviour("server.login.unknown-account", "spec/08, 8.2")]
    public void Who_is_not_in_the_file_of_accounts_does_not_come_in()
    {
        string path = Path.Combine(Path.GetTempPath(), $"accounts-{Guid.NewGuid():N}.json");
        try
        {
            AccountFile file = AccountFile.ReadOrBegin(path);
            file.Set("Anna", "right", administrator: true);
            file.Set("bert", "right", administrator: false);
            Assert.DoesNotContain("right", File.ReadAllText(path), StringComparison.Ordinal);
            AccountFile accounts = AccountFile.Read(path);
            Assert.Equal(2, accounts.Count);
            Assert.Equal(
                [AccountVerdict.Administrator, AccountVerdict.Welcome, AccountVerdict.WrongPassword, AccountVerdict.Unknown],
                [
                    accounts.Check("anna", "right"), accounts.Check("bert", "right"), accounts.Check("anna", "Right"),
                    accounts.Check("carl", "right"),
                ]);

            // Slow checks are made on another thread: time passes on the wall, too.
            SimulatedHost host = new(ground, options => options with { Accounts = accounts, Commands = CommandRights.Administrators });
            TestClient stranger = host.Connect("carl", "right"), anna = host.Connect("anna", "right");
            Assert.True(host.RunUntil(
                () =>
                {
                    Thread.Sleep(20);
                    return stranger.Session.State == SessionState.Failed && anna.Session.State == SessionState.CharacterSelect;
                },
                14));
            Assert.Equal(SessionFailureKind.AccountUnknown, stranger.Session.Failure!.Kind);
            host.Server.Dispose();
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Theory]
    [InlineData("not json")]
    [InlineData("[{\"name\":\"anna\",\"hash\":\"plain\"}]")]
    [InlineData("[{\"hash\":\"plain\"}]")]
    [Behaviour("server.accounts.bad-file", "design, decision 7")]
    public void A_damaged_file_of_accounts_is_refused_in_a_sentence(string content)
    {
        string path = Path.Combine(Path.GetTempPath(), $"accounts-{Guid.NewGuid():N}.json");
        File.WriteAllText(path, content);
        try
        {
            Assert.Contains(path, Assert.Throws<InvalidDataException>(() => AccountFile.Read(path)).Message, StringComparison.Ordinal);
        }
        finally
        {
            File.Delete(path);
        }
    }

    [Fact]
    [Behaviour("server.login.slots", "spec/08, 8.2: server full")]
    public void Who_finds_no_slot_is_told_so_and_comes_in_when_one_is_free()
    {
        SimulatedHost host = new(ground, options => options with { Slots = 2 });
        TestClient one = host.Connect("one"), two = host.Connect("two");
        Assert.True(host.RunUntil(() => one.Session.State == SessionState.CharacterSelect && two.Session.State == one.Session.State));
        TestClient three = host.Connect("three");
        Assert.True(host.RunUntil(() => three.Session.State == SessionState.Failed, 5));
        Assert.Equal(SessionFailureKind.ServerFull, three.Session.Failure!.Kind);
        one.Session.Close();
        host.Run(3);
        TestClient four = host.Connect("four");
        Assert.True(host.RunUntil(() => four.Session.State == SessionState.CharacterSelect, 5));
    }

    [Fact]
    [Behaviour("server.login.slots-per-address", "spec/08, 8.2: too many from one address")]
    public void An_address_has_no_more_sessions_than_it_may()
    {
        SimulatedHost host = new(ground, options => options with { MostPerAddress = 1 });
        TestClient one = host.Connect("one");
        Assert.True(host.RunUntil(() => one.Session.State == SessionState.CharacterSelect));
        TestClient two = host.Connect("two"), elsewhere = host.Connect("three", from: SimulatedHost.Loopback + 1);
        Assert.True(host.RunUntil(() => two.Session.State == SessionState.Failed, 5));
        Assert.True(host.RunUntil(() => elsewhere.Session.State == SessionState.CharacterSelect, 5));
    }

    [Fact]
    [Behaviour("server.login.flood", "spec/08, 8.2; floods of logins are limited")]
    public void A_flood_of_logins_takes_neither_memory_nor_all_slots_and_gets_little_back()
    {
        SimulatedHost host = new(ground, options => options with { Slots = 16 });
        byte[] login = LoginOf("flood");
        UInt128 address = SimulatedHost.Loopback + 2;
        for (int i = 0; i < 2_000; i++)
        {
            // From many ports of one address, and from many addresses.
            UInt128 from = i % 2 == 0 ? address : address + (uint)i;
            host.SendAsStranger(login, new ClientAddress(from, (ushort)(1000 + (i % 60000))));
            if (i % 100 == 0) host.Run(1 / 60.0);
        }

        Assert.True(host.Server.Figures.LoginsOverRate > 500);
        Assert.All(host.SentToStrangers.Values, bytes => Assert.True(bytes <= 3 * login.Length));

        // An honest client comes in meanwhile.
        TestClient honest = host.Connect("honest");
        bool isIn = host.RunUntil(
            () =>
            {
                for (int i = 0; i < 5; i++)
                    host.SendAsStranger(login, new ClientAddress(address, (ushort)(2000 + (int)(host.Now * 1000 % 50000) + i)));
                return honest.Session.State == SessionState.CharacterSelect;
            },
            30);
        Assert.True(isIn, honest.Session.Failure?.Sentence);
    }

    [Fact]
    [Behaviour("server.silence", "spec/08, 2.7: 15 s before the answer, 60 s after")]
    public void Who_falls_silent_is_dropped_after_a_minute_and_its_player_leaves()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        uint id = walker.Id;
        walker.IsMute = true;
        host.Run(57);
        Assert.DoesNotContain(watcher.Deleted, gone => gone.Guid == id);
        Assert.True(host.RunUntil(() => watcher.Deleted.Any(gone => gone.Guid == id), 6));
    }

    internal static byte[] LoginOf(string account, string password = "secret")
    {
        Capture sink = new();
        new ClientSession(new ClientSessionOptions { Account = account, Password = password }, sink).Connect(0);
        return sink.Bytes;
    }

    private sealed class Capture : IDatagramSink
    {
        public byte[] Bytes { get; private set; } = [];

        public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => Bytes = datagram.ToArray();
    }
}
