using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>What of a server's words about an object matters to collisions.</summary>
/// <remarks>Specification 08, 6.7 (flags, and the status of player killers) and 02, 2.4.</remarks>
internal static class WeenieForms
{
    private const uint CreatureType = 0x10;
    private const uint Player = 0x8, PlayerKiller = 0x20, Corpse = 0x2000, FreePlayerKiller = 0x200000, PlayerKillerLite = 0x2000000;
    private const uint StatusKiller = 0x4, StatusFree = 0x20, StatusLite = 0x40;

    /// <summary>Number of the property that says whether a player is a killer.</summary>
    internal const uint StatusProperty = 134;

    /// <summary>Traits of an object as it is described.</summary>
    internal static WeenieTraits TraitsOf(WeenieDescription weenie)
    {
        WeenieTraits traits = WeenieTraits.Present;
        Set((weenie.ItemType & CreatureType) != 0, WeenieTraits.Creature);
        Set((weenie.Description & Player) != 0, WeenieTraits.Player);
        Set((weenie.Description & PlayerKiller) != 0, WeenieTraits.PK);
        Set((weenie.Description & PlayerKillerLite) != 0, WeenieTraits.PKLite);
        Set((weenie.Description & FreePlayerKiller) != 0, WeenieTraits.Impenetrable);
        Set((weenie.Description & Corpse) != 0, WeenieTraits.Corpse);
        Set(weenie.HookItemTypes is not null and not 0, WeenieTraits.Hook);
        return traits;

        void Set(bool has, WeenieTraits trait) => traits |= has ? trait : 0;
    }

    /// <summary>Traits of a player whose status changed.</summary>
    internal static WeenieTraits WithStatus(WeenieTraits traits, int status) =>
        (traits & ~(WeenieTraits.PK | WeenieTraits.PKLite | WeenieTraits.Impenetrable)) | ((uint)status switch
        {
            StatusKiller => WeenieTraits.PK,
            StatusLite => WeenieTraits.PKLite,
            StatusFree => WeenieTraits.Impenetrable,
            _ => 0,
        });
}
