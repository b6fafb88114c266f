using System.Buffers;
using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Whole files (spec 07, 5.1).</summary>
public sealed class WriterTests
{
    private static readonly DatFileOptions MiniOptions = new() { Date = 0x6A000000 };

    public static TheoryData<string, DatFileKind> Mini { get; } = new()
    {
        { DatSet.PortalName, DatFileKind.Portal },
        { DatSet.CellName, DatFileKind.Cell },
        { DatSet.LocalName, DatFileKind.Local },
        { DatSet.HighResName, DatFileKind.HighRes },
    };

    [Theory]
    [MemberData(nameof(Mini))]
    [Behaviour("dats.writer.byte-for-byte", "spec/07, 5.1, 10.3; data/dat-samples/mini")]
    public void The_sample_files_are_reproduced_byte_for_byte(string name, DatFileKind kind)
    {
        using var folder = new TempFolder();
        string sample = Path.Combine(TestData.Mini, name), written = folder.File(name);
        var writer = new DatFileWriter(written, kind, MiniOptions);
        using (var file = DatFile.Open(sample))
        {
            foreach (DatEntry entry in file.Entries)
            {
                if (entry.Id == DatIds.Iteration)
                    continue;
                if (entry.IsCompressed)
                    writer.AddStored(entry.Id, file.ReadStored(entry).ToArray(), entry.Flags);
                else
                    writer.Add(DatRecords.Decode(file, entry.Id));
            }
        }

        writer.Complete();

        Assert.Equal(File.ReadAllBytes(sample), File.ReadAllBytes(written));
    }

    [Fact]
    [Behaviour("dats.writer.round-trip", "design.md")]
    public void What_is_written_is_read()
        => Gen.Select(
            Gen.Select(Gen.UInt[1, 0xFFFF0000], Gen.Byte.Array[1, 700]).Array[0, 200],
            Gen.Int[64, 1024],
            Gen.Bool,
            (records, blockSize, compress) => (Records: records, BlockSize: blockSize, Compress: compress)).Sample(
            sample =>
            {
                using var folder = new TempFolder();
                string path = folder.File("x.dat");
                var expected = new SortedDictionary<uint, byte[]>();
                var writer = new DatFileWriter(path, DatFileKind.Portal, new() { BlockSize = sample.BlockSize });
                foreach (var (id, bytes) in sample.Records)
                {
                    // Half of them repeat, so that compression has something to do.
                    if (bytes[0] < 128)
                        Array.Fill(bytes, bytes[0]);
                    if (expected.TryAdd(id, bytes))
                        writer.Add(id, bytes, sample.Compress);
                }

                writer.Complete();

                using var file = DatFile.Open(path);
                Assert.Empty(file.Damage);
                Assert.Empty(file.Remarks);
                Assert.Equal([.. expected.Keys, DatIds.Iteration], file.Ids);
                foreach (var (id, bytes) in expected)
                {
                    Assert.True(file.TryRead(id, out ReadOnlySequence<byte> read));
                    Assert.Equal(bytes, read.ToArray());
                }
            },
            iter: Fuzz.Cases(60));

    [Theory]
    [InlineData(1)]
    [InlineData(60)]
    [InlineData(61)]
    [InlineData(62)]
    [InlineData(3842)]
    [InlineData(3843)]
    [InlineData(5000)]
    [Behaviour("dats.writer.tree-shape", "spec/07, 5.1, 4.3")]
    public void Every_node_but_the_root_has_30_to_61_entries_and_leaves_lie_level(int records)
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        var writer = new DatFileWriter(path, DatFileKind.Portal, new() { BlockSize = 64 });
        for (uint id = 1; id <= records; id++)
            writer.Add(id, [1]);
        writer.Complete();

        using var file = DatFile.Open(path);
        Assert.Equal(records + 1, file.Ids.Count);
        var depths = new HashSet<int>();
        Walk(file.Header.RootNode, 0);
        Assert.Single(depths);

        void Walk(uint offset, int depth)
        {
            DirectoryNode node = file.ReadNode(offset);
            Assert.InRange(node.Entries.Count, depth == 0 ? 0 : 30, 61);
            if (node.IsLeaf)
                depths.Add(depth);
            else
                Assert.Equal(node.Entries.Count + 1, node.Children.Count);
            foreach (uint child in node.Children)
                Walk(child, depth + 1);
        }
    }

    [Fact]
    [Behaviour("dats.writer.deterministic", "design, decision 5")]
    public void The_same_records_in_any_order_give_the_same_bytes()
    {
        using var folder = new TempFolder();
        string a = folder.File("a.dat"), b = folder.File("b.dat");
        uint[] ids = [.. Enumerable.Range(1, 200).Select(i => (uint)(i * 7919 % 10007))];
        var first = new DatFileWriter(a, DatFileKind.Portal);
        var second = new DatFileWriter(b, DatFileKind.Portal);
        foreach (uint id in ids)
            first.Add(id, BitConverter.GetBytes(id));
        foreach (uint id in ids.Reverse())
            second.Add(id, BitConverter.GetBytes(id));
        first.Complete();
        second.Complete();
        Assert.Equal(File.ReadAllBytes(a), File.ReadAllBytes(b));
    }

    [Fact]
    [Behaviour("dats.writer.header", "spec/07, 4.1, 4.5, 10.3")]
    public void An_empty_local_file_has_an_iteration_record_and_sixty_free_blocks()
    {
        using var folder = new TempFolder();
        string path = folder.File(DatSet.LocalName);
        new DatFileWriter(path, DatFileKind.Local).Complete();

        using var file = DatFile.Open(path);
        DatHeader header = file.Header;
        Assert.Equal((1024u, 65536u, 3u, 1u), (header.BlockSize, header.FileSize, header.FileType, header.Subset));
        Assert.Equal((0x1000u, 0xFC00u, 60u, 0x800u),
            (header.FirstFreeBlock, header.LastFreeBlock, header.FreeBlockCount, header.RootNode));
        Assert.Equal((110u, 0u, 1u), (header.EngineVersion, header.GameVersion, header.MinorVersion));
        Assert.Equal([new DatEntry(0, 1, 0xFFFF0001, 0x400, 12, 0, 0)], file.Entries);
        Assert.Equal([-1, 1], ((IterationRecord)DatRecords.Decode(file, DatIds.Iteration)).Words);
        Assert.Equal(Convert.FromHexString("00504C0000"), File.ReadAllBytes(path)[0x100..0x105]);
    }

    [Fact]
    [Behaviour("dats.writer.replaces-whole", "spec/07, 4.6 (temporary name and rename)")]
    public void An_existing_file_is_replaced_and_nothing_else_is_left()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        File.WriteAllText(path, "old");
        new DatFileWriter(path, DatFileKind.Cell).Complete();
        Assert.Equal([path], Directory.GetFiles(folder.Path));
        using var file = DatFile.Open(path);
        Assert.Equal(DatFileKind.Cell, file.Kind);
    }

    [Fact]
    [Behaviour("dats.writer.refuses", "spec/07, 5.1")]
    public void Wrong_records_are_refused()
    {
        var writer = new DatFileWriter("never.dat", DatFileKind.Cell).Add(1, [1]);
        Assert.Throws<ArgumentException>(() => writer.Add(0, [1]));
        Assert.Throws<ArgumentException>(() => writer.Add(1, [1]));
        Assert.Throws<ArgumentException>(() => writer.Add(2, []));
        Assert.Throws<ArgumentException>(() => writer.Add(DatIds.Iteration, [1]));
        Assert.Throws<ArgumentException>(() => writer.Add(new Scene { Id = 0x12000001 }));
        Assert.Throws<ArgumentException>(() => new DatFileWriter("x", DatFileKind.Cell, new() { FreeBlocks = 51 }));
        Assert.Throws<ArgumentException>(() => new DatFileWriter("x", DatFileKind.Cell, new() { BlockSize = 63 }));
        Assert.Throws<ArgumentException>(() => new DatFileWriter("x", DatFileKind.Cell, new() { Iterations = 0 }));
    }
}
