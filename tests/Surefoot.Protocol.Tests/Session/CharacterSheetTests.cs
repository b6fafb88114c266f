using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Captures;
using Surefoot.Tool.Conformance.Captures;

namespace Surefoot.Protocol.Tests.Session;

public class CharacterSheetTests
{
    private const uint Player = 0x50000001;

    [Fact, Behaviour("protocol.character.kept-current", "08, 7")]
    public void The_recorded_character_that_was_raised_ends_with_the_numbers_that_it_was_raised_to()
    {
        var sheet = new CharacterSheet();
        var tap = new WireTap();
        foreach (CapturedDatagram captured in RecordedSessions.Load("raise").Datagrams)
            tap.Observe(captured.Direction, captured.Bytes, new Reader(sheet));

        Assert.True(sheet.IsDescribed);
        Assert.Equal(300, sheet.Burden);
        Assert.Equal(17, sheet.Int(25));
        Assert.Equal(2, sheet.PlayerKillerStatus);
        Assert.Equal(0, sheet.CarryAugmentations);
        Assert.Equal(61u, sheet.Strength);
        Assert.Equal(73u, sheet.Attribute(3));
        Assert.Equal(60u, sheet.Attribute(4));
        Assert.Equal(new SkillRecord(3, 1, 2, 5526, 25, 0, 0), sheet.Skill(CharacterSheet.RunSkill));
        Assert.Equal(new SkillRecord(2, 1, 2, 2026, 0, 0, 0), sheet.Skill(CharacterSheet.JumpSkill));
        Assert.Equal(new VitalRecord(1, 50000, 700, 50057), sheet.Stamina);
        Assert.Equal(50030u, sheet.Health.Current);
        Assert.Equal(45u, sheet.Mana.Current);
    }

    [Fact, Behaviour("protocol.character.late-updates", "08, 7.1")]
    public void An_update_that_comes_late_is_dropped_around_the_wrap_and_each_kind_counts_for_itself()
    {
        var sheet = new CharacterSheet();
        Assert.True(Apply(sheet, new PrivateUpdatePropertyInt(254, 5, 100)));
        Assert.True(Apply(sheet, new PrivateUpdatePropertyInt(1, 5, 300)));
        Assert.False(Apply(sheet, new PrivateUpdatePropertyInt(255, 5, 200)));
        Assert.False(Apply(sheet, new PrivateUpdatePropertyInt(1, 5, 400)));
        Assert.True(Apply(sheet, new PrivateUpdatePropertyInt(0, 134, 4)));
        Assert.Equal((300, 4), (sheet.Burden, sheet.PlayerKillerStatus));
    }

    [Fact, Behaviour("protocol.character.others-numbers", "08, 7.1")]
    public void Numbers_of_other_objects_are_not_the_characters()
    {
        var sheet = new CharacterSheet();
        Apply(sheet, new PlayerDescription { Ints = [new Property<int>(134, 2)] });
        Assert.False(Apply(sheet, new PublicUpdatePropertyInt(0, Player + 1, 134, 4)));
        Assert.True(Apply(sheet, new PublicUpdatePropertyInt(0, Player, 134, 0x40)));
        Assert.Equal(0x40, sheet.PlayerKillerStatus);
    }

    [Fact, Behaviour("protocol.character.enchantments", "08, 7.3")]
    public void Enchantments_come_change_and_go()
    {
        Enchantment Spell(ushort id, float value) => new(id, 1, 9, 1, 0, 60, 7, 0, 0, 0, 0x8010, 24, value, 0, 0);
        var sheet = new CharacterSheet();
        var registry = new EnchantmentRegistry(7, [Spell(1, 5)], [Spell(2, 6)], [], Spell(666, 0.95f));
        Apply(sheet, new PlayerDescription { Enchantments = registry });
        Assert.Equal(0.95f, sheet.Vitae?.StatModValue);
        Apply(sheet, new UpdateEnchantment(Spell(2, 8)));
        Apply(sheet, new UpdateEnchantment(Spell(3, 9)));
        Assert.Equal([5f, 8f, 9f], sheet.Enchantments.Select(e => e.StatModValue).Order());
        Assert.True(Apply(sheet, new RemoveEnchantment(3, 1)));
        Assert.False(Apply(sheet, new RemoveEnchantment(3, 1)));
        Assert.True(Apply(sheet, new PurgeEnchantments()));
        Assert.Empty(sheet.Enchantments);
    }

    [Fact, Behaviour("protocol.character.new-description", "08, 7.3")]
    public void A_new_description_replaces_everything_and_counts_updates_anew()
    {
        var sheet = new CharacterSheet();
        Apply(sheet, new PlayerDescription { Ints = [new Property<int>(5, 10), new Property<int>(230, 2)] });
        Apply(sheet, new PrivateUpdatePropertyInt(9, 5, 11));
        Apply(sheet, new PlayerDescription { Ints = [new Property<int>(5, 12)] });
        Assert.Equal((12, 0), (sheet.Burden, sheet.CarryAugmentations));
        Assert.True(Apply(sheet, new PrivateUpdatePropertyInt(0, 5, 13)));
    }

    private static bool Apply<T>(CharacterSheet sheet, T message)
        where T : IMessage<T>
    {
        byte[] buffer = new byte[1024];
        Assert.True(WireMessage.TryWrite(message, buffer, out int length, 1, Player));
        Assert.True(WireMessage.TryParse(buffer.AsSpan(0, length), out WireMessage wire));
        return sheet.Apply(wire);
    }

    private sealed class Reader(CharacterSheet sheet) : ITapReceiver
    {
        public void OnMessage(WireDirection direction, FragmentHeader fragment, in WireMessage message) => sheet.Apply(message);
    }
}
