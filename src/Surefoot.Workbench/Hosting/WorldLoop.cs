using System.Threading.Channels;
using Microsoft.Extensions.Logging;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Hosting;

/// <summary>
/// The one loop that touches the world: takes what pages said, lets time pass, and tells the pages. It wakes far more often than physics
/// ticks, so that a tick comes as soon as its quantum is full and a key acts at the moment it arrives. All quanta are of one length: when
/// it wakes late it makes up for those that are due, so that what a player did can be done again. Without a page it sleeps, and so does the
/// world's time.
/// </summary>
internal sealed partial class WorldLoop(IWorkbenchWorld world, ServerCounters counters, TimeProvider clock, ILogger logger, int maxPlayers)
{
    private static readonly TimeSpan WakeEvery = TimeSpan.FromMilliseconds(4);

    /// <summary>Quanta made up for at once; time that is later still is lost.</summary>
    private const int MostQuantaDue = 8;

    private readonly Channel<(PageConnection Page, bool Enters)> doors = Channel.CreateUnbounded<(PageConnection, bool)>();
    private readonly List<Seat> seats = [];
    private readonly List<(uint Id, PlayerPose Pose)> others = [];
    private readonly List<TruePlace> truth = [];
    private readonly List<BodyPose> bodies = [];
    private readonly List<MovingPart> moving = [];
    private readonly long epoch = clock.GetTimestamp();
    private TimeSpan lost;
    private double lastTick;
    private long turns;
    private long rests;
    private int reserved;
    private uint lastId;
    private uint tick;

    /// <summary>Called after each tick with each player's pose, before it is sent; for tests that compare a page with the world.</summary>
    public Action<uint, uint, PlayerPose>? PosePublished { get; set; }

    /// <summary>How often the loop has looked after the world.</summary>
    public long Turns => Interlocked.Read(ref turns);

    /// <summary>How often it has gone to sleep.</summary>
    public long Rests => Interlocked.Read(ref rests);

    /// <summary>The world's time: seconds since the loop was made, without those in which nobody was there or it was late.</summary>
    private double Now => WorldTime.Floor((clock.GetElapsedTime(epoch) - lost).TotalSeconds);

    /// <summary>Reserves a seat for a page that is about to connect; false when all are taken.</summary>
    public bool TryReserve()
    {
        if (Interlocked.Increment(ref reserved) <= maxPlayers) return true;
        Interlocked.Decrement(ref reserved);
        return false;
    }

    /// <summary>Gives back a seat of <see cref="TryReserve"/>.</summary>
    public void Release() => Interlocked.Decrement(ref reserved);

    /// <summary>A page came: it gets a player at the next turn of the loop.</summary>
    public void Enter(PageConnection page) => doors.Writer.TryWrite((page, true));

    /// <summary>A page went: its player leaves at the next turn of the loop.</summary>
    public void Exit(PageConnection page) => doors.Writer.TryWrite((page, false));

    /// <summary>Runs until cancelled.</summary>
    public async Task RunAsync(CancellationToken stopping)
    {
        try
        {
            while (true)
            {
                await SleepAsync(stopping).ConfigureAwait(false);
                await PlayAsync(stopping).ConfigureAwait(false);
            }
        }
        catch (OperationCanceledException) when (stopping.IsCancellationRequested)
        {
            // Stopping is how the loop ends.
        }
        finally
        {
            foreach (Seat seat in seats) seat.Page.End();
        }
    }

    /// <summary>Waits until a page comes.</summary>
    private async Task SleepAsync(CancellationToken stopping)
    {
        long since = clock.GetTimestamp();
        Interlocked.Increment(ref rests);
        await doors.Reader.WaitToReadAsync(stopping).ConfigureAwait(false);
        lost += clock.GetElapsedTime(since);
    }

    /// <summary>Lets the world go on while a page is there.</summary>
    private async Task PlayAsync(CancellationToken stopping)
    {
        using PeriodicTimer timer = new(WakeEvery, clock);
        do Turn();
        while ((seats.Count > 0 || doors.Reader.TryPeek(out _)) && await timer.WaitForNextTickAsync(stopping).ConfigureAwait(false));
    }

    /// <summary>First the ticks that are due, then what is new: a key acts in the quantum in which it comes.</summary>
    private void Turn()
    {
        Interlocked.Increment(ref turns);
        double now = Now, late = now - lastTick - (MostQuantaDue * WorldTime.Quantum);
        if (late > 0)
        {
            lost += TimeSpan.FromSeconds(late);
            now -= late;
        }

        while (now - lastTick >= WorldTime.Quantum) Tick();
        OpenDoors(now);
        for (int i = seats.Count - 1; i >= 0; i--) Listen(seats[i], now);
    }

    private void Tick()
    {
        lastTick += WorldTime.Quantum;
        if (!world.Advance(lastTick)) return;
        tick++;
        counters.CountTick();
        Tell(lastTick);
    }

    private void OpenDoors(double now)
    {
        while (doors.Reader.TryRead(out (PageConnection Page, bool Enters) door))
        {
            if (door.Enters) Admit(door.Page, now);
            else if (seats.Find(seat => seat.Page == door.Page) is { } seat) Dismiss(seat);
        }
    }

    private void Admit(PageConnection page, double now)
    {
        uint id = ++lastId;
        try
        {
            PlayerSettings settings = PlayerSettings.Default;
            IWorkbenchPlayer player = world.Join(id, settings, world.Places[0], now);
            seats.Add(new Seat(id, page, player));
            counters.CountPlayer(1);
            page.Welcome(ServerFrames.Welcome(id, settings, world.BurdenCapacity, world.Places.Count, WireLimits.Quantum));
        }
        catch (Exception mistake) when (mistake is ArgumentException or InvalidOperationException)
        {
            LogPlayerFailed(logger, id, mistake);
            page.End();
        }
    }

    private void Dismiss(Seat seat)
    {
        seats.Remove(seat);
        world.Leave(seat.Player);
        seat.Page.End();
        counters.CountPlayer(-1);
    }

    private void Listen(Seat seat, double now)
    {
        try
        {
            while (seat.Page.TryTake(out ClientFrame frame)) Obey(seat, frame, now);
        }
        catch (Exception mistake) when (mistake is ArgumentException or InvalidOperationException)
        {
            LogPlayerFailed(logger, seat.Id, mistake);
            Dismiss(seat);
        }
    }

    private void Obey(Seat seat, in ClientFrame frame, double now)
    {
        switch (frame.Kind)
        {
            case FrameKind.Input:
                seat.Sequence = frame.Sequence;
                seat.Player.SetKeys(frame.Keys, now);
                break;
            case FrameKind.Settings:
                seat.Player.Configure(frame.Settings, now);
                break;
            case FrameKind.Goto:
                seat.Player.Goto(world.Places[frame.Place], now);
                break;
            case FrameKind.PlaceAt:
                seat.Player.Goto(new WorkbenchPlace("", frame.Cell, frame.Position, frame.Yaw), now);
                break;
            case FrameKind.Use:
                seat.Player.Use(now);
                break;
            case FrameKind.AskWalk:
                seat.Page.Send(ServerFrames.Walk(seat.Player.Walk));
                break;
            case FrameKind.Network:
                seat.Player.UseNetwork(frame.Network, frame.On);
                break;
            case FrameKind.Creature:
                seat.Player.Ask(frame.Body, frame.Wish);
                break;
            case FrameKind.Pointer:
                seat.Player.MovePointer(frame.Buttons, frame.Right, now);
                break;
            case FrameKind.MouseTurning:
                seat.Player.UseMouseTurning(frame.On, now);
                break;
            case FrameKind.AutoRun:
                seat.Player.ToggleAutoRun(now);
                break;
            case FrameKind.FocusLost:
                seat.Player.LoseFocus(now);
                break;
        }
    }

    private void Tell(double now)
    {
        foreach (Seat seat in seats)
        {
            PlayerPose pose = seat.Player.Pose;
            PosePublished?.Invoke(seat.Id, tick, pose);
            while (seat.Player.TryTakeEvent(out PlayerEvent happened)) seat.Page.Send(ServerFrames.Event(happened));
            while (seat.Player.TryTakeSentence(out string sentence)) seat.Page.Send(ServerFrames.Sentence(sentence));
            seat.Page.Send(ServerFrames.Pose(pose, tick, seat.Sequence, seats.Count));
            world.LookAtPlayers(seat.Player, others);
            if (others.Count > 0 || seat.HadCompany) seat.Page.Send(ServerFrames.Others(now, others));
            seat.HadCompany = others.Count > 0;
            world.LookAtTruth(seat.Player, truth);
            if (truth.Count > 0 || seat.KnewTruth) seat.Page.Send(ServerFrames.Truth(now, truth));
            seat.KnewTruth = truth.Count > 0;
            world.Look(seat.Player, bodies);
            if (IsNews(seat.Bodies, bodies)) seat.Page.Send(ServerFrames.Bodies(now, bodies));
            world.LookAtParts(seat.Player, moving);
            if (IsNews(seat.Moving, moving)) seat.Page.Send(ServerFrames.Moving(now, moving));
            if (IsNews(seat.Touches, seat.Player.Touches)) seat.Page.Send(ServerFrames.Touches(seat.Player.Touches));
        }
    }

    /// <summary>Is a list to be told: because it changed, or because it is time to say it again? Remembers it as told.</summary>
    private bool IsNews<T>(List<T> told, IReadOnlyList<T> list)
    {
        bool repeat = tick % WireLimits.RepeatEvery == 0 && list.Count > 0;
        if (!repeat && told.SequenceEqual(list)) return false;
        told.Clear();
        told.AddRange(list);
        return true;
    }

    [LoggerMessage(Level = LogLevel.Error, Message = "Player {Player} was removed because the world refused it")]
    private static partial void LogPlayerFailed(ILogger logger, uint player, Exception mistake);

    private sealed class Seat(uint id, PageConnection page, IWorkbenchPlayer player)
    {
        public uint Id => id;

        public PageConnection Page => page;

        public IWorkbenchPlayer Player => player;

        public uint Sequence { get; set; }

        /// <summary>The bodies that the page was told of last.</summary>
        public List<BodyPose> Bodies { get; } = [];

        /// <summary>The moving parts that the page was told of last.</summary>
        public List<MovingPart> Moving { get; } = [];

        /// <summary>The touches that the page was told of last.</summary>
        public List<Touch> Touches { get; } = [];

        /// <summary>Whether the last frame of others listed anyone; one empty frame follows the last of them.</summary>
        public bool HadCompany { get; set; }

        /// <summary>The same of the frame of true places.</summary>
        public bool KnewTruth { get; set; }
    }
}
