using CsCheck;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client.Tests;

/// <summary>What a server says of the local player.</summary>
public class PlayerMessagesTests
{
    private const uint Run = 24, Jump = 22;
    private const ushort RunForward = 0x07;

    private static readonly MovementData RunOrder = MovementData.Motion(0,
        new WireInterpretedMotion(forwardCommand: RunForward, forwardSpeed: 1.5f));

    private static SkillRecord Skill(uint level) => new(0, 1, 2, 0, level, 0, 0);

    private static UpdateMotion Motion(ushort stamp, ushort serverControl, bool autonomous = false, ushort instance = 1,
        uint guid = KeyFixture.Id) =>
        new(guid, instance, stamp, serverControl, autonomous, RunOrder);

    private static bool Obeys(KeyFixture f, in UpdateMotion motion)
    {
        f.Say(motion);
        return f.Forward == (MotionCommand.RunForward, 1.5f);
    }

    [Fact]
    [Behaviour("client.update-motion.stamps", "spec/08, 4.3 and 11.12; spec/09, 5.2 and 5.4")]
    public void An_order_is_obeyed_once_and_only_when_nothing_newer_came_before()
    {
        Assert.True(Obeys(new KeyFixture(), Motion(6, 3)));
        Assert.True(Obeys(new KeyFixture(), Motion(0x7FFF, 0)), "nearly half way round, and as new a control as before");
        Assert.False(Obeys(new KeyFixture(), Motion(0x8000, 0)), "half way round: the smaller number is the newer one");
        Assert.False(Obeys(new KeyFixture(), Motion(0, 1)), "equal");

        KeyFixture f = new();
        f.Say(Motion(5, 2, autonomous: true));
        Assert.False(Obeys(f, Motion(6, 1)), "an older control");
        Assert.False(Obeys(f, Motion(6, 3)), "the movement stamp was used up all the same");
        Assert.True(Obeys(f, Motion(7, 2)), "as new a control");
    }

    [Fact]
    [Behaviour("client.update-motion.instance", "spec/08, 4.3; spec/09, 5.1")]
    public void A_motion_for_another_life_or_another_object_does_nothing_and_uses_no_stamp_up()
    {
        KeyFixture f = new();
        Assert.False(Obeys(f, Motion(1, 1, instance: 2)));
        Assert.False(Obeys(f, Motion(1, 1, instance: 0)));
        Assert.False(Obeys(f, Motion(1, 1, guid: KeyFixture.Id + 1)));
        Assert.True(Obeys(f, Motion(1, 1)));
    }

    [Fact]
    [Behaviour("client.sends.stored-stamps", "spec/08, 5.2")]
    public void What_is_sent_carries_the_stamps_that_were_heard()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        Assert.Equal(new MovementStamps(1, 0, 0, 0), f.LastSent.Message.Stamps);
        f.Say(Motion(9, 4));
        f.Press(MovementKeys.TurnLeft);
        Assert.Equal(new MovementStamps(1, 4, 0, 0), f.LastSent.Message.Stamps);
    }

    [Fact]
    [Behaviour("client.character.acts-when-asked-next", "spec/01, 4.1 and 6; spec/08, 7.1")]
    public void A_new_skill_acts_from_the_next_motion_on()
    {
        KeyFixture f = new();
        f.Say(new PrivateUpdateAttribute2ndLevel(0, 4, 10));
        f.Say(new PrivateUpdateAttribute(0, 1, new AttributeRecord(0, 100, 0)));
        f.Say(new PrivateUpdateSkill(0, Run, Skill(300)));
        f.Press(MovementKeys.Forward);
        f.Say(new PrivateUpdateSkill(1, Run, Skill(800)));
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
        f.Press(MovementKeys.None);
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 4.5f), f.Forward);
    }

    [Fact]
    [Behaviour("client.character.exhaustion-acts-at-once", "spec/01, 4.1 and 4.5; spec/09b, 9.6")]
    public void Without_stamina_a_runner_slows_at_once_and_keeps_control()
    {
        KeyFixture f = new();
        f.Press(MovementKeys.Forward);
        f.Say(new PrivateUpdateVital(0, 3, new VitalRecord(0, 100, 0, 1)));
        f.Say(new PrivateUpdateSkill(0, Run, Skill(300)));
        f.Say(new PrivateUpdateAttribute2ndLevel(0, 4, 0));
        Assert.Equal((MotionCommand.RunForward, 1f), f.Forward);
        Assert.False(f.Controller.IsControlledByServer);
        Assert.Single(f.Sent.Moves);
    }

    [Fact]
    [Behaviour("client.messages.unreadable-is-counted", "design, decision 7; spec/08, section 6")]
    public void What_cannot_be_read_is_counted_and_changes_nothing()
    {
        FakeServer server = new();
        byte[][] messages =
        [
            server.Say(Motion(1, 1)), server.Say(new PrivateUpdateSkill(0, Run, Skill(10))),
            server.Say(new PrivateUpdateAttribute(0, 1, default)),
            server.Say(new PrivateUpdateVital(0, 3, default)), server.Say(new PrivateUpdateAttribute2ndLevel(0, 4, 0)),
            server.Say(new PrivateUpdatePropertyInt(0, 5, 7)), server.Say(new PublicUpdatePropertyInt(0, KeyFixture.Id, 5, 7)),
            server.Say(new PlayerDescription()),
        ];
        KeyFixture f = new(server: server);
        server.Clear();
        int cuts = 0;
        foreach (byte[] message in messages)
        {
            // A wrapper that is cut short names no event.
            for (int length = message.Length == messages[^1].Length ? 16 : 4; length < message.Length; length++, cuts++)
                server.SayBytes(message.AsSpan(0, length));
        }

        f.Hear();
        Assert.Equal(cuts, f.Messages.UnreadableCount);
        Assert.Equal((MotionCommand.Ready, 300), (f.Forward.Command, ((PlayerWeenie)f.Interpreter.Weenie!).Stats.RunSkill));
    }

    [Theory]
    [Behaviour("client.update-motion.bad-numbers", "design, decision 7")]
    [InlineData((ushort)0x07, float.NaN)]
    [InlineData((ushort)0x07, float.PositiveInfinity)]
    [InlineData((ushort)0xFFFF, 1f)]
    public void An_order_with_a_speed_that_is_not_finite_or_an_unknown_command_is_counted_and_not_obeyed(ushort command, float speed)
    {
        KeyFixture f = new();
        f.Say(new UpdateMotion(KeyFixture.Id, 1, 1, 1, false,
            MovementData.Motion(0, new WireInterpretedMotion(forwardCommand: command, forwardSpeed: speed))));
        Assert.Equal((1, MotionCommand.Ready), (f.Messages.UnreadableCount, f.Forward.Command));
        f.Press(MovementKeys.Forward);
        Assert.Equal((MotionCommand.RunForward, 2.6500001f), f.Forward);
    }

    [Fact]
    [Behaviour("client.messages.damaged-never-throw", "design, decision 7")]
    public void No_damaged_message_throws()
    {
        FakeServer server = new();
        byte[] order = server.Say(Motion(1, 1)), description = server.Say(new PlayerDescription
        {
            Ints = [new Property<int>(5, 7)],
            Skills = [new Property<SkillRecord>(Run, Skill(10)), new Property<SkillRecord>(Jump, Skill(10))],
            Attributes = new CharacterAttributes(new AttributeRecord(1, 2, 3), null, null, null, null, null),
        });
        server.Clear();
        KeyFixture f = new(server: server);
        Gen.Select(Gen.Bool, Gen.Int[4, 200], Gen.Byte, Gen.Int[4, 200], Gen.Byte).Sample(
            change =>
            {
                byte[] damaged = [.. change.Item1 ? order : description];
                damaged[change.Item2 % damaged.Length] = change.Item3;
                damaged[change.Item4 % damaged.Length] = change.Item5;
                server.SayBytes(damaged);
                f.Hear();
                f.Press(MovementKeys.Forward);
            },
            iter: Fuzz.Cases(2000), threads: 1);
    }
}
