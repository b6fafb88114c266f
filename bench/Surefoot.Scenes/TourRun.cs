using System.Numerics;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Scenes;

/// <summary>
/// A player with restless fingers who is taken from one place of the demo world to the next, among all who are spawned there; at each a
/// ball, an arrow, a giant and a creature are thrown as well.
/// </summary>
internal sealed class TourRun : SceneRun
{
    private const int QuantaPerPlace = 75, QuantaPerKeys = 15;
    private const uint PlayerId = 0x50000001, FirstThrown = 0x60000001, FirstSpawned = 0x80000001;
    private const uint SmallCreatureSetup = 0x02000100;

    private static readonly SetupAsset Ball = SetupAsset.OfSpheres(0x02FF0001, [new Sphere(Vector3.Zero, 0.25f)], 0.3f, 0.3f);
    private static readonly SetupAsset Arrow = SetupAsset.OfSpheres(0x02FF0002, [new Sphere(Vector3.Zero, 0.1f)]);

    private static readonly MovementKeys[] Fingers =
    [
        MovementKeys.Forward, MovementKeys.Forward | MovementKeys.TurnLeft, MovementKeys.Forward | MovementKeys.Jump, MovementKeys.Back,
        MovementKeys.SidestepLeft, MovementKeys.Forward | MovementKeys.SidestepRight, MovementKeys.Forward | MovementKeys.Walk,
        MovementKeys.Forward | MovementKeys.TurnRight | MovementKeys.Jump, MovementKeys.None,
        MovementKeys.SidestepRight | MovementKeys.Jump,
    ];

    private readonly List<PhysicsBody> visitors = [];
    private LocalPlayer? player;
    private MovementKeys keys;
    private double now;
    private int quanta;
    private ulong rolls = 1;

    internal TourRun(DatSet dats)
        : base(dats)
    {
        uint id = FirstSpawned;
        foreach (DemoSpawn spawn in DemoSpawns.All)
        {
            bool door = spawn.Kind == DemoSpawnKind.Door;
            PhysicsBody body = Engine.CreateBody(
                id++, Cache.GetSetup(spawn.SetupId), door ? PhysicsState.ReportCollisions : PhysicsState.Default,
                door ? WeenieTraits.Present : WeenieTraits.Present | WeenieTraits.Creature);
            body.EnterWorld(new Position(spawn.CellId, new Frame(spawn.Origin, spawn.Orientation)));
        }
    }

    /// <summary>Quanta of the whole tour.</summary>
    internal static int QuantumCount => QuantaPerPlace * DemoPlaces.All.Length;

    public override void AdvanceQuantum()
    {
        if (quanta % QuantaPerPlace == 0) Visit(DemoPlaces.All[quanta / QuantaPerPlace % DemoPlaces.All.Length]);
        if (quanta % QuantaPerKeys == 0) keys = Fingers[(int)(Roll() * Fingers.Length)];
        quanta++;
        now += Quantum + 1e-9;
        player?.Update(keys, now);
        Engine.Tick(now);
    }

    private void Visit(NamedPlace place)
    {
        if (player is not null) Engine.RemoveBody(player.Body);
        foreach (PhysicsBody visitor in visitors) Engine.RemoveBody(visitor);
        visitors.Clear();

        Position position = Load(place.Name, 1);
        LoopbackServer server = new(PlayerId, new CharacterStats((int)(Roll() * 800), (int)(Roll() * 800)), Engine.Now);
        player = LocalPlayer.Spawn(Engine, PlayerId, Human, Motions, position, server);
        Engine.Player = player?.Body;
        const PhysicsState plain = PhysicsState.Gravity | PhysicsState.ReportCollisions;
        Throw(position, Engine.CreateBody(FirstThrown, Ball, plain, WeenieTraits.Present));
        Throw(
            position, Engine.CreateBody(FirstThrown + 1, Arrow,
                plain | PhysicsState.Missile | PhysicsState.PathClipped | PhysicsState.AlignPath, WeenieTraits.Present));
        Throw(position, Engine.CreateBody(FirstThrown + 2, Human, weenie: WeenieTraits.Present | WeenieTraits.Creature, scale: 1.5f));
        Throw(position,
            Engine.CreateBody(FirstThrown + 3, Cache.GetSetup(SmallCreatureSetup), plain, WeenieTraits.Present | WeenieTraits.Creature));
    }

    private void Throw(Position position, PhysicsBody body)
    {
        visitors.Add(body);
        position.Frame.Origin += new Vector3(Roll(-3, 3), Roll(-3, 3), Roll(0, 2));
        if (CellIds.IsOutdoor(position.CellId)) position.AdjustToOutside();
        if (CellIds.HasValidIndex(position.CellId) && body.EnterWorld(position))
            body.SetVelocity(new Vector3(Roll(-15, 15), Roll(-15, 15), Roll(-3, 10)));
    }

    private float Roll(float from, float to) => (float)(from + ((to - from) * Roll()));

    /// <summary>A number in [0, 1) from the tour's own seed (SplitMix64).</summary>
    private double Roll()
    {
        rolls += 0x9E3779B97F4A7C15;
        ulong z = rolls;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53));
    }
}
