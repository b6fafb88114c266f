namespace Surefoot.Dats.Tests;

/// <summary>The files of other writers, read completely.</summary>
public sealed class WorldFilesTests
{
    public static TheoryData<string> Files { get; } = [.. TestData.DatFiles.Select(path => Path.GetRelativePath(TestData.Root, path))];

    [Theory]
    [MemberData(nameof(Files))]
    [Behaviour("dats.worlds.re-encode-to-identical-bytes", "spec/07, section 7")]
    public void Every_record_decodes_and_encodes_to_the_same_bytes(string name)
    {
        using var file = DatFile.Open(Path.Combine(TestData.Root, name));

        List<DatVerifyResult> results = [.. DatVerifier.Verify([file])];

        Assert.Empty(file.Damage);
        Assert.Equal(file.Ids.Count, results.Count);
        Assert.All(results, result => Assert.True(result.IsGood, $"{result.Type} 0x{result.Id:X8}: {result.Message}"));
        Assert.All(results, result => Assert.NotEqual(DatRecordType.Unknown, result.Type));
    }

    [Theory]
    [MemberData(nameof(Files))]
    [Behaviour("dats.show.every-record-as-text-and-json", "design.md")]
    public void Every_record_can_be_shown_as_text_and_JSON(string name)
    {
        using var file = DatFile.Open(Path.Combine(TestData.Root, name));
        foreach (uint id in file.Ids)
        {
            var record = Records.DatRecords.Decode(file, id);
            Assert.Contains($"0x{id:X8}", RecordText.ToText(record), StringComparison.Ordinal);
            using var json = System.Text.Json.JsonDocument.Parse(RecordText.ToJson(record));
            Assert.Equal($"0x{id:X8}", json.RootElement.GetProperty("id").GetString());
        }
    }
}
