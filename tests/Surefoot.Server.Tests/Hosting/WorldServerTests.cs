using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

public sealed class WorldServerTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const uint OwnHidden = 0x404410, Visible = 0x600408, RunKey = 2, WalkForward = 0x45000005;
    private const ushort RunForward = 0x07, LogOut = 0x11E;

    [Fact]
    [Behaviour("server.entering.messages", "spec/08, 3.4 and 8.6")]
    public void Who_enters_is_told_of_itself_and_is_hidden_until_it_has_loaded_the_place()
    {
        SimulatedHost host = new(ground);
        TestClient client = host.Connect("Walker");
        Assert.True(host.RunUntil(() => client.Session.State == SessionState.CharacterSelect));
        Assert.Equal("walker", client.Session.Characters!.Value.Account);
        Assert.Empty(client.Session.Characters.Value.Characters);
        client.EnterAs("Walker");
        CreateObject own = client.Objects[client.Id];
        Assert.Equal((OwnHidden, "Walker"), (own.Object.Physics.State, own.Object.Weenie.Name));
        Assert.Equal(new ObjectStamps(0, 0, 0, 0, 0, 0, 0, 0, Instance: 1), own.Object.Physics.Stamps);
        Assert.Equal(new SetState(client.Id, Visible, 1, 1), client.States.Single(state => state.Guid == client.Id));
        Assert.Equal("Walker", client.Description!.Strings!.Value[0].Value);

        // Events leave before objects, each in its order.
        MessageId[] order = [.. client.Heard.Where(id => id.Opcode is Opcode.PlayerCreate || id.Event is GameEventType.PlayerDescription)];
        Assert.Equal([Opcode.GameEvent, Opcode.PlayerCreate], order.Select(id => id.Opcode));
    }

    [Fact]
    [Behaviour("server.others-see-a-player", "spec/08, 8.7 and 8.8")]
    public void A_second_client_sees_the_first_one_come_run_and_stop()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        Assert.Equal("Walker", watcher.Objects[walker.Id].Object.Weenie.Name);
        Assert.Equal("Watcher", walker.Objects[watcher.Id].Object.Weenie.Name);
        using PlayedPlayer player = new(ground, walker);
        player.Hold(Surefoot.Client.MovementKeys.Forward);
        host.Run(3, () => player.Frame(host.Now));
        player.Hold(Surefoot.Client.MovementKeys.None);
        host.Run(3, () => player.Frame(host.Now));

        UpdateMotion seen = watcher.Motions.First(motion => motion.Guid == walker.Id);
        Assert.Equal((RunForward, true), (seen.Movement.State.ForwardCommand, seen.Autonomous));
        Assert.Equal(player.Stats.RunRate(), seen.Movement.State.ForwardSpeed);
        Vector3 last = watcher.Positions.Last(position => position.Guid == walker.Id).Pack.Position.Origin;
        Assert.True(Vector3.Distance(last, player.Body.Position.Frame.Origin) < 0.05f, $"{last} {player.Body.Position}");
        Assert.True(Vector3.Distance(last, walker.Objects[walker.Id].Object.Physics.Position!.Value.Origin) > 10);
        Assert.Equal(0, host.Server.Figures.AllRefusedClaims);

        // The mover hears the same of itself.
        Assert.Contains(walker.Motions, motion => motion.Guid == walker.Id && motion.Autonomous);
    }

    [Fact]
    [Behaviour("server.log-off", "spec/08, 3.6")]
    public void Who_logs_off_is_gone_for_others_at_once_and_selects_a_character_six_seconds_later()
    {
        SimulatedHost host = new(ground);
        TestClient watcher = host.Enter("Watcher"), walker = host.Enter("Walker");
        uint id = walker.Id;
        double asked = host.Now;
        walker.Session.LogOff();
        Assert.True(host.RunUntil(() => watcher.Deleted.Any(gone => gone.Guid == id), 1));
        UpdateMotion last = walker.Motions.Last(motion => motion.Guid == id);
        Assert.Equal((LogOut, false, (ushort)1), (last.Movement.State.Actions[0].Command, last.Autonomous, last.ServerControlledMove));
        Assert.True(host.RunUntil(() => walker.Session.State == SessionState.CharacterSelect, 10));
        Assert.InRange(host.Now - asked, 6, 6.5);

        // It comes back in its next life.
        walker.EnterAs("Walker");
        Assert.Equal(2, walker.Objects[id].Object.Physics.Stamps.Instance);
        Assert.True(host.RunUntil(() => watcher.Objects.ContainsKey(id), 1));
    }
}
