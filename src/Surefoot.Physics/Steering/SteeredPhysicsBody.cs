using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>A body of an engine, as its managers see it.</summary>
internal sealed partial class SteeredPhysicsBody(PhysicsBody body) : SteeredBody
{
    internal override uint Id => body.Id;

    internal override uint ParentId => body.Parent?.Id ?? 0;

    internal override Position Position => body.Position;

    internal override float Radius => body.Radius;

    internal override float Height => body.Height;

    internal override Vector3 AchievedVelocity => body.AchievedVelocity;

    internal override bool HasContact => body.HasContact;

    internal override bool HasCell => body.HasCell;

    internal override bool IsLocalPlayer => ReferenceEquals(body.Population.Player, body);

    internal override float PlayerDistance => body.PlayerDistance;

    internal override double Now => body.Population.Now;

    internal override float MaxSpeed => GetInterpreter()?.MaxSpeed ?? 0f;

    internal override float AdjustedMaxSpeed => GetInterpreter()?.AdjustedMaxSpeed ?? 0f;

    internal override bool MotionsPending => Manager is { MotionsPending: true };

    internal override MoveToManager? MoveTo => Manager?.MoveTo;

    /// <summary>The motion side; null for a body without motions.</summary>
    internal IBodyMovement? Movement { get; private set; }

    private MovementManager? Manager => Movement as MovementManager;

    /// <summary>What drives a body of an engine.</summary>
    internal static SteeredPhysicsBody Of(PhysicsBody body) => (SteeredPhysicsBody)body.Driver;

    internal override SteeredBody? Find(uint id) => body.Population.Find(id) is { } other ? Of(other) : null;

    internal override void Wake() => body.SetActive(true);

    internal override void SetHeading(float degrees) => body.SetHeading(degrees);

    internal override bool Place(in Position place) => body.SetPositionSimple(place, sliding: true) == PlacementResult.OK;

    internal override void TeleportHook() => body.TeleportHook();

    internal override MotionError DoMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        if (GetInterpreter() is not { } interpreter) return MotionError.NoInterpreter;
        interpreter.AdjustMotion(ref motion, ref parameters.Speed, parameters.HoldKey);
        return interpreter.DoInterpretedMotion(motion, parameters);
    }

    internal override MotionError StopMotion(MotionCommand motion, ref MovementParameters parameters)
    {
        if (GetInterpreter() is not { } interpreter) return MotionError.NoInterpreter;
        interpreter.AdjustMotion(ref motion, ref parameters.Speed, parameters.HoldKey);
        return interpreter.StopInterpretedMotion(motion, parameters);
    }

    internal override void StopCompletely() => Manager?.StopCompletely();

    internal override void OnMoveToEnded(MotionError error) => Manager?.OnMoveToEnded(error);

    /// <summary>The motion interpreter; a body without a movement side gets one in its default state.</summary>
    /// <returns>Null when something else than a movement manager moves the body.</returns>
    /// <remarks>Retail: CPhysicsObj::get_minterp @0x005120C0.</remarks>
    private MotionInterpreter? GetInterpreter()
    {
        if (Movement is null)
        {
            IWeenieObj? weenie = body.Weenie == WeenieTraits.None ? null : new OtherWeenie((body.Weenie & WeenieTraits.Creature) != 0);
            Attach(new MovementManager(body, table: null, weenie));
        }

        return Manager?.Interpreter;
    }
}
