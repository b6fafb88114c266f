using System.Numerics;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>A client of a <see cref="SimulatedHost"/>: its session, and what it was told.</summary>
internal sealed class TestClient : ISessionHandler, IDatagramSink
{
    private readonly SimulatedHost host;
    private readonly SimulatedLine line;
    private readonly ClientAddress address;
    private readonly Queue<SimulatedDatagram> forClient = new();

    internal TestClient(
        SimulatedHost host, ClientAddress address, string account, string password, NetworkQuality quality, ulong seed,
        Func<ClientSessionOptions, ClientSessionOptions>? change)
    {
        this.host = host;
        this.address = address;
        line = new SimulatedLine(seed) { Quality = quality };
        ClientSessionOptions options = new() { Account = account, Password = password };
        Session = new ClientSession(change is null ? options : change(options), this);
    }

    internal ClientSession Session { get; }

    internal ClientAddress Address => address;

    internal uint Id => Session.Player;

    /// <summary>Nothing gets through any more, either way.</summary>
    internal bool IsCutOff { get; set; }

    /// <summary>What this client sends is lost.</summary>
    internal bool IsMute { get; set; }

    /// <summary>It remembers nothing but what it must to play on.</summary>
    internal bool IsForgetful { get; set; }

    /// <summary>Is shown what the client sends.</summary>
    internal Action<byte[]>? Sends { get; set; }

    internal Dictionary<uint, CreateObject> Objects { get; } = [];

    internal List<DeleteObject> Deleted { get; } = [];

    internal List<UpdateMotion> Motions { get; } = [];

    internal List<UpdatePosition> Positions { get; } = [];

    internal List<SetState> States { get; } = [];

    internal List<VectorUpdate> Vectors { get; } = [];

    internal List<PlayerTeleport> Teleports { get; } = [];

    internal List<UseDone> UsesDone { get; } = [];

    internal List<string> Texts { get; } = [];

    internal List<CharacterError> Errors { get; } = [];

    internal List<MessageId> Heard { get; } = [];

    internal PlayerDescription? Description { get; private set; }

    /// <summary>The stamps that its claims must have, as it was told.</summary>
    internal MovementStamps Stamps { get; private set; }

    /// <summary>Makes the character when the account has none, enters the world and says that it has loaded it.</summary>
    internal void EnterAs(string name)
    {
        host.RunUntil(() => Session.State is SessionState.CharacterSelect or SessionState.Failed, 60);
        Assert.Equal(SessionState.CharacterSelect, Session.State);
        if (!Session.Characters!.Value.Characters.Any(one => one.Name == name))
        {
            Session.CreateCharacter(new CharacterCreate { Name = name, Strength = 60, Quickness = 60, Coordination = 60, Endurance = 60 });
            Assert.True(host.RunUntil(() => Session.Creation is not null, 60));
            Assert.Equal(1u, Session.Creation!.Value.Result);
        }

        Session.EnterWorld(Session.Characters!.Value.Characters.First(one => one.Name == name).Guid);
        Assert.True(host.RunUntil(() => Objects.ContainsKey(Id) && Id != 0, 60), Session.Refusal?.Sentence);
        Session.Send(new LoginComplete());
        Assert.True(host.RunUntil(() => States.Any(state => state.Guid == Id), 60));
    }

    internal void Update()
    {
        while (forClient.TryDequeue(out SimulatedDatagram datagram))
        {
            Session.Receive(datagram.Bytes, host.Now, this);
            line.Free(datagram);
        }

        Session.Update(host.Now, this);
    }

    /// <summary>Hands over what has arrived: to the server what is its, the rest to the client's next update.</summary>
    internal void Deliver(Queue<(byte[] Bytes, ClientAddress From, ServerPort Port)> toServer)
    {
        while (line.TryTake(host.Now, out SimulatedDatagram? datagram))
        {
            if (!datagram.Value.ToServer)
            {
                forClient.Enqueue(datagram.Value);
                continue;
            }

            toServer.Enqueue((datagram.Value.Bytes.ToArray(), address, datagram.Value.Port));
            line.Free(datagram.Value);
        }
    }

    internal void SendFromServer(ReadOnlySpan<byte> datagram, ServerPort port)
    {
        if (!IsCutOff) line.Send(datagram, port, toServer: false, host.Now);
    }

    void IDatagramSink.Send(ReadOnlySpan<byte> datagram, ServerPort port)
    {
        Sends?.Invoke(datagram.ToArray());
        if (!IsCutOff && !IsMute) line.Send(datagram, port, toServer: true, host.Now);
    }

    /// <summary>Claims to be somewhere, standing.</summary>
    internal void ClaimPlace(in WirePosition place) => Session.Send(new AutonomousPosition(place, Stamps, Contact: true));

    /// <summary>Where it was last told that it is.</summary>
    internal WirePosition Place => Positions.LastOrDefault(position => position.Guid == Id) is { Guid: not 0 } told
        ? told.Pack.Position
        : Objects[Id].Object.Physics.Position!.Value;

    internal static WirePosition Beside(in WirePosition place, float east, float north) =>
        place with { Origin = place.Origin + new Vector3(east, north, 0) };

    void ISessionHandler.OnStateChanged(SessionState state)
    {
    }

    void IMessageReceiver.OnMessage(in WireMessage message)
    {
        if (IsForgetful && message.Id.Opcode is Opcode.UpdateMotion or Opcode.VectorUpdate) return;
        if (!IsForgetful) Heard.Add(message.Id);
        if (message.TryRead(out CreateObject create))
        {
            Objects[create.Object.Guid] = create;
            if (create.Object.Guid == Id) Stamps = Of(create.Object.Physics.Stamps);
        }
        else if (message.TryRead(out DeleteObject gone))
        {
            Deleted.Add(gone);
            Objects.Remove(gone.Guid);
        }
        else if (message.TryRead(out UpdateMotion motion))
        {
            Motions.Add(motion);
            if (motion.Guid == Id) Stamps = Stamps with { ServerControlledMove = motion.ServerControlledMove };
        }
        else if (message.TryRead(out UpdatePosition position))
        {
            if (!IsForgetful) Positions.Add(position);
            if (position.Guid == Id)
                Stamps = Stamps with { Teleport = position.Pack.Teleport, ForcePosition = position.Pack.ForcePosition };
        }
        else if (message.TryRead(out SetState state))
        {
            if (!IsForgetful || state.Guid == Id) States.Add(state);
        }
        else if (message.TryRead(out VectorUpdate vector)) Vectors.Add(vector);
        else if (message.TryRead(out PlayerTeleport teleport)) Teleports.Add(teleport);
        else if (message.TryRead(out UseDone done)) UsesDone.Add(done);
        else if (message.TryRead(out Chat chat)) Texts.Add(chat.Text);
        else if (message.TryRead(out HearSpeech speech)) Texts.Add(speech.Text);
        else if (message.TryRead(out CharacterError error)) Errors.Add(error);
        else if (message.TryRead(out PlayerDescription description)) Description = description;

        static MovementStamps Of(in ObjectStamps own) => new(own.Instance, own.ServerControlledMove, own.Teleport, own.ForcePosition);
    }
}
