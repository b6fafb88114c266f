using System.Diagnostics;
using System.Net;
using Surefoot.Physics.Assets;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>
/// A server that clients of the field log in to: many sessions, one world, on two ports of this machine. It is for tests, demos and load:
/// there are no fights, no things to carry, no houses.
/// <code>
/// using WorldServer server = new(new PhysicsDataCache(dats), new WorldServerOptions { Port = 0, Start = somewhere });
/// while (goesOn) server.Tick(seconds);   // on a loop of one's own, sixty times a second or more
/// server.Run(cancellation);              // or until somebody cancels
/// </code>
/// Everything happens on the thread that calls. Nothing is shared with another server but the shapes.
/// </summary>
/// <remarks>Specification 08, section 8.</remarks>
public sealed class WorldServer : IDisposable
{
    private const int MostDatagramsPerPass = 1024, LongestDatagram = 2048;

    /// <summary>So many sessions send in a pass of a loop of its own: what many have to send is spread over passes.</summary>
    private const int MostSendersPerPass = 32;

    /// <summary>For so long a pass takes what has arrived before it does the rest, seconds; what is left waits for the next one.</summary>
    private const double LongestReceiving = 0.004;

    private const double LongestSleep = 0.01, AddUpInterval = 1;

    private readonly IServerTransport transport;
    private readonly ClientTable clients;
    private readonly ServerMeter meter;
    private readonly byte[] buffer = new byte[LongestDatagram];
    private double addsUpAt = double.NegativeInfinity;
    private bool isClosed;
    private volatile bool resetsSteps;

    /// <summary>Opens the ports.</summary>
    /// <param name="cache">The shapes; over an open folder of dat files, which stays the caller's.</param>
    /// <param name="options">What it is like.</param>
    /// <exception cref="ArgumentException">An option is out of range.</exception>
    /// <exception cref="System.Net.Sockets.SocketException">A port is taken, or not for us.</exception>
    /// <exception cref="Surefoot.Dats.DatRecordMissingException">The region, a setup or a motion table is missing.</exception>
    /// <exception cref="Surefoot.Dats.DatFormatException">One of them is malformed.</exception>
    /// <exception cref="IOException">The file of characters cannot be read.</exception>
    /// <exception cref="InvalidDataException">It is no file of characters.</exception>
    public WorldServer(PhysicsDataCache cache, WorldServerOptions options)
        : this(cache, options, null)
    {
    }

    internal WorldServer(PhysicsDataCache cache, WorldServerOptions options, IServerTransport? transport)
    {
        ArgumentNullException.ThrowIfNull(cache);
        ArgumentNullException.ThrowIfNull(options);
        options.ThrowIfBad();
        Options = options;
        Characters = new CharacterBook(options);
        Lobby = new Lobby(this, Characters);
        Stage = new WorldStage(this, cache);
        this.transport = transport ?? new UdpTransport(options.Address, options.Port);
        clients = new ClientTable(this, this.transport, options.Accounts ?? new MemoryAccounts());
        meter = new ServerMeter(Figures);
    }

    /// <summary>Where clients find it: its first port.</summary>
    public IPEndPoint EndPoint => new(Options.Address, transport.Port);

    /// <summary>What it has counted.</summary>
    public ServerFigures Figures { get; } = new();

    /// <summary>The time of the last <see cref="Tick"/>, seconds.</summary>
    public double Now { get; private set; }

    internal WorldServerOptions Options { get; }

    internal CharacterBook Characters { get; }

    internal Lobby Lobby { get; }

    internal WorldStage Stage { get; }

    /// <summary>Takes what has arrived, lets the time pass in the world and sends what there is to send. Nothing in it waits.</summary>
    /// <param name="now">Seconds, by a clock that does not run backwards: a time before the last one counts as that.</param>
    /// <exception cref="ArgumentException">The time is not finite; nothing has changed.</exception>
    public void Tick(double now)
    {
        if (!double.IsFinite(now)) throw new ArgumentException("The time is not finite.", nameof(now));
        Pass(now, null);
    }

    /// <summary>Runs on the calling thread until it is cancelled; sessions are told then.</summary>
    public void Run(CancellationToken cancellation)
    {
        long began = Stopwatch.GetTimestamp();
        double before = Now;
        double Clock() => before + Stopwatch.GetElapsedTime(began).TotalSeconds;
        while (!cancellation.IsCancellationRequested)
        {
            transport.Wait(TimeSpan.FromSeconds(LongestSleep));
            Pass(Clock(), Clock);
        }

        Close();
    }

    /// <summary>What a person wants a creature to do.</summary>
    /// <param name="creature">Id of the creature; nothing happens when there is no such one.</param>
    /// <param name="wish">What it is to do.</param>
    /// <param name="player">Id of the person's player.</param>
    public void Ask(uint creature, CreatureWish wish, uint player) => (Stage.Find(creature) as CreatureItem)?.Ask(wish, player);

    /// <summary>Where a player is, by what the server believes; null when nobody of that name is in the world.</summary>
    /// <param name="name">The character's name.</param>
    public Position? FindPlayer(string name) =>
        Stage.Players.FirstOrDefault(player => player.Name.Equals(name, StringComparison.OrdinalIgnoreCase))?.Authority.Position;

    /// <summary>From the next pass on it is measured anew how long passes take. May be called on any thread.</summary>
    public void ResetStepTimes() => resetsSteps = true;

    /// <summary>Ends all sessions, keeps the characters and closes the ports.</summary>
    public void Dispose()
    {
        Close();
        clients.Dispose();
        meter.Dispose();
        transport.Dispose();
    }

    internal void Say(string line) => Options.Log?.Invoke(line);

    private void Close()
    {
        if (isClosed) return;
        isClosed = true;
        foreach (PlayerItem player in Stage.Players.ToArray()) player.BeginLeaving();
        clients.Close();
        Characters.Save();
    }

    private void Pass(double now, Func<double>? clock)
    {
        long began = Stopwatch.GetTimestamp();
        Now = Math.Max(Now, now);
        for (int i = 0; i < MostDatagramsPerPass; i++)
        {
            if (!transport.TryReceive(buffer, out ReadOnlySpan<byte> datagram, out ClientAddress from, out ServerPort port)) break;

            // What arrives in a long pass did not arrive at its begin: a claim would seem to come too soon.
            if (clock is not null) Now = Math.Max(Now, clock());
            clients.Receive(datagram, from, port);
            if (clock is not null && Stopwatch.GetElapsedTime(began).TotalSeconds > LongestReceiving) break;
        }

        Stage.Step(Now);
        clients.Update(clock is null ? int.MaxValue : MostSendersPerPass);
        if (Now >= addsUpAt) AddUp();
        if (resetsSteps) Figures.Steps.Clear();
        resetsSteps = false;
        double took = Stopwatch.GetElapsedTime(began).TotalSeconds;
        Figures.Steps.Add(took);
        meter.Step(took);
    }

    private void AddUp()
    {
        addsUpAt = Now + AddUpInterval;
        Figures.AddUp(clients.All.Select(client => client.Link.Statistics));
        (Figures.Sessions, Figures.Players, Figures.Objects) = (clients.Count, Stage.Players.Count, Stage.Items.Count);
    }
}
