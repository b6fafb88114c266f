using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>Whatever arrives: it is counted and dropped.</summary>
public sealed class ServerFuzzTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private static readonly int Datagrams = Fuzz.Cases(400_000), Messages = Fuzz.Cases(20_000);

    [Fact]
    [Behaviour("server.input.datagrams", "spec/08, 8.3: every failure is silent")]
    public void Damaged_datagrams_of_clients_and_strangers_are_dropped_and_little_is_sent_back()
    {
        SimulatedHost host = new(ground, options => options with { Spawns = [], Slots = 8 });
        TestClient watcher = host.Enter("Watcher");
        Random random = new(7);
        byte[] login = ServerLoginTests.LoginOf("flood");
        List<byte[]> seen = [login];
        TestClient honest = host.Connect("honest");
        honest.Sends = bytes => seen.Add(bytes);
        honest.EnterAs("Honest");
        Dictionary<ClientAddress, long> received = [];
        for (int i = 0; i < Datagrams; i++)
        {
            byte[] damaged = Damage(seen[random.Next(seen.Count)], random);
            ClientAddress from = i % 3 == 0 ? honest.Address : new ClientAddress(SimulatedHost.Loopback + (uint)random.Next(2, 20), 7);
            if (from != honest.Address) received[from] = received.GetValueOrDefault(from) + damaged.Length;
            host.SendAsStranger(damaged, from, random.Next(4) == 0 ? ServerPort.Second : ServerPort.First);
            if (i % 500 == 0) host.Run(1 / 60.0);
        }

        host.Run(1);
        Assert.True(host.Server.Figures.Faults == 0, FaultIn(host));
        Assert.All(host.SentToStrangers, sent => Assert.True(sent.Value <= 3 * received[sent.Key], $"{sent}"));

        // Nobody who was in has been disturbed.
        foreach (TestClient client in (TestClient[])[watcher, honest])
        {
            client.Session.Send(new Talk("still here"));
            Assert.True(host.RunUntil(() => client.Texts.Contains("still here"), 5));
        }
    }

    [Fact]
    [Behaviour("server.input.messages", "spec/08, 8.1: a message without meaning is ignored")]
    public void Damaged_messages_of_a_client_in_the_world_disturb_nobody()
    {
        SimulatedHost host = new(ground, options => options with { Slots = 8 });
        TestClient watcher = host.Enter("Watcher");
        Random random = new(11);
        for (int round = 0; round < 6; round++)
        {
            TestClient rogue = host.Enter($"rogue{round}", $"Rogue {(char)('a' + round)}");
            byte[][] models = Models(rogue, watcher.Id);
            for (int i = 0; i < Messages / 6; i++)
            {
                byte[] model = models[random.Next(models.Length)];
                byte[] damaged = random.Next(8) == 0 ? model : Damage(model, random);
                if (damaged.Length >= 4) rogue.Session.Send(damaged, (MessageGroup)random.Next(1, 10));
                if (i % 20 == 0) host.Run(1 / 60.0);
            }

            rogue.Session.Close();
            host.Run(3);
        }

        Assert.True(host.Server.Figures.Faults == 0, FaultIn(host));
        watcher.Session.Send(new Talk("still here"));
        Assert.True(host.RunUntil(() => watcher.Texts.Contains("still here"), 5));
        Assert.True(float.IsFinite(watcher.Place.Origin.LengthSquared()));
    }

    private static string? FaultIn(SimulatedHost host) =>
        host.Lines.FirstOrDefault(line => line.Contains("could not", StringComparison.Ordinal));

    private static byte[][] Models(TestClient client, uint other)
    {
        WirePosition place = client.Place;
        MovementStamps stamps = client.Stamps;
        return
        [
            Bytes(new MoveToState(new WireRawMotion(2, forwardCommand: 0x45000005), place, stamps, true, false)),
            Bytes(new AutonomousPosition(place, stamps, true)),
            Bytes(new Jump(0.5f, new(0, 2, 4), place, stamps)),
            Bytes(new Use(other)),
            Bytes(new Talk($"@teleloc 0x{place.Cell:X8} 10 10 10")),
            Bytes(new Talk("hello")),
            Bytes(new LoginComplete()),
            Bytes(new ForceObjDesc(other)),
            Bytes(new CharacterCreate { Account = "x", Name = "X" }),
            Bytes(new CharacterEnterWorld(client.Id, "x")),
            Bytes(new DddInterrogationResponse(1, [], 0, 0)),
        ];
    }

    private static byte[] Bytes<T>(in T message)
        where T : IMessage<T>
    {
        byte[] bytes = new byte[2048];
        Assert.True(WireMessage.TryWrite(message, bytes, out int length, stamp: 1));
        return bytes[..length];
    }

    private static byte[] Damage(byte[] whole, Random random)
    {
        byte[] bytes = [.. whole];
        switch (random.Next(4))
        {
            case 0:
                return bytes[..random.Next(bytes.Length + 1)];
            case 1:
                random.NextBytes(bytes);
                return bytes;
            case 2:
                for (int i = random.Next(1, 4); i > 0; i--) bytes[random.Next(bytes.Length)] ^= (byte)(1 << random.Next(8));
                return bytes;
            default:
                // A number of four bytes, of those that hurt.
                uint[] numbers = [0, 1, 0x7FC00000, 0x7F800000, 0xFFFFFFFF, 0x80000000, 0x7F7FFFFF, 0x00010000];
                if (bytes.Length >= 4)
                    BitConverter.TryWriteBytes(bytes.AsSpan(4 * random.Next(bytes.Length / 4)), numbers[random.Next(numbers.Length)]);
                return bytes;
        }
    }
}
