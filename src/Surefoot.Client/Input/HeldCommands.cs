using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>
/// The commands of one kind whose keys are held; the newest, at the head, acts, and letting it go falls back to the one before.
/// </summary>
/// <remarks>Retail: CommandList @0x006B4960; specification 09b, 9.2.</remarks>
internal sealed class HeldCommands
{
    private readonly MotionCommand[] commands = new MotionCommand[2];
    private int count;

    /// <summary>The command that acts; none when no key is held.</summary>
    public MotionCommand Head => count == 0 ? MotionCommand.None : commands[count - 1];

    /// <summary>Puts a command at the head.</summary>
    public void Press(MotionCommand command)
    {
        Release(command);
        commands[count++] = command;
    }

    /// <summary>Takes a command out, wherever it is.</summary>
    /// <returns>True when it was the head.</returns>
    public bool Release(MotionCommand command)
    {
        int i = Array.IndexOf(commands, command, 0, count);
        if (i < 0) return false;
        Array.Copy(commands, i + 1, commands, i, count - i - 1);
        count--;
        return i == count;
    }

    /// <summary>Takes everything out.</summary>
    public void Clear() => count = 0;
}
