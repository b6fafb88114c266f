using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Scenes;

/// <summary>
/// Players who ran side by side through the same landblock, a few metres apart and listed in the same cells, and the quanta of their runs,
/// to be asked about again by as many threads.
/// </summary>
public sealed class ProbeRun : SceneRun
{
    private const int Quanta = 60, SettlingQuanta = 10;

    private readonly List<Way[]> runs = [];

    /// <summary>Lets them run.</summary>
    /// <param name="dats">The demo world's files.</param>
    /// <param name="place">Where the first one begins.</param>
    /// <param name="runners">How many there are.</param>
    /// <param name="spacing">Metres from one to the next.</param>
    public ProbeRun(DatSet dats, string place, int runners, float spacing)
        : base(dats)
    {
        Position first = Load(place, 2);
        List<LocalPlayer> players = [];
        for (int i = 0; i < runners; i++)
        {
            Position start = new(first.CellId, new Frame(first.Frame.Origin + (i * spacing * first.Frame.XAxis), first.Frame.Rotation));
            LoopbackServer server = new((uint)(i + 1), new CharacterStats(300, 300), Engine.Now);
            players.Add(LocalPlayer.Spawn(Engine, (uint)(i + 1), Human, Motions, start, server)
                ?? throw new InvalidOperationException($"There is no room at {place}."));
            runs.Add(new Way[Quanta]);
        }

        double now = 0;
        for (int quantum = -SettlingQuanta; quantum < Quanta; quantum++)
        {
            now += Quantum + 1e-9;
            for (int i = 0; i < runners; i++)
            {
                players[i].Update(quantum < 0 ? MovementKeys.None : MovementKeys.Forward, now);
                if (quantum >= 0) runs[i][quantum] = Way.Of(players[i].Body);
            }

            Engine.Tick(now);
            for (int i = 0; quantum >= 0 && i < runners; i++) runs[i][quantum] = runs[i][quantum] with { To = players[i].Body.Position };
        }

        Bodies = [.. players.Select(player => player.Body)];
    }

    /// <summary>Those who ran.</summary>
    public IReadOnlyList<PhysicsBody> Bodies { get; }

    /// <summary>All players go on by a quantum.</summary>
    public override void AdvanceQuantum() => Engine.Tick(Engine.Now + Quantum + 1e-9);

    /// <summary>Asks about each quantum of a player's run once.</summary>
    /// <param name="query">The asking thread's own.</param>
    /// <param name="runner">Which player.</param>
    /// <returns>How many questions that were.</returns>
    public int Ask(WorldQuery query, int runner)
    {
        ArgumentNullException.ThrowIfNull(query);
        PhysicsBody body = Bodies[runner];
        foreach (ref readonly Way way in runs[runner].AsSpan()) query.Sweep(body, way.From, way.To);
        return Quanta;
    }

    private readonly record struct Way(BodySeat From, Position To)
    {
        public static Way Of(PhysicsBody body) => new(
            new BodySeat(body.Position, body.Velocity, body.Transient, body.ContactPlane, body.ContactPlaneCellId, body.SlidingNormal),
            body.Position);
    }
}
