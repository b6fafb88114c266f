using System.Buffers;

namespace Surefoot.Dats;

/// <summary>A source that can tell a cell id from an equal portal id when the kind is known, and names the file for errors.</summary>
internal interface ITypedDatSource
{
    bool TryRead(uint id, DatRecordType type, out ReadOnlySequence<byte> bytes, out string file);
}
