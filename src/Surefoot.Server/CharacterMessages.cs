using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>
/// Tells a client the numbers of its character: all of them when it enters the world, later those that changed. Skills are told as points
/// that come with their training: no attribute is part of them.
/// </summary>
/// <remarks>Specification 08, 7 and 8.6.</remarks>
internal sealed class CharacterMessages(MessageQueue queue, uint player)
{
    private const uint Jump = 22, Run = 24, StrengthId = 1, CurrentStamina = 4;
    private const uint Burden = 5, PlayerKillerStatus = 134, CarryingAugmentations = 230;
    private const int NonPlayerKiller = 2;
    private const uint Character = 10, Trained = 2;
    private const uint FirstEvent = 1;

    private byte runUpdates, jumpUpdates, strengthUpdates, staminaUpdates, burdenUpdates, augmentationUpdates;

    /// <summary>Everything, as a character's first message in the world.</summary>
    public void TellAll(in CharacterStats stats, double due) => queue.Enqueue(
        new PlayerDescription
        {
            WeenieType = Character,
            Ints =
            [
                new Property<int>(Burden, stats.Burden), new Property<int>(PlayerKillerStatus, NonPlayerKiller),
                new Property<int>(CarryingAugmentations, stats.Augmentations),
            ],
            Attributes = new CharacterAttributes(Strength(stats), default(AttributeRecord), default(AttributeRecord),
                default(AttributeRecord), default(AttributeRecord), default(AttributeRecord)),
            Vitals = new CharacterVitals(default(VitalRecord), new VitalRecord(0, (uint)stats.Stamina, 0, (uint)stats.Stamina),
                default(VitalRecord)),
            Skills = [new Property<SkillRecord>(Jump, Skill(stats.JumpSkill)), new Property<SkillRecord>(Run, Skill(stats.RunSkill))],
        },
        due, FirstEvent, player);

    /// <summary>What is not as it was.</summary>
    public void TellChanges(in CharacterStats before, in CharacterStats now, double due)
    {
        if (now.RunSkill != before.RunSkill) queue.Enqueue(new PrivateUpdateSkill(runUpdates++, Run, Skill(now.RunSkill)), due);
        if (now.JumpSkill != before.JumpSkill) queue.Enqueue(new PrivateUpdateSkill(jumpUpdates++, Jump, Skill(now.JumpSkill)), due);
        if (now.Strength != before.Strength) queue.Enqueue(new PrivateUpdateAttribute(strengthUpdates++, StrengthId, Strength(now)), due);
        if (now.Stamina != before.Stamina)
            queue.Enqueue(new PrivateUpdateAttribute2ndLevel(staminaUpdates++, CurrentStamina, (uint)now.Stamina), due);
        if (now.Augmentations != before.Augmentations)
            queue.Enqueue(new PrivateUpdatePropertyInt(augmentationUpdates++, CarryingAugmentations, now.Augmentations), due);
        if (now.Burden != before.Burden) queue.Enqueue(new PrivateUpdatePropertyInt(burdenUpdates++, Burden, now.Burden), due);
    }

    private static AttributeRecord Strength(in CharacterStats stats) => new(0, (uint)stats.Strength, 0);

    private static SkillRecord Skill(int level) => new(0, 1, Trained, 0, (uint)level, 0, 0);
}
