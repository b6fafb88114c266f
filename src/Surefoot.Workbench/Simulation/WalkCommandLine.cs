using System.Globalization;
using System.Numerics;
using System.Text;
using System.Text.RegularExpressions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>Keys held for a while.</summary>
/// <param name="Keys">The keys.</param>
/// <param name="AutoRun">The player runs ahead without a key.</param>
/// <param name="Seconds">How long; 0 for keys that others followed before the next quantum.</param>
internal readonly record struct WalkStretch(PlayerKeys Keys, bool AutoRun, double Seconds);

/// <summary>The words of <c>surefoot walk</c> for keys that were held.</summary>
internal static partial class WalkCommandLine
{
    private static readonly (PlayerKeys Key, string Name)[] Names =
    [
        (PlayerKeys.Forward, "W"), (PlayerKeys.Back, "S"), (PlayerKeys.TurnLeft, "A"), (PlayerKeys.TurnRight, "D"),
        (PlayerKeys.SidestepLeft, "Q"), (PlayerKeys.SidestepRight, "E"), (PlayerKeys.Walk, "Shift"), (PlayerKeys.Jump, "Space"),
    ];

    /// <summary>A command line that walks the stretches in quanta of <see cref="WorldTime"/>.</summary>
    /// <param name="start">Where.</param>
    /// <param name="settings">Skills and burden.</param>
    /// <param name="stretches">What the hands do.</param>
    /// <param name="datFolder">Folder of the files; null for the demo world.</param>
    public static string Write(in Position start, PlayerSettings settings, IReadOnlyList<WalkStretch> stretches, string? datFolder)
    {
        StringBuilder line = new();
        CultureInfo invariant = CultureInfo.InvariantCulture;
        line.Append(invariant, $"surefoot walk --at {PlaceOf(start)} --run {settings.RunSkill} --jump {settings.JumpSkill}");
        if (settings.Burden != 0) line.Append(invariant, $" --burden {settings.Burden}");
        if (datFolder is not null) line.Append(invariant, $" --dats {Quote(datFolder)}");
        line.Append(invariant, $" --quantum {WorldTime.Quantum * 1000} --script \"{ScriptOf(stretches)}\"");
        return line.ToString();
    }

    /// <summary>
    /// The place as <c>--at</c> reads it, to the last bit: with a heading where that says the rotation, as the game prints it where not.
    /// </summary>
    private static string PlaceOf(in Position place)
    {
        Vector3 at = place.Frame.Origin;
        Quaternion turn = place.Frame.Rotation;
        float heading = (float)place.Frame.Heading;
        Frame faced = new(at, Quaternion.Identity);
        faced.SetHeading(heading);
        return faced.Rotation == turn
            ? FormattableString.Invariant($"0x{place.CellId:X8},{at.X},{at.Y},{at.Z},{heading}")
            : FormattableString.Invariant($"\"0x{place.CellId:X8} [{at.X} {at.Y} {at.Z}] {turn.W} {turn.X} {turn.Y} {turn.Z}\"");
    }

    private static string ScriptOf(IReadOnlyList<WalkStretch> stretches) => stretches.Count == 0
        ? "Wait 1"
        : string.Join("; ", stretches.Select(one => FormattableString.Invariant($"{KeysOf(one)} {one.Seconds:0.###}")));

    private static string KeysOf(WalkStretch stretch)
    {
        IEnumerable<string> held = Names.Where(one => stretch.Keys.HasFlag(one.Key)).Select(one => one.Name);
        string keys = string.Join('+', stretch.AutoRun ? held.Prepend("Auto") : held);
        return keys.Length > 0 ? keys : "Wait";
    }

    /// <summary>A word that a shell takes as it is: of the system that the path is written for.</summary>
    private static string Quote(string path)
    {
        if (PlainPath().IsMatch(path)) return path;
        return WindowsPath().IsMatch(path) ? $"\"{path}\"" : $"'{path.Replace("'", "'\\''", StringComparison.Ordinal)}'";
    }

    [GeneratedRegex(@"^[\w./-]+$")]
    private static partial Regex PlainPath();

    [GeneratedRegex(@"^([A-Za-z]:)?\\")]
    private static partial Regex WindowsPath();
}
