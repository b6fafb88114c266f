using System.Numerics;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Fixture = Surefoot.Client.Tests.GameClientFixture;

namespace Surefoot.Client.Tests;

/// <summary>What a server's words about places do to the local player.</summary>
public class GameClientPlaceTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const ushort RunForward = 7;
    private static readonly Vector3 Beside = new(3, 2, 0);

    [Theory]
    [Behaviour("client.game.position-stamps", "spec/08, 4.4 and 11.12")]
    [InlineData(1, 11, 3, 4, "stays", 3, 4)]
    [InlineData(1, 9, 3, 5, "blip", 3, 5)]
    [InlineData(1, 11, 2, 4, "stays", 3, 4)]
    [InlineData(1, 11, 2, 5, "stays", 3, 5)]
    [InlineData(1, 11, 4, 4, "teleport", 4, 4)]
    [InlineData(2, 11, 4, 5, "stays", 3, 4)]
    [InlineData(0, 11, 4, 5, "stays", 3, 4)]
    public void A_position_moves_the_player_only_as_its_stamps_say(
        int instance, int position, int teleport, int force, string effect, int teleportKept, int forceKept)
    {
        Fixture f = new(files);
        f.Enter();
        Vector3 stood = f.Position.Frame.Origin;
        double heading = f.Position.Frame.Heading;
        WirePosition told = Fixture.At("meadow", Beside) with { Orientation = Quaternion.CreateFromAxisAngle(Vector3.UnitZ, 1) };
        f.Say(Fixture.PositionOf(told, (ushort)position, (ushort)teleport, (ushort)force, (ushort)instance));

        bool moved = Vector2.Distance(Flat(f.Position.Frame.Origin), Flat(told.Origin)) < 0.01f;
        Assert.Equal(effect != "stays", moved);
        if (!moved) Assert.Equal(stood, f.Position.Frame.Origin);
        bool turned = Math.Abs(f.Position.Frame.Heading - heading) > 1;
        Assert.Equal(effect == "teleport", turned);
        Assert.Equal(
            effect switch
            {
                "blip" => [GameActionType.AutonomousPosition],
                "teleport" => [GameActionType.MoveToState, GameActionType.LoginComplete],
                _ => [],
            },
            f.Sent);
        f.Frames(1, MovementKeys.Forward);
        MovementStamps sent = f.Moves.Moves[^1].Message.Stamps;
        Assert.Equal((teleportKept, forceKept), (sent.Teleport, sent.ForcePosition));

        static Vector2 Flat(Vector3 v) => new(v.X, v.Y);
    }

    [Fact]
    [Behaviour("client.game.portal-space", "spec/08, 3.5, 4.3 (PlayerTeleport), 4.4, step 5 and 5.6")]
    public void From_the_announcement_of_a_teleport_to_the_arrival_the_player_is_hidden_no_key_acts_and_nothing_is_told()
    {
        Fixture f = new(files);
        f.Enter();
        f.Frames(20, MovementKeys.Forward);
        f.Player.Controller.SetAutoRun(true, f.Now);
        f.Server.Sent.Clear();
        f.Say(new PlayerTeleport(4));
        Assert.True(f.Player.IsInPortalSpace);
        Assert.False(f.Game.IsPlaying);
        Assert.True(f.Player.Body.State.Has(PhysicsState.Hidden));
        Vector3 left = f.Position.Frame.Origin;
        f.Frames(90, MovementKeys.Back);
        Assert.Equal(left, f.Position.Frame.Origin);
        Assert.Empty(f.Sent);

        f.Say(Fixture.PositionOf(Fixture.At("dungeon"), 11, 4, 4));
        Assert.Equal([GameActionType.MoveToState, GameActionType.LoginComplete], f.Sent[..2]);
        Assert.False(f.Player.IsInPortalSpace);
        Assert.False(f.Player.Body.State.Has(PhysicsState.Hidden));
        Assert.False(f.Player.Controller.AutoRun);
        Assert.Equal(Fixture.At("dungeon").Cell, f.Position.CellId);
        Assert.Equal(Vector3.Zero, f.Player.Body.Velocity);
        Assert.Null(f.Game.Engine.World.FindLandblock(Fixture.At("meadow").Cell));
        f.Frames(10);
        f.Frames(60, MovementKeys.Forward);
        Assert.Contains(GameActionType.AutonomousPosition, f.Sent);
    }

    [Fact]
    [Behaviour("client.game.teleport-announcements", "spec/08, 4.3 and 11.12")]
    public void An_overtaken_announcement_is_ignored_an_equal_one_counts_and_a_shown_player_is_free_again()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new PlayerTeleport(2));
        Assert.False(f.Player.IsInPortalSpace);
        f.Say(new PlayerTeleport(3));
        Assert.True(f.Player.IsInPortalSpace);
        f.Say(new SetState(Fixture.Id, Fixture.Hidden, 1, 1));
        Assert.True(f.Player.IsInPortalSpace);
        f.Say(new SetState(Fixture.Id, Fixture.Shown, 1, 2));
        Assert.False(f.Player.IsInPortalSpace);
        f.Frames(5, MovementKeys.Forward);
        Assert.Equal(MotionCommand.RunForward, f.Player.Movement.Interpreter.Interpreted.ForwardCommand);
    }

    [Fact]
    [Behaviour("client.game.waits-for-land", "spec/08, 3.5, step 7; spec/09, 4.1, step 1")]
    public void Where_there_is_no_land_the_player_waits_and_time_stands_still_until_a_teleport_takes_it_elsewhere()
    {
        Fixture f = new(files);
        f.Server.Say(new PlayerCreate(Fixture.Id));
        WirePosition nowhere = new(0x50500010, new Vector3(40, 160, 10), Quaternion.Identity);
        f.Say(new CreateObject(Fixture.Describe(Fixture.Id, nowhere, Fixture.Stamps)));
        double since = f.Game.Engine.Now;
        f.Frames(60, MovementKeys.Forward);
        Assert.Empty(f.Sent);
        Assert.False(f.Game.IsPlaying);
        Assert.Equal(since, f.Game.Engine.Now);

        f.Server.Say(new PlayerTeleport(4));
        f.Say(Fixture.PositionOf(Fixture.At("town"), 11, 4, 4));
        Assert.Equal([GameActionType.MoveToState, GameActionType.LoginComplete], f.Sent[..2]);
        Assert.True(f.Game.IsPlaying);
        Assert.Equal(Fixture.At("town").Cell, f.Position.CellId);
    }

    [Fact]
    [Behaviour("client.game.own-velocity", "spec/08, 4.3 (VectorUpdate); spec/09, 5.5")]
    public void A_velocity_for_the_player_is_noted_and_moves_nobody()
    {
        Fixture f = new(files);
        f.Enter();
        Vector3 stood = f.Position.Frame.Origin;
        f.Say(new VectorUpdate(Fixture.Id, new Vector3(0, 0, 9), default, 1, 1));
        f.Frames(5);
        Assert.Equal(stood, f.Position.Frame.Origin);
        Assert.Equal(0, f.Player.UnreadableMessages);
    }

    [Fact]
    [Behaviour("client.game.control-and-back", "spec/08, 4.3 (UpdateMotion), 5.6 and 11.12; spec/09b, 9.6")]
    public void An_order_takes_control_an_echo_does_not_and_the_next_key_takes_it_back()
    {
        Fixture f = new(files);
        f.Enter();
        f.Frames(5, MovementKeys.TurnLeft);
        f.Frames(5);
        f.Say(Order(6, 2, autonomous: true));
        f.Say(Order(7, 1, autonomous: false));
        Assert.False(f.Player.Controller.IsControlledByServer);
        f.Say(Order(8, 3, autonomous: false));
        Assert.True(f.Player.Controller.IsControlledByServer);
        Vector3 stood = f.Position.Frame.Origin;
        f.Frames(30);
        Assert.True(Vector3.Distance(stood, f.Position.Frame.Origin) > 3, "the order is not obeyed");

        f.Server.Sent.Clear();
        f.Frames(1, MovementKeys.TurnRight);
        Assert.False(f.Player.Controller.IsControlledByServer);
        Assert.Contains(GameActionType.MoveToState, f.Sent);
        Assert.Equal(3, f.Moves.Moves[^1].Message.Stamps.ServerControlledMove);

        static UpdateMotion Order(ushort movement, ushort serverControl, bool autonomous) => new(
            Fixture.Id, 1, movement, serverControl, autonomous,
            MovementData.Motion(0x3D, new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 1.5f)));
    }
}
