using System.Globalization;
using System.Text.RegularExpressions;

namespace Surefoot.DemoWorld.Tests;

/// <summary>The rows by which a server of the field knows the demo world's inhabitants.</summary>
public sealed partial class ServerRowsTests
{
    private static readonly string Rows = DemoServerRows.ToSql();

    [Fact, Behaviour("demo-world.rows.every-inhabitant", "ACE's ace_world.landblock_instance")]
    public void Every_inhabitant_stands_where_the_demo_world_spawns_it()
    {
        var places = Instance().Matches(Rows).Select(match => (
            Guid: uint.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture),
            Cell: uint.Parse(match.Groups[3].Value, CultureInfo.InvariantCulture),
            X: float.Parse(match.Groups[4].Value, CultureInfo.InvariantCulture),
            Y: float.Parse(match.Groups[5].Value, CultureInfo.InvariantCulture))).ToList();

        Assert.Equal(
            DemoSpawns.All.Select(spawn => (spawn.CellId, spawn.Origin.X, spawn.Origin.Y)), places.Select(p => (p.Cell, p.X, p.Y)));
        Assert.Equal(places.Count, places.Select(place => place.Guid).Distinct().Count());
        Assert.All(places, place => Assert.Equal(0x70000000 | (place.Cell >> 16 << 12), place.Guid & 0xFFFFF000));
    }

    [Fact, Behaviour("demo-world.rows.every-class-has-a-setup", "ACE's ace_world.weenie_properties_d_i_d")]
    public void Every_class_is_made_before_it_is_used_and_has_a_setup_of_the_demo_world()
    {
        HashSet<string> made = [.. Class().Matches(Rows).Select(match => match.Groups[1].Value)];

        Assert.All(Instance().Matches(Rows).Select(match => match.Groups[2].Value), used => Assert.Contains(used, made));
        Assert.All((string[])["1", "127", "130", "132"], needed => Assert.Contains(needed, made));
        Assert.All(made, id => Assert.Matches($@"`weenie_properties_d_i_d` .* VALUES \({id}, 1, 33554\d\d\d\)", Rows));
    }

    [Fact, Behaviour("demo-world.rows.again", "demo-world")]
    public void Loading_the_rows_again_replaces_them()
    {
        foreach (string id in Class().Matches(Rows).Select(match => match.Groups[1].Value))
        {
            int deletion = Rows.IndexOf($"DELETE FROM `weenie` WHERE `class_Id` = {id};", StringComparison.Ordinal);
            Assert.InRange(deletion, 0, Rows.IndexOf($"`type`) VALUES ({id}, '", StringComparison.Ordinal));
        }

        Assert.InRange(Rows.IndexOf("DELETE FROM `landblock_instance`", StringComparison.Ordinal), 0,
            Rows.IndexOf("INSERT INTO `landblock_instance`", StringComparison.Ordinal));
    }

    [GeneratedRegex(@"INTO `landblock_instance` .* VALUES \((\d+), (\d+), (\d+), ([\d.E+-]+), ([\d.E+-]+),")]
    private static partial Regex Instance();

    [GeneratedRegex(@"INTO `weenie` .* VALUES \((\d+), '")]
    private static partial Regex Class();
}
