using Surefoot.Physics.Motion;

namespace Surefoot.Client;

/// <summary>The commands of one kind whose keys are held; the newest acts, and letting it go falls back to the one before.</summary>
/// <remarks>Retail: the three lists of CommandInterpreter; specification 01, 4.15.</remarks>
internal sealed class HeldCommands
{
    private readonly MotionCommand[] commands = new MotionCommand[4];
    private int count;

    /// <summary>The command that acts; none when no key is held.</summary>
    public MotionCommand Acting => count == 0 ? MotionCommand.None : commands[count - 1];

    /// <summary>Puts a command on top.</summary>
    public void Press(MotionCommand command)
    {
        Release(command);
        commands[count++] = command;
    }

    /// <summary>Takes a command out, wherever it is.</summary>
    public void Release(MotionCommand command)
    {
        int i = Array.IndexOf(commands, command, 0, count);
        if (i < 0) return;
        Array.Copy(commands, i + 1, commands, i, count - i - 1);
        count--;
    }

    /// <summary>Takes everything out.</summary>
    public void Clear() => count = 0;
}
