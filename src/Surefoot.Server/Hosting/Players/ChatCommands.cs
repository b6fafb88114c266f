using System.Globalization;
using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>Commands that players give by chat.</summary>
internal static class ChatCommands
{
    private const string Help =
        "@teleloc CELL X Y Z [QW QX QY QZ] | @start | @loc | @follow | @flee | @stand | @roam (the nearest creature) | @help";

    /// <summary>Does what a text asks for; the player is told what came of it when nothing can be seen.</summary>
    public static void Take(WorldStage stage, PlayerItem player, string text)
    {
        if (stage.Server.Options.Commands == CommandRights.Administrators && !player.Client.IsAdministrator)
        {
            player.Say("Commands are for administrators here.");
            return;
        }

        string[] words = text.Split([' ', ','], StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        switch (words[0].ToLowerInvariant())
        {
            case "@teleloc":
                if (!TryReadPlace(words, player.Place, out Position place)) player.Say("It is: @teleloc 0xA8B50033 152 60 20");
                else if (!player.TryTeleport(place)) player.Say("Nobody can be there.");
                break;
            case "@start":
                if (!player.TryTeleport(stage.Server.Options.Start)) player.Say("Nobody can be there.");
                break;
            case "@loc":
                player.Say($"You are at {player.Place}.");
                break;
            case "@follow" or "@flee" or "@stand" or "@roam":
                Ask(stage, player, words[0].ToLowerInvariant());
                break;
            default:
                player.Say(Help);
                break;
        }
    }

    private static void Ask(WorldStage stage, PlayerItem player, string wish)
    {
        CreatureItem? nearest = null;
        foreach (WorldItem item in stage.Items)
        {
            if (item is not CreatureItem { IsThere: true } creature || !player.Awareness.Knows(item)) continue;
            if (nearest is null || creature.Place.DistanceTo(player.Place) < nearest.Place.DistanceTo(player.Place)) nearest = creature;
        }

        if (nearest is null) player.Say("There is no creature near.");
        nearest?.Ask(
            wish switch
            {
                "@follow" => CreatureWish.Follow,
                "@flee" => CreatureWish.Flee,
                "@stand" => CreatureWish.Stand,
                _ => CreatureWish.AsItLikes,
            },
            player.Id);
    }

    private static bool TryReadPlace(string[] words, in Position now, out Position place)
    {
        place = now;
        if (words.Length is not (5 or 9)) return false;
        string cell = words[1].StartsWith("0x", StringComparison.OrdinalIgnoreCase) ? words[1][2..] : words[1];
        if (!uint.TryParse(cell, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out uint id)) return false;
        Span<float> numbers = stackalloc float[words.Length - 2];
        for (int i = 0; i < numbers.Length; i++)
        {
            string word = words[i + 2].Trim('[', ']');
            if (!float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out numbers[i]) || !float.IsFinite(numbers[i]))
                return false;
        }

        Quaternion turn = numbers.Length > 3
            ? new Quaternion(numbers[4], numbers[5], numbers[6], numbers[3])
            : now.Frame.Rotation;
        place = new Position(id, new Frame(new Vector3(numbers[0], numbers[1], numbers[2]), turn));
        return place.IsValid;
    }
}
