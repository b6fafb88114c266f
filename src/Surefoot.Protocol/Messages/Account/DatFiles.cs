namespace Surefoot.Protocol.Messages;

/// <summary>Which dat files does the client have? (Specification 08, 3.4.)</summary>
/// <param name="Region">Always 1.</param>
/// <param name="NameRuleLanguage">Always 1.</param>
/// <param name="Product">Always 1.</param>
/// <param name="Languages">0 and 1.</param>
public readonly record struct DddInterrogation(
    uint Region,
    uint NameRuleLanguage,
    uint Product,
    ValueList<uint> Languages) : IMessage<DddInterrogation>
{
    static MessageId IMessage<DddInterrogation>.Id => new(Opcode.DddInterrogation);

    static MessageGroup IMessage<DddInterrogation>.Group => MessageGroup.Database;

    static DddInterrogation IMessage<DddInterrogation>.Read(ref WireReader reader) => new(
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadList(4, static (ref r) => r.ReadUInt32()));

    void IMessage<DddInterrogation>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Region);
        writer.WriteUInt32(NameRuleLanguage);
        writer.WriteUInt32(Product);
        writer.WriteList(Languages, static (ref w, language) => w.WriteUInt32(language));
    }
}

/// <summary>Iterations of a dat file that a client has.</summary>
/// <param name="Total">How many.</param>
/// <param name="Entries">As they travel: a number from 0 on is one iteration, −k and the number after it are k of them from that number
/// on.</param>
public readonly record struct IterationSet(int Total, ValueList<int> Entries)
{
    /// <summary>The iterations 1 to <paramref name="total"/>.</summary>
    /// <param name="total">Not negative.</param>
    public static IterationSet UpTo(int total) => new(total, total switch { 0 => [], 1 => [1], _ => [-total, 1] });

    internal static IterationSet Read(ref WireReader reader)
    {
        int total = reader.ReadInt32();
        var entries = new List<int>();
        for (long left = total; left > 0 && reader.Fault == WireFault.None;)
        {
            int entry = reader.ReadInt32();
            entries.Add(entry);
            left -= entry < 0 ? -(long)entry : 1;
            if (entry < 0)
                entries.Add(reader.ReadInt32());
        }

        return new IterationSet(total, [.. entries]);
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteInt32(Total);
        writer.WriteElements(Entries, static (ref w, entry) => w.WriteInt32(entry));
    }
}

/// <summary>Iterations of one dat file.</summary>
/// <param name="FileType">0.</param>
/// <param name="FileId">1 portal, 2 cell, 3 language.</param>
/// <param name="Iterations">Those that the client has.</param>
public readonly record struct DatFileState(uint FileType, uint FileId, IterationSet Iterations)
{
    internal static DatFileState Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadUInt32(), IterationSet.Read(ref reader));

    internal static void Write(ref WireWriter writer, DatFileState state)
    {
        writer.WriteUInt32(state.FileType);
        writer.WriteUInt32(state.FileId);
        state.Iterations.Write(ref writer);
    }
}

/// <summary>The answer to <see cref="DddInterrogation"/> (specification 08, 3.4).</summary>
/// <param name="Language">1.</param>
/// <param name="Files">The client's files; none is accepted too.</param>
/// <param name="NoKeys">0.</param>
/// <param name="Flags">0.</param>
public readonly record struct DddInterrogationResponse(
    uint Language,
    ValueList<DatFileState> Files,
    uint NoKeys,
    uint Flags) : IMessage<DddInterrogationResponse>
{
    static MessageId IMessage<DddInterrogationResponse>.Id => new(Opcode.DddInterrogationResponse);

    static MessageGroup IMessage<DddInterrogationResponse>.Group => MessageGroup.Database;

    static DddInterrogationResponse IMessage<DddInterrogationResponse>.Read(ref WireReader reader)
        => new(reader.ReadUInt32(), reader.ReadList(12, DatFileState.Read), reader.ReadUInt32(), reader.ReadUInt32());

    void IMessage<DddInterrogationResponse>.Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Language);
        writer.WriteList(Files, DatFileState.Write);
        writer.WriteUInt32(NoKeys);
        writer.WriteUInt32(Flags);
    }
}

/// <summary>The exchange about dat files is over; both sides say it (specification 08, 3.4).</summary>
public readonly record struct DddEnd : IMessage<DddEnd>
{
    static MessageId IMessage<DddEnd>.Id => new(Opcode.DddEnd);

    static MessageGroup IMessage<DddEnd>.Group => MessageGroup.Database;

    static DddEnd IMessage<DddEnd>.Read(ref WireReader reader) => default;

    void IMessage<DddEnd>.Write(ref WireWriter writer)
    {
    }
}
