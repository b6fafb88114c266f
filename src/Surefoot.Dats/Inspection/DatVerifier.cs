using System.Buffers;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>What became of one record in <see cref="DatVerifier"/>.</summary>
public enum DatVerifyOutcome
{
    /// <summary>Decoded, and encoded again to the same bytes.</summary>
    Identical,

    /// <summary>A kind that is carried as bytes; they could be read.</summary>
    Opaque,

    /// <summary>Decoded, but encoding gives other bytes.</summary>
    Different,

    /// <summary>Not readable.</summary>
    Failed,
}

/// <summary>One line of a verification.</summary>
/// <param name="File">Path of the file.</param>
/// <param name="Id">The record; 0 for the file as a whole.</param>
/// <param name="Type">Its kind.</param>
/// <param name="Size">Unpacked bytes.</param>
/// <param name="Outcome">What became of it.</param>
/// <param name="Message">Why, when it is not identical; empty otherwise.</param>
/// <param name="Remarks">What is odd but readable.</param>
public sealed record DatVerifyResult(
    string File, uint Id, DatRecordType Type, long Size, DatVerifyOutcome Outcome, string Message, IReadOnlyList<DatRemark> Remarks)
{
    /// <summary>Whether nothing is wrong.</summary>
    public bool IsGood => Outcome is DatVerifyOutcome.Identical or DatVerifyOutcome.Opaque;
}

/// <summary>How far a verification is.</summary>
/// <param name="Done">Records done.</param>
/// <param name="Total">Records in all.</param>
public readonly record struct DatVerifyProgress(int Done, int Total);

/// <summary>Reads, decodes and encodes again every record of files: <c>surefoot dats verify</c>.</summary>
public static class DatVerifier
{
    /// <summary>Verifies all files of a folder, lazily, a result a record. A damaged directory is a failed result with id 0.</summary>
    /// <param name="set">The folder.</param>
    /// <param name="progress">Called after each record, on the caller's thread; null for none.</param>
    /// <param name="cancellation">Ends the walk with an <see cref="OperationCanceledException"/>.</param>
    public static IEnumerable<DatVerifyResult> Verify(
        DatSet set, Action<DatVerifyProgress>? progress = null, CancellationToken cancellation = default)
        => Verify(set.Files, progress, cancellation);

    /// <inheritdoc cref="Verify(DatSet, Action{DatVerifyProgress}, CancellationToken)"/>
    public static IEnumerable<DatVerifyResult> Verify(
        IReadOnlyList<DatFile> files, Action<DatVerifyProgress>? progress = null, CancellationToken cancellation = default)
    {
        int done = 0, total = files.Sum(static file => file.Ids.Count);
        foreach (DatFile file in files)
        {
            foreach (DatRemark damage in file.Damage)
                yield return new(file.Path, 0, DatRecordType.Unknown, 0, DatVerifyOutcome.Failed, damage.ToString(), []);
            foreach (uint id in file.Ids)
            {
                cancellation.ThrowIfCancellationRequested();
                yield return Verify(file, id);
                progress?.Invoke(new(++done, total));
            }
        }
    }

    /// <summary>Verifies one record.</summary>
    public static DatVerifyResult Verify(DatFile file, uint id)
    {
        DatRecordType type = DatIds.RecordTypeOf(id, file.Kind);
        var remarks = new List<DatRemark>();
        DatVerifyResult Result(DatVerifyOutcome outcome, long size, string message = "")
            => new(file.Path, id, type, size, outcome, message, remarks);

        try
        {
            if (!file.TryRead(id, out ReadOnlySequence<byte> bytes))
                return Result(DatVerifyOutcome.Failed, 0, "there is no such record");
            DatRecord record = DatRecords.Decode(type, id, bytes, file.Path, remarks);
            if (record is RawRecord)
                return Result(DatVerifyOutcome.Opaque, bytes.Length);
            string difference = FirstDifference(bytes.ToArray(), record.Encode(), remarks);
            return Result(difference.Length == 0 ? DatVerifyOutcome.Identical : DatVerifyOutcome.Different, bytes.Length, difference);
        }
        catch (DatFormatException e)
        {
            return Result(DatVerifyOutcome.Failed, 0, e.Message);
        }
    }

    // Alignment is skipped without looking and written as zeros, so what was in it does not count.
    private static string FirstDifference(byte[] stored, byte[] encoded, List<DatRemark> remarks)
    {
        foreach (DatRemark remark in remarks)
        {
            if (remark.Message == DatReader.PaddingRemark)
                stored[remark.Offset] = 0;
        }

        if (stored.AsSpan().SequenceEqual(encoded))
            return string.Empty;
        int offset = stored.AsSpan().CommonPrefixLength(encoded);
        return $"{stored.Length} stored bytes and {encoded.Length} encoded bytes differ from offset 0x{offset:X} on";
    }
}
