using System.Net;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>Who may give commands to a <see cref="WorldServer"/> by chat, such as <c>@teleloc</c>.</summary>
public enum CommandRights
{
    /// <summary>Administrators' accounts.</summary>
    Administrators,

    /// <summary>Everybody: for tests and demos.</summary>
    Everybody,
}

/// <summary>What a <see cref="WorldServer"/> is like.</summary>
public sealed record WorldServerOptions
{
    /// <summary>Address of this machine that it listens to: by default nobody else's.</summary>
    public IPAddress Address { get; init; } = IPAddress.Loopback;

    /// <summary>The first port; the next one is used too. 0 for any that is free.</summary>
    public int Port { get; init; } = 9000;

    /// <summary>Name of the world, as clients show it.</summary>
    public string WorldName { get; init; } = "Surefoot";

    /// <summary>Most sessions at a time: 1 to 65535.</summary>
    public int Slots { get; init; } = 256;

    /// <summary>Most sessions at a time from one address; 0 for as many as there are slots.</summary>
    public int MostPerAddress { get; init; }

    /// <summary>Logins a second that are looked at from one address; four times as many at once. More than 0.</summary>
    public double LoginsPerSecond { get; init; } = 20;

    /// <summary>Where new characters enter the world. On the ground there, in a cell of the dat files.</summary>
    public required Position Start { get; init; }

    /// <summary>Whom and what it spawns.</summary>
    public IReadOnlyList<WorldSpawn> Spawns { get; init; } = [];

    /// <summary>Shape of players, 0x02…; it names their motions too.</summary>
    public uint PlayerSetup { get; init; } = 0x02000001;

    /// <summary>Run skill of all characters; null for what follows from their attributes.</summary>
    public int? RunSkill { get; init; }

    /// <summary>Jump skill of all characters; null for what follows from their attributes.</summary>
    public int? JumpSkill { get; init; }

    /// <summary>How what clients claim is judged; null when it is believed.</summary>
    public AuthorityOptions? Authority { get; init; } = new();

    /// <summary>How much others are told of a player.</summary>
    public BroadcastDetail Detail { get; init; } = BroadcastDetail.Live;

    /// <summary>Who may give commands by chat.</summary>
    public CommandRights Commands { get; init; } = CommandRights.Everybody;

    /// <summary>The accounts; null for accounts in memory that are made at their first login.</summary>
    public IAccounts? Accounts { get; init; }

    /// <summary>A file that keeps characters; null for memory alone.</summary>
    public string? CharacterFile { get; init; }

    /// <summary>Seed of creatures' ways.</summary>
    public ulong Seed { get; init; } = 1;

    /// <summary>Is told in one sentence what an operator should know: who comes and goes, what is refused. No password is ever in
    /// it.</summary>
    public Action<string>? Log { get; init; }

    internal void ThrowIfBad()
    {
        if (Slots is < 1 or > ushort.MaxValue) throw new ArgumentOutOfRangeException(nameof(Slots), Slots, "Slots are 1 to 65535.");
        if (MostPerAddress < 0)
            throw new ArgumentOutOfRangeException(nameof(MostPerAddress), MostPerAddress, "Sessions from one address are 0 or more.");
        if (!(LoginsPerSecond > 0) || !double.IsFinite(LoginsPerSecond))
            throw new ArgumentOutOfRangeException(nameof(LoginsPerSecond), LoginsPerSecond, "Logins a second are a number above 0.");
        if (Port is < 0 or >= IPEndPoint.MaxPort)
            throw new ArgumentOutOfRangeException(nameof(Port), Port, "A port is 0 to 65534: the next one is used too.");
        if (RunSkill < 0 || JumpSkill < 0) throw new ArgumentOutOfRangeException(nameof(RunSkill), "A skill is 0 or more.");
        if (!Start.IsValid) throw new ArgumentException("The start is not finite, or its id names no cell.", nameof(Start));
    }
}
