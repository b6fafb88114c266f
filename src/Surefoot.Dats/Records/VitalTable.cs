namespace Surefoot.Dats.Records;

/// <summary>0x0E000003: how attributes make health, stamina and mana (spec 07, 7.17).</summary>
public sealed class VitalTable : DatRecord, IDatRecord<VitalTable>
{
    /// <inheritdoc/>
    public static DatRecordType RecordType => DatRecordType.VitalTable;

    /// <inheritdoc/>
    public override DatRecordType Type => RecordType;

    /// <summary>Greatest health.</summary>
    public AttributeFormula Health { get; init; }

    /// <summary>Greatest stamina.</summary>
    public AttributeFormula Stamina { get; init; }

    /// <summary>Greatest mana.</summary>
    public AttributeFormula Mana { get; init; }

    /// <inheritdoc/>
    public static VitalTable Decode(ref DatReader reader) => new()
    {
        Id = reader.ReadId(),
        Health = AttributeFormula.Read(ref reader),
        Stamina = AttributeFormula.Read(ref reader),
        Mana = AttributeFormula.Read(ref reader),
    };

    /// <inheritdoc/>
    public override void Encode(DatWriter writer)
    {
        writer.WriteUInt32(Id);
        Health.Write(writer);
        Stamina.Write(writer);
        Mana.Write(writer);
    }
}
