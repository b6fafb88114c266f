using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>
/// What a server says of the local player: what its body does, and what numbers its character has. Other messages are not looked at; what
/// cannot be read is counted and changes nothing.
/// </summary>
/// <remarks>Specification 08, 4.3 and 09, 5.2 and 5.4.</remarks>
internal sealed class PlayerMessages(
    PlayerObject player, MovementManager movement, PlayerMovementController controller, PlayerWeenie weenie, CharacterSheet sheet,
    CommandTable commands)
    : IMessageReceiver
{
    private readonly ServerOrders orders = new(commands);

    /// <summary>Messages that could not be read.</summary>
    public long UnreadableCount { get; private set; }

    /// <inheritdoc/>
    public void OnMessage(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.UpdateMotion when IsReadable(message, out UpdateMotion motion):
                if (motion.Guid == player.Id && player.Accepts(motion) && !motion.Autonomous) Obey(motion.Movement);
                break;
            case Opcode.GameEvent when message.Id.Event == GameEventType.PlayerDescription &&
                IsReadable(message, out PlayerDescription all):
                sheet.Take(all);
                UseSheet();
                break;
            case Opcode.PrivateUpdateSkill when IsReadable(message, out PrivateUpdateSkill skill):
                sheet.TakeSkill(skill.Skill, skill.Record);
                UseSheet();
                break;
            case Opcode.PrivateUpdateAttribute when IsReadable(message, out PrivateUpdateAttribute attribute):
                sheet.TakeAttribute(attribute.Attribute, attribute.Record);
                UseSheet();
                break;
            case Opcode.PrivateUpdateVital when IsReadable(message, out PrivateUpdateVital vital):
                sheet.TakeVital(vital.Vital, vital.Record.Current);
                UseSheet();
                break;
            case Opcode.PrivateUpdateAttribute2ndLevel when IsReadable(message, out PrivateUpdateAttribute2ndLevel vital):
                sheet.TakeVital(vital.Vital, vital.Current);
                UseSheet();
                break;
            case Opcode.PrivateUpdatePropertyInt when IsReadable(message, out PrivateUpdatePropertyInt property):
                sheet.TakeProperty(property.Property, property.Value);
                UseSheet();
                break;
            case Opcode.PublicUpdatePropertyInt when IsReadable(message, out PublicUpdatePropertyInt property):
                if (property.Guid != player.Id) break;
                sheet.TakeProperty(property.Property, property.Value);
                UseSheet();
                break;
        }
    }

    /// <summary>Does what the server ordered. The keys wait until it is done.</summary>
    private void Obey(in MovementData order)
    {
        if (orders.TryObey(movement, order, autonomous: false)) controller.LoseControlToServer();
        else UnreadableCount++;
    }

    /// <summary>The numbers act when they are asked for next; only running out of stamina acts at once.</summary>
    private void UseSheet()
    {
        bool hadStamina = weenie.Stats.Stamina > 0;
        weenie.SetStats(sheet.Stats);
        if (hadStamina && weenie.Stats.Stamina == 0) movement.Interpreter.ReportExhaustion();
    }

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value)) return true;
        UnreadableCount++;
        return false;
    }
}
