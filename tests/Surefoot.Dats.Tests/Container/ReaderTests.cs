using System.Buffers;
using System.Buffers.Binary;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Opening and reading files.</summary>
public sealed class ReaderTests
{
    [Fact]
    [Behaviour("dats.open.mini-headers", "data/dat-samples/README.md")]
    public void Headers_of_the_sample_files()
    {
        using var portal = DatFile.Open(Path.Combine(TestData.Mini, DatSet.PortalName));
        using var cell = DatFile.Open(Path.Combine(TestData.Mini, DatSet.CellName));
        using var local = DatFile.Open(Path.Combine(TestData.Mini, DatSet.LocalName));
        using var highRes = DatFile.Open(Path.Combine(TestData.Mini, DatSet.HighResName));

        AssertHeader(portal, DatFileKind.Portal, 96256, 1024, 1, 0, 26, 0x8000, 0x8800, 0x17400);
        AssertHeader(cell, DatFileKind.Cell, 48640, 256, 2, 1, 105, 0x7B00, 0x8200, 0xBD00);
        AssertHeader(local, DatFileKind.Local, 65536, 1024, 3, 1, 1, 0x800, 0x1000, 0xFC00);
        AssertHeader(highRes, DatFileKind.HighRes, 66560, 1024, 1, 0x69466948, 2, 0xC00, 0x1400, 0x10000);
        DirectoryNode root = cell.ReadNode(cell.Header.RootNode);
        Assert.Equal(new DatEntry(0, 2, 0xA9B2FFFF, 0x3800, 252, 0x6A000000, 1), Assert.Single(root.Entries));
        Assert.Equal([0x6D00u, 0x7400u], root.Children);
        Assert.All(root.Children, child => Assert.Equal(52, cell.ReadNode(child).Entries.Count));

        static void AssertHeader(
            DatFile file, DatFileKind kind, uint size, uint block, uint type, uint subset, int entries, uint root, uint firstFree,
            uint lastFree)
        {
            Assert.Equal(kind, file.Kind);
            Assert.Equal((size, block, type, subset),
                (file.Header.FileSize, file.Header.BlockSize, file.Header.FileType, file.Header.Subset));
            Assert.Equal((root, firstFree, lastFree, 60u),
                (file.Header.RootNode, file.Header.FirstFreeBlock, file.Header.LastFreeBlock, file.Header.FreeBlockCount));
            Assert.Equal(entries, file.Ids.Count);
            Assert.Empty(file.Damage);
            Assert.Empty(file.Remarks);
            Assert.All(file.Entries, entry => Assert.Equal(0x6A000000u, entry.Date));
        }
    }

    [Fact]
    [Behaviour("dats.open.other-writers", "spec/07, section 8 (0xCDCDCDCD leaves, root 0, no iteration record)")]
    public void Files_of_another_writer_are_read_with_remarks()
    {
        string folder = Path.Combine(TestData.Root, "worlds", "first");
        using var local = DatFile.Open(Path.Combine(folder, DatSet.LocalName));
        using var portal = DatFile.Open(Path.Combine(folder, DatSet.PortalName));

        Assert.Equal(0u, local.Header.RootNode);
        Assert.Empty(local.Ids);
        Assert.Equal(1u, portal.Header.GameVersion);
        Assert.Empty(portal.Damage);
        Assert.Contains(portal.Remarks, remark => remark.RecordId == DatIds.Iteration);
        Assert.Equal([DatIds.Region], portal.IdsOf(DatRecordType.Region));
        Assert.Contains(0x02000001u, portal.IdsOf(DatRecordType.Setup));
    }

    [Fact]
    [Behaviour("dats.open.lazy", "design.md")]
    public void Opening_a_file_of_a_gigabyte_and_a_half_reads_its_directory_only()
    {
        using var folder = new TempFolder();
        string path = folder.File(DatSet.CellName);
        const long length = 3L << 29;
        const uint acrossTheWindows = (1u << 30) - 100;
        byte[] bytes = File.ReadAllBytes(Path.Combine(TestData.Mini, DatSet.CellName));
        byte[] block = bytes[0x3800..0x3900];
        Patch(bytes, EntryOffset(bytes, 0xA9B2FFFF) + 8, acrossTheWindows);
        using (var stream = new FileStream(path, FileMode.CreateNew))
        {
            stream.Write(bytes);
            stream.SetLength(length);
            stream.Position = acrossTheWindows;
            stream.Write(block);
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        using var file = DatFile.Open(path);
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        // Three nodes of seven blocks.
        Assert.Equal(21, file.BlocksRead);
        Assert.InRange(allocated, 0, 1_000_000);
        Assert.Equal(105, file.Ids.Count);
        Assert.Equal(10, file.Read<LandBlock>(0xA9B2FFFF).Heights[0]);
        Assert.Equal(22, file.BlocksRead);
    }

    [Fact]
    [Behaviour("dats.read.no-copy", "design.md")]
    public void Reading_a_record_copies_none_of_its_bytes()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        var record = new byte[1 << 20];
        Random.Shared.NextBytes(record);
        new DatFileWriter(path, DatFileKind.Portal).Add(1, record).Add(2, [1, 2, 3]).Complete();
        using var file = DatFile.Open(path);
        Assert.True(file.TryRead(1, out _));

        long before = GC.GetAllocatedBytesForCurrentThread();
        Assert.True(file.TryRead(1, out ReadOnlySequence<byte> bytes));
        long allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        // A link of the chain for each block of 1020 bytes, but not the bytes.
        Assert.InRange(allocated, 0, record.Length / 8);
        Assert.Equal(record, bytes.ToArray());
        before = GC.GetAllocatedBytesForCurrentThread();
        file.TryRead(2, out _);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    [Fact]
    [Behaviour("dats.read.compressed", "spec/07, 4.4, 10.3")]
    public void A_compressed_record_is_unpacked()
    {
        using var file = DatFile.Open(Path.Combine(TestData.Mini, DatSet.HighResName));

        Assert.True(file.TryGetEntry(0x06000002, out DatEntry entry));
        Assert.True(entry.IsCompressed);
        Assert.Equal(33u, entry.Size);
        Assert.Equal(
            "2000000078DA6362606063000226206604E25420660109007940" + "3E0B0007E0007B",
            Convert.ToHexString(file.ReadStored(entry).ToArray()));
        Assert.True(file.TryRead(0x06000002, out ReadOnlySequence<byte> bytes));
        Assert.Equal(TestData.SampleBytes("rendersurface-06000002"), bytes.ToArray());
    }

    [Theory]
    [InlineData("0100000078DA")]
    [InlineData("FFFFFFFF78DA6362606063000226206604E254206601")]
    [InlineData("0000000F78DA6362606063000226206604E254206601")]
    [InlineData("2100000078DA6362606063000226206604E254206601090079403E0B0007E0007B")]
    [InlineData("1F00000078DA6362606063000226206604E254206601090079403E0B0007E0007B")]
    [InlineData("2000000078DA6362606063000226206604E254206601090079403E0B0007E0007C")]
    [InlineData("20000000FFDA6362606063000226206604E254206601090079403E0B0007E0007B")]
    [InlineData("2000000078DA6362606063000226206604E2")]
    [Behaviour("dats.read.compressed-damaged", "spec/07, 4.4")]
    public void A_damaged_compressed_record_is_a_format_error(string stored)
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.HighRes).AddStored(0x06000002, Convert.FromHexString(stored), 1).Complete();
        using var file = DatFile.Open(path);

        long before = GC.GetAllocatedBytesForCurrentThread();
        var error = Assert.Throws<DatFormatException>(() => file.TryRead(0x06000002, out _));

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1_000_000);
        Assert.Equal((path, 0x06000002u), (error.File, error.RecordId));
    }

    [Fact]
    [Behaviour("dats.read.compressed-writing", "spec/07, 4.4")]
    public void Compression_is_only_kept_where_it_is_smaller()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        byte[] noise = new byte[100], plain = new byte[100];
        Random.Shared.NextBytes(noise);
        new DatFileWriter(path, DatFileKind.HighRes).Add(1, noise, compress: true).Add(2, plain, compress: true).Add(3, plain).Add(4,
            new byte[16], compress: true).Complete();
        using var file = DatFile.Open(path);
        Assert.Equal([false, true, false, false, false], file.Entries.Select(e => e.IsCompressed));
        Assert.True(file.TryRead(2, out ReadOnlySequence<byte> bytes));
        Assert.Equal(plain, bytes.ToArray());
    }

    [Fact]
    [Behaviour("dats.read.concurrent", "design.md")]
    public void Many_threads_read_the_same_file()
    {
        using var file = DatFile.Open(Path.Combine(TestData.Root, "worlds", "oracle", DatSet.PortalName));
        string[] expected = [.. file.Ids.Select(Content)];

        Parallel.For(0, 20 * file.Ids.Count, i =>
        {
            int index = i * 31 % file.Ids.Count;
            Assert.Equal(expected[index], Content(file.Ids[index]));
        });

        string Content(uint id)
        {
            Assert.True(file.TryRead(id, out ReadOnlySequence<byte> bytes));
            return Convert.ToHexString(DatRecords.Decode(DatIds.RecordTypeOf(id, file.Kind), id, bytes).Encode());
        }
    }

    [Fact]
    [Behaviour("dats.read.pinned", "design.md: bytes of a record are memory of the mapped file")]
    public void A_record_can_be_pinned_and_handed_to_the_system_as_it_lies_in_the_file()
    {
        var file = DatFile.Open(Path.Combine(TestData.Mini, DatSet.PortalName));
        Assert.True(file.TryRead(0x01000011, out ReadOnlySequence<byte> bytes));
        ReadOnlyMemory<byte> memory = bytes.First;
        using var folder = new TempFolder();
        using (var copy = File.OpenHandle(folder.File("copy"), FileMode.Create, FileAccess.Write))
            RandomAccess.Write(copy, [memory[..3], memory[3..]], 0);
        Assert.Equal(TestData.SampleBytes("gfxobj-01000011"), File.ReadAllBytes(folder.File("copy")));
        file.Dispose();
        Assert.Throws<ObjectDisposedException>(() => memory.Pin());
    }

    [Fact]
    [Behaviour("dats.open.iteration-version", "spec/07, 4.5: the iteration record has entry version 1")]
    public void An_iteration_record_that_retail_would_not_take_is_remarked_on()
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        new DatFileWriter(path, DatFileKind.Portal).Complete();
        byte[] bytes = File.ReadAllBytes(path);
        byte[] entry = [0, 0, 1, 0, .. BitConverter.GetBytes(DatIds.Iteration)];
        bytes[bytes.AsSpan().IndexOf(entry) + 2] = 2;
        File.WriteAllBytes(path, bytes);
        using var file = DatFile.Open(path);
        DatRemark remark = Assert.Single(file.Remarks);
        Assert.Equal(DatIds.Iteration, remark.RecordId);
        Assert.Contains("entry version 2", remark.Message, StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("dats.read.empty", "spec/07, 4.2: a chain of size 0 has no block")]
    public void A_record_of_size_0_has_no_bytes()
    {
        byte[] bytes = File.ReadAllBytes(Path.Combine(TestData.Mini, DatSet.PortalName));
        Patch(bytes, EntryOffset(bytes, 0x01000011) + 12, 0);
        using var folder = new TempFolder();
        File.WriteAllBytes(folder.File("x.dat"), bytes);
        using var file = DatFile.Open(folder.File("x.dat"));
        Assert.True(file.TryRead(0x01000011, out ReadOnlySequence<byte> record));
        Assert.True(record.IsEmpty);
    }

    [Fact]
    [Behaviour("dats.verify.missing-record", "design.md, decision 7")]
    public void Verifying_a_record_that_is_not_there_says_so()
    {
        using var file = DatFile.Open(Path.Combine(TestData.Mini, DatSet.PortalName));
        DatVerifyResult result = DatVerifier.Verify(file, 0x0100FFFF);
        Assert.Equal((DatVerifyOutcome.Failed, "there is no such record"), (result.Outcome, result.Message));
    }

    [Fact]
    [Behaviour("dats.read.id-zero", "spec/07, 5.3")]
    public void Id_zero_and_unknown_ids_are_not_found()
    {
        using var file = DatFile.Open(Path.Combine(TestData.Mini, DatSet.PortalName));
        Assert.False(file.TryRead(0, out ReadOnlySequence<byte> none));
        Assert.True(none.IsEmpty);
        Assert.False(file.TryRead(0x01000002, out _));
        var error = Assert.Throws<DatRecordMissingException>(() => file.Read<GfxObj>(0x01000002, requestedBy: 0x02000001));
        Assert.Contains("0x01000002", error.Message, StringComparison.Ordinal);
        Assert.Contains("0x02000001", error.Message, StringComparison.Ordinal);
        Assert.False(file.TryRead<Scene>(0x01000001, out _));
    }

    [Fact]
    [Behaviour("dats.read.after-dispose", "design, decision 7")]
    public void After_Dispose_reading_fails_instead_of_crashing()
    {
        var file = DatFile.Open(Path.Combine(TestData.Mini, DatSet.PortalName));
        Assert.True(file.TryRead(0x01000001, out ReadOnlySequence<byte> bytes));
        file.Dispose();
        file.Dispose();
        Assert.Throws<ObjectDisposedException>(() => file.TryRead(0x01000001, out _));
        Assert.Throws<ObjectDisposedException>(() => bytes.ToArray());
    }

    [Fact]
    [Behaviour("dats.source.any-library", "design.md")]
    public void Any_source_of_bytes_gives_typed_records()
    {
        IDatSource source = new OneRecord(0x12000001, TestData.SampleBytes("scene-12000001"));
        Assert.Equal(0.75f, source.Read<Scene>(0x12000001).Objects[0].Frequency);
        Assert.False(source.TryRead<Scene>(0x12000002, out Scene? none));
        Assert.Null(none);
    }

    internal static void Patch(byte[] bytes, int offset, uint value) =>
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(offset), value);

    // Where the entry of an id lies: 4 bytes before the first occurrence of the id behind version 2.
    internal static int EntryOffset(byte[] bytes, uint id)
    {
        byte[] pattern = [0, 0, 2, 0, .. BitConverter.GetBytes(id)];
        return bytes.AsSpan().IndexOf(pattern);
    }

    private sealed class OneRecord(uint only, byte[] content) : IDatSource
    {
        public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
        {
            bytes = id == only ? new(content) : default;
            return id == only;
        }
    }
}
