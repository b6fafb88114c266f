namespace Surefoot.Protocol.Session;

/// <summary>The words that checksums are mixed with: Bob Jenkins' ISAAC, with the seed only in its three accumulators (specification 08,
/// 2.4).</summary>
internal sealed class KeyStream
{
    private const int Size = 256;
    private const uint GoldenRatio = 0x9E3779B9;

    private readonly uint[] memory = new uint[Size];
    private readonly uint[] results = new uint[Size];
    private uint a, b, c;
    private int cursor = Size - 1;

    public KeyStream(uint seed)
    {
        Span<uint> x = stackalloc uint[8];
        x.Fill(GoldenRatio);
        for (int i = 0; i < 4; i++)
            Mix(x);
        Pass(x, results);
        Pass(x, memory);
        a = b = c = seed;
        Scramble();
    }

    /// <summary>The next word.</summary>
    public uint Next()
    {
        uint word = results[cursor--];
        if (cursor < 0)
        {
            Scramble();
            cursor = Size - 1;
        }

        return word;
    }

    private static void Mix(Span<uint> x)
    {
        ReadOnlySpan<int> shifts = [11, -2, 8, -16, 10, -4, 8, -9];
        for (int k = 0; k < 8; k++)
        {
            uint next = x[(k + 1) & 7];
            x[k] ^= shifts[k] > 0 ? next << shifts[k] : next >> -shifts[k];
            x[(k + 3) & 7] += x[k];
            x[(k + 1) & 7] += x[(k + 2) & 7];
        }
    }

    private void Pass(Span<uint> x, uint[] source)
    {
        for (int j = 0; j < Size; j += 8)
        {
            for (int k = 0; k < 8; k++)
                x[k] += source[j + k];
            Mix(x);
            x.CopyTo(memory.AsSpan(j));
        }
    }

    private void Scramble()
    {
        b += ++c;
        for (int i = 0; i < Size; i++)
        {
            uint x = memory[i];
            a ^= (i & 3) switch { 0 => a << 13, 1 => a >> 6, 2 => a << 2, _ => a >> 16 };
            a += memory[(i + 128) & 0xFF];
            uint y = memory[(x >> 2) & 0xFF] + a + b;
            memory[i] = y;
            b = memory[(y >> 10) & 0xFF] + x;
            results[i] = b;
        }
    }
}
