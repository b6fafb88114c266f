using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Scenes;

/// <summary>Humans who run in circles and into each other.</summary>
public static class Runners
{
    /// <summary>How many are in the scenes of crowds.</summary>
    public const int CrowdSize = 200;

    internal const int PerRow = 20;

    /// <summary>Spawns them in rows of twenty from west to east, the next row to the north.</summary>
    /// <param name="engine">The world.</param>
    /// <param name="human">Their shape.</param>
    /// <param name="motions">Their motions.</param>
    /// <param name="south">The middle of the southernmost row, outdoors.</param>
    /// <param name="count">How many.</param>
    /// <param name="spacing">Metres from one to the next; a body is 0.96 m wide.</param>
    /// <exception cref="InvalidOperationException">There is no room for one.</exception>
    public static IReadOnlyList<PhysicsBody> Spawn(
        PhysicsEngine engine, SetupAsset human, MotionTableAsset motions, in Position south, int count, float spacing)
    {
        ArgumentNullException.ThrowIfNull(engine);
        List<PhysicsBody> runners = [];
        for (int i = 0; i < count; i++)
        {
            PhysicsBody body = engine.CreateBody(
                0x80000001 + (uint)i, human, weenie: WeenieTraits.Present | WeenieTraits.Creature,
                motions: new BodyMotions(motions, new PlayerWeenie(new CharacterStats(100, 100))));
            MovementManager movement = engine.MovementOf(body)!;
            Vector3 aside = new(spacing * ((i % PerRow) - (PerRow / 2)), spacing * (i / PerRow), 0);
            Position position = new(south.CellId, new Frame(south.Frame.Origin + aside, south.Frame.Rotation));
            position.AdjustToOutside();
            if (!body.EnterWorld(position)) throw new InvalidOperationException($"There is no room for runner {i + 1}.");
            movement.DoMotion(MotionCommand.WalkForward, new MovementParameters());
            movement.DoMotion(i % 2 == 0 ? MotionCommand.TurnRight : MotionCommand.TurnLeft, new MovementParameters());
            runners.Add(body);
        }

        return runners;
    }
}
