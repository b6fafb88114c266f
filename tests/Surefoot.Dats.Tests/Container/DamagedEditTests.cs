using System.Buffers;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Changing files that are broken, and changes that cannot be: an error that says why, and the file stays as it was.</summary>
public sealed class DamagedEditTests
{
    private const uint Big = 7, Small = 8;
    private const int BigSize = 3000;

    [Fact]
    [Behaviour("dats.editor.refuses-damaged-directory", "spec/07, 5.4")]
    public void A_file_with_a_damaged_directory_is_not_changed()
    {
        using var folder = new TempFolder();
        string path = folder.File(DatSet.CellName);
        byte[] bytes = File.ReadAllBytes(Path.Combine(TestData.Mini, DatSet.CellName));
        ReaderTests.Patch(bytes, 0x7B00 + 4, 0x7B00);
        AssertRefused(path, bytes, () => DatFileEditor.Open(path), "damaged directory");
    }

    [Theory]
    [InlineData(0x80000400u, "free block")]
    [InlineData(0x7FFFFF00u, "outside")]
    [InlineData(0x00000010u, "outside")]
    [Behaviour("dats.editor.broken-chain", "spec/07, 4.2 and 5.2")]
    public void A_record_whose_chain_is_broken_cannot_be_taken_away(uint link, string reason)
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        byte[] bytes = TwoRecords(path);
        ReaderTests.Patch(bytes, OffsetOf(path, Big), link);
        AssertRefused(path, bytes, () =>
        {
            using var editor = DatFileEditor.Open(path);
            editor.Delete(Big);
        }, reason);
    }

    [Theory]
    [InlineData(0x154, 0u)]
    [InlineData(0x154, 0x7FFFFF00u)]
    [InlineData(0x158, 0x400u)]
    [InlineData(0x15C, 0u)]
    [InlineData(0x15C, 0xFFFFFFFFu)]
    [InlineData(0x15C, 3u)]
    [Behaviour("dats.editor.broken-free-list", "spec/07, 4.1 and 5.2: first free, last free, number of free blocks")]
    public void A_broken_free_list_is_left_alone_and_a_new_one_begins(int field, uint value)
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        byte[] bytes = TwoRecords(path);
        ReaderTests.Patch(bytes, field, value);
        File.WriteAllBytes(path, bytes);
        using (var editor = DatFileEditor.Open(path))
        {
            editor.Put(9, new byte[BigSize]);
            editor.Complete();
        }

        using var file = DatFile.Open(path);
        Assert.Empty(file.Damage);
        Assert.Equal([Big, Small, 9u, DatIds.Iteration], file.Ids);
        Assert.True(file.TryRead(Big, out ReadOnlySequence<byte> big));
        Assert.Equal(Content(), big.ToArray());
        Assert.InRange(file.Entries.Single(entry => entry.Id == 9).Offset, (uint)bytes.Length, (uint)new FileInfo(path).Length);
    }

    [Fact]
    [Behaviour("dats.editor.refuses-arguments", "design.md, decision 7")]
    public void A_record_without_an_id_without_bytes_or_of_another_file_is_refused()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        byte[] before = TwoRecords(path);
        using (var editor = DatFileEditor.Open(path))
        {
            Assert.Throws<ArgumentException>(() => editor.Put(0, [1]));
            Assert.Throws<ArgumentException>(() => editor.Put(5, []));
            LandBlock land = new() { Id = 0xA9B4FFFF, Terrain = [.. new ushort[81]], Heights = [.. new byte[81]] };
            Assert.Throws<ArgumentException>(() => editor.Put(land));
            Assert.Throws<ArgumentNullException>(() => editor.Put(null!));
        }

        Assert.Equal(before, File.ReadAllBytes(path));
    }

    [Fact]
    [Behaviour("dats.writer.cleans-up", "design.md, decision 7")]
    public void A_file_that_cannot_be_put_in_its_place_leaves_nothing_behind()
    {
        using var folder = new TempFolder();
        string path = Directory.CreateDirectory(folder.File("x.dat")).FullName;
        Assert.ThrowsAny<Exception>(() => new DatFileWriter(path, DatFileKind.Portal).Add(7, [1]).Complete());
        Assert.Equal([path], Directory.GetFileSystemEntries(folder.Path));
    }

    [Fact]
    [Behaviour("dats.tree.delete-upper-separators", "spec/07, 5.3")]
    public void Separators_of_the_root_of_three_levels_are_replaced_from_the_leaves()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        var writer = new DatFileWriter(path, DatFileKind.Portal, new() { BlockSize = 256 });
        for (uint id = 1; id <= 4500; id++)
            writer.Add(id, [1]);
        writer.Complete();
        SortedSet<uint> left = [.. Enumerable.Range(1, 4500).Select(i => (uint)i), DatIds.Iteration];
        for (int round = 0; round < 40; round++)
        {
            uint[] separators;
            using (var file = DatFile.Open(path))
            {
                DirectoryNode root = file.ReadNode(file.Header.RootNode);
                Assert.False(file.ReadNode(root.Children[0]).IsLeaf);
                separators = [.. root.Entries.Select(entry => entry.Id)];
            }

            using var editor = DatFileEditor.Open(path);
            foreach (uint id in separators)
            {
                Assert.True(editor.Delete(id));
                left.Remove(id);
            }

            editor.Complete();
        }

        using var end = DatFile.Open(path);
        Assert.Empty(end.Damage);
        Assert.Equal(left, end.Ids);
    }

    private static void AssertRefused(string path, byte[] bytes, Action change, string reason)
    {
        File.WriteAllBytes(path, bytes);
        var error = Assert.Throws<DatFormatException>(change);
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
        Assert.Equal(bytes, File.ReadAllBytes(path));
        Assert.Equal([path], Directory.GetFiles(Path.GetDirectoryName(path)!));
    }

    private static byte[] TwoRecords(string path)
    {
        new DatFileWriter(path, DatFileKind.Portal).Add(Big, Content()).Add(Small, [1]).Complete();
        return File.ReadAllBytes(path);
    }

    private static byte[] Content() => [.. Enumerable.Range(0, BigSize).Select(i => (byte)i)];

    private static int OffsetOf(string path, uint id)
    {
        using var file = DatFile.Open(path);
        return (int)file.Entries.Single(entry => entry.Id == id).Offset;
    }
}
