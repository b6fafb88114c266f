using System.Numerics;
using System.Text.Json;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>All characters of a server, in memory and, when there is one, in a file.</summary>
internal sealed class CharacterBook
{
    /// <summary>Characters that an account may have.</summary>
    public const int MostPerAccount = 11;

    private const uint FirstGuid = 0x50000001;
    private const int Most = 20_000, LongestName = 32;
    private const uint Made = 1, NotAllowed = 2, NameInUse = 3, Invalid = 5;

    private static readonly JsonSerializerOptions Json = new()
    {
        WriteIndented = true,
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
    };

    private readonly WorldServerOptions options;
    private readonly Dictionary<uint, Character> byGuid = [];
    private readonly Dictionary<string, Character> byName = new(StringComparer.OrdinalIgnoreCase);
    private readonly Dictionary<string, List<Character>> byAccount = [];
    private uint nextGuid = FirstGuid;

    /// <summary>The characters of the options' file; none when it is not there yet.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    /// <exception cref="InvalidDataException">It is no file of characters.</exception>
    public CharacterBook(WorldServerOptions options)
    {
        this.options = options;
        if (options.CharacterFile is not { } path || !File.Exists(path)) return;
        try
        {
            foreach (Line line in JsonSerializer.Deserialize<List<Line>>(File.ReadAllText(path), Json) ?? []) Add(line.Read());
        }
        catch (Exception error) when (error is JsonException or ArgumentException or NullReferenceException)
        {
            throw new InvalidDataException($"{path} is no list of characters: {error.Message}", error);
        }
    }

    /// <summary>The account's characters, last played first.</summary>
    public IReadOnlyList<Character> Of(string account) => byAccount.GetValueOrDefault(account) ?? [];

    /// <summary>The character of an account, or null.</summary>
    public Character? Find(uint guid) => byGuid.GetValueOrDefault(guid);

    /// <summary>It is played: it comes first from now on.</summary>
    public void MoveToFront(Character character)
    {
        List<Character> own = byAccount[character.Account];
        own.Remove(character);
        own.Insert(0, character);
    }

    /// <summary>Makes a character.</summary>
    /// <param name="account">Whose.</param>
    /// <param name="wish">What its client asks for.</param>
    /// <remarks>Specification 08, 8.5; looks are not looked at.</remarks>
    public CharacterCreateResponse Create(string account, CharacterCreate wish)
    {
        string name = wish.Name.Trim();
        CharacterAttributeValues attributes = new(
            wish.Strength, wish.Endurance, wish.Quickness, wish.Coordination, wish.Focus, wish.Self);
        if (!IsName(name) || !attributes.IsAllowed) return new CharacterCreateResponse(Invalid, null);
        if (byName.ContainsKey(name)) return new CharacterCreateResponse(NameInUse, null);
        if (Of(account).Count >= MostPerAccount || byGuid.Count >= Most) return new CharacterCreateResponse(NotAllowed, null);
        const int jump = 22, run = 24;
        Character made = new()
        {
            Guid = nextGuid,
            Name = name,
            Account = account,
            Attributes = attributes,
            RunPoints = Points(options.RunSkill, (int)attributes.Quickness, wish.Skills[run]),
            JumpPoints = Points(options.JumpSkill, (int)((attributes.Strength + attributes.Coordination + 1) / 2), wish.Skills[jump]),
            Place = options.Start,
        };
        Add(made);
        Save();
        return new CharacterCreateResponse(Made, new CharacterEntry(made.Guid, made.Name, 0));

        static int Points(int? wanted, int formula, uint training) =>
            wanted is { } level ? Math.Max(0, level - formula) : Character.PointsOf(training);
    }

    /// <summary>Writes the file, when there is one.</summary>
    public void Save()
    {
        if (options.CharacterFile is not { } path) return;
        try
        {
            string unfinished = $"{path}.{Guid.NewGuid():N}.tmp";
            File.WriteAllText(unfinished, JsonSerializer.Serialize(byAccount.Values.SelectMany(own => own).Select(Line.Of), Json));
            File.Move(unfinished, path, overwrite: true);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            options.Log?.Invoke($"the characters cannot be written to {path}: {error.Message}");
        }
    }

    private static bool IsName(string name) =>
        name.Length is > 0 and <= LongestName && name.All(letter => char.IsAsciiLetter(letter) || letter is ' ' or '-' or '\'');

    private void Add(Character character)
    {
        byGuid.Add(character.Guid, character);
        byName.Add(character.Name, character);
        if (!byAccount.TryGetValue(character.Account, out List<Character>? own)) byAccount[character.Account] = own = [];
        own.Add(character);
        nextGuid = Math.Max(nextGuid, character.Guid + 1);
    }

    /// <summary>A character as the file has it.</summary>
    private sealed record Line(
        uint Guid, string Name, string Account, uint[] Attributes, int RunPoints, int JumpPoints, uint Cell, float[] Place, ushort Logins)
    {
        public static Line Of(Character one)
        {
            (Vector3 at, Quaternion turn) = (one.Place.Frame.Origin, one.Place.Frame.Rotation);
            CharacterAttributeValues own = one.Attributes;
            return new Line(
                one.Guid, one.Name, one.Account, [own.Strength, own.Endurance, own.Quickness, own.Coordination, own.Focus, own.Self],
                one.RunPoints, one.JumpPoints, one.Place.CellId, [at.X, at.Y, at.Z, turn.W, turn.X, turn.Y, turn.Z], one.Logins);
        }

        public Character Read()
        {
            if (Attributes.Length != 6 || Place.Length != 7) throw new ArgumentException($"{Name} has not all its numbers.");
            Position place = new(
                Cell, new Frame(new Vector3(Place[0], Place[1], Place[2]), new Quaternion(Place[4], Place[5], Place[6], Place[3])));
            if (!place.IsValid) throw new ArgumentException($"{Name} is at no place.");
            return new Character
            {
                Guid = Guid,
                Name = Name,
                Account = Account,
                Attributes = new(Attributes[0], Attributes[1], Attributes[2], Attributes[3], Attributes[4], Attributes[5]),
                RunPoints = RunPoints,
                JumpPoints = JumpPoints,
                Place = place,
                Logins = Logins,
            };
        }
    }
}
