using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>Tables that movement does not need and servers look for when they start: as small as readers accept.</summary>
internal static class EmptyTables
{
    // A hash table without entries is u16 count 0, u16 buckets 1; a list is a count of 0.
    private static readonly (DatRecordType Type, uint Id, byte[] Content)[] Portal =
    [
        (DatRecordType.ChatPoseTable, 0x0E000007, [0, 0, 1, 0, 0, 0, 1, 0]),
        (DatRecordType.ObjectHierarchy, 0x0E00000D, [.. new byte[8], 2, .. new byte[27]]),
        (DatRecordType.SpellTable, 0x0E00000E, [0, 0, 1, 0, 0, 0, 1, 0]),
        (DatRecordType.SpellComponentTable, 0x0E00000F, [0, 0, 1, 0]),
        (DatRecordType.BadDataTable, 0x0E00001A, [0, 0, 1, 0]),
        (DatRecordType.ContractTable, 0x0E00001D, [0, 0, 1, 0]),
        (DatRecordType.TabooTable, 0x0E00001E, [0, 0]),
        (DatRecordType.NameFilterTable, 0x0E000020, [0, 0]),
        (DatRecordType.CombatTable, CombatTable, [0, 0, 0, 0]),
        (DatRecordType.MasterProperty, 0x39000001, [.. new byte[8], 5, 0, 6, 0]),
    ];

    private static readonly byte[] NoTexts = [1, 0, 0, 0, 1, 0];

    /// <summary>Id of the combat table of a human, which has no manoeuvre.</summary>
    public const uint CombatTable = 0x30000000;

    /// <summary>Of client_portal.dat.</summary>
    public static IEnumerable<DatRecord> All() => Portal.Select(table => Table(table.Type, table.Id, table.Content));

    /// <summary>Of client_local_English.dat: the texts of the user interface, none.</summary>
    public static IEnumerable<DatRecord> Local() => [Table(DatRecordType.StringTable, 0x2300000E, NoTexts)];

    private static RawRecord Table(DatRecordType type, uint id, byte[] content)
        => RawRecords.Of(type, id, writer => writer.WriteBytes(content));
}
