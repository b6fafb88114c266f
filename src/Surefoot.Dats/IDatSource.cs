using System.Buffers;

namespace Surefoot.Dats;

/// <summary>Where record bytes come from: one question, id to bytes. Implement it to plug in any other dat library.</summary>
/// <remarks>Implementations must be safe to call from several threads at once.</remarks>
public interface IDatSource
{
    /// <summary>Finds the bytes of one record, unpacked, the leading id (where the kind has one) included.</summary>
    /// <param name="id">Record id, e.g. 0x01000001 or 0xA9B4FFFF.</param>
    /// <param name="bytes">The record; empty when the answer is false. May be a chain of segments over a memory map.</param>
    /// <returns>False when there is no such record.</returns>
    /// <exception cref="DatFormatException">The record is listed but its blocks cannot be followed or unpacked.</exception>
    bool TryRead(uint id, out ReadOnlySequence<byte> bytes);
}
