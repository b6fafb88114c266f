using System.Globalization;

namespace Surefoot.Dats;

/// <summary>Bytes that are no dat file or no record: says which file, which record and where.</summary>
public sealed class DatFormatException : Exception
{
    /// <summary>Creates the error.</summary>
    /// <param name="file">Name or path of the file; empty when the bytes came from elsewhere.</param>
    /// <param name="recordId">The record being read; null when the container itself is at fault.</param>
    /// <param name="offset">Bytes from the start of the record, or of the file when <paramref name="recordId"/> is null.</param>
    /// <param name="message">What is wrong there.</param>
    /// <param name="inner">The cause, where there is one.</param>
    public DatFormatException(string file, uint? recordId, long offset, string message, Exception? inner = null)
        : base(Compose(file, recordId, offset, message), inner)
    {
        File = file;
        RecordId = recordId;
        Offset = offset;
        Reason = message;
    }

    /// <summary>Name or path of the file; empty when the bytes came from elsewhere.</summary>
    public string File { get; }

    /// <summary>The record being read; null when the container itself is at fault.</summary>
    public uint? RecordId { get; }

    /// <summary>Bytes from the start of the record, or of the file when <see cref="RecordId"/> is null.</summary>
    public long Offset { get; }

    /// <summary>What is wrong, without the place.</summary>
    public string Reason { get; }

    private static string Compose(string file, uint? recordId, long offset, string message)
    {
        string name = file.Length == 0 ? "(bytes)" : file;
        return recordId is uint id
            ? string.Create(CultureInfo.InvariantCulture, $"{name}, record 0x{id:X8}, offset 0x{offset:X}: {message}")
            : string.Create(CultureInfo.InvariantCulture, $"{name}, file offset 0x{offset:X}: {message}");
    }
}
