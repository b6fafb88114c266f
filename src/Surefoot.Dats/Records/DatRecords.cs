using System.Buffers;

namespace Surefoot.Dats.Records;

/// <summary>Decoding by kind.</summary>
public static class DatRecords
{
    /// <summary>Decodes a record of any kind; kinds without a type of their own become a <see cref="RawRecord"/>.</summary>
    /// <param name="type">The kind, see <see cref="DatIds.RecordTypeOf"/>.</param>
    /// <param name="id">Its id.</param>
    /// <param name="bytes">All its bytes.</param>
    /// <param name="file">Name of its file, for errors.</param>
    /// <param name="remarks">Receives what is odd but readable; null to drop it.</param>
    /// <exception cref="DatFormatException">The bytes are no such record.</exception>
    public static DatRecord Decode(
        DatRecordType type, uint id, ReadOnlySequence<byte> bytes, string file = "", ICollection<DatRemark>? remarks = null) => type switch
        {
            DatRecordType.Iteration => DatRecord.Decode<IterationRecord>(id, bytes, file, remarks),
            DatRecordType.GfxObj => DatRecord.Decode<GfxObj>(id, bytes, file, remarks),
            DatRecordType.Setup => DatRecord.Decode<Setup>(id, bytes, file, remarks),
            DatRecordType.Animation => DatRecord.Decode<Animation>(id, bytes, file, remarks),
            DatRecordType.MotionTable => DatRecord.Decode<MotionTable>(id, bytes, file, remarks),
            DatRecordType.Environment => DatRecord.Decode<CellEnvironment>(id, bytes, file, remarks),
            DatRecordType.Scene => DatRecord.Decode<Scene>(id, bytes, file, remarks),
            DatRecordType.Region => DatRecord.Decode<Region>(id, bytes, file, remarks),
            DatRecordType.LandBlock => DatRecord.Decode<LandBlock>(id, bytes, file, remarks),
            DatRecordType.LandBlockInfo => DatRecord.Decode<LandBlockInfo>(id, bytes, file, remarks),
            DatRecordType.EnvCell => DatRecord.Decode<EnvCell>(id, bytes, file, remarks),
            DatRecordType.VitalTable => DatRecord.Decode<VitalTable>(id, bytes, file, remarks),
            DatRecordType.SkillTable => DatRecord.Decode<SkillTable>(id, bytes, file, remarks),
            DatRecordType.ExperienceTable => DatRecord.Decode<ExperienceTable>(id, bytes, file, remarks),
            _ => RawRecord.FromBytes(id, type, bytes),
        };

    /// <summary>Reads and decodes a record of one file.</summary>
    /// <exception cref="DatRecordMissingException">There is no such record.</exception>
    /// <exception cref="DatFormatException">Its bytes are wrong.</exception>
    public static DatRecord Decode(DatFile file, uint id, ICollection<DatRemark>? remarks = null)
    {
        DatRecordType type = DatIds.RecordTypeOf(id, file.Kind);
        return file.TryRead(id, out ReadOnlySequence<byte> bytes)
            ? Decode(type, id, bytes, file.Path, remarks)
            : throw new DatRecordMissingException(id, type);
    }
}
