using System.Buffers;
using System.Buffers.Binary;
using System.Text;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

/// <summary>The tables by which a server makes characters and computes how fast they run.</summary>
public sealed class CharacterTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    [Fact, Behaviour("demo-world.characters.run-and-jump-by-attributes", "spec/07, 7.17; spec/08, 7.2")]
    public void Run_is_quickness_and_jump_the_half_of_strength_and_coordination()
    {
        var skills = world.Dats.Read<SkillTable>(0x0E000004).Skills.ToDictionary(skill => skill.Skill);

        Assert.Equal(("Jump", new AttributeFormula(0, 1, 1, 2, 1, 4)), (skills[22].Name, skills[22].Formula));
        Assert.Equal(("Run", new AttributeFormula(0, 1, 0, 1, 3, 0)), (skills[24].Name, skills[24].Formula));
        Assert.All(skills.Values, skill => Assert.True(skill.Formula.Z > 0, $"{skill.Name} divides by zero"));
    }

    [Fact, Behaviour("demo-world.characters.stamina-is-endurance", "spec/08, 7.2")]
    public void Stamina_is_endurance_and_health_the_half_of_it()
    {
        var vitals = world.Dats.Read<VitalTable>(0x0E000003);

        Assert.Equal(new AttributeFormula(0, 1, 0, 1, 2, 0), vitals.Stamina);
        Assert.Equal(new AttributeFormula(0, 1, 0, 2, 2, 0), vitals.Health);
    }

    [Fact, Behaviour("demo-world.characters.buckets", "spec/07, 7.17")]
    public void Skills_stand_in_the_order_of_their_buckets()
    {
        var table = world.Dats.Read<SkillTable>(0x0E000004);

        uint[] buckets = [.. table.Skills.Select(skill => skill.Skill % table.Buckets)];
        Assert.Equal(buckets.Order(), buckets);
        Assert.Equal(table.Skills.Length, table.Skills.Select(skill => skill.Skill).Distinct().Count());
    }

    [Fact, Behaviour("demo-world.characters.costs-grow", "spec/07, 7.17")]
    public void Every_rank_and_level_takes_more_than_the_one_before_it()
    {
        var table = world.Dats.Read<ExperienceTable>(0x0E000018);

        foreach (var costs in new[] { table.Attribute, table.Vital, table.TrainedSkill, table.SpecializedSkill })
            Assert.All(costs.Zip(costs.Skip(1)), pair => Assert.True(pair.First < pair.Second));
        Assert.All(table.Level.Skip(1).Zip(table.Level.Skip(2)), pair => Assert.True(pair.First < pair.Second));
        Assert.Equal((0ul, 0ul), (table.Level[0], table.Level[1]));
    }

    [Fact, Behaviour("demo-world.characters.begin-in-town", "client_portal.dat 0x0E000002 as servers read it")]
    public void A_character_begins_in_the_town_and_spends_all_its_attribute_points()
    {
        Assert.True(world.Dats.Portal.TryRead(0x0E000002, out ReadOnlySequence<byte> bytes));
        byte[] table = bytes.ToArray();
        NamedPlace town = DemoPlaces.All.Single(place => place.Name == "town");

        int place = 9 + 1 + town.Title.Length + 1;
        Assert.Equal((1, town.Title), (table[8], Encoding.ASCII.GetString(table, 10, town.Title.Length)));
        Assert.Equal(town.CellId, BinaryPrimitives.ReadUInt32LittleEndian(table.AsSpan(place)));
        Assert.Equal(town.Origin.X, BinaryPrimitives.ReadSingleLittleEndian(table.AsSpan(place + 4)));
        int people = IndexOf(table, "Human") + "Human".Length;
        uint credits = BinaryPrimitives.ReadUInt32LittleEndian(table.AsSpan(people + 12));
        int walker = IndexOf(table, "Walker") + "Walker".Length + 8;
        long spent = Enumerable.Range(0, 6).Sum(i => (long)BinaryPrimitives.ReadUInt32LittleEndian(table.AsSpan(walker + (4 * i))));
        Assert.Equal(credits, spent);
    }

    [Theory, Behaviour("demo-world.characters.tables-of-a-server", "what ACE looks for when it starts")]
    [InlineData(0x0E000007)]
    [InlineData(0x0E00000D)]
    [InlineData(0x0E00000E)]
    [InlineData(0x0E00000F)]
    [InlineData(0x0E00001A)]
    [InlineData(0x0E00001D)]
    [InlineData(0x0E00001E)]
    [InlineData(0x0E000020)]
    [InlineData(0x30000000)]
    [InlineData(0x39000001)]
    public void Tables_that_a_server_looks_for_begin_with_their_ids(uint id)
    {
        Assert.True(world.Dats.Portal.TryRead(id, out ReadOnlySequence<byte> bytes));
        Assert.Equal(id, BinaryPrimitives.ReadUInt32LittleEndian(bytes.ToArray()));
    }

    private static int IndexOf(byte[] table, string text)
    {
        int found = table.AsSpan().IndexOf(Encoding.ASCII.GetBytes(text));
        Assert.True(found > 0, text);
        return found;
    }
}
