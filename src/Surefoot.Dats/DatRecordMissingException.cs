namespace Surefoot.Dats;

/// <summary>A record that is needed is in none of the files (spec 07, 9.1).</summary>
public sealed class DatRecordMissingException : Exception
{
    /// <summary>Creates the error.</summary>
    /// <param name="id">The id that was not found.</param>
    /// <param name="type">The kind that was wanted.</param>
    /// <param name="requestedBy">The record that names it; null when the caller asked by itself.</param>
    public DatRecordMissingException(uint id, DatRecordType type, uint? requestedBy = null)
        : base($"{type} 0x{id:X8} is not in the dat files" + (requestedBy is uint by ? $"; record 0x{by:X8} asks for it." : "."))
    {
        Id = id;
        Type = type;
        RequestedBy = requestedBy;
    }

    /// <summary>The id that was not found.</summary>
    public uint Id { get; }

    /// <summary>The kind that was wanted.</summary>
    public DatRecordType Type { get; }

    /// <summary>The record that names it; null when the caller asked by itself.</summary>
    public uint? RequestedBy { get; }
}
