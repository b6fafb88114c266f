using System.Buffers;
using CsCheck;

namespace Surefoot.Dats.Tests;

/// <summary>
/// Files that are broken: reported, never another exception than <see cref="DatFormatException"/>, a hang or endless memory.
/// </summary>
public sealed class DamagedFileTests
{
    private const uint Slab = 0x01000010;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(0x18F)]
    [Behaviour("dats.open.too-short", "spec/07, 4.1, 4.2, 5.4")]
    public void A_file_shorter_than_its_header_is_a_format_error(int length)
    {
        byte[] bytes = Mini(DatSet.PortalName)[..length];
        var error = Assert.Throws<DatFormatException>(() => Open(bytes, _ => { }));
        Assert.Null(error.RecordId);
    }

    [Theory]
    [InlineData(0x140, 0x5443u)]
    [InlineData(0x144, 63u)]
    [InlineData(0x144, 0u)]
    [InlineData(0x144, 0xFFFFFFFFu)]
    [InlineData(0x14C, 0u)]
    [InlineData(0x14C, 4u)]
    [InlineData(0x160, 0x100u)]
    [InlineData(0x160, 0x7FFFFFFFu)]
    [Behaviour("dats.open.wrong-header", "spec/07, 4.1, 4.2, 5.4")]
    public void A_wrong_header_is_a_format_error_that_says_where(int offset, uint value)
    {
        byte[] bytes = Mini(DatSet.PortalName);
        ReaderTests.Patch(bytes, offset, value);
        var error = Assert.Throws<DatFormatException>(() => Open(bytes, _ => { }));
        Assert.Equal(offset, error.Offset);
    }

    [Fact]
    [Behaviour("dats.chain.ends-early", "spec/07, 4.1, 4.2, 5.4")]
    public void A_chain_that_ends_early_is_a_format_error()
        => AssertRecordError(bytes => ReaderTests.Patch(bytes, First(bytes, 0x0D000001), 0), 0x0D000001, "ends");

    [Fact]
    [Behaviour("dats.chain.free-block", "spec/07, 4.1, 4.2, 5.4")]
    public void A_chain_into_a_free_block_is_a_format_error()
        => AssertRecordError(bytes => ReaderTests.Patch(bytes, First(bytes, 0x0D000001), 0x80001000), 0x0D000001, "free block");

    [Fact]
    [Behaviour("dats.chain.loop", "spec/07, 4.1, 4.2, 5.4")]
    public void A_chain_that_comes_back_is_a_format_error()
        => AssertRecordError(
            bytes => ReaderTests.Patch(bytes, First(bytes, 0x0D000001), (uint)First(bytes, 0x0D000001)), 0x0D000001, "comes back");

    [Fact]
    [Behaviour("dats.chain.outside", "spec/07, 4.1, 4.2, 5.4")]
    public void A_chain_that_leaves_the_file_is_a_format_error()
        => AssertRecordError(bytes => ReaderTests.Patch(bytes, First(bytes, 0x0D000001), (uint)bytes.Length - 2), 0x0D000001, "outside");

    [Theory]
    [InlineData(0u)]
    [InlineData(0xFFFFFFFFu)]
    [Behaviour("dats.chain.offset-outside", "spec/07, 4.1, 4.2, 5.4")]
    public void An_entry_that_points_outside_is_a_format_error(uint offset)
        => AssertRecordError(bytes => ReaderTests.Patch(bytes, ReaderTests.EntryOffset(bytes, Slab) + 8, offset), Slab, "outside");

    [Fact]
    [Behaviour("dats.chain.huge-size", "design.md")]
    public void A_huge_size_is_a_format_error()
        => AssertRecordError(bytes => ReaderTests.Patch(bytes, ReaderTests.EntryOffset(bytes, Slab) + 12, 0xFFFFFFFF), Slab, "do not fit");

    [Fact]
    [Behaviour("dats.chain.longer-than-needed", "spec/07, 4.2 (ignore the last link)")]
    public void The_last_link_of_a_chain_is_ignored()
    {
        byte[] bytes = Mini(DatSet.PortalName);
        ReaderTests.Patch(bytes, First(bytes, Slab), 0x12345678);
        Open(bytes, file =>
        {
            Assert.True(file.TryRead(Slab, out ReadOnlySequence<byte> record));
            Assert.Equal(TestData.SampleBytes("gfxobj-01000010"), record.ToArray());
        });
    }

    [Fact]
    [Behaviour("dats.directory.out-of-order", "spec/07, 4.1, 4.2, 5.4")]
    public void A_subtree_out_of_order_is_reported_and_the_rest_is_read()
    {
        byte[] bytes = Mini(DatSet.CellName);

        // The first id of the left leaf, in its second block, becomes greater than the second.
        ReaderTests.Patch(bytes, 0x6E00 + 4 + 4, 0xA9B1FFFF);
        Open(bytes, file =>
        {
            DatRemark damage = Assert.Single(file.Damage);
            Assert.Equal(0x6D00, damage.Offset);
            Assert.Equal(53, file.Ids.Count);
            DatVerifyResult failure = Assert.Single(DatVerifier.Verify([file]), result => !result.IsGood);
            Assert.Equal((0u, DatVerifyOutcome.Failed), (failure.Id, failure.Outcome));
            Assert.Contains("0x6D00", failure.Message, StringComparison.Ordinal);
        });
    }

    [Fact]
    [Behaviour("dats.directory.beyond-separator", "spec/07, 4.1, 4.2, 5.4")]
    public void A_subtree_beyond_its_separator_is_reported()
    {
        byte[] bytes = Mini(DatSet.CellName);
        ReaderTests.Patch(bytes, 0x7C00 + 4 + 4, 0xA9B00000);
        Open(bytes, file => Assert.Equal(0x6D00, Assert.Single(file.Damage).Offset));
    }

    [Theory]
    [InlineData(62u)]
    [InlineData(0xFFFFFFFFu)]
    [Behaviour("dats.directory.count", "spec/07, 4.1, 4.2, 5.4")]
    public void A_node_with_too_many_entries_is_reported(uint count)
    {
        byte[] bytes = Mini(DatSet.PortalName);
        ReaderTests.Patch(bytes, 0x8000 + 4 + 0xF8, count);
        Open(bytes, file =>
        {
            Assert.Equal(0x8000, Assert.Single(file.Damage).Offset);
            Assert.Empty(file.Ids);
        });
    }

    [Fact]
    [Behaviour("dats.directory.loop", "spec/07, 4.1, 4.2, 5.4")]
    public void A_node_that_is_its_own_child_is_reported()
    {
        byte[] bytes = Mini(DatSet.CellName);
        ReaderTests.Patch(bytes, 0x7B00 + 4, 0x7B00);
        Open(bytes, file =>
        {
            Assert.Contains("twice", Assert.Single(file.Damage).Message, StringComparison.Ordinal);
            Assert.Equal(53, file.Ids.Count);
        });
    }

    [Fact]
    [Behaviour("dats.directory.too-deep", "spec/07, 4.1, 4.2, 5.4")]
    public void A_directory_deeper_than_8_is_reported()
    {
        // Ten nodes without entries, each the only child of the one before, in blocks that hold a whole node.
        const int blockSize = 2048;
        byte[] bytes = new byte[1024 + (10 * blockSize)];
        Mini(DatSet.PortalName)[..0x190].CopyTo(bytes, 0);
        ReaderTests.Patch(bytes, 0x144, blockSize);
        ReaderTests.Patch(bytes, 0x160, 1024);
        for (int i = 0; i < 9; i++)
            ReaderTests.Patch(bytes, 1024 + (i * blockSize) + 4, (uint)(1024 + ((i + 1) * blockSize)));
        Open(bytes, file => Assert.Contains("deeper", Assert.Single(file.Damage).Message, StringComparison.Ordinal));
    }

    [Fact]
    [Behaviour("dats.file.one-byte", "design.md")]
    public void Any_wrong_byte_of_a_file_is_a_value_or_a_format_error()
        => Gen.Select(RecordGen.Among(DatSet.PortalName, DatSet.CellName, DatSet.HighResName), Gen.Int[0, 0x8800], Gen.Byte,
            Gen.Bool).Sample(
            (name, place, value, inHeader) =>
            {
                byte[] bytes = Mini(name);
                bytes[inHeader ? 0x100 + (place % 0x90) : place] = value;
                try
                {
                    Open(bytes, file => Assert.All(DatVerifier.Verify([file]), result => Assert.NotNull(result.Message)));
                }
                catch (DatFormatException e)
                {
                    Assert.NotEmpty(e.File);
                }
            },
            iter: Fuzz.Cases(150));

    [Fact]
    [Behaviour("dats.file.truncated", "design.md")]
    public void A_file_cut_anywhere_is_a_value_or_a_format_error()
        => Gen.Select(RecordGen.Among(DatSet.PortalName, DatSet.CellName, DatSet.HighResName), Gen.Int[1, 0x8800]).Sample(
            (name, length) =>
            {
                try
                {
                    Open(Mini(name)[..length], file => Assert.All(DatVerifier.Verify([file]), result => Assert.NotNull(result.Message)));
                }
                catch (DatFormatException e)
                {
                    Assert.NotEmpty(e.File);
                }
            },
            iter: Fuzz.Cases(100));

    [Fact]
    [Behaviour("dats.verify.says-what-is-wrong", "design.md")]
    public void Verifying_names_record_and_reason_and_reports_progress()
    {
        byte[] bytes = Mini(DatSet.PortalName);
        bytes[First(bytes, Slab) + 4 + 0x0D] = 2;
        Open(bytes, file =>
        {
            var progress = new List<DatVerifyProgress>();
            DatVerifyResult bad = Assert.Single(DatVerifier.Verify([file], progress.Add), result => !result.IsGood);
            Assert.Equal((Slab, DatRecordType.GfxObj, DatVerifyOutcome.Failed), (bad.Id, bad.Type, bad.Outcome));
            Assert.Contains("vertex type 2", bad.Message, StringComparison.Ordinal);
            Assert.Equal(Enumerable.Range(1, 26).Select(i => new DatVerifyProgress(i, 26)), progress);
            using var cancelled = new CancellationTokenSource();
            cancelled.Cancel();
            Assert.Throws<OperationCanceledException>(() => DatVerifier.Verify([file], null, cancelled.Token).Count());
        });
    }

    private static byte[] Mini(string name) => File.ReadAllBytes(Path.Combine(TestData.Mini, name));

    // Offset of the first block of a record.
    private static int First(byte[] bytes, uint id) => BitConverter.ToInt32(bytes, ReaderTests.EntryOffset(bytes, id) + 8);

    private static void AssertRecordError(Action<byte[]> damage, uint id, string reason)
    {
        byte[] bytes = Mini(DatSet.PortalName);
        damage(bytes);
        Open(bytes, file =>
        {
            var error = Assert.Throws<DatFormatException>(() => file.TryRead(id, out _));
            Assert.Equal((file.Path, id), (error.File, error.RecordId));
            Assert.Contains(reason, error.Message, StringComparison.Ordinal);
        });
    }

    private static void Open(byte[] bytes, Action<DatFile> use)
    {
        using var folder = new TempFolder();
        string path = folder.File("x.dat");
        File.WriteAllBytes(path, bytes);
        using var file = DatFile.Open(path);
        use(file);
    }
}
