using System.Diagnostics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;
using Surefoot.Protocol.Tests.Support;

namespace Surefoot.Protocol.Tests.Peer;

/// <summary>One player on an <see cref="AceServer"/>.</summary>
internal sealed class AcePlayer : IDisposable
{
    private const double Frame = 0.015;

    private readonly Stopwatch watch = Stopwatch.StartNew();

    public AcePlayer(AceServer server, string account, string password = "testpass", string version = LoginRequest.LiveVersion)
        => Session = new WorldSession(
            server.Address, new ClientSessionOptions { Account = account, Password = password, Version = version });

    public WorldSession Session { get; }

    public ReceivedMessages Received { get; } = new();

    /// <summary>Letters that no account or character has had.</summary>
    public static string NewName(string start) => start + new string(Random.Shared.GetItems<char>("abcdefghijklmnopqrstuvwxyz", 8));

    /// <summary>Lets real time pass until something holds.</summary>
    /// <returns>False when it did not within the time.</returns>
    public bool Until(Func<bool> holds, double seconds = 20)
    {
        double end = watch.Elapsed.TotalSeconds + seconds;
        while (!holds() && watch.Elapsed.TotalSeconds < end)
        {
            Session.Update(Received);
            Thread.Sleep(TimeSpan.FromSeconds(Frame));
        }

        return holds();
    }

    public void Reach(SessionState state)
        => Assert.True(Until(() => Session.State == state), $"{state} wanted, {Session.State} reached: {Session.Failure?.Sentence}");

    /// <summary>Makes a character and enters the world with it.</summary>
    /// <returns>Where it stands.</returns>
    public WirePosition Enter(string name)
    {
        Reach(SessionState.CharacterSelect);
        uint[] skills = new uint[CharacterCreate.SkillCount];
        foreach (int untrained in (int[])[6, 7, 14, 15, 19, 20, 21, 27])
            skills[untrained] = 1;
        skills[22] = skills[24] = 2;
        Session.CreateCharacter(new CharacterCreate
        {
            Name = name,
            Strength = 60,
            Endurance = 60,
            Coordination = 60,
            Quickness = 60,
            Focus = 45,
            Self = 45,
            Skills = ValueList.Create<uint>(skills),
        });
        Assert.True(Until(() => Session.Creation is not null), "no answer to the creation");
        Assert.Equal(1u, Session.Creation!.Value.Result);

        Session.EnterWorld(Session.Creation.Value.Character!.Value.Guid);
        Reach(SessionState.InWorld);
        Assert.True(Until(() => Own().Any() && Received.Of<PlayerDescription>().Count > 0), "the character was not described");
        Session.Send(new LoginComplete());
        Assert.True(Until(() => Received.Of<SetState>().Any(m => m.Guid == Session.Player && (m.State & 0x4000) == 0)), "still hidden");
        return Own().First().Position!.Value;

        IEnumerable<PhysicsDescription> Own()
            => Received.Of<CreateObject>().Where(m => m.Object.Guid == Session.Player).Select(m => m.Object.Physics);
    }

    public void Dispose() => Session.Dispose();
}
