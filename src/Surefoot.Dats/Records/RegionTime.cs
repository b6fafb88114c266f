using System.Collections.Immutable;

namespace Surefoot.Dats.Records;

/// <summary>A part of the day.</summary>
/// <param name="Start">When it begins, as a share of the day, 0 to 1.</param>
/// <param name="IsNight">Non-zero at night; write 0 or 1.</param>
/// <param name="Name">Its name.</param>
public sealed record TimeOfDay(float Start, uint IsNight, string Name)
{
    internal static TimeOfDay Read(ref DatReader reader) => new(reader.ReadSingle(), reader.ReadUInt32(), reader.ReadPString());

    internal static void Write(DatWriter writer, TimeOfDay time)
    {
        writer.WriteSingle(time.Start);
        writer.WriteUInt32(time.IsNight);
        writer.WritePString(time.Name);
    }
}

/// <summary>A season.</summary>
/// <param name="StartDay">Day of the year on which it begins.</param>
/// <param name="Name">Its name.</param>
public sealed record Season(uint StartDay, string Name)
{
    internal static Season Read(ref DatReader reader) => new(reader.ReadUInt32(), reader.ReadPString());

    internal static void Write(DatWriter writer, Season season)
    {
        writer.WriteUInt32(season.StartDay);
        writer.WritePString(season.Name);
    }
}

/// <summary>The calendar of a region (spec 07, 7.15).</summary>
/// <remarks>Retail: GameTime::UnPack @0x005A6EC0.</remarks>
public sealed record GameTime
{
    /// <summary>Offset of the clock into its first year; seconds.</summary>
    public double ZeroTimeOfYear { get; init; }

    /// <summary>Year in which the clock begins.</summary>
    public uint ZeroYear { get; init; }

    /// <summary>Length of a day; seconds.</summary>
    public float DayLength { get; init; }

    /// <summary>Days of a year.</summary>
    public uint DaysPerYear { get; init; }

    /// <summary>How years are named, e.g. "P.Y.".</summary>
    public string YearName { get; init; } = string.Empty;

    /// <summary>Parts of the day.</summary>
    public ImmutableArray<TimeOfDay> TimesOfDay { get; init; } = [];

    /// <summary>Names of the week's days.</summary>
    public ImmutableArray<string> WeekDays { get; init; } = [];

    /// <summary>Seasons.</summary>
    public ImmutableArray<Season> Seasons { get; init; } = [];

    internal static GameTime Read(ref DatReader reader) => new()
    {
        ZeroTimeOfYear = reader.ReadDouble(),
        ZeroYear = reader.ReadUInt32(),
        DayLength = reader.ReadSingle(),
        DaysPerYear = reader.ReadUInt32(),
        YearName = reader.ReadPString(),
        TimesOfDay = reader.ReadList(10, TimeOfDay.Read),
        WeekDays = reader.ReadList(2, static (ref r) => r.ReadPString()),
        Seasons = reader.ReadList(6, Season.Read),
    };

    internal void Write(DatWriter writer)
    {
        writer.WriteDouble(ZeroTimeOfYear);
        writer.WriteUInt32(ZeroYear);
        writer.WriteSingle(DayLength);
        writer.WriteUInt32(DaysPerYear);
        writer.WritePString(YearName);
        writer.WriteList(TimesOfDay, TimeOfDay.Write);
        writer.WriteList(WeekDays, static (w, name) => w.WritePString(name));
        writer.WriteList(Seasons, Season.Write);
    }
}
