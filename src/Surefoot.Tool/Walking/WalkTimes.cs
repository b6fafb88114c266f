using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Surefoot.Client;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Walking;

/// <summary>
/// The frames of a walk on a server: when each was, which keys were held, and where the body was then. The same keys at the same times,
/// from the same place, bring an offline body to the same places, bit for bit.
/// </summary>
internal sealed class WalkTimes
{
    private readonly List<TimedFrame> frames;
    private bool begun;

    internal WalkTimes(LocalPlayer player)
        : this(player.Weenie.Stats, [])
    {
    }

    private WalkTimes(CharacterStats stats, List<TimedFrame> frames)
    {
        Stats = stats;
        this.frames = frames;
    }

    /// <summary>The character's numbers at the beginning.</summary>
    internal CharacterStats Stats { get; }

    /// <summary>The frames, in order. In the first one bodies moved; the walk begins where the body was after it.</summary>
    internal IReadOnlyList<TimedFrame> Frames => frames;

    /// <summary>A frame is over.</summary>
    /// <param name="player">The player.</param>
    /// <param name="keys">Keys held in it.</param>
    /// <param name="now">Its time, seconds.</param>
    /// <param name="moved">Bodies moved in it.</param>
    internal void Add(LocalPlayer player, MovementKeys keys, double now, bool moved)
    {
        begun |= moved;
        if (begun) frames.Add(new TimedFrame(now, keys, player.Body.Position));
    }

    /// <summary>Writes a file that <see cref="Read"/> reads: numbers that give the same bits again.</summary>
    internal void Write(string file)
    {
        using StreamWriter writer = new(file);
        writer.WriteLine(JsonSerializer.Serialize(Stats));
        foreach (TimedFrame f in frames)
        {
            (Vector3 o, Quaternion r) = (f.Position.Frame.Origin, f.Position.Frame.Rotation);
            writer.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{f.Now:R} {(int)f.Keys} {f.Position.CellId:X8} {o.X:R} {o.Y:R} {o.Z:R} {r.W:R} {r.X:R} {r.Y:R} {r.Z:R}"));
        }
    }

    /// <exception cref="InvalidDataException">That is no such file; the message says where.</exception>
    internal static WalkTimes Read(string file)
    {
        string[] lines = File.ReadAllLines(file);
        try
        {
            List<TimedFrame> frames = [.. lines.Skip(1).Select(ReadFrame)];
            if (frames.Count > 0) return new WalkTimes(JsonSerializer.Deserialize<CharacterStats>(lines[0]), frames);
        }
        catch (Exception e) when (e is FormatException or JsonException or OverflowException)
        {
        }

        throw new InvalidDataException($"'{file}' holds no recorded times: 'surefoot connect --script … --times FILE' writes them.");
    }

    private static TimedFrame ReadFrame(string line)
    {
        string[] words = line.Split(' ');
        if (words.Length != 10) throw new FormatException();
        float[] n = [.. words[3..].Select(word => float.Parse(word, CultureInfo.InvariantCulture))];
        double now = double.Parse(words[0], CultureInfo.InvariantCulture);
        Position position = new(
            uint.Parse(words[2], NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture),
            new Frame(new Vector3(n[0], n[1], n[2]), new Quaternion(n[4], n[5], n[6], n[3])));
        if (!double.IsFinite(now) || !position.IsValid) throw new FormatException();
        return new TimedFrame(now, (MovementKeys)int.Parse(words[1], CultureInfo.InvariantCulture), position);
    }
}

/// <summary>A frame of a walk on a server.</summary>
/// <param name="Now">Its time, seconds.</param>
/// <param name="Keys">Keys held in it.</param>
/// <param name="Position">Where the body was.</param>
internal readonly record struct TimedFrame(double Now, MovementKeys Keys, Position Position);
