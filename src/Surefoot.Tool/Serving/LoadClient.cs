using System.Net;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Serving;

/// <summary>A client that logs in, plays a course from the start, is teleported back and plays it again.</summary>
internal sealed class LoadClient : ISessionHandler, IDisposable
{
    private const uint Hidden = 0x4000;

    private readonly LoadSocket socket;
    private readonly ClientSession session;
    private readonly LoadCourse course;
    private readonly byte[] buffer;
    private readonly string name;
    private MovementStamps stamps;
    private double began = double.PositiveInfinity;
    private int next;
    private bool isAsked;

    /// <summary>A client that asks for a session.</summary>
    /// <param name="server">The server.</param>
    /// <param name="course">What it plays.</param>
    /// <param name="account">Its account, and its password.</param>
    /// <param name="name">Its character.</param>
    /// <param name="buffer">Memory for a datagram, shared by those of one thread.</param>
    /// <param name="now">Seconds.</param>
    internal LoadClient(IPEndPoint server, LoadCourse course, string account, string name, byte[] buffer, double now)
    {
        this.buffer = buffer;
        this.course = course;
        this.name = name;
        socket = new LoadSocket(server);
        session = new ClientSession(new ClientSessionOptions { Account = account, Password = account, SilenceTimeout = 20 }, socket);
        session.Connect(now);
    }

    /// <summary>Its player is in the world and has loaded it.</summary>
    internal bool IsInWorld { get; private set; }

    /// <summary>Why its session ended; null while it has not.</summary>
    internal SessionFailure? Failure => session.Failure;

    /// <summary>What its session has counted.</summary>
    internal SessionStatistics Statistics => session.Statistics;

    /// <summary>Claims that it made.</summary>
    internal long Claims { get; private set; }

    /// <summary>How often the server put it somewhere.</summary>
    internal int Forced { get; private set; }

    /// <summary>Lets time pass.</summary>
    internal void Update(double now)
    {
        for (int length; (length = socket.Receive(buffer)) > 0;) session.Receive(buffer.AsSpan(0, length), now, this);
        session.Update(now, this);
        if (session.State == SessionState.CharacterSelect) Select();
        while (next < course.Messages.Count && now >= began + course.Messages[next].At) Tell(course.Messages[next++]);
        if (now >= began + course.Length) GoBack(now);
        if (double.IsNaN(began)) began = now;
        session.Flush();
    }

    public void Dispose()
    {
        session.Close();
        socket.Dispose();
    }

    void ISessionHandler.OnStateChanged(SessionState state)
    {
    }

    void IMessageReceiver.OnMessage(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.CreateObject when !IsInWorld && message.TryRead(out CreateObject create) && create.Object.Guid == session.Player:
                ObjectStamps own = create.Object.Physics.Stamps;
                stamps = new MovementStamps(own.Instance, own.ServerControlledMove, own.Teleport, own.ForcePosition);
                session.Send(new LoginComplete());
                break;
            case Opcode.SetState when message.TryRead(out SetState state) && state.Guid == session.Player && (state.State & Hidden) == 0:
                IsInWorld = true;
                (began, next) = (double.NaN, 0);
                break;
            case Opcode.UpdatePosition when message.TryRead(out UpdatePosition position) && position.Guid == session.Player:
                if (position.Pack.ForcePosition != stamps.ForcePosition) Forced++;
                stamps = stamps with { Teleport = position.Pack.Teleport, ForcePosition = position.Pack.ForcePosition };
                break;
            case Opcode.PlayerTeleport:
                began = double.PositiveInfinity;
                session.Send(new LoginComplete());
                break;
        }
    }

    private void Select()
    {
        CharacterEntry? own = session.Characters!.Value.Characters.Select(one => (CharacterEntry?)one).FirstOrDefault();
        if (own is { } character) session.EnterWorld(character.Guid);
        else if (!isAsked) session.CreateCharacter(new CharacterCreate { Name = name });
        isAsked = true;
    }

    private void GoBack(double now)
    {
        // The answer is a teleport; when it is lost it is asked for again.
        began = now + 5 - course.Length;
        next = course.Messages.Count;
        session.Send(new Talk("@start"));
    }

    private void Tell(LoadCourse.Told told)
    {
        Claims++;
        if (told.Move is { } move) session.Send(move with { Stamps = stamps });
        else if (told.Jump is { } jump) session.Send(jump with { Stamps = stamps });
        else if (told.Place is { } place) session.Send(place with { Stamps = stamps });
    }
}
