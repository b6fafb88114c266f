namespace Surefoot.Protocol.Messages;

/// <summary>Full ids of motion commands by their low words (specification 08, appendix A). Servers of the field number them as a later
/// client does: from 0x118 on, three more than the client of 2013.</summary>
public sealed class CommandTable
{
    private const int RetailEntries = 0x198, FirstShifted = 0x118, Shift = 3;

    // First low word of each run of commands of one class, and that class: the high word of their ids.
    private static readonly (int First, int Class)[] Runs =
    [
        (0x000, 0x8000), (0x001, 0x8500), (0x003, 0x4100), (0x004, 0x4000), (0x005, 0x4500), (0x007, 0x4400), (0x008, 0x4000),
        (0x00D, 0x6500), (0x011, 0x4000), (0x012, 0x4100), (0x015, 0x4000), (0x03A, 0x2000), (0x03B, 0x2500), (0x03C, 0x8000),
        (0x04A, 0x1000), (0x04C, 0x1300), (0x04D, 0x1000), (0x079, 0x1300), (0x09B, 0x1200), (0x09C, 0x1000), (0x0A2, 0x0800),
        (0x0A3, 0x0900), (0x0A9, 0x0800), (0x0AA, 0x0900), (0x0B2, 0x0D00), (0x0B5, 0x0800), (0x0B8, 0x0900), (0x0BA, 0x0D00),
        (0x0C0, 0x0900), (0x0C1, 0x0C00), (0x0C2, 0x0900), (0x0C5, 0x0D00), (0x0C6, 0x0900), (0x0CA, 0x1300), (0x0CD, 0x1000),
        (0x0D3, 0x4000), (0x0D4, 0x1200), (0x0D5, 0x0900), (0x0DF, 0x1200), (0x0E0, 0x4000), (0x0E2, 0x1000), (0x0E4, 0x4000),
        (0x0E7, 0x0900), (0x0E8, 0x8000), (0x0EA, 0x4300), (0x0F9, 0x4200), (0x0FA, 0x4300), (0x0FE, 0x0900), (0x10E, 0x1000),
        (0x10F, 0x0900), (0x115, 0x4300), (0x116, 0x1300), (0x117, 0x4300), (0x11A, 0x0900), (0x11B, 0x1000), (0x132, 0x1300),
        (0x133, 0x4000), (0x137, 0x1000), (0x138, 0x8000), (0x13A, 0x4300), (0x147, 0x1300), (0x150, 0x1000), (0x151, 0x0900),
        (0x162, 0x1000), (0x165, 0x0900), (0x16E, 0x1000),
    ];

    private readonly uint[] ids;

    private CommandTable(uint[] ids) => this.ids = ids;

    /// <summary>The numbering of the retail client of 2013.</summary>
    public static CommandTable Retail { get; } = new(RetailIds());

    /// <summary>The numbering of live servers.</summary>
    public static CommandTable Ace { get; } = new(AceIds());

    /// <summary>The full id of a low word.</summary>
    /// <returns>False for a low word that no command has.</returns>
    public bool TryGetCommand(ushort lowWord, out uint command)
    {
        command = lowWord < ids.Length ? ids[lowWord] : 0;
        return command != 0;
    }

    private static uint[] RetailIds()
    {
        var ids = new uint[RetailEntries];
        for (int run = 0; run < Runs.Length; run++)
        {
            int end = run + 1 < Runs.Length ? Runs[run + 1].First : RetailEntries;
            for (int i = Runs[run].First; i < end; i++)
                ids[i] = ((uint)Runs[run].Class << 16) | (uint)i;
        }

        return ids;
    }

    private static uint[] AceIds()
    {
        uint[] retail = RetailIds(), ids = new uint[RetailEntries + Shift];
        retail.AsSpan(0, FirstShifted - Shift).CopyTo(ids);
        ids[0x10F] = 0x1000010F;
        for (int i = FirstShifted; i < ids.Length; i++)
            ids[i] = (retail[i - Shift] & 0xFFFF0000) | (uint)i;
        return ids;
    }
}
