using Surefoot.Client;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Authority;

/// <summary>
/// A client at a place, with a world of its own that ticks 30 times a second, and a server's authority over its player, which hears each
/// message at once.
/// </summary>
internal sealed class AuthorityFixture : IMovementObserver
{
    internal const uint PlayerId = 0x50000001;
    private const double FrameTime = (1.0 / 30) + 1e-9;

    private int frames;

    internal AuthorityFixture(
        DemoGround ground, string place, float right = 0, CharacterStats? stats = null, AuthorityOptions? options = null, float turn = 0)
    {
        Stats = stats ?? new CharacterStats(200, 200);
        Position at = DemoGround.At(place, right);
        at.Frame.SetHeading((float)((at.Frame.Heading + turn + 360) % 360));
        World = ground.EngineAt(place);
        Server = ground.EngineAt(place);
        Player = LocalPlayer.Spawn(
            World, PlayerId, ground.Human, ground.Motions, at, new LoopbackServer(PlayerId, Stats, 0),
            new LocalPlayerOptions { Observer = this })!;
        Authority = new MovementAuthority(Server, ground.Human, ground.Motions, Stats, options);
        Assert.True(Authority.TryPlace(Player.Body.Position, 0));
    }

    internal CharacterStats Stats { get; }

    internal PhysicsEngine World { get; }

    internal PhysicsEngine Server { get; }

    internal LocalPlayer Player { get; }

    internal MovementAuthority Authority { get; }

    internal PhysicsBody Body => Player.Body;

    internal double Now => frames * FrameTime;

    /// <summary>The verdicts so far.</summary>
    internal List<ClaimVerdict> Verdicts { get; } = [];

    /// <summary>The verdicts that were no acceptance.</summary>
    internal IEnumerable<ClaimVerdict> Objections => Verdicts.Where(verdict => !verdict.IsAccepted);

    internal ClaimVerdict Last => Verdicts[^1];

    /// <summary>The last message about keys.</summary>
    internal MoveToState LastMove { get; private set; }

    /// <summary>The last message about a jump.</summary>
    internal Jump LastJump { get; private set; }

    /// <summary>What a client says of where its body is.</summary>
    internal AutonomousPosition Here => At(Body.Position);

    internal static AutonomousPosition At(in Position place) =>
        new(new WirePosition(place.CellId, place.Frame.Origin, place.Frame.Rotation), new MovementStamps(1, 0, 0, 0), Contact: true);

    internal void Hold(MovementKeys keys, double seconds, Action? each = null)
    {
        for (double end = Now + seconds; Now < end;)
        {
            frames++;
            Player.Update(keys, Now);
            World.Tick(Now);
            each?.Invoke();
        }
    }

    /// <summary>The client says where its body is although no rule asks for it.</summary>
    internal ClaimVerdict Say(in AutonomousPosition message)
    {
        Verdicts.Add(Authority.Judge(message, Now));
        return Last;
    }

    public void OnMoveToState(in MoveToState message, double now)
    {
        LastMove = message;
        Verdicts.Add(Authority.Judge(message, now));
    }

    public void OnJump(in Jump message, double now)
    {
        LastJump = message;
        Verdicts.Add(Authority.Judge(message, now));
    }

    public void OnAutonomousPosition(in AutonomousPosition message, double now) => Verdicts.Add(Authority.Judge(message, now));
}
