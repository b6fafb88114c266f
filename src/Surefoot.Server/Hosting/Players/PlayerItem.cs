using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server;

/// <summary>A client's player in the world: its place is what its client says and the server believes.</summary>
internal sealed class PlayerItem : WorldItem
{
    private const double LogOffTakes = 6, LongestPortal = 300;
    private const byte ItemCapacity = 102, PackCapacity = 7, RadarAlways = 4;
    private const uint Unusable = 1, PlayerFlags = 0x1C, AdministratorFlag = 0x100000;
    private const float UseRadius = 0.25f;
    private const ushort LogOut = 0x11E, FirstActionStamp = 1;
    private const uint TextOfTheServer = 0;

    private readonly Character character;
    private double hiddenSince;
    private uint settledBlock;

    public PlayerItem(WorldStage stage, ClientConnection client, Character character, MovementAuthority authority)
        : base(stage)
    {
        this.character = character;
        Client = client;
        Authority = authority;
        character.Logins++;
        Body = stage.Engine.CreateBody(
            character.Guid, stage.Human, PhysicsState.ReportCollisions,
            WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player);
        Audience.Owner = client;
        Broadcast = new PlayerBroadcast(
            character.Guid, WireOf(authority.Position), Audience, character.Stats.RunRate(), character.Logins)
        {
            Detail = stage.Server.Options.Detail,
            BeginsHidden = true,
        };
        Awareness = new Awareness(stage, this);
        Claims = new PlayerClaims(stage, this);
        Use = new PlayerUse(stage, this);
        Inbox = new PlayerInbox(stage, this);
    }

    public override PhysicsBody Body { get; }

    public override ushort Instance => Broadcast.Stamps.Instance;

    public ClientConnection Client { get; }

    /// <summary>What everybody is told of it.</summary>
    public PlayerBroadcast Broadcast { get; }

    public MovementAuthority Authority { get; }

    public Awareness Awareness { get; }

    public PlayerInbox Inbox { get; }

    public PlayerClaims Claims { get; }

    public PlayerUse Use { get; }

    /// <summary>It is out of the world, and its client waits to be told so.</summary>
    public bool IsLeaving { get; private set; }

    /// <summary>When its client is told so, seconds.</summary>
    public double OutAt { get; private set; }

    public string Name => character.Name;

    /// <summary>Factor on its running speed.</summary>
    public float RunRate => Broadcast.RunRate;

    /// <summary>It enters the world: its client is told all about it.</summary>
    /// <remarks>Specification 08, 8.6.</remarks>
    public void Enter()
    {
        character.IsOnline = true;
        hiddenSince = Stage.Server.Now;
        Client.Player = this;
        Client.IsSelecting = false;
        Client.BeginEvents();
        Authority.Stamps = MovementStamps();
        MoveTo(Authority.Position);
        Client.Send(character.Describe(Client.IsAdministrator));
        Client.Send(new Titles(1, 0, []));
        Client.Send(new Friends(0));
        Client.Send(new Chat($"Welcome to {Stage.Server.Options.WorldName}.", TextOfTheServer));
        Client.Send(new PlayerCreate(Id));
        Client.Send(Describe());
    }

    /// <summary>Its client has loaded the place where it is: it is seen from now on.</summary>
    public void Appear()
    {
        if (!Broadcast.IsTeleporting) return;
        Authority.TryPlace(Authority.Position, Stage.Server.Now);
        Broadcast.EndTeleport();
    }

    /// <summary>Puts it somewhere else. It is hidden there until its client has loaded the place.</summary>
    /// <returns>False when nobody can be there.</returns>
    public bool TryTeleport(in Position place)
    {
        if (!Stage.TryPlace(Authority, place)) return false;
        Use.End();
        double now = Stage.Server.Now;
        hiddenSince = now;
        Client.Send(new PlayerTeleport(Next(Broadcast.Stamps.Teleport)));
        Broadcast.Teleport(WireOf(Authority.Position), now);
        Authority.Stamps = MovementStamps();
        MoveTo(Authority.Position);
        return true;
    }

    /// <summary>Puts its body where it is believed to be.</summary>
    public void MoveTo(in Position place)
    {
        uint block = CellIds.BlockOf(place.CellId);
        if (block != settledBlock) Stage.Settle(place);
        settledBlock = block;
        if (!Body.HasCell) Body.EnterWorld(place);
        Body.Seat(new BodySeat(place, Vector3.Zero, TransientState.None, default, 0, Vector3.Zero));
    }

    /// <summary>Lets the time pass.</summary>
    public void Update(double now)
    {
        if (!Client.IsAlive || (Broadcast.IsTeleporting && now - hiddenSince > LongestPortal))
        {
            BeginLeaving();
            return;
        }

        Awareness.Update(now);
        Broadcast.Update(now);
        Use.Update(now);
    }

    /// <summary>It leaves the world at once; its client is told later.</summary>
    /// <remarks>Specification 08, 3.6.</remarks>
    public void BeginLeaving()
    {
        if (IsLeaving) return;
        IsLeaving = true;
        OutAt = Stage.Server.Now + LogOffTakes;
        character.Place = Authority.Position;
        Broadcast.Order(MovementData.Motion(
            0, new WireInterpretedMotion(actions: new MotionActions([new MotionAction(LogOut, FirstActionStamp, false, 1)]))));
        Stage.Remove(this);
        Awareness.Clear();
        Stage.Server.Characters.Save();
        Stage.Server.Say($"{Name} left the world");
    }

    /// <summary>Its client has it no more, and selects a character again.</summary>
    /// <param name="tells">There is somebody to tell.</param>
    public void EndLeaving(bool tells)
    {
        Stage.LetGo(this);
        character.IsOnline = false;
        Client.Player = null;
        if (!tells || !Client.IsAlive) return;
        Client.Send(new LogOffReply());
        Stage.Server.Lobby.ShowCharacters(Client);
    }

    /// <summary>Its client is gone: it leaves without a word to it.</summary>
    public void LeaveAtOnce()
    {
        BeginLeaving();
        EndLeaving(tells: false);
    }

    /// <summary>Tells its client a line of text.</summary>
    public void Say(string text) => Client.Send(new Chat(text, TextOfTheServer));

    public override CreateObject Describe()
    {
        CreateObject plain = Broadcast.Describe(Stage.Human.Id, Stage.Human.DefaultMotionTableId, Name);
        ObjectDescription all = plain.Object;
        return new CreateObject(all with
        {
            Physics = all.Physics with { Autonomous = 0 },
            Weenie = all.Weenie with
            {
                ItemCapacity = ItemCapacity,
                ContainerCapacity = PackCapacity,
                Useability = Unusable,
                UseRadius = UseRadius,
                RadarBehavior = RadarAlways,
                Description = PlayerFlags | (Client.IsAdministrator ? AdministratorFlag : 0),
            },
        });
    }

    /// <summary>The stamps that its client's claims must have.</summary>
    public MovementStamps MovementStamps()
    {
        ObjectStamps own = Broadcast.Stamps;
        return new MovementStamps(own.Instance, own.ServerControlledMove, own.Teleport, own.ForcePosition);
    }
}
