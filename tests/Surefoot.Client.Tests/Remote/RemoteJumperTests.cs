using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Server;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>What is drawn of a player who jumps, by what <see cref="BroadcastDetail.Full"/> tells of it.</summary>
public sealed class RemoteJumperTests : IAudience
{
    private const uint RunKey = 2;
    private const double Gravity = 9.8;

    private static readonly Vector3 Leap = new(0, 4, 5), Landing = Start + new Vector3(0, (float)(4 * 2 * 5 / Gravity), 0);
    private static readonly MovementStamps NoStamps = new(1, 0, 0, 0);

    private readonly RemoteFixture f = new();
    private readonly PlayerBroadcast broadcast;
    private readonly List<byte[]> held = [];
    private bool holds;

    public RemoteJumperTests()
    {
        broadcast = new PlayerBroadcast(One, At(Start), this) { Detail = BroadcastDetail.Full };
        f.CreateStanding(broadcast.Stamps);
    }

    void IAudience.Tell<T>(in T message)
    {
        if (holds) held.Add(f.Encode(message));
        else f.Say(message);
    }

    [Fact]
    [Behaviour("remote.followed-late-take-off", "spec/09, 4.4, 5.2 and 5.5; BroadcastDetail.Full")]
    public void A_take_off_that_comes_after_the_landing_moves_nobody_who_rests()
    {
        holds = true;
        Jump(Start);
        Pass(seconds: 0.5);
        byte[][] late = [.. held];
        Pass(seconds: 0.5);
        holds = false;
        Land(Landing);
        Pass(seconds: 2);
        Assert.Equal(Landing.Y, f.Origin.Y, 0.05f);
        foreach (byte[] message in late) f.SayBytes(message);
        for (int frame = 0; frame < 30; frame++)
        {
            Pass(seconds: 0.04);
            Assert.True(f.Body.OnWalkable);
            Assert.Equal(Landing.Y, f.Origin.Y, 0.05f);
        }
    }

    [Fact]
    [Behaviour("remote.followed-no-way-back", "spec/09, 3.2, 4.4 and 5.3; BroadcastDetail.Full")]
    public void Who_jumps_off_elsewhere_than_it_was_drawn_does_not_go_back_there_after_landing()
    {
        // Its client says where it is and that it jumps, in one moment; a place from before comes late.
        holds = true;
        broadcast.Take(new AutonomousPosition(At(Start + new Vector3(0, 0.5f, 0)), NoStamps, Contact: true), f.Now);
        broadcast.Update(f.Now);
        holds = false;
        Jump(Start + new Vector3(0, 1, 0));
        Pass(seconds: 0.2);
        Assert.False(f.Body.HasContact);
        foreach (byte[] message in held) f.SayBytes(message);
        float before = f.Origin.Y;
        Vector3 landed = default;
        for (int frame = 0; frame < 60; frame++)
        {
            if (frame == 30) Land(landed = f.Origin + new Vector3(0, 0.5f, 0));
            Pass(seconds: 0.04);
            Assert.True(f.Origin.Y >= before - 1e-3f, $"back from {before} to {f.Origin.Y}");
            before = f.Origin.Y;
        }

        Assert.Equal(landed.Y, f.Origin.Y, 0.05f);
    }

    private void Jump(Vector3 from)
    {
        broadcast.Take(new MoveToState(new WireRawMotion(RunKey), At(from), NoStamps, Contact: true, StandingLongJump: false), f.Now);
        broadcast.Take(new Jump(0.5f, Leap, At(from), NoStamps));
    }

    private void Land(Vector3 at) => broadcast.Take(new AutonomousPosition(At(at), NoStamps, Contact: true), f.Now);

    private void Pass(double seconds)
    {
        for (double end = f.Now + seconds; f.Now < end;)
        {
            broadcast.Update(f.Now);
            f.Frames(1);
        }
    }
}
