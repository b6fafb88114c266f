using Surefoot.Protocol;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>A new character that runs and jumps, as servers of the field accept it.</summary>
public static class NewCharacter
{
    private const uint Inactive = 0, Untrained = 1, Trained = 2;
    private const int Jump = 22, Run = 24;

    // Skills that every character has without training.
    private static readonly int[] Common = [6, 7, 14, 15, 19, 20, 21, 27];

    /// <summary>
    /// What to ask a server for: 330 points of attributes (60 each for strength, endurance, coordination and quickness, 45 for focus and
    /// self), run and jump trained.
    /// </summary>
    /// <param name="name">Its name.</param>
    /// <remarks>Specification 08, 8.5.</remarks>
    public static CharacterCreate Named(string name)
    {
        ArgumentException.ThrowIfNullOrWhiteSpace(name);
        uint[] skills = new uint[CharacterCreate.SkillCount];
        Array.Fill(skills, Inactive);
        foreach (int skill in Common) skills[skill] = Untrained;
        skills[Jump] = skills[Run] = Trained;
        return new CharacterCreate
        {
            Name = name,
            Strength = 60,
            Endurance = 60,
            Coordination = 60,
            Quickness = 60,
            Focus = 45,
            Self = 45,
            Skills = ValueList.Create<uint>(skills),
        };
    }

    /// <summary>Why a server did not make a character, in a sentence.</summary>
    /// <param name="name">The name that was asked for.</param>
    /// <param name="result">What the server answered: <see cref="CharacterCreateResponse.Result"/>.</param>
    public static string Refusal(string name, uint result) => result switch
    {
        2 => $"The server does not allow this account to make '{name}'.",
        3 => $"The name '{name}' is taken: choose another one.",
        4 => $"The server does not allow the name '{name}': choose another one.",
        5 => $"The server does not accept the choices made for '{name}'.",
        6 => $"The server's database failed to make '{name}': try again.",
        _ => $"The server did not make '{name}': error {result}.",
    };
}
