using System.Globalization;
using Surefoot.Client;

namespace Surefoot.Tool.Walking;

/// <summary>Keys held for a while.</summary>
/// <param name="Keys">Keys held; none waits.</param>
/// <param name="Seconds">How long; 0 for keys that are others again at once.</param>
/// <param name="AutoRun">Runs ahead without a key.</param>
internal sealed record WalkLeg(MovementKeys Keys, double Seconds, bool AutoRun = false);

/// <summary>A mistake in a script, and where.</summary>
internal sealed class WalkScriptException(string message, int position) : Exception(message)
{
    /// <summary>Index of the first character that is wrong, from 0.</summary>
    public int Position { get; } = position;
}

/// <summary>
/// Reads what the hands do: legs separated by <c>;</c>, each some keys joined by <c>+</c> and a number of seconds, as in
/// <c>W 3; W+Space 0.6; Wait 1</c>. <c>Auto</c> among the keys runs ahead without one.
/// </summary>
internal static class WalkScript
{
    /// <summary>Longest script accepted, seconds.</summary>
    internal const double MaxSeconds = 3600;

    internal const string Example = "W 3; W+Space 0.6; W 2";

    private const string AutoRun = "Auto";

    private static readonly Dictionary<string, MovementKeys> KeyNames = new(StringComparer.OrdinalIgnoreCase)
    {
        ["W"] = MovementKeys.Forward,
        ["S"] = MovementKeys.Back,
        ["A"] = MovementKeys.TurnLeft,
        ["D"] = MovementKeys.TurnRight,
        ["Q"] = MovementKeys.SidestepLeft,
        ["E"] = MovementKeys.SidestepRight,
        ["Shift"] = MovementKeys.Walk,
        ["Space"] = MovementKeys.Jump,
        ["Wait"] = MovementKeys.None,
    };

    /// <exception cref="WalkScriptException">The script is wrong; the exception says where.</exception>
    internal static IReadOnlyList<WalkLeg> Parse(string script)
    {
        List<WalkLeg> legs = [];
        double total = 0;
        int start = 0;
        foreach (string part in script.Split(';'))
        {
            if (part.Trim().Length > 0)
            {
                WalkLeg leg = ParseLeg(part, start);
                total += leg.Seconds;
                if (total > MaxSeconds) throw new WalkScriptException($"the script is longer than {MaxSeconds:0} seconds", start);
                legs.Add(leg);
            }

            start += part.Length + 1;
        }

        if (legs.Count == 0) throw new WalkScriptException("the script is empty", 0);
        return legs;
    }

    private static WalkLeg ParseLeg(string part, int start)
    {
        int at = part.Length - part.TrimStart().Length;
        int space = part.IndexOf(' ', at);
        string keys = space < 0 ? part[at..].Trim() : part[at..space];
        MovementKeys held = MovementKeys.None;
        bool autoRun = false;
        int keyAt = start + at;
        foreach (string name in keys.Split('+'))
        {
            if (name.Trim().Equals(AutoRun, StringComparison.OrdinalIgnoreCase)) autoRun = true;
            else if (KeyNames.TryGetValue(name.Trim(), out MovementKeys key)) held |= key;
            else throw new WalkScriptException($"'{name}' is not a key; keys are {string.Join(", ", KeyNames.Keys)}, {AutoRun}", keyAt);
            keyAt += name.Length + 1;
        }

        string number = space < 0 ? "" : part[space..].Trim();
        int numberAt = space < 0
            ? start + part.TrimEnd().Length
            : start + space + (part[space..].Length - part[space..].TrimStart().Length);
        if (!double.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out double seconds) || !double.IsFinite(seconds) ||
            seconds < 0)
            throw new WalkScriptException(
                number.Length == 0 ? "a number of seconds is missing" : $"'{number}' is not a number of seconds, 0 or more", numberAt);
        return new WalkLeg(held, seconds, autoRun);
    }
}
