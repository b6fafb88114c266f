using System.Collections.Concurrent;
using System.Numerics;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests.Support;

/// <summary>
/// A world of one rule each, for tests of what carries it: level ground at 20 m, ticks of at least 1/30 s, the formulas' speeds at once.
/// </summary>
internal sealed class StandInWorld : IWorkbenchWorld
{
    public const float Ground = 20f;
    public const uint DoorId = 0x80000001;

    public static readonly Vector3 DoorAt = new(101, 102, Ground);
    public static readonly Vector3 DoorSize = new(1.2f, 0.12f, 2.2f);

    private readonly List<StandInPlayer> players = [];
    private readonly ConcurrentQueue<double> moments = [];
    private double last = double.NaN;
    private bool doorIsOpen;

    public string Name => "Stand-in";

    public IReadOnlyList<WorkbenchPlace> Places { get; } =
    [
        new("Middle", 0xA9B40025, new Vector3(100, 100, Ground), 0),
        new("Far east", 0xAAB40025, new Vector3(100, 100, Ground), -MathF.PI / 2),
    ];

    public LeftOutNotice LeftOut => LeftOutNotice.Nothing;

    public int BurdenCapacity => 15_000;

    public int PlayerCount => players.Count;

    public bool Disposed { get; private set; }

    public IWorkbenchPlayer Join(uint id, PlayerSettings settings, WorkbenchPlace place, double now)
    {
        StandInPlayer player = new(id, settings, place, now, () => doorIsOpen = !doorIsOpen);
        players.Add(player);
        return player;
    }

    public void Leave(IWorkbenchPlayer player) => players.Remove((StandInPlayer)player);

    /// <summary>Closed, the world stands still, as a server does that hangs.</summary>
    public ManualResetEventSlim Gate { get; } = new(initialState: true);

    /// <summary>How often the world was advanced.</summary>
    public int Advances => moments.Count;

    /// <summary>When the world was advanced last, seconds.</summary>
    public double Now => moments.Max();

    /// <summary>When the world was first advanced after a moment, seconds.</summary>
    public double FirstAfter(double moment) => moments.Where(one => one > moment).Min();

    public bool Advance(double now)
    {
        Gate.Wait();
        moments.Enqueue(now);
        if (double.IsNaN(last)) last = now;
        float quantum = (float)(now - last);
        if (quantum < WireLimits.Quantum) return false;
        last = now;
        foreach (StandInPlayer player in players) player.Advance(quantum, now);
        return true;
    }

    public void LookAtPlayers(IWorkbenchPlayer player, List<(uint Id, PlayerPose Pose)> near)
    {
        near.Clear();
        foreach (StandInPlayer other in players)
            if (other != player) near.Add((other.Id, other.Pose));
    }

    public void LookAtTruth(IWorkbenchPlayer player, List<TruePlace> near)
    {
        near.Clear();
        foreach (StandInPlayer other in players)
            if (other != player && ((StandInPlayer)player).WantsTruth)
                near.Add(new TruePlace(other.Id, other.Pose.CellId, other.Pose.Position, other.Pose.Yaw));
    }

    public void Look(IWorkbenchPlayer player, List<BodyPose> near)
    {
        near.Clear();
        near.Add(
            new BodyPose(DoorId, BodyKind.Door, doorIsOpen ? BodyFlags.Open : BodyFlags.None, "door", 0xA9B40025, DoorAt, 0.5f,
                Vector3.Zero, 1, DoorSize));
    }

    public void LookAtParts(IWorkbenchPlayer player, List<MovingPart> near) => near.Clear();

    public TerrainBlock? ReadTerrain(ushort block)
    {
        if (block is < 0x1000 or > 0xEFFF) return null;
        float[] heights = new float[81];
        Array.Fill(heights, Ground);
        ushort[] words = new ushort[81];
        Array.Fill(words, (ushort)(1 << 2));
        return new TerrainBlock(heights, words, [.. Enumerable.Range(0, 64).Select(cell => cell % 3 == 0)]);
    }

    public BlockShapes? ReadShapes(ushort block) =>
        block == 0xA9B4
            ? new BlockShapes(
                [Vector3.Zero, Vector3.UnitX, Vector3.UnitY], [], [], [
                    new NamedShape(0xA9B40100, [Vector3.Zero, Vector3.UnitX, new Vector3(0, 0, 2)])],
                [new Plant(new Vector3(1, 2, 3), 0.5f, 4, IsRound: false)],
                [new MovingShape(3, 2, [Vector3.Zero, Vector3.UnitX, new Vector3(0, 0, 9)])])
            : null;

    public void Dispose()
    {
        Gate.Dispose();
        Disposed = true;
    }

    private sealed class StandInPlayer(uint id, PlayerSettings settings, WorkbenchPlace place, double joined, Action use) : IWorkbenchPlayer
    {
        private readonly Queue<PlayerEvent> events = [];
        private PlayerSettings settings = settings;
        private PlayerKeys keys;
        private double chargedSince = double.NaN;
        private Vector3 velocity;
        private bool airborne;

        public uint Id => id;

        public bool WantsTruth { get; private set; }

        public PlayerPose Pose { get; private set; } = new(
            joined, place.CellId, place.Position, place.Yaw, Vector3.Zero, 0, PoseFlags.Contact | PoseFlags.OnWalkable,
            new Plane(Vector3.UnitZ, -Ground), 0,
            WireLimits.Quantum, 1, 0x41000003, 1, 0, 0, 0);

        public void SetKeys(PlayerKeys now, double time)
        {
            if (now.HasFlag(PlayerKeys.Jump) && !keys.HasFlag(PlayerKeys.Jump)) chargedSince = time;
            if (!now.HasFlag(PlayerKeys.Jump) && keys.HasFlag(PlayerKeys.Jump)) Jump(time);
            keys = now;
        }

        public void MovePointer(PointerButtons held, float right, double now)
        {
        }

        public void UseMouseTurning(bool on, double now)
        {
        }

        public void ToggleAutoRun(double now)
        {
        }

        public void LoseFocus(double now) => keys = PlayerKeys.None;

        public void Configure(PlayerSettings changed, double time) => settings = changed;

        public void Goto(WorkbenchPlace where, double time) =>
            Pose = Pose with
            {
                CellId = where.CellId,
                Position = where.Position with { Z = Ground },
                Yaw = where.Yaw,
                Teleports = (byte)(Pose.Teleports + 1),
            };

        public IReadOnlyList<Touch> Touches =>
            [
                new Touch(true, TouchKind.Ground, Pose.CellId, Vector3.UnitZ, ""),
                new Touch(false, TouchKind.Body, DoorId, Vector3.UnitX, "door")];

        public void Ask(uint creature, CreatureWish wish)
        {
        }

        public void UseNetwork(NetworkQuality quality, bool showsTruth) => WantsTruth = showsTruth;

        public WalkReport Walk => new("surefoot walk", "nothing");

        public void Use(double now) => use();

        public bool TryTakeSentence(out string sentence)
        {
            sentence = "";
            return false;
        }

        public bool TryTakeEvent(out PlayerEvent happened) => events.TryDequeue(out happened);

        public void Advance(float quantum, double now)
        {
            float rate = ((settings.RunSkill / (settings.RunSkill + 200f) * 11f) + 4f) / 4f;
            float turn = Axis(PlayerKeys.TurnLeft, PlayerKeys.TurnRight) * 1.5f;
            float yaw = Pose.Yaw + (turn * quantum);
            float forward = keys.HasFlag(PlayerKeys.Forward) ? 1 : keys.HasFlag(PlayerKeys.Back) ? -0.65f : 0;
            float side = -Axis(PlayerKeys.SidestepLeft, PlayerKeys.SidestepRight);
            float speed = keys.HasFlag(PlayerKeys.Walk) ? 3.12f : 4f * rate;
            if (!airborne)
            {
                velocity = new Vector3((-MathF.Sin(yaw) * forward) + (MathF.Cos(yaw) * side),
                    (MathF.Cos(yaw) * forward) + (MathF.Sin(yaw) * side), 0) * speed;
            }
            else velocity.Z -= 9.8f * quantum;
            Vector3 position = Pose.Position + (velocity * quantum);
            if (airborne && position.Z <= Ground)
            {
                events.Enqueue(new PlayerEvent(PlayerEventKind.Landed, now, -velocity.Z));
                airborne = false;
                position.Z = Ground;
            }

            PoseFlags flags = airborne ? PoseFlags.None : PoseFlags.Contact | PoseFlags.OnWalkable;
            float charge = double.IsNaN(chargedSince) ? 0 : (float)Math.Min(1, now - chargedSince);
            if (!double.IsNaN(chargedSince)) flags |= PoseFlags.Charging;
            Pose = Pose with
            {
                Time = now,
                Position = position,
                Yaw = yaw,
                Velocity = velocity,
                Speed = new Vector2(velocity.X, velocity.Y).Length(),
                Flags = flags,
                Charge = charge,
                Quantum = quantum,
                RunRate = rate,
                ForwardSpeed = forward,
                SidestepSpeed = side,
                TurnSpeed = turn,
            };
        }

        private void Jump(double time)
        {
            float extent = (float)Math.Min(1, time - chargedSince);
            chargedSince = double.NaN;
            airborne = true;
            velocity.Z = MathF.Sqrt(19.6f * 4.2f * Math.Max(extent, 0.1f));
            events.Enqueue(new PlayerEvent(PlayerEventKind.Jumped, time, extent));
        }

        private float Axis(PlayerKeys positive, PlayerKeys negative) => (keys.HasFlag(positive) ? 1 : 0) - (keys.HasFlag(negative) ? 1 : 0);
    }
}
