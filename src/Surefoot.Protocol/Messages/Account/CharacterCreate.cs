namespace Surefoot.Protocol.Messages;

/// <summary>Create a character (specification 08, 3.4). The defaults make a plain one.</summary>
public sealed record CharacterCreate : IMessage<CharacterCreate>
{
    /// <summary>Number of skills that a server of the field wants to be told of.</summary>
    public const int SkillCount = 55;

    private const int AppearanceCount = 14, HueCount = 6;

    /// <summary>The account's name as the character list has it.</summary>
    public string Account { get; init; } = "";

    /// <summary>Always 1.</summary>
    public uint One { get; init; } = 1;

    /// <summary>People that it comes from.</summary>
    public uint Heritage { get; init; } = 1;

    /// <summary>1 male, 2 female.</summary>
    public uint Gender { get; init; } = 1;

    /// <summary>Fourteen choices: eyes, nose, mouth, hair colour, eye colour, hair style, headgear style (0xFFFFFFFF none) and colour,
    /// shirt style and colour, pants style and colour, footwear style and colour.</summary>
    public ValueList<uint> Appearance { get; init; } = [0, 0, 0, 0, 0, 0, uint.MaxValue, 0, 0, 0, 0, 0, 0, 0];

    /// <summary>Six shades, 0 to 1: skin, hair, headgear, shirt, pants, footwear.</summary>
    public ValueList<double> Hues { get; init; } = [0, 0, 0, 0, 0, 0];

    /// <summary>Profession; 0 for an own choice of skills.</summary>
    public int Template { get; init; }

    /// <summary>10 to 100.</summary>
    public uint Strength { get; init; } = 10;

    /// <summary>10 to 100.</summary>
    public uint Endurance { get; init; } = 10;

    /// <summary>10 to 100.</summary>
    public uint Coordination { get; init; } = 10;

    /// <summary>10 to 100.</summary>
    public uint Quickness { get; init; } = 10;

    /// <summary>10 to 100.</summary>
    public uint Focus { get; init; } = 10;

    /// <summary>10 to 100.</summary>
    public uint Self { get; init; } = 10;

    /// <summary>Place in the list of characters.</summary>
    public uint Slot { get; init; }

    /// <summary>Always 0.</summary>
    public uint ClassId { get; init; }

    /// <summary>Training of each skill by its id: 0 inactive, 1 untrained, 2 trained, 3 specialized.</summary>
    public ValueList<uint> Skills { get; init; } = new(new uint[SkillCount]);

    /// <summary>The name.</summary>
    public string Name { get; init; } = "";

    /// <summary>Where it begins.</summary>
    public uint StartArea { get; init; }

    /// <summary>1 for an administrator.</summary>
    public uint IsAdmin { get; init; }

    /// <summary>1 for a sentinel.</summary>
    public uint IsSentinel { get; init; }

    static MessageId IMessage<CharacterCreate>.Id => new(Opcode.CharacterCreate);

    static MessageGroup IMessage<CharacterCreate>.Group => MessageGroup.Logon;

    static CharacterCreate IMessage<CharacterCreate>.Read(ref WireReader reader) => new()
    {
        Account = reader.ReadString16(),
        One = reader.ReadUInt32(),
        Heritage = reader.ReadUInt32(),
        Gender = reader.ReadUInt32(),
        Appearance = reader.ReadList(AppearanceCount, 4, static (ref r) => r.ReadUInt32()),
        Hues = reader.ReadList(HueCount, 8, static (ref r) => r.ReadDouble()),
        Template = reader.ReadInt32(),
        Strength = reader.ReadUInt32(),
        Endurance = reader.ReadUInt32(),
        Coordination = reader.ReadUInt32(),
        Quickness = reader.ReadUInt32(),
        Focus = reader.ReadUInt32(),
        Self = reader.ReadUInt32(),
        Slot = reader.ReadUInt32(),
        ClassId = reader.ReadUInt32(),
        Skills = reader.ReadList(4, static (ref r) => r.ReadUInt32()),
        Name = reader.ReadString16(),
        StartArea = reader.ReadUInt32(),
        IsAdmin = reader.ReadUInt32(),
        IsSentinel = reader.ReadUInt32(),
    };

    void IMessage<CharacterCreate>.Write(ref WireWriter writer)
    {
        if (Appearance.Count != AppearanceCount || Hues.Count != HueCount)
            writer.Fail();
        writer.WriteString16(Account);
        writer.WriteUInt32(One);
        writer.WriteUInt32(Heritage);
        writer.WriteUInt32(Gender);
        writer.WriteElements(Appearance, static (ref w, choice) => w.WriteUInt32(choice));
        writer.WriteElements(Hues, static (ref w, hue) => w.WriteDouble(hue));
        writer.WriteInt32(Template);
        writer.WriteUInt32(Strength);
        writer.WriteUInt32(Endurance);
        writer.WriteUInt32(Coordination);
        writer.WriteUInt32(Quickness);
        writer.WriteUInt32(Focus);
        writer.WriteUInt32(Self);
        writer.WriteUInt32(Slot);
        writer.WriteUInt32(ClassId);
        writer.WriteList(Skills, static (ref w, training) => w.WriteUInt32(training));
        writer.WriteString16(Name);
        writer.WriteUInt32(StartArea);
        writer.WriteUInt32(IsAdmin);
        writer.WriteUInt32(IsSentinel);
    }
}

/// <summary>The answer to <see cref="CharacterCreate"/> (specification 08, 3.4).</summary>
/// <param name="Result">1 made, 2 not allowed, 3 name in use, 4 name banned, 5 invalid choice, 6 database.</param>
/// <param name="Character">The character, when it was made.</param>
public readonly record struct CharacterCreateResponse(uint Result, CharacterEntry? Character) : IInterfaceMessage<CharacterCreateResponse>
{
    private const uint Made = 1;

    static Opcode IInterfaceMessage<CharacterCreateResponse>.Opcode => Opcode.CharacterCreateResponse;

    static CharacterCreateResponse IMessage<CharacterCreateResponse>.Read(ref WireReader reader)
    {
        uint result = reader.ReadUInt32();
        return new CharacterCreateResponse(result, result == Made ? CharacterEntry.Read(ref reader) : null);
    }

    void IMessage<CharacterCreateResponse>.Write(ref WireWriter writer)
    {
        if (Result == Made != Character is not null)
            writer.Fail();
        writer.WriteUInt32(Result);
        if (Character is { } character)
            CharacterEntry.Write(ref writer, character);
    }
}
