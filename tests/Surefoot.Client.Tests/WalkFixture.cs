using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

/// <summary>A player on an endless plain at z = 0, with a world that ticks 30 times a second.</summary>
internal sealed class WalkFixture
{
    /// <summary>A little more than 1/30 s, so that each frame is a quantum whatever the rounding of the clock.</summary>
    internal const double FrameTime = (1.0 / 30) + 1e-9;

    /// <summary>The foot's sphere reaches 5 mm below the body's origin, as in retail's human.</summary>
    internal const float RestHeight = 0.005f;

    private const uint PlayerId = 1;

    private int frames;

    internal WalkFixture(CharacterStats stats, double latency = 0, bool smooth = false, Func<Vector3, Plane?>? ground = null)
    {
        World = new StubWorld(ground ?? (_ => StubWorld.Flat(0)));
        Engine = new PhysicsEngine(World);
        Table = HumanoidTable.Create(smooth);
        Server = new LoopbackServer(PlayerId, stats, Engine.Now, latency);
        Player = LocalPlayer.Spawn(
            Engine, PlayerId, Setup, Table, new Position(StubWorld.CellId, new Vector3(12, 12, 0)), Server,
            new LocalPlayerOptions { Observer = Sent })!;
        Engine.Player = Player.Body;
        Hold(MovementKeys.None, 5);
    }

    internal static Physics.Assets.SetupAsset Setup { get; } =
        StubWorld.Setup(new(new Vector3(0, 0, 0.475f), 0.48f), new(new Vector3(0, 0, 1.35f), 0.48f));

    internal StubWorld World { get; }

    internal PhysicsEngine Engine { get; }

    internal MotionTableAsset Table { get; }

    internal LoopbackServer Server { get; }

    internal LocalPlayer Player { get; }

    internal Recorder Sent { get; } = new();

    internal PhysicsBody Body => Player.Body;

    internal Vector3 Origin => Body.Position.Frame.Origin;

    /// <summary>Height above the place where the body stands, metres.</summary>
    internal float Height => Origin.Z - RestHeight;

    internal double Now => frames * FrameTime;

    /// <summary>Holds keys for a number of frames.</summary>
    internal void Hold(MovementKeys keys, int count)
    {
        for (int i = 0; i < count; i++)
        {
            frames++;
            Player.Update(keys, Now);
            Engine.Tick(Now);
        }
    }

    /// <summary>Horizontal speed over a time in which keys are held, m/s.</summary>
    internal double SpeedOver(MovementKeys keys, double seconds)
    {
        Vector3 from = Origin;
        int count = (int)Math.Round(seconds / FrameTime);
        Hold(keys, count);
        Vector3 moved = Origin - from;
        return Math.Sqrt(((double)moved.X * moved.X) + ((double)moved.Y * moved.Y)) / (count * FrameTime);
    }
}
