namespace Surefoot.Dats;

/// <summary>Something odd in a file that does not stop reading it.</summary>
/// <param name="RecordId">The record; null when the container is meant.</param>
/// <param name="Offset">Bytes from the start of the record, or of the file when <paramref name="RecordId"/> is null.</param>
/// <param name="Message">What is odd.</param>
public readonly record struct DatRemark(uint? RecordId, long Offset, string Message)
{
    /// <inheritdoc/>
    public override string ToString()
        => RecordId is uint id ? $"record 0x{id:X8}, offset 0x{Offset:X}: {Message}" : $"file offset 0x{Offset:X}: {Message}";
}
