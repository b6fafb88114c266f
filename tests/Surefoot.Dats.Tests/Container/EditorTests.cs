using System.Buffers;
using System.Buffers.Binary;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Changing single records (spec 07, 5.2 and 5.3).</summary>
public sealed class EditorTests
{
    [Fact]
    [Behaviour("dats.tree.insert-ascending", "spec/07, 5.3")]
    public void Inserting_1_to_62_in_order_gives_31_over_two_leaves()
    {
        using var folder = new TempFolder();
        using var file = Build(folder, Range(1, 62));
        AssertShape(file, [31], Range(1, 30), Range(32, 62));
    }

    [Fact]
    [Behaviour("dats.tree.insert-descending", "spec/07, 5.3")]
    public void Inserting_62_to_1_gives_32_over_two_leaves()
    {
        using var folder = new TempFolder();
        using var file = Build(folder, Range(1, 62).Reverse());
        AssertShape(file, [32], Range(1, 31), Range(33, 62));
    }

    [Fact]
    [Behaviour("dats.tree.delete-separator", "spec/07, 5.3")]
    public void Deleting_the_separator_takes_the_smallest_of_the_right_leaf()
    {
        using var folder = new TempFolder();
        using var file = Build(folder, Range(1, 62), 31);
        AssertShape(file, [32], Range(1, 30), Range(33, 62));
    }

    [Fact]
    [Behaviour("dats.tree.delete-merges", "spec/07, 5.3")]
    public void Deleting_from_thin_leaves_merges_them_into_the_root()
    {
        using var folder = new TempFolder();
        using var file = Build(folder, Range(1, 62), 31, 1);
        AssertShape(file, [.. Range(2, 30), .. Range(32, 62)]);
    }

    [Fact]
    [Behaviour("dats.tree.any-order", "spec/07, 5.3")]
    public void Any_inserts_replacements_and_deletions_leave_a_sound_file()
        => Gen.Select(Gen.Select(Gen.UInt[1, 300], Gen.Int[0, 900], Gen.Bool).Array[0, 900], Gen.Int[64, 300]).Sample(
            (steps, blockSize) =>
            {
                using var folder = new TempFolder();
                string path = folder.File("x.dat");
                new DatFileWriter(path, DatFileKind.Portal, new() { BlockSize = blockSize }).Complete();
                var expected = new SortedDictionary<uint, byte[]>();
                using (var editor = DatFileEditor.Open(path))
                {
                    foreach (var (id, size, delete) in steps)
                    {
                        if (delete && expected.Count > 100)
                        {
                            Assert.Equal(expected.Remove(id), editor.Delete(id));
                            continue;
                        }

                        byte[] bytes = new byte[size + 1];
                        Array.Fill(bytes, (byte)size);
                        expected[id] = bytes;
                        Assert.True(editor.Put(id, bytes));
                    }

                    editor.Complete();
                }

                using var file = DatFile.Open(path);
                Assert.Empty(file.Damage);
                Assert.Empty(file.Remarks);
                Assert.Equal([.. expected.Keys, DatIds.Iteration], file.Ids);
                foreach (var (id, bytes) in expected)
                {
                    Assert.True(file.TryRead(id, out ReadOnlySequence<byte> read));
                    Assert.Equal(bytes, read.ToArray());
                }

                AssertEveryBlockIsUsedOnce(file, path);
            },
            iter: Fuzz.Cases(15));

    [Fact]
    [Behaviour("dats.tree.many", "spec/07, 5.3")]
    public void A_tree_of_three_levels_grows_and_shrinks()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal, new() { BlockSize = 256 }).Complete();
        const uint count = 4500;
        using (var editor = DatFileEditor.Open(path))
        {
            for (uint i = 0; i < count; i++)
                editor.Put(1 + (i * 2917 % count), [1]);
            for (uint i = 0; i < count; i += 2)
                Assert.True(editor.Delete(1 + (i * 1999 % count)));
            editor.Complete();
        }

        using var file = DatFile.Open(path);
        Assert.Empty(file.Damage);
        Assert.Equal((int)(count / 2) + 1, file.Ids.Count);
        AssertEveryBlockIsUsedOnce(file, path);
    }

    [Fact]
    [Behaviour("dats.editor.higher-iteration-stays", "spec/07, 5.2")]
    public void A_record_of_a_later_update_is_kept()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Complete();
        using (var editor = DatFileEditor.Open(path))
        {
            Assert.True(editor.Put(5, [1], iteration: 7, date: 9));
            Assert.False(editor.Put(5, [2], iteration: 6));
            Assert.True(editor.Put(6, [3], iteration: 7));
            Assert.True(editor.Put(6, [4], iteration: 0));
            editor.Complete();
        }

        using var file = DatFile.Open(path);
        Assert.True(file.TryGetEntry(5, out DatEntry entry));
        Assert.Equal((7u, 9u, (ushort)2), (entry.Iteration, entry.Date, entry.Version));
        Assert.True(file.TryRead(5, out ReadOnlySequence<byte> bytes));
        Assert.Equal([1], bytes.ToArray());
    }

    [Fact]
    [Behaviour("dats.editor.grows", "spec/07, 5.2 (1 MiB)")]
    public void A_file_grows_by_a_mebibyte_before_its_free_blocks_run_out()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Complete();
        long before = new FileInfo(path).Length;
        using (var editor = DatFileEditor.Open(path))
        {
            editor.Put(5, new byte[1020 * 20]);
            editor.Complete();
        }

        Assert.Equal(before + 0x100000, new FileInfo(path).Length);
        using var file = DatFile.Open(path);
        Assert.Equal(60u + 1024 - 20, file.Header.FreeBlockCount);
        Assert.Equal((uint)new FileInfo(path).Length, file.Header.FileSize);
        AssertEveryBlockIsUsedOnce(file, path);
    }

    [Fact]
    [Behaviour("dats.editor.unlinked-free-list", "spec/07, section 8 (free list of DatReaderWriter)")]
    public void A_file_of_another_writer_with_unlinked_free_blocks_can_be_changed()
    {
        using var folder = new TempFolder();
        string path = folder.File(DatSet.PortalName);
        File.Copy(Path.Combine(TestData.Root, "worlds", "first", DatSet.PortalName), path);
        using (var editor = DatFileEditor.Open(path))
        {
            editor.Put(new Scene { Id = 0x1200FFFF });
            Assert.True(editor.Delete(0x02000001));
            editor.Complete();
        }

        using var before = DatFile.Open(Path.Combine(TestData.Root, "worlds", "first", DatSet.PortalName));
        using var file = DatFile.Open(path);
        Assert.Empty(file.Damage);
        Assert.Equal(before.Ids.Except([0x02000001u]).Append(0x1200FFFFu).Order(), file.Ids);
        Assert.All(DatVerifier.Verify([file]), result => Assert.True(result.IsGood));
    }

    [Fact]
    [Behaviour("dats.editor.empty-root", "spec/07, 4.1 (root 0)")]
    public void A_file_without_a_root_gets_one()
    {
        using var folder = new TempFolder();
        string path = folder.File(DatSet.LocalName);
        File.Copy(Path.Combine(TestData.Root, "worlds", "first", DatSet.LocalName), path);
        using (var editor = DatFileEditor.Open(path))
        {
            Assert.False(editor.Delete(1));
            editor.Put(IterationRecord.UpTo(1));
            editor.Complete();
        }

        using var file = DatFile.Open(path);
        Assert.Equal([DatIds.Iteration], file.Ids);
        Assert.Equal((1, 0u), (file.Entries[0].Version, file.Entries[0].Iteration));
    }

    [Fact]
    [Behaviour("dats.editor.drops-changes", "spec/07, 4.6")]
    public void Without_Complete_the_file_stays_as_it_was()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Add(7, [1]).Complete();
        byte[] before = File.ReadAllBytes(path);
        using (var editor = DatFileEditor.Open(path))
            editor.Delete(7);
        Assert.Equal(before, File.ReadAllBytes(path));
        Assert.Equal([path], Directory.GetFiles(folder.Path));
    }

    [Fact]
    [Behaviour("dats.editor.refuses-interrupted", "spec/07, 4.6")]
    public void A_file_left_in_the_middle_of_a_write_is_read_but_not_changed()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Add(7, [1]).Complete();
        byte[] bytes = File.ReadAllBytes(path);
        bytes[0x100] = 6;
        File.WriteAllBytes(path, bytes);

        Assert.Throws<DatFormatException>(() => DatFileEditor.Open(path));
        using var file = DatFile.Open(path);
        Assert.True(file.TryRead(7, out _));
        Assert.Contains("middle of a write", Assert.Single(file.Remarks).Message, StringComparison.Ordinal);
    }

    private static IEnumerable<uint> Range(int first, int last) => Enumerable.Range(first, last - first + 1).Select(i => (uint)i);

    // Inserts ids into a file that holds nothing, not even an iteration record, then deletes some.
    private static DatFile Build(TempFolder folder, IEnumerable<uint> ids, params uint[] deleted)
    {
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Complete();
        using (var editor = DatFileEditor.Open(path))
        {
            Assert.True(editor.Delete(DatIds.Iteration));
            foreach (uint id in ids)
                editor.Put(id, [1]);
            foreach (uint id in deleted)
                Assert.True(editor.Delete(id));
            editor.Complete();
        }

        return DatFile.Open(path);
    }

    private static void AssertShape(DatFile file, IEnumerable<uint> root, params IEnumerable<uint>[] leaves)
    {
        DirectoryNode node = file.ReadNode(file.Header.RootNode);
        Assert.Equal(root, node.Entries.Select(e => e.Id));
        Assert.Equal(leaves.Length, node.Children.Count);
        for (int i = 0; i < leaves.Length; i++)
        {
            DirectoryNode leaf = file.ReadNode(node.Children[i]);
            Assert.True(leaf.IsLeaf);
            Assert.Equal(leaves[i], leaf.Entries.Select(e => e.Id));
        }
    }

    // Records, nodes and the free list together are all blocks of the file, none twice.
    private static void AssertEveryBlockIsUsedOnce(DatFile file, string path)
    {
        byte[] bytes = File.ReadAllBytes(path);
        int blockSize = (int)file.Header.BlockSize;
        var used = new HashSet<uint>();
        foreach (DatEntry entry in file.Entries)
            Follow(entry.Offset, 0, (int)((entry.Size + blockSize - 5) / (blockSize - 4)));
        FollowNode(file.Header.RootNode);
        Follow(file.Header.FirstFreeBlock, BlockReader.FreeBit, (int)file.Header.FreeBlockCount);
        Assert.Equal((bytes.Length - 1024) / blockSize, used.Count);

        void FollowNode(uint offset)
        {
            Follow(offset, 0, (DirectoryNode.ByteSize + blockSize - 5) / (blockSize - 4));
            foreach (uint child in file.ReadNode(offset).Children)
                FollowNode(child);
        }

        void Follow(uint offset, uint bit, int blocks)
        {
            for (int i = 0; i < blocks; i++)
            {
                Assert.True(used.Add(offset), $"block 0x{offset:X} is used twice");
                uint link = BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan((int)offset));
                Assert.Equal(bit, link & BlockReader.FreeBit);
                offset = link & ~BlockReader.FreeBit;
            }

            Assert.Equal(0u, offset);
        }
    }
}
