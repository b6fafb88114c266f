using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>0xFFFF0001: which updates a file contains (spec 07, 4.5). It has no leading id.</summary>
public sealed class IterationRecord : DatRecord, IDatRecord<IterationRecord>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.Iteration;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>How many iteration numbers the file contains.</summary>
    public required int Count { get; init; }

    /// <summary>The words behind the count as stored: −k followed by s is the run s … s+k−1, others are single numbers.</summary>
    public ImmutableArray<int> Words { get; init; } = [];

    /// <summary>The record of iterations 1 to <paramref name="count"/>, in the form that all readers take.</summary>
    public static IterationRecord UpTo(int count)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(count, 1);
        return new() { Id = DatIds.Iteration, Count = count, Words = [-count, 1] };
    }

    /// <inheritdoc/>
    public static IterationRecord Decode(ref DatReader reader)
    {
        int count = reader.ReadInt32();
        if (count is < 0 or > 100000)
            throw reader.Error($"{count} iteration numbers; 0 to 100000 are possible", 0);
        var words = ImmutableArray.CreateBuilder<int>();
        for (long numbers = 0; numbers < count;)
        {
            int word = reader.ReadInt32();
            words.Add(word);
            if (word < 0)
                words.Add(reader.ReadInt32());
            numbers += word < 0 ? -(long)word : 1;
        }

        return new() { Id = reader.RecordId, Count = count, Words = words.DrainToImmutable() };
    }

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteInt32(Count);
        foreach (int word in Words)
            writer.WriteInt32(word);
    }
}
