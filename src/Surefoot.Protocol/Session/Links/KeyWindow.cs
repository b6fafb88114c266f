namespace Surefoot.Protocol.Session;

/// <summary>The words of a key stream from a receiver's side: those to come can be looked at before they are taken, and words taken too
/// early can be given back.</summary>
internal sealed class KeyWindow(uint seed)
{
    private readonly KeyStream stream = new(seed);
    private readonly List<uint> ahead = [];
    private int taken;

    /// <summary>Number of the next word, from 0.</summary>
    public int Head { get; private set; }

    /// <summary>A word that is to come; 0 is the next.</summary>
    public uint Peek(int offset)
    {
        while (ahead.Count - taken <= offset)
            ahead.Add(stream.Next());
        return ahead[taken + offset];
    }

    /// <summary>Takes the next word.</summary>
    public uint Take()
    {
        uint word = Peek(0);
        taken++;
        Head++;
        if (taken >= 256 && taken * 2 >= ahead.Count)
        {
            ahead.RemoveRange(0, taken);
            taken = 0;
        }

        return word;
    }

    /// <summary>Gives back the words that were taken last, oldest first.</summary>
    public void GiveBack(ReadOnlySpan<uint> words)
    {
        ahead.RemoveRange(0, taken);
        taken = 0;
        ahead.InsertRange(0, words);
        Head -= words.Length;
    }
}
