using CsCheck;
using Surefoot.Dats.Records;

namespace Surefoot.Dats.Tests;

/// <summary>Generates any region.</summary>
internal static class RegionGen
{
    public static Gen<Region> Region() =>
        from parts in Gen.UInt[0, 0x3FF]
        from id in Gen.UInt[0, 0xFFFF]
        from head in Gen.Select(Gen.UInt, Gen.UInt, RecordGen.Texts, Land(), RecordGen.Numbers.List(256, 256))
        from time in Time()
        from sky in Sky()
        from sounds in Sounds().List()
        from scenes in Gen.Select(Gen.UInt, Gen.UInt.List(), (sound, ids) => new SceneType(sound, ids)).List()
        from terrain in Gen.Select(
            RecordGen.Texts, RecordGen.Colors, Gen.UInt.List(), (name, color, types) => new TerrainType(name, color, types)).List()
        from surface in Surface()
        from misc in Gen.UInt.Array[6]
        let flags = (RegionParts)parts
        select new Region
        {
            Id = 0x13000000 | id,
            Number = head.Item1,
            Version = head.Item2,
            Name = head.Item3,
            Land = head.Item4,
            HeightTable = head.Item5,
            Time = time,
            Parts = flags,
            Sky = flags.HasFlag(RegionParts.Sky) ? sky : null,
            Sounds = flags.HasFlag(RegionParts.Sound) ? sounds : [],
            SceneTypes = flags.HasFlag(RegionParts.Scenes) ? scenes : [],
            TerrainTypes = terrain,
            Surface = surface,
            Misc = flags.HasFlag(RegionParts.Misc) ? new RegionMisc(misc[0], misc[1], misc[2], misc[3], misc[4], misc[5]) : null,
        };

    private static Gen<RegionLand> Land() => Gen.Select(
        Gen.Int.Array[4], RecordGen.Numbers.Array[4], (i, f) => new RegionLand(i[0], i[1], f[0], i[2], i[3], f[1], f[2], f[3]));

    private static Gen<GameTime> Time() =>
        from numbers in Gen.Select(RecordGen.Doubles, Gen.UInt, RecordGen.Numbers, Gen.UInt, RecordGen.Texts)
        from times in Gen.Select(RecordGen.Numbers, Gen.UInt, RecordGen.Texts, (start, night, name) => new TimeOfDay(start, night, name))
            .List()
        from days in RecordGen.Texts.List()
        from seasons in Gen.Select(Gen.UInt, RecordGen.Texts, (day, name) => new Season(day, name)).List()
        select new GameTime
        {
            ZeroTimeOfYear = numbers.Item1,
            ZeroYear = numbers.Item2,
            DayLength = numbers.Item3,
            DaysPerYear = numbers.Item4,
            YearName = numbers.Item5,
            TimesOfDay = times,
            WeekDays = days,
            Seasons = seasons,
        };

    /// <summary>With scripts: bytes of a sky without may, rarely, read as one with as well, and nothing tells which was meant.</summary>
    private static Gen<SkyDescription> Sky() => Sky(hasScripts: true);

    /// <summary>A sky of one kind; one without anything in it, which is the same in both kinds, counts as one with scripts.</summary>
    public static Gen<SkyDescription> Sky(bool hasScripts)
    {
        var things = Gen.Select(
            RecordGen.Numbers.Array[6], Gen.UInt.Array[3],
            (f, u) => new SkyObject(f[0], f[1], f[2], f[3], f[4], f[5], u[0], hasScripts ? u[1] : 0, u[2]));
        var replacements = Gen.Select(
            Gen.UInt.Array[2], RecordGen.Numbers.Array[4], (u, f) => new SkyObjectReplacement(u[0], u[1], f[0], f[1], f[2], f[3]));
        var skies = Gen.Select(RecordGen.Numbers.Array[7], RecordGen.Colors.Array[3], Gen.UInt, replacements.List());
        var times = skies.Select((f, c, mode, list) => new SkyTime
        {
            Begin = f[0],
            DirectionalBrightness = f[1],
            Heading = f[2],
            Pitch = f[3],
            DirectionalColor = c[0],
            AmbientBrightness = f[4],
            AmbientColor = c[1],
            MinFog = f[5],
            MaxFog = f[6],
            FogColor = c[2],
            FogMode = mode,
            Replacements = list,
        });
        var groups = Gen.Select(
            RecordGen.Numbers, RecordGen.Texts, things.List(), times.List(),
            (chance, name, objects, list) => new DayGroup(chance, name, objects, list));
        var parts = Gen.Select(RecordGen.Doubles, RecordGen.Doubles, groups.List(0, 2));
        return parts.Select((tick, light, list) => new SkyDescription(tick, light, list)
        {
            HasScripts = hasScripts || list.All(group => group.Objects.IsEmpty),
        });
    }

    private static Gen<AmbientSounds> Sounds() => Gen.Select(
        Gen.UInt,
        Gen.Select(Gen.UInt, RecordGen.Numbers.Array[4], (type, f) => new AmbientSound(type, f[0], f[1], f[2], f[3])).List(),
        (table, sounds) => new AmbientSounds(table, sounds));

    private static Gen<LandSurface> Surface()
    {
        var maps = Gen.Select(Gen.UInt, Gen.UInt, (code, texture) => new TerrainMap(code, texture)).List();
        var textures = Gen.UInt.Array[11].Select(
            u => new TerrainTexture(u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7], u[8], u[9], u[10])).List();
        return Gen.Select(Gen.UInt, maps, maps, maps, textures, (size, corners, sides, roads, list) => new LandSurface
        {
            BaseTextureSize = size,
            CornerMaps = corners,
            SideMaps = sides,
            RoadMaps = roads,
            TerrainTextures = list,
        });
    }
}
