using System.Text;
using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Records;

/// <summary>What a new character may be (0x0E000002): one people, two sexes, one look, one set of attributes, one place to begin.</summary>
internal static class CharacterCreation
{
    /// <summary>Weenies of what a new character wears; a server's database has them.</summary>
    public const uint Trousers = 127, Shirt = 130, Shoes = 132;

    private const uint Human = 1, Male = 1, Female = 2;
    private const uint Icon = 0x06000001, SoundTable = 0x20000001, PhysicsScripts = 0x34000004, Clothing = 0x10000001;
    private const uint Palette = 0x04000001, PaletteSet = 0x0F000001;
    private const uint SurfaceTextureBase = 0x05000000, FaceTexture = 0x05000001;
    private const byte LookMark = 0x11;
    private const uint AttributeCredits = 330, SkillCredits = 52;

    /// <summary>The table, and the palettes it names.</summary>
    /// <param name="beginning">Where characters begin.</param>
    public static IEnumerable<DatRecord> All(NamedPlace beginning)
    {
        yield return RawRecords.Of(DatRecordType.CharGen, 0x0E000002, writer => WriteTable(writer, beginning));
        yield return RawRecords.Of(DatRecordType.Palette, Palette, writer =>
        {
            writer.WriteUInt32(1);
            writer.WriteColor(new(0xD9, 0xA8, 0x83, 0xFF));
        });
        yield return RawRecords.Of(DatRecordType.PaletteSet, PaletteSet, writer =>
        {
            writer.WriteUInt32(1);
            writer.WriteUInt32(Palette);
        });
    }

    private static void WriteTable(DatWriter writer, NamedPlace beginning)
    {
        writer.WriteUInt32(0x0E000002);
        Count(writer, 1);
        WriteText(writer, beginning.Title);
        Count(writer, 1);
        writer.WriteUInt32(beginning.CellId);
        writer.WriteFrame(new(beginning.Origin, beginning.Orientation));

        Table(writer, 1);
        writer.WriteUInt32(Human);
        WriteText(writer, "Human");
        writer.WriteUInt32(Icon);
        writer.WriteUInt32(DemoIds.HumanSetup);
        writer.WriteUInt32(DemoIds.HumanSetup);
        writer.WriteUInt32(AttributeCredits);
        writer.WriteUInt32(SkillCredits);
        Count(writer, 1);
        writer.WriteUInt32(0); // the first beginning is one to choose
        Count(writer, 0); // and there is no other
        Count(writer, 0); // no skill is cheaper for this people
        Count(writer, 1);
        WriteWalker(writer);
        Table(writer, 2);
        writer.WriteUInt32(Male);
        WriteLook(writer, "Male");
        writer.WriteUInt32(Female);
        WriteLook(writer, "Female");
    }

    // A set of attributes: strength, endurance, coordination, quickness, focus, self.
    private static void WriteWalker(DatWriter writer)
    {
        WriteText(writer, "Walker");
        writer.WriteUInt32(0);
        writer.WriteUInt32(1);
        foreach (uint points in (uint[])[60, 60, 60, 60, 45, 45])
            writer.WriteUInt32(points);
        Count(writer, 0); // trained skills
        Count(writer, 0); // specialised ones
    }

    private static void WriteLook(DatWriter writer, string name)
    {
        WriteText(writer, name);
        writer.WriteUInt32(100); // scale, per cent
        foreach (uint id in (uint[])
            [DemoIds.HumanSetup, SoundTable, Icon, Palette, PaletteSet, PhysicsScripts, DemoIds.HumanMotionTable, EmptyTables.CombatTable])
        {
            writer.WriteUInt32(id);
        }

        Plain(writer);
        Count(writer, 1);
        writer.WriteUInt32(PaletteSet); // hair colour
        Count(writer, 1); // hair: icon, not bald, no setup of its own, what it changes
        writer.WriteUInt32(0);
        writer.WriteByte(0);
        writer.WriteUInt32(0);
        Plain(writer);
        Count(writer, 1);
        writer.WriteUInt32(Palette); // eye colour
        Count(writer, 1); // eyes: two icons, what they change with hair and without
        writer.WriteUInt32(0);
        writer.WriteUInt32(0);
        Face(writer);
        Face(writer);
        for (int feature = 0; feature < 2; feature++) // nose, mouth
        {
            Count(writer, 1);
            writer.WriteUInt32(0);
            Face(writer);
        }

        Count(writer, 0); // headgear
        foreach (uint weenie in (uint[])[Shirt, Trousers, Shoes])
        {
            Count(writer, 1);
            WriteText(writer, "Plain");
            writer.WriteUInt32(Clothing);
            writer.WriteUInt32(weenie);
        }

        Count(writer, 1);
        writer.WriteUInt32(1); // clothing colour
    }

    // A look that changes nothing: no palettes, textures, parts.
    private static void Plain(DatWriter writer)
    {
        writer.Align4();
        writer.WriteBytes([LookMark, 0, 0, 0]);
    }

    // A look that puts a texture of part 0 in its own place: servers take a face's first texture without asking whether there is one.
    private static void Face(DatWriter writer)
    {
        writer.Align4();
        writer.WriteBytes([LookMark, 0, 1, 0]);
        writer.WriteByte(0);
        writer.WriteKnownTypeId(FaceTexture, SurfaceTextureBase);
        writer.WriteKnownTypeId(FaceTexture, SurfaceTextureBase);
        writer.Align4();
    }

    private static void Count(DatWriter writer, uint count) => writer.WriteCompressedUInt32(count);

    // A hash table: which of the sizes for its buckets, then the count.
    private static void Table(DatWriter writer, uint count)
    {
        writer.WriteByte(1);
        Count(writer, count);
    }

    private static void WriteText(DatWriter writer, string text)
    {
        Count(writer, (uint)text.Length);
        writer.WriteBytes(Encoding.ASCII.GetBytes(text));
    }
}
