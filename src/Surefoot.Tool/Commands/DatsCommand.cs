using System.CommandLine;
using System.Globalization;
using System.Text.Json;
using Spectre.Console;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.Physics.World;
using Surefoot.Tool.Inspection;
using Surefoot.Tool.Output;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot dats</c>: looks into dat files.</summary>
internal static class DatsCommand
{
    private static readonly JsonSerializerOptions Json = new() { WriteIndented = true, PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    internal static Command Create() =>
        new("dats", "Looks into a folder of dat files.\n\nExample:\n  surefoot dats verify tests/data/worlds/first")
    {
        CreateList(), CreateShow(), CreateVerify(),
    };

    private static Argument<DirectoryInfo> FolderArgument() =>
        new("DIR") { Description = "Folder with client_portal.dat and client_cell_1.dat." };

    private static Command CreateList()
    {
        Argument<DirectoryInfo> folder = FolderArgument();
        Option<string?> type = new("--type") { Description = "Only records of this kind, each on a line; for example Setup or EnvCell." };
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Command command = new(
            "list",
            "Lists the kinds of records in the files, or the records of one kind.\n\nExample:\n  surefoot dats list DIR --type Setup")
        {
            folder, type, json,
        };
        command.SetAction(parsed =>
        {
            DatRecordType? wanted = parsed.GetValue(type) is { } name ? ParseType(name) : null;
            using DatSet set = DatSet.Open(parsed.GetRequiredValue(folder).FullName);
            if (wanted is { } kind) ListRecords(set, kind, parsed.GetValue(json));
            else ListKinds(set, parsed.GetValue(json));
            return ExitCode.Done;
        });
        return command;
    }

    private static DatRecordType ParseType(string name) =>
        Enum.TryParse(name, ignoreCase: true, out DatRecordType type) && Enum.IsDefined(type)
        ? type
        : throw new UsageException(
            $"--type '{name}': there is no such kind of record. Kinds are " +
            $"{string.Join(", ", Enum.GetNames<DatRecordType>().Order(StringComparer.Ordinal))}.");

    private static void ListKinds(DatSet set, bool json)
    {
        var kinds =
            set.Files.SelectMany(file => file.Entries.GroupBy(e => DatIds.RecordTypeOf(e.Id, file.Kind)).OrderBy(g => g.Key).Select(g => new
            {
                File = Path.GetFileName(file.Path),
                Kind = g.Key.ToString(),
                Records = g.Count(),
                Bytes = g.Sum(e => (long)e.Size),
                First = $"{g.Min(e => e.Id):X8}",
                Last = $"{g.Max(e => e.Id):X8}",
            })).ToList();
        if (json)
        {
            Console.Out.WriteLine(JsonSerializer.Serialize(new { Kinds = kinds }, Json));
            return;
        }

        Table table = new() { Border = TableBorder.Simple };
        foreach (string heading in (string[])["file", "kind", "records", "bytes", "first", "last"]) table.AddColumn(heading);
        table.Columns[2].Alignment = table.Columns[3].Alignment = Justify.Right;
        foreach (var k in kinds) table.AddRow(k.File, k.Kind, Number(k.Records), Number(k.Bytes), k.First, k.Last);
        Terminal.Write(table);
    }

    private static void ListRecords(DatSet set, DatRecordType kind, bool json)
    {
        var records = set.Files.SelectMany(
            file =>
                file.IdsOf(kind)
                    .Select(id => new { Id = $"{id:X8}", Bytes = file.TryGetEntry(id, out DatEntry entry) ? entry.Size : 0 })).ToList();
        if (records.Count == 0) Console.Error.WriteLine($"surefoot: {set.Folder} has no record of the kind {kind}.");
        if (json) Console.Out.WriteLine(JsonSerializer.Serialize(new { Kind = kind.ToString(), Records = records }, Json));
        else foreach (var r in records) Console.Out.WriteLine(FormattableString.Invariant($"{r.Id} {r.Bytes,8}"));
    }

    private static Command CreateShow()
    {
        Argument<DirectoryInfo> folder = FolderArgument();
        Argument<string> id = new("ID") { Description = "Record id, hexadecimal." };
        Option<bool> json = new("--json") { Description = "Print the record as JSON." };
        Option<bool> cell = new("--cell") { Description = "Take the record of the cell file where the portal file has the same id." };
        Command command = new("show",
            "Shows a record as readable text.\n\nExample:\n  surefoot dats show DIR 02000001") { folder, id, json, cell };
        command.SetAction(parsed =>
        {
            string text = parsed.GetRequiredValue(id);
            string digits = text.StartsWith("0x", StringComparison.OrdinalIgnoreCase) ? text[2..] : text;
            if (!uint.TryParse(digits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint number))
                throw new UsageException($"'{text}' is not a record id: up to eight hexadecimal digits, for example 02000001.");
            using DatSet set = DatSet.Open(parsed.GetRequiredValue(folder).FullName);
            IEnumerable<DatFile> files = parsed.GetValue(cell) ? set.Files.OrderByDescending(f => f.Kind == DatFileKind.Cell) : set.Files;
            DatFile? file = files.FirstOrDefault(f => f.TryGetEntry(number, out _));
            if (file is null)
            {
                Console.Error.WriteLine(
                    $"surefoot: there is no record 0x{number:X8} in {set.Folder}. 'surefoot dats list DIR' shows what there is.");
                return ExitCode.Failed;
            }

            DatRecord record = DatRecords.Decode(file, number);
            Console.Out.WriteLine(parsed.GetValue(json) ? RecordText.ToJson(record) : RecordText.ToText(record));
            return ExitCode.Done;
        });
        return command;
    }

    private static Command CreateVerify()
    {
        Argument<DirectoryInfo> folder = FolderArgument();
        Option<bool> json = new("--json") { Description = "Print one JSON object." };
        Command command = new(
            "verify",
            "Reads every record, decodes it, encodes it again and compares the bytes; then loads every landblock and lists what a world " +
            "has to " +
            "leave out.\n\nExample:\n  surefoot dats verify DIR")
        {
            folder, json,
        };
        command.SetAction((parsed, cancellation) =>
        {
            using DatSet set = DatSet.Open(parsed.GetRequiredValue(folder).FullName);
            List<DatVerifyResult> bad = [];
            int[] outcomes = new int[Enum.GetValues<DatVerifyOutcome>().Length];
            int remarks = 0;
            ProgressBar.Run("records", parsed.GetValue(json), report =>
            {
                foreach (DatVerifyResult result in DatVerifier.Verify(set, p => report(p.Done, p.Total), cancellation))
                {
                    outcomes[(int)result.Outcome]++;
                    remarks += result.Remarks.Count;
                    if (!result.IsGood) bad.Add(result);
                }
            });
            WorldCheck check = ProgressBar.Run("landblocks", parsed.GetValue(json), report => WorldCheck.Of(set, report, cancellation));
            var summary = new
            {
                Records = outcomes.Sum(),
                Identical = outcomes[(int)DatVerifyOutcome.Identical],
                Opaque = outcomes[(int)DatVerifyOutcome.Opaque],
                Different = outcomes[(int)DatVerifyOutcome.Different],
                Failed = outcomes[(int)DatVerifyOutcome.Failed],
                Remarks = remarks,
                Faults = bad.Select(b => new
                {
                    File = Path.GetFileName(b.File),
                    Id = $"{b.Id:X8}",
                    Kind = b.Type.ToString(),
                    Outcome = b.Outcome.ToString(),
                    b.Message,
                }),
                check.Region,
                LeftOut = new
                {
                    check.LeftOut.Total,
                    check.LeftOut.Unlisted,
                    Items = check.LeftOut.Select(item => new
                    {
                        Kind = item.Kind.ToString(),
                        Id = $"{item.Id:X8}",
                        FirstIn = $"{item.FirstIn:X8}",
                        item.Reason,
                        File = Path.GetFileName(item.File),
                        item.Offset,
                        item.Count,
                    }),
                },
            };
            if (parsed.GetValue(json))
            {
                Console.Out.WriteLine(JsonSerializer.Serialize(summary, Json));
            }
            else
            {
                foreach (DatVerifyResult b in bad)
                    Console.Out.WriteLine($"{Path.GetFileName(b.File)} {b.Id:X8} {b.Type} {b.Outcome}: {b.Message}");
                Console.Out.WriteLine(
                    $"{summary.Records} records: {summary.Identical} identical after decoding and encoding, " +
                    $"{summary.Opaque} carried as bytes, {summary.Different} different, {summary.Failed} unreadable");
                Console.Out.WriteLine($"Region: {check.Region}");
                foreach (LeftOutItem item in check.LeftOut) Console.Out.WriteLine($"left out: {item}");
                if (check.HasRegion) Console.Out.WriteLine($"left out of a world of these files: {Number(check.LeftOut.Total)}");
            }

            return Task.FromResult(bad.Count == 0 && check.IsComplete ? ExitCode.Done : ExitCode.Failed);
        });
        return command;
    }

    private static string Number(long value) => value.ToString("N0", CultureInfo.InvariantCulture);
}
