using System.Numerics;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Many bodies that a server moves.</summary>
public class RemoteCrowdTests
{
    private const uint Count = 200;

    [Fact]
    [Behaviour("remote.allocates-nothing", "design, decision 4")]
    public void Two_hundred_creatures_that_follow_a_server_allocate_nothing_nor_do_its_positions_and_velocities()
    {
        RemoteFixture f = new();
        for (uint i = 0; i < Count; i++) f.Create(Describe(One + i, PlaceOf(i)));
        byte[] buffer = new byte[256];
        ushort stamp = 0;
        Run(100);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(100);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
        Assert.True(f.Body.IsInterpolating && f.Remote.Find(One + Count - 1)!.Body.IsInterpolating);
        Assert.Equal(0, f.Remote.Drops.Total);

        void Run(int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                // Each second a new place for everybody, two metres to and fro, and the same runners with a word on their way.
                if (i % 30 == 0)
                {
                    stamp++;
                    for (uint k = 0; k < Count; k++)
                    {
                        Say(PositionOf(PlaceOf(k) + new Vector3(0, stamp % 2 == 0 ? 0 : 12, 0), stamp, guid: One + k));
                        Say(MotionOf(stamp, stamp, RemoteFixture.Run(), guid: One + k));
                    }
                }

                f.Frames(1);
            }
        }

        void Say<T>(in T message)
            where T : IMessage<T>
        {
            Assert.True(WireMessage.TryWrite(message, buffer, out int length));
            f.SayBytes(buffer.AsSpan(0, length));
        }

        static Vector3 PlaceOf(uint i) => Start + new Vector3(2 * (i % 20), 2 * (i / 20), 0);
    }

    [Fact]
    [Behaviour("remote.same-messages-same-bits", "design, decision 5")]
    public void The_same_messages_give_the_same_bits()
    {
        ulong[] hashes = new ulong[2];
        for (int run = 0; run < 2; run++)
        {
            RemoteFixture f = new();
            Random random = new(7);
            for (uint i = 0; i < 20; i++) f.Create(Describe(One + i, Start + new Vector3(2 * i, 0, 0)));
            for (ushort stamp = 1; stamp < 100; stamp++)
            {
                uint who = One + (uint)random.Next(20);
                f.Say(MotionOf(stamp, stamp, RemoteFixture.Run(1 + random.NextSingle()), guid: who));
                f.Say(PositionOf(Start + new Vector3(random.Next(40), random.Next(10), 0), stamp, guid: who));
                f.Frames(3);
            }

            hashes[run] = f.Engine.HashState();
        }

        Assert.Equal(hashes[0], hashes[1]);
    }
}
