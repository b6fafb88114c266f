using System.Buffers;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>Records of kinds that the library carries as bytes.</summary>
internal static class RawRecords
{
    /// <summary>A record that begins with its id.</summary>
    /// <param name="type">Its kind.</param>
    /// <param name="id">Its id, which is written first.</param>
    /// <param name="write">Writes what follows.</param>
    public static RawRecord Of(DatRecordType type, uint id, Action<DatWriter> write)
    {
        var writer = new DatWriter();
        writer.WriteUInt32(id);
        write(writer);
        return RawRecord.FromBytes(id, type, new ReadOnlySequence<byte>(writer.ToArray()));
    }
}
