using System.Numerics;
using Surefoot.Client;
using Surefoot.Dats;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Scenes;

/// <summary>What a player does.</summary>
/// <param name="Place">Where it begins.</param>
/// <param name="Keys">The keys it holds.</param>
internal sealed record PlayerAct(string Place, MovementKeys Keys)
{
    /// <summary>Metres to the north and upwards from where the player came to be with its keys.</summary>
    public Vector2 Offset { get; init; }

    /// <summary>Velocity it begins with in the air, metres a second; null for a player on the ground.</summary>
    public Vector3? Airborne { get; init; }

    /// <summary>Quanta until it is put back where it began.</summary>
    public int Quanta { get; init; } = 60;
}

/// <summary>A player who holds some keys, and goes back to where it began now and then.</summary>
internal sealed class PlayerRun : SceneRun
{
    private const uint PlayerId = 0x50000001;
    private const int SettlingQuanta = 10, QuantaWithKeys = 2;

    private readonly PhysicsBody body;
    private readonly BodySeat seat;
    private readonly int quantaBeforeReturn;
    private int quanta;

    internal PlayerRun(DatSet dats, PlayerAct act)
        : base(dats)
    {
        LoopbackServer server = new(PlayerId, new CharacterStats(300, 300), Engine.Now);
        LocalPlayer player = LocalPlayer.Spawn(Engine, PlayerId, Human, Motions, Load(act.Place, 2), server)
            ?? throw new InvalidOperationException($"There is no room at {act.Place}.");
        double now = 0;
        for (int i = 0; i < SettlingQuanta + QuantaWithKeys; i++)
        {
            player.Update(i < SettlingQuanta ? MovementKeys.None : act.Keys, now += Quantum);
            Engine.Tick(now);
        }

        quantaBeforeReturn = act.Quanta;
        body = player.Body;
        Position start = body.Position;
        start.Frame.Origin += new Vector3(0, act.Offset.X, act.Offset.Y);
        seat = act.Airborne is { } velocity
            ? new BodySeat(start, velocity, TransientState.None, body.ContactPlane, body.ContactPlaneCellId, Vector3.Zero)
            : new BodySeat(start, body.Velocity, body.Transient, body.ContactPlane, body.ContactPlaneCellId, body.SlidingNormal);
        Return();
    }

    public override void AdvanceQuantum()
    {
        if (++quanta > quantaBeforeReturn) Return();
        body.AdvanceQuantum(Quantum);
    }

    private void Return()
    {
        quanta = 1;
        body.Seat(seat);
        body.SetActive(true);
    }
}
