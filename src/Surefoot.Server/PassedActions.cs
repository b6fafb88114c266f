using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>Which one-shot motions of a player everybody sees: emotes at the usual speed, each with a stamp of the server's own.</summary>
/// <remarks>Specification 08, 5.7.</remarks>
internal sealed class PassedActions
{
    private const uint ChatEmote = 0x12000000;

    private ushort stamp = 1;

    /// <summary>Passes on what is passed on.</summary>
    /// <param name="actions">What the player does.</param>
    /// <param name="passed">What everybody sees of it.</param>
    /// <returns>False when there was something and nothing of it is passed on: then nobody is told anything.</returns>
    public bool TryPass(in MotionActions actions, out MotionActions passed)
    {
        Span<MotionAction> kept = stackalloc MotionAction[actions.Count];
        int count = 0;
        foreach (MotionAction action in actions.Span)
        {
            bool isEmote = CommandTable.Retail.TryGetCommand(action.Command, out uint command) && (command & ChatEmote) == ChatEmote;
            if (isEmote && action.Speed == 1f) kept[count++] = action with { Stamp = Next() };
        }

        passed = new MotionActions(kept[..count]);
        return actions.Count == 0 || count > 0;
    }

    private ushort Next() => stamp = (ushort)((stamp + 1) & 0x7FFF);
}
