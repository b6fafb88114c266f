using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Client;

/// <summary>
/// What a server says of the local player: what its body does, and what numbers its character has. Where it is, is the business of
/// <see cref="PlayerPlaces"/>. Other messages are not looked at; what cannot be read is counted and changes nothing.
/// </summary>
/// <remarks>Specification 08, 4.3 and 09, 5.2 and 5.4.</remarks>
internal sealed class PlayerMessages : IMessageReceiver
{
    private readonly PlayerObject player;
    private readonly MovementManager movement;
    private readonly PlayerMovementController controller;
    private readonly PlayerWeenie weenie;
    private readonly CharacterSheet sheet;
    private readonly bool attributesRaiseSkills;
    private readonly ServerOrders orders;
    private long unreadable;

    /// <summary>What is known of the character already counts from now on.</summary>
    public PlayerMessages(
        PlayerObject player, MovementManager movement, PlayerMovementController controller, PlayerWeenie weenie, CharacterSheet sheet,
        CommandTable commands, bool attributesRaiseSkills = false)
    {
        this.player = player;
        this.movement = movement;
        this.controller = controller;
        this.weenie = weenie;
        this.sheet = sheet;
        this.attributesRaiseSkills = attributesRaiseSkills;
        orders = new ServerOrders(commands);
        if (sheet.IsDescribed) UseSheet();
    }

    /// <summary>Messages that could not be read.</summary>
    public long UnreadableCount => unreadable + sheet.UnreadableMessages;

    /// <inheritdoc/>
    public void OnMessage(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.UpdateMotion when IsReadable(message, out UpdateMotion motion):
                Move(motion);
                break;
            case Opcode.PositionAndMovement when IsReadable(message, out PositionAndMovement both):
                Move(both.Motion);
                break;
            default:
                if (sheet.Apply(message)) UseSheet();
                break;
        }
    }

    /// <summary>What the player's object does as it is described, before anything newer is heard of it.</summary>
    public void Begin(in MovementData order, bool autonomous)
    {
        if (!orders.TryObey(movement, order, autonomous)) unreadable++;
    }

    private void Move(in UpdateMotion motion)
    {
        if (motion.Guid == player.Id && player.Accepts(motion) && !motion.Autonomous) Obey(motion.Movement);
    }

    /// <summary>Does what the server ordered. The keys wait until it is done.</summary>
    private void Obey(in MovementData order)
    {
        if (orders.TryObey(movement, order, autonomous: false)) controller.LoseControlToServer();
        else unreadable++;
    }

    /// <summary>The numbers act when they are asked for next; only running out of stamina acts at once.</summary>
    private void UseSheet()
    {
        bool hadStamina = weenie.Stats.Stamina > 0;
        weenie.SetStats(CharacterNumbers.Of(sheet, attributesRaiseSkills));
        if (hadStamina && weenie.Stats.Stamina == 0) movement.Interpreter.ReportExhaustion();
    }

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value)) return true;
        unreadable++;
        return false;
    }
}
