using System.Buffers;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Folders of dat files.</summary>
public sealed class DatSetTests
{
    [Fact]
    [Behaviour("dats.folder.opens", "spec/07, 1.2")]
    public void A_folder_of_four_files_is_one_source()
    {
        using var set = DatSet.Open(TestData.Mini);

        Assert.Equal(4, set.Files.Count);
        Assert.Equal(456, set.Read<Setup>(0x02000001).Encode().Length);
        Assert.True(set.Read<LandBlock>(0xA9B4FFFF).HasInfo);
        Assert.Equal(0x0D000001u, set.Read<EnvCell>(0xA9B40100).EnvironmentId);
        Assert.Equal([0xA9B40100u, 0xA9B40101u, 0xA9B40102u], set.IdsOf(DatRecordType.EnvCell));
        Assert.Equal(100, set.IdsOf(DatRecordType.LandBlock).Count());
        Assert.True(set.TryRead(0xA9B4FFFE, out ReadOnlySequence<byte> info));
        Assert.Equal(128, info.Length);
        Assert.False(set.TryRead(0x01007777, out _));
        Assert.False(set.TryRead(0, out _));
    }

    [Fact]
    [Behaviour("dats.folder.highres-first", "spec/07, 1.2")]
    public void Textures_are_searched_in_the_high_resolution_file_too()
    {
        using var set = DatSet.Open(TestData.Mini);
        Assert.False(set.Portal.TryRead(0x06000002, out _));
        Assert.True(set.TryRead(0x06000002, out ReadOnlySequence<byte> bytes));
        Assert.Equal(32, bytes.Length);
    }

    [Fact]
    [Behaviour("dats.folder.names-without-case", "spec/07, 1.2")]
    public void Names_are_matched_without_regard_to_case_and_two_files_suffice()
    {
        using var folder = new TempFolder();
        File.Copy(Path.Combine(TestData.Mini, DatSet.PortalName), folder.File("CLIENT_Portal.DAT"));
        File.Copy(Path.Combine(TestData.Mini, DatSet.CellName), folder.File("Client_Cell_1.dat"));
        using var set = DatSet.Open(folder.Path);
        Assert.Null(set.Local);
        Assert.Null(set.HighRes);
        Assert.Equal(2, set.Files.Count);
    }

    [Fact]
    [Behaviour("dats.folder.equal-ids", "spec/07, section 6")]
    public void A_cell_and_a_shape_of_one_id_are_told_apart_by_type()
    {
        using var folder = new TempFolder();
        new DatFileWriter(folder.File(DatSet.PortalName), DatFileKind.Portal).Add(new GfxObj { Id = 0x01000100 }).Complete();
        new DatFileWriter(folder.File(DatSet.CellName), DatFileKind.Cell)
            .Add(new EnvCell { Id = 0x01000100, CellId = 0x01000100 })
            .Complete();
        using var set = DatSet.Open(folder.Path);
        Assert.Equal(0x01000100u, set.Read<GfxObj>(0x01000100).Id);
        Assert.Equal(0x01000100u, set.Read<EnvCell>(0x01000100).CellId);
        Assert.True(set.TryRead(0x01000100, out ReadOnlySequence<byte> bytes));
        Assert.Equal(29, bytes.Length);
    }

    [Fact]
    [Behaviour("dats.folder.typed-reads", "spec/07, 1.2 and section 6")]
    public void A_record_is_found_by_its_kind_in_the_file_of_that_kind_and_then_in_the_local_one()
    {
        using var folder = new TempFolder();
        new DatFileWriter(folder.File(DatSet.PortalName), DatFileKind.Portal).Add(new Scene { Id = 0x12000001 }).Complete();
        new DatFileWriter(folder.File(DatSet.CellName), DatFileKind.Cell).Add(0x12000002, [1]).Complete();
        new DatFileWriter(folder.File(DatSet.LocalName),
            DatFileKind.Local).Add(new Scene { Id = 0x12000003 }).Add(0x12000004, [1]).Complete();
        using var set = DatSet.Open(folder.Path);
        Assert.Equal(0x12000001u, set.Read<Scene>(0x12000001).Id);
        Assert.Equal(0x12000003u, set.Read<Scene>(0x12000003).Id);
        Assert.False(set.TryRead<Scene>(0x12000002, out _));
        Assert.False(set.TryRead<GfxObj>(0x12000001, out _));
        Assert.Equal(folder.File(DatSet.LocalName), Assert.Throws<DatFormatException>(() => set.Read<Scene>(0x12000004)).File);
    }

    [Theory]
    [InlineData(true, true, "There is no folder")]
    [InlineData(false, true, "has no client_portal.dat:")]
    [InlineData(true, false, "has no client_cell_1.dat:")]
    [InlineData(false, false, "has no client_portal.dat and client_cell_1.dat:")]
    [Behaviour("dats.folder.missing", "design.md, decision 7")]
    public void A_missing_or_partial_folder_is_one_line_that_says_what_to_do(bool portal, bool cell, string expected)
    {
        using var folder = new TempFolder();
        if (portal)
            File.Copy(Path.Combine(TestData.Mini, DatSet.PortalName), folder.File(DatSet.PortalName));
        if (cell)
            File.Copy(Path.Combine(TestData.Mini, DatSet.CellName), folder.File(DatSet.CellName));
        string path = portal && cell ? folder.File("nowhere") : folder.Path;

        var error = Assert.Throws<DatFolderException>(() => DatSet.Open(path));

        Assert.Equal(path, error.Folder);
        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
        Assert.Contains(path, error.Message, StringComparison.Ordinal);
        Assert.Contains("surefoot demo write DIR", error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', error.Message);
    }

    [Fact]
    [Behaviour("dats.folder.file-instead", "design.md, decision 7")]
    public void A_file_instead_of_a_folder_is_said()
        => Assert.Contains(
            "is a file", Assert.Throws<DatFolderException>(() => DatSet.Open(Path.Combine(TestData.Mini, DatSet.PortalName))).Message,
            StringComparison.Ordinal);

    [Fact]
    [Behaviour("dats.folder.wrong-kind", "spec/07, 1.2")]
    public void A_file_of_another_kind_than_its_name_is_a_format_error()
    {
        using var folder = new TempFolder();
        File.Copy(Path.Combine(TestData.Mini, DatSet.CellName), folder.File(DatSet.PortalName));
        File.Copy(Path.Combine(TestData.Mini, DatSet.CellName), folder.File(DatSet.CellName));
        Assert.Contains("Portal", Assert.Throws<DatFormatException>(() => DatSet.Open(folder.Path)).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0x01000000u, DatFileKind.Portal, DatRecordType.GfxObj)]
    [InlineData(0x0200FFFFu, DatFileKind.Portal, DatRecordType.Setup)]
    [InlineData(0x02010000u, DatFileKind.Portal, DatRecordType.Unknown)]
    [InlineData(0x07FFFFFFu, DatFileKind.HighRes, DatRecordType.RenderSurface)]
    [InlineData(0x0E000018u, DatFileKind.Portal, DatRecordType.ExperienceTable)]
    [InlineData(0x0E000019u, DatFileKind.Portal, DatRecordType.Unknown)]
    [InlineData(0x13000000u, DatFileKind.Portal, DatRecordType.Region)]
    [InlineData(0x23000005u, DatFileKind.Local, DatRecordType.StringTable)]
    [InlineData(0xFFFF0001u, DatFileKind.Portal, DatRecordType.Iteration)]
    [InlineData(0xFFFF0001u, DatFileKind.Cell, DatRecordType.Iteration)]
    [InlineData(0xA9B4FFFFu, DatFileKind.Cell, DatRecordType.LandBlock)]
    [InlineData(0xA9B4FFFEu, DatFileKind.Cell, DatRecordType.LandBlockInfo)]
    [InlineData(0xA9B4FFFDu, DatFileKind.Cell, DatRecordType.EnvCell)]
    [InlineData(0xA9B40100u, DatFileKind.Cell, DatRecordType.EnvCell)]
    [InlineData(0xA9B40040u, DatFileKind.Cell, DatRecordType.Unknown)]
    [InlineData(0xA9B4FFFFu, DatFileKind.Portal, DatRecordType.Unknown)]
    [Behaviour("dats.ids.kinds", "spec/07, section 6")]
    public void Ids_say_their_kind(uint id, DatFileKind file, DatRecordType type) => Assert.Equal(type, DatIds.RecordTypeOf(id, file));
}
