using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Protocol.Tests.Peer;

/// <summary>The session against a real server of the field.</summary>
public class AceTests(AceServer server) : IClassFixture<AceServer>
{
    private const uint RunKey = 2, WalkForward = 0x45000005;
    private const ushort RunForward = 0x0007;

    [Fact, Behaviour("protocol.ace.session", "08, 3 to 6")]
    public void A_new_character_enters_runs_is_seen_running_and_logs_off()
    {
        using var walker = new AcePlayer(server, AcePlayer.NewName("walk"));
        using var watcher = new AcePlayer(server, AcePlayer.NewName("watch"));
        WirePosition place = walker.Enter(AcePlayer.NewName("Wa"));
        watcher.Enter(AcePlayer.NewName("Wo"));
        uint guid = walker.Session.Player;
        Assert.True(watcher.Until(() => watcher.Received.Of<CreateObject>().Any(m => m.Object.Guid == guid)), "the walker is not seen");

        // Half a second of running ahead, which is +y for a character that has not turned: ten reports.
        var stamps = new MovementStamps(Instance(walker), 0, 0, 0);
        Assert.Equal(Quaternion.Identity, place.Orientation);
        walker.Session.Send(new MoveToState(
            new WireRawMotion(currentHoldKey: RunKey, forwardCommand: WalkForward), place, stamps, Contact: true, StandingLongJump: false));
        for (int i = 0; i < 10; i++)
        {
            place = place with { Origin = place.Origin + new Vector3(0, 0.2f, 0) };
            walker.Session.Send(new AutonomousPosition(place, stamps, Contact: true));
            walker.Until(() => false, 0.05);
            watcher.Until(() => false, 0.01);
        }

        walker.Session.Send(new MoveToState(new WireRawMotion(), place, stamps, Contact: true, StandingLongJump: false));
        Assert.True(walker.Until(() => LastOf(walker, guid) is { } p && Near(p, place), 5), $"{LastOf(walker, guid)} is not {place}");
        Assert.True(watcher.Until(() => LastOf(watcher, guid) is { } p && Near(p, place), 5), $"{LastOf(watcher, guid)} is not {place}");
        Assert.Contains(
            watcher.Received.Of<UpdateMotion>(),
            m => m.Guid == guid && m.Movement.State is { ForwardCommand: RunForward, ForwardSpeed: > 1 } && m.Autonomous);

        double since = Environment.TickCount64;
        walker.Session.LogOff();
        walker.Reach(SessionState.CharacterSelect);
        Assert.InRange(Environment.TickCount64 - since, 5500, 12_000);
        Assert.Single(walker.Session.Characters!.Value.Characters);
        Assert.True(watcher.Until(() => watcher.Received.Of<DeleteObject>().Any(m => m.Guid == guid)), "the walker is still seen");
        Assert.Equal(0, walker.Session.Statistics.Dropped(DropReason.Checksum) + watcher.Session.Statistics.Dropped(DropReason.Checksum));
        Assert.InRange(walker.Session.RoundTrip!.Value, 0, 1);
    }

    [Fact, Behaviour("protocol.ace.stays-connected", "08, 2.6 and 2.7")]
    public void A_character_that_only_stands_stays_in_the_world_beyond_the_servers_patience()
    {
        using var player = new AcePlayer(server, AcePlayer.NewName("stand"));
        player.Enter(AcePlayer.NewName("St"));
        player.Until(() => player.Session.State != SessionState.InWorld, 75);
        Assert.Equal(SessionState.InWorld, player.Session.State);
        Assert.InRange(player.Session.SilentFor, 0, 3);
    }

    [Fact, Behaviour("protocol.ace.loss", "08, 2.6 and 10")]
    public void At_ten_percent_loss_nothing_is_lost_for_good_in_either_direction()
    {
        string account = AcePlayer.NewName("loss");
        using (var maker = new AcePlayer(server, account))
        {
            maker.Enter(AcePlayer.NewName("Lo"));
            maker.Session.LogOff();
            maker.Reach(SessionState.CharacterSelect);
        }

        Thread.Sleep(4000);
        using var player = new LossyPlayer(server.Address, account, seed: 12);
        Assert.True(player.Until(() => player.Session.State == SessionState.CharacterSelect, 20));
        player.Session.EnterWorld(player.Session.Characters!.Value.Characters[0].Guid);
        Assert.True(player.Until(() => player.Session.State == SessionState.InWorld, 20));
        uint guid = player.Session.Player;
        Assert.True(player.Until(() => player.Received.Of<CreateObject>().Any(m => m.Object.Guid == guid), 20));
        PhysicsDescription own = player.Received.Of<CreateObject>().First(m => m.Object.Guid == guid).Object.Physics;
        player.Session.Send(new LoginComplete());
        player.Until(() => false, 1);

        player.Loss = 0.1;
        WirePosition place = own.Position!.Value;
        var stamps = new MovementStamps(own.Stamps.Instance, 0, 0, 0);
        for (int i = 0; i < 200; i++)
        {
            place = place with { Origin = place.Origin + new Vector3(0, i % 40 < 20 ? 0.1f : -0.1f, 0) };
            Assert.True(player.Session.Send(new AutonomousPosition(place, stamps, Contact: true)));
            player.Until(() => false, 0.1);
        }

        player.Loss = 0;
        player.Until(() => false, 12);
        WirePosition last = player.Received.Of<UpdatePosition>().Where(m => m.Guid == guid).MaxBy(m => m.Pack.PositionStamp).Pack.Position;
        Assert.True(Near(last, place), $"{last} is not {place}");
        Assert.Equal(SessionState.InWorld, player.Session.State);
        Assert.Equal(0, player.Session.MissingPackets);
        Assert.Equal(0, player.Session.Statistics.Dropped(DropReason.Checksum));
        Assert.InRange(player.Session.Statistics.Resent, 1, 1000);
        Assert.InRange(player.Session.Statistics.RequestsSent, 1, 1000);
    }

    private static ushort Instance(AcePlayer player)
        => player.Received.Of<CreateObject>().First(m => m.Object.Guid == player.Session.Player).Object.Physics.Stamps.Instance;

    private static WirePosition? LastOf(AcePlayer player, uint guid)
        => player.Received.Of<UpdatePosition>().Where(m => m.Guid == guid).Select(m => (WirePosition?)m.Pack.Position).LastOrDefault();

    private static bool Near(WirePosition position, WirePosition claimed)
        => position.Cell == claimed.Cell && Vector3.Distance(position.Origin, claimed.Origin) < 0.05f;
}
