using System.Numerics;
using CsCheck;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;
using Fixture = Surefoot.Client.Tests.GameClientFixture;

namespace Surefoot.Client.Tests;

/// <summary>A stay in a server's world, from its messages alone.</summary>
public class GameClientTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const uint Other = 0x80000007;
    private static readonly Vector3 Beside = new(3, 2, 0);

    [Fact]
    [Behaviour("client.game.enters", "spec/08, 3.5, steps 4 and 5")]
    public void The_described_player_stands_in_loaded_land_and_the_server_is_told_that_it_may_come_in()
    {
        Fixture f = new(files);
        f.Frames(3);
        Assert.Null(f.Game.Player);
        f.Server.Say(new PlayerCreate(Fixture.Id));
        f.Say(new CreateObject(Fixture.Describe(Fixture.Id, Fixture.At("meadow"), Fixture.Stamps, Fixture.Hidden)));
        Assert.Equal([GameActionType.LoginComplete, GameActionType.AutonomousPosition], f.Sent);
        Assert.Same(f.Player.Body, f.Game.Engine.Player);
        Assert.True(f.Player.Body.State.Has(PhysicsState.Hidden));
        Assert.Equal(9, f.Game.Engine.World.Landblocks.Count);

        f.Say(new SetState(Fixture.Id, Fixture.Shown, 1, 1));
        Assert.Equal((PhysicsState)Fixture.Shown, f.Player.Body.State);
        f.Frames(30, MovementKeys.Forward);
        Assert.True(f.Position.Frame.Origin.Y - Fixture.At("meadow").Origin.Y > 2);
    }

    [Fact]
    [Behaviour("client.game.any-order-of-arrival", "spec/08, 4.3: before the player's id is known, and 4.5")]
    public void Whatever_comes_before_the_player_is_heard_once_the_player_is_there()
    {
        Fixture f = new(files);
        f.Server.Say(new CreateObject(Fixture.Describe(Other, Fixture.At("meadow", Beside), Fixture.Stamps)));
        f.Server.Say(Fixture.PositionOf(Fixture.At("meadow", -Beside), 11, 4, 4));
        f.Say(new CreateObject(Fixture.Describe(Fixture.Id, Fixture.At("meadow"), Fixture.Stamps)));
        Assert.Null(f.Game.Player);
        f.Say(new PlayerCreate(Fixture.Id));
        f.Frames(2);
        Assert.NotNull(f.Game.Others.Find(Other));
        Assert.Null(f.Game.Others.Find(Fixture.Id));

        // The position is that of a later teleport.
        Assert.Equal(Fixture.At("meadow", -Beside).Origin.X, f.Position.Frame.Origin.X, 1e-3f);
    }

    [Fact]
    [Behaviour("client.game.character-before-player", "spec/08, 3.5: the two queues race each other; 7")]
    public void The_characters_numbers_count_whether_they_come_before_the_player_or_after()
    {
        Fixture f = new(files);
        f.Say(new PlayerDescription
        {
            Attributes = new CharacterAttributes(new(0, 60, 0), null, new(0, 70, 0), new(0, 61, 0), null, null),
            Vitals = new CharacterVitals(null, new VitalRecord(0, 60, 0, 60), null),
            Skills = [new(24, new SkillRecord(10, 1, 2, 0, 5, 0, 0)), new(22, new SkillRecord(1, 1, 2, 0, 5, 0, 0))],
        });
        f.Enter();

        // Run 15 + 70; jump 6 + (60 + 61 + 1) / 2.
        Assert.Equal((85, 67, 60), (f.Player.Weenie.Stats.RunSkill, f.Player.Weenie.Stats.JumpSkill, f.Player.Weenie.Stats.Stamina));
        f.Say(new PrivateUpdateAttribute(0, 3, new AttributeRecord(5, 70, 0)));
        Assert.Equal(90, f.Player.Weenie.Stats.RunSkill);
    }

    [Fact]
    [Behaviour("client.game.wrong-dats", "design, decision 7")]
    public void A_player_whose_shape_is_in_no_file_is_told_in_a_sentence_and_a_good_description_mends_it()
    {
        Fixture f = new(files);
        ObjectDescription good = Fixture.Describe(Fixture.Id, Fixture.At("meadow"), Fixture.Stamps);
        f.Server.Say(new PlayerCreate(Fixture.Id));
        f.Say(new CreateObject(good with { Physics = good.Physics with { Setup = 0x02FFFFFF } }));
        Assert.Equal("The dat files have no setup 0x02FFFFFF, which the server says is the player's.", f.Game.Fault);
        f.Say(new CreateObject(good with { Physics = good.Physics with { MotionTable = 0x09FFFFFF } }));
        Assert.Equal("The dat files have no motion table 0x09FFFFFF, which the server says is the player's.", f.Game.Fault);
        Assert.Null(f.Game.Player);
        f.Say(new CreateObject(good));
        Assert.Null(f.Game.Fault);
        Assert.True(f.Game.IsPlaying);
    }

    [Fact]
    [Behaviour("client.game.asks-for-objects", "spec/08, 5.6 (ForceObjDesc)")]
    public void An_object_of_which_only_messages_came_is_asked_for_after_twenty_seconds()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new SetState(Other, 0, 1, 1));
        f.Frames((int)(19 / Fixture.FrameTime));
        Assert.Empty(f.Server.Requested);
        f.Frames((int)(2 / Fixture.FrameTime));
        Assert.Equal([Other], f.Server.Requested);
    }

    [Fact]
    [Behaviour("client.game.land-ahead", "spec/09, 4.1: cell loading around the player")]
    public void Land_is_loaded_before_it_is_needed_and_forgotten_far_behind()
    {
        Fixture f = new(files);
        f.Enter("runway");
        f.Server.Say(new PlayerDescription
        {
            Skills = [new(24, new SkillRecord(0, 1, 2, 0, 800, 0, 0))],
            Vitals = new CharacterVitals(null, new VitalRecord(0, 60, 0, 60), null),
        });
        uint first = CellIds.BlockOf(f.Position.CellId);
        HashSet<uint> blocks = [];
        for (int i = 0; i < 1500; i++)
        {
            f.Frames(1, MovementKeys.Forward);
            Assert.False(f.Player.Body.IsLost);
            blocks.Add(CellIds.BlockOf(f.Position.CellId));
        }

        Assert.True(blocks.Count >= 5, $"{blocks.Count} landblocks");
        Assert.Null(f.Game.Engine.World.FindLandblock(first));
    }

    [Fact]
    [Behaviour("client.game.new-life", "spec/08, 4.5, steps 2 and 3")]
    public void A_description_with_a_newer_instance_is_a_new_life_and_one_with_an_older_is_nothing()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new CreateObject(Fixture.Describe(Fixture.Id, Fixture.At("town"), Fixture.Stamps with { Instance = 0 })));
        Assert.Equal(Fixture.At("meadow").Cell >> 16, f.Position.CellId >> 16);
        f.Say(new CreateObject(Fixture.Describe(Fixture.Id, Fixture.At("town"), Fixture.Stamps with { Instance = 2, Teleport = 9 })));
        Assert.Equal(Fixture.At("town").Cell, f.Position.CellId);
        Assert.Equal([GameActionType.LoginComplete, GameActionType.AutonomousPosition], f.Sent);
        f.Frames(10, MovementKeys.Forward);
        MovementStamps sent = f.Moves.Moves[^1].Message.Stamps;
        Assert.Equal((2, 9), (sent.Instance, sent.Teleport));
    }

    [Fact]
    [Behaviour("client.game.described-again", "spec/08, 4.5, step 2")]
    public void A_description_of_the_same_life_acts_part_by_part_by_its_stamps()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new CreateObject(Fixture.Describe(
            Fixture.Id, Fixture.At("town"), Fixture.Stamps with { State = 1 }, Fixture.Shown | (uint)PhysicsState.Ethereal)));
        Assert.True(f.Player.Body.State.Has(PhysicsState.Ethereal));
        Assert.Equal(Fixture.At("meadow").Cell >> 16, f.Position.CellId >> 16);
        f.Say(new CreateObject(Fixture.Describe(
            Fixture.Id, Fixture.At("town"), Fixture.Stamps with { Position = 11, Teleport = 4 })));
        Assert.Equal(Fixture.At("town").Cell, f.Position.CellId);
        Assert.True(f.Player.Body.State.Has(PhysicsState.Ethereal), "the state is not news");
    }

    [Fact]
    [Behaviour("client.game.object-of-many-parts", "spec/05, 4.17: cells by the parts' boxes")]
    public void A_state_word_that_makes_the_parts_of_a_human_count_lists_it_by_all_of_them()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new CreateObject(Fixture.Describe(
            Other, Fixture.At("meadow", Beside), Fixture.Stamps, Fixture.Shown | (uint)PhysicsState.HasPhysicsBsp)));
        Assert.True(f.Game.Others.Find(Other)!.Body.HasCell);
    }

    [Fact]
    [Behaviour("client.game.allocates-nothing", "design, decision 4")]
    public void A_player_among_others_who_walks_and_tells_its_place_allocates_nothing()
    {
        Fixture f = new(files);
        f.Enter();
        f.Say(new CreateObject(Fixture.Describe(Other, Fixture.At("meadow", Beside), Fixture.Stamps)));
        f.Server.IsDeaf = true;
        f.Frames(300, MovementKeys.Forward | MovementKeys.TurnRight);
        f.Moves.Positions.EnsureCapacity(1000);
        long before = GC.GetAllocatedBytesForCurrentThread();
        f.Frames(200, MovementKeys.Forward | MovementKeys.TurnRight);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    [Behaviour("client.game.damaged-never-throw", "design, decision 7")]
    public void No_damaged_message_throws_and_the_player_stays_somewhere()
    {
        Fixture f = new(files);
        f.Enter();
        byte[][] all =
        [
            f.Server.Say(Fixture.PositionOf(Fixture.At("meadow", Beside), 11, 4, 5)), f.Server.Say(new PlayerTeleport(4)),
            f.Server.Say(new SetState(Fixture.Id, Fixture.Shown, 1, 1)),
            f.Server.Say(new VectorUpdate(Fixture.Id, new Vector3(1, 2, 3), default, 1, 1)),
            f.Server.Say(new CreateObject(Fixture.Describe(Fixture.Id, Fixture.At("town"), Fixture.Stamps with { Instance = 2 }))),
            f.Server.Say(new UpdateMotion(Fixture.Id, 1, 6, 3, false, MovementData.Motion(
                0, new WireInterpretedMotion(forwardCommand: 7, forwardSpeed: 1.5f)))),
        ];
        f.Server.Clear();
        Gen.Select(Gen.Int[0, all.Length - 1], Gen.Int[4, 200], Gen.Byte, Gen.Int[4, 200], Gen.Byte).Sample(
            change =>
            {
                byte[] damaged = [.. all[change.Item1]];
                damaged[change.Item2 % damaged.Length] = change.Item3;
                damaged[change.Item4 % damaged.Length] = change.Item5;
                f.Server.SayBytes(damaged);
                f.Frames(1, MovementKeys.Forward);
                Assert.True(f.Position.Frame.IsValid);
            },
            iter: Fuzz.Cases(2000), threads: 1);
    }
}
