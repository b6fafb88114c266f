using System.Globalization;
using System.Text;
using Surefoot.DemoWorld.Placement;
using Surefoot.DemoWorld.Records;

namespace Surefoot.DemoWorld;

/// <summary>The demo world's inhabitants as rows of an ACE server's world database (MariaDB or MySQL).</summary>
/// <remarks>
/// The rows hold what the server needs to start (a human, what new characters wear) and every <see cref="DemoSpawn"/>. Class ids are
/// 1, 127, 130, 132 and from 90001 on; running the statements again replaces these rows and no others.
/// </remarks>
public static class DemoServerRows
{
    // Kinds of weenies and numbers of their properties, as the server's tables have them.
    private const int Clothing = 2, Creature = 10, Door = 19;
    private const int ItemType = 1, CreatureType = 2, EncumbranceValue = 5, ItemsCapacity = 6, ContainersCapacity = 7, Mass = 8,
        ValidLocations = 9, Usable = 16, Value = 19, Level = 25, PhysicsState = 93, Gender = 113, Showable = 133,
        PlayerKillerStatus = 134, Heritage = 188, ClothingPriority = 4;
    private const int Stuck = 1, IgnoreCollisions = 11, ReportCollisions = 12, Ethereal = 13, Gravity = 14, Attackable = 19;
    private const int ResetInterval = 11, UseRadius = 54;
    private const int Setup = 1, MotionTable = 2, SoundTable = 3, CombatTable = 4, Icon = 8;
    private const int CreatureItem = 16, ClothingItem = 4, MiscellaneousItem = 128, HumanKind = 31;

    // ReportCollisions, Gravity and EdgeSlide for whoever walks; a door has a physics tree and neither falls nor slides.
    private const int WalkerState = 0x400408, DoorState = 0x10008;

    private const uint FirstClass = 90001, CreatureIcon = 0x06001036;

    /// <summary>SQL statements, in one text.</summary>
    /// <param name="seed">The seed that the world was written with: creatures stand on its ground.</param>
    public static string ToSql(uint seed = DemoWorldBuilder.DefaultSeed)
    {
        var sql = new StringBuilder();
        Line(sql, $"-- What ACE needs to run on the demo world of seed {seed}, and who lives there.");
        Line(sql, $"USE `ace_world`;");
        Line(sql, $"INSERT INTO `version` (`id`, `base_Version`, `patch_Version`) VALUES (1, 'surefoot', '0')"
            + " ON DUPLICATE KEY UPDATE `base_Version` = 'surefoot';");
        var spawns = WorldPlan.Create(seed).Spawns;
        AppendPlayers(sql);
        foreach (var kind in Kinds)
            AppendKind(sql, kind);
        AppendPlaces(sql, spawns);
        return sql.ToString();
    }

    private static readonly WeenieKind[] Kinds =
    [
        new(FirstClass, "person", Creature, DemoIds.HumanSetup, DemoIds.HumanMotionTable),
        new(FirstClass + 1, "small creature", Creature, DemoIds.SmallCreatureSetup, DemoIds.CreatureMotionTable),
        new(FirstClass + 2, "large creature", Creature, DemoIds.LargeCreatureSetup, DemoIds.HeavyCreatureMotionTable),
        new(FirstClass + 3, "door", Door, DemoIds.DoorSetup, 0),
    ];

    private static void AppendPlayers(StringBuilder sql)
    {
        Line(sql, $"\n-- Every new character is made of class 1 and wears the other three.");
        Weenie(sql, 1, "human", Creature);
        Numbers(sql, 1, (ItemType, CreatureItem), (CreatureType, HumanKind), (EncumbranceValue, 0), (ItemsCapacity, 102),
            (ContainersCapacity, 7),
            (Mass, 120), (Usable, 1), (Level, 1), (PhysicsState, WalkerState), (Gender, 1), (Showable, 4), (PlayerKillerStatus, 2),
                (Heritage, 1));
        Flags(sql, 1, (Stuck, true), (IgnoreCollisions, false), (ReportCollisions, true), (Ethereal, false), (Gravity, true),
            (Attackable, true));
        Reals(sql, 1, (UseRadius, 0.25));
        Name(sql, 1, "Human");
        Ids(sql, 1, (Setup, DemoIds.HumanSetup), (MotionTable, DemoIds.HumanMotionTable), (SoundTable, 0x20000001),
            (CombatTable, EmptyTables.CombatTable), (Icon, CreatureIcon));
        Line(sql, $"-- So much health and stamina that no fall kills and no jump tires: a death needs spells that the demo world has not.");
        Vitals(sql, 1, 50000);
        Garment(sql, CharacterCreation.Trousers, "Trousers", priority: 19, location: 196);
        Garment(sql, CharacterCreation.Shirt, "Shirt", priority: 104, location: 2);
        Garment(sql, CharacterCreation.Shoes, "Shoes", priority: 65536, location: 256);
    }

    private static void Garment(StringBuilder sql, uint id, string name, int priority, int location)
    {
        Weenie(sql, id, name, Clothing);
        Numbers(sql, id, (ItemType, ClothingItem), (ClothingPriority, priority), (EncumbranceValue, 100), (ValidLocations, location),
            (Usable, 1),
            (Value, 5), (PhysicsState, 0x414));
        Name(sql, id, name);
        Ids(sql, id, (Setup, DemoIds.HumanSetup), (Icon, 0x06000001));
    }

    private static void AppendKind(StringBuilder sql, WeenieKind kind)
    {
        Line(sql, $"\n-- {kind.Name}");
        bool door = kind.Type == Door;
        Weenie(sql, kind.Id, kind.Name, kind.Type);
        if (door)
            Numbers(sql, kind.Id, (ItemType, MiscellaneousItem), (Mass, 120), (Usable, 32), (PhysicsState, DoorState));
        else
            Numbers(sql, kind.Id, (ItemType, CreatureItem), (CreatureType, HumanKind), (Mass, 120), (Usable, 1), (Level, 1),
                (PhysicsState, WalkerState), (Showable, 4), (PlayerKillerStatus, 16));
        Flags(sql, kind.Id, (Stuck, true), (ReportCollisions, true), (Ethereal, false), (Gravity, !door), (Attackable, false));
        Reals(sql, kind.Id, (ResetInterval, 10), (UseRadius, 2));
        Name(sql, kind.Id, kind.Name);
        Ids(sql, kind.Id, [(Setup, kind.Setup), (Icon, CreatureIcon), .. kind.MotionTable == 0 ? [] : new[] { (MotionTable,
            kind.MotionTable) }]);
        if (!door)
            Vitals(sql, kind.Id, 100);
    }

    private static void AppendPlaces(StringBuilder sql, IEnumerable<DemoSpawn> spawns)
    {
        Line(sql, $"\n-- Where they stand.");
        Line(sql, $"DELETE FROM `landblock_instance` WHERE `weenie_Class_Id` BETWEEN {FirstClass} AND {FirstClass + Kinds.Length - 1};");
        var inBlock = new Dictionary<uint, uint>();
        foreach (DemoSpawn spawn in spawns)
        {
            uint block = spawn.CellId >> 16;
            uint index = inBlock[block] = inBlock.GetValueOrDefault(block) + 1;
            uint kind = Kinds.Single(kind => kind.Setup == spawn.SetupId).Id;
            var (at, turn) = (spawn.Origin, spawn.Orientation);
            Line(sql, $"INSERT INTO `landblock_instance` (`guid`, `weenie_Class_Id`, `obj_Cell_Id`, `origin_X`, `origin_Y`, `origin_Z`, "
                + $"`angles_W`, `angles_X`, `angles_Y`, `angles_Z`, `is_Link_Child`) VALUES ({0x70000000 | (block << 12) | index}, {kind}, "
                + $"{spawn.CellId}, {Real(at.X)}, {Real(at.Y)}, {Real(at.Z)}, "
                + $"{Real(turn.W)}, {Real(turn.X)}, {Real(turn.Y)}, {Real(turn.Z)}, b'0');");
        }
    }

    private static void Weenie(StringBuilder sql, uint id, string name, int type)
    {
        Line(sql, $"DELETE FROM `weenie` WHERE `class_Id` = {id};");
        string key = $"surefoot-{name.Replace(' ', '-').ToLowerInvariant()}";
        Line(sql, $"INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`) VALUES ({id}, '{(id == 1 ? "human" : key)}', {type});");
    }

    private static void Numbers(StringBuilder sql, uint id, params (int Type, int Value)[] values)
        => Properties(sql, "int", id, values.Select(p => (p.Type, p.Value.ToString(CultureInfo.InvariantCulture))));

    private static void Flags(StringBuilder sql, uint id, params (int Type, bool Value)[] values)
        => Properties(sql, "bool", id, values.Select(p => (p.Type, p.Value ? "b'1'" : "b'0'")));

    private static void Reals(StringBuilder sql, uint id, params (int Type, double Value)[] values)
        => Properties(sql, "float", id, values.Select(p => (p.Type, Real(p.Value))));

    private static void Ids(StringBuilder sql, uint id, params (int Type, uint Value)[] values)
        => Properties(sql, "d_i_d", id, values.Select(p => (p.Type, p.Value.ToString(CultureInfo.InvariantCulture))));

    private static void Name(StringBuilder sql, uint id, string name) => Properties(sql, "string", id, [(1, $"'{name}'")]);

    private static void Properties(StringBuilder sql, string kind, uint id, IEnumerable<(int Type, string Value)> values)
        => Line(sql, $"INSERT INTO `weenie_properties_{kind}` (`object_Id`, `type`, `value`) VALUES "
            + string.Join(", ", values.Select(p => $"({id}, {p.Type}, {p.Value})")) + ";");

    // Six attributes of 50; health (1) and stamina (3) beyond what endurance gives, mana (5) not.
    private static void Vitals(StringBuilder sql, uint id, int beyond)
    {
        Line(sql, $"INSERT INTO `weenie_properties_attribute` (`object_Id`, `type`, `init_Level`, `level_From_C_P`, `c_P_Spent`) VALUES "
            + string.Join(", ", Enumerable.Range(1, 6).Select(attribute => $"({id}, {attribute}, 50, 0, 0)")) + ";");
        Line(sql, $"INSERT INTO `weenie_properties_attribute_2nd` (`object_Id`, `type`, `init_Level`, `level_From_C_P`, `c_P_Spent`, "
            + $"`current_Level`) VALUES "
            + $"({id}, 1, {beyond}, 0, 0, {beyond}), ({id}, 3, {beyond}, 0, 0, {beyond}), ({id}, 5, 10, 0, 0, 10);");
    }

    private static string Real(double value) => ((float)value).ToString("R", CultureInfo.InvariantCulture);

    private static void Line(StringBuilder sql, FormattableString text) => Line(sql, FormattableString.Invariant(text));

    private static void Line(StringBuilder sql, string text) => sql.Append(text).Append('\n');

    private readonly record struct WeenieKind(uint Id, string Name, int Type, uint Setup, uint MotionTable);
}
