using System.Buffers;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>Records in memory, as bytes: what a test wrote is read back the way a file is.</summary>
internal sealed class MemorySource : IDatSource
{
    private readonly Dictionary<uint, byte[]> records = [];
    private int reads;

    internal int Reads => reads;

    internal MemorySource Add(params DatRecord[] added)
    {
        foreach (DatRecord record in added) records[record.Id] = record.Encode();
        return this;
    }

    internal MemorySource Add(uint id, params byte[] bytes)
    {
        records[id] = bytes;
        return this;
    }

    public bool TryRead(uint id, out ReadOnlySequence<byte> bytes)
    {
        Interlocked.Increment(ref reads);
        bool found = records.TryGetValue(id, out byte[]? record);
        bytes = found ? new ReadOnlySequence<byte>(record!) : default;
        return found;
    }
}
