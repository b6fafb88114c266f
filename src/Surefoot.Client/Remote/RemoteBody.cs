using System.Numerics;
using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>One object that a server moves: its body, and what was heard of it last.</summary>
/// <remarks>Specification 09, section 5.</remarks>
public sealed class RemoteBody
{
    private readonly IWeenieObj weenie;
    private readonly PhysicsEngine engine;
    private MessageStamps stamps;

    internal RemoteBody(PhysicsEngine engine, PhysicsBody body, ObjectDescription description, IWeenieObj weenie)
    {
        this.engine = engine;
        Body = body;
        this.weenie = weenie;
        Model = description.Model;
        Weenie = description.Weenie;
    }

    /// <summary>Id of the object.</summary>
    public uint Id => Body.Id;

    /// <summary>Its body.</summary>
    public PhysicsBody Body { get; }

    /// <summary>Its motions; null for one that has none.</summary>
    public MovementManager? Movement => engine.MovementOf(Body);

    /// <summary>What it is.</summary>
    public WeenieDescription Weenie { get; private set; }

    /// <summary>What it looks like, as changes of its setup.</summary>
    public ModelData Model { get; private set; }

    /// <summary>The stamps of what was heard of it last.</summary>
    internal MessageStamps Stamps => stamps;

    /// <summary>It was out of sight when it was looked at last: its timer runs.</summary>
    internal bool WasOutOfSight { get; set; }

    /// <summary>It waits for its cell to be loaded, or is held by somebody who does.</summary>
    internal bool IsOutOfSight => Body.IsLost || Body is { Cell: null, Parent: PhysicsBody { IsLost: true } };

    /// <summary>All nine stamps, as the object's description tells them.</summary>
    internal void TakeStamps(in ObjectStamps value) => stamps = WireForms.Of(value);

    /// <summary>What it is now.</summary>
    internal void TakeWeenie(WeenieDescription value)
    {
        Weenie = value;
        Body.SetWeenie(WeenieForms.TraitsOf(value));
    }

    /// <summary>Its player became a killer, or is none any more.</summary>
    internal void TakeKillerStatus(int status) => Body.SetWeenie(WeenieForms.WithStatus(Body.Weenie, status));

    /// <summary>Looks different, if that is news.</summary>
    /// <remarks>Retail: SmartBox::UpdateVisualDesc @0x00451F40.</remarks>
    internal bool TryTakeModel(ModelData model, ushort stamp)
    {
        if (!stamps.TryAdvance(ObjectStamp.ObjectDescription, stamp)) return false;
        Model = model;
        return true;
    }

    /// <summary>Is somewhere, if that is news: teleported, followed, or put there.</summary>
    /// <param name="place">Where.</param>
    /// <param name="contact">It stands on the ground there.</param>
    /// <param name="positionStamp">Number of the position.</param>
    /// <param name="teleport">Number of the last teleport.</param>
    /// <param name="placement">How its parts are put down when nothing animates them; null for as they are.</param>
    /// <remarks>Retail: SmartBox::HandleReceivedPosition @0x00453FD0, for another object than the player.</remarks>
    internal bool TryTakePosition(in Position place, bool contact, ushort positionStamp, ushort teleport, uint? placement)
    {
        if (!stamps.TryAcceptPosition(positionStamp, teleport, out bool teleported)) return false;
        Body.UnsetParent();
        PutDown(placement);
        Body.MoveOrTeleport(place, teleported, contact);
        return true;
    }

    /// <summary>Does what a server orders, if that is news. A body that has no motions ignores it.</summary>
    /// <param name="order">What it is to do.</param>
    /// <param name="movementStamp">Number of the order.</param>
    /// <param name="serverControlledMove">Number of the last order that its own player did not ask for.</param>
    /// <param name="autonomous">Its own player asked for it.</param>
    /// <param name="orders">Reads orders.</param>
    /// <param name="isReadable">The order can be obeyed.</param>
    /// <remarks>Retail: CPhysics::SetObjectMovement @0x00509690.</remarks>
    internal bool TryObey(
        in MovementData order, ushort movementStamp, ushort serverControlledMove, bool autonomous, ServerOrders orders, out bool isReadable)
    {
        isReadable = true;
        if (!stamps.TryAcceptMotion(movementStamp, serverControlledMove)) return false;
        isReadable = orders.TryObey(engine.MakeMovement(Body, weenie), order, autonomous);
        return true;
    }

    /// <summary>Moves with a velocity, if that is news.</summary>
    /// <remarks>Retail: SmartBox::DoVectorUpdate @0x004521C0.</remarks>
    internal bool TryTakeVelocity(Vector3 velocity, Vector3 omega, ushort stamp)
    {
        if (!stamps.TryAdvance(ObjectStamp.Vector, stamp)) return false;
        Body.SetVelocity(velocity);
        Body.SetOmega(omega);
        return true;
    }

    /// <summary>Has a state word, if that is news.</summary>
    /// <remarks>Retail: SmartBox::DoSetState @0x004520D0.</remarks>
    internal bool TryTakeState(uint state, ushort stamp)
    {
        if (!stamps.TryAdvance(ObjectStamp.State, stamp)) return false;
        Body.SetState((PhysicsState)state);
        return true;
    }

    /// <summary>Leaves the world into somebody's pack, if that is news.</summary>
    /// <remarks>Retail: SmartBox::DoPickupEvent @0x00452240.</remarks>
    internal bool TryLeave(ushort positionStamp)
    {
        if (!stamps.TryAdvance(ObjectStamp.Position, positionStamp)) return false;
        Body.UnsetParent();
        Body.LeaveWorld();
        return true;
    }

    /// <summary>Is held by another body, if that is news.</summary>
    /// <param name="holder">Who holds it.</param>
    /// <param name="location">Number of the holder's holding location.</param>
    /// <param name="placement">How its parts are put down; null for as they are.</param>
    /// <param name="positionStamp">Number of its position.</param>
    /// <param name="isHeld">The holder took it.</param>
    /// <remarks>Retail: SmartBox::DoParentEvent @0x00452290. The parts are put down also when the holder has no such location.</remarks>
    internal bool TryBeHeld(PhysicsBody holder, uint location, uint? placement, ushort positionStamp, out bool isHeld)
    {
        isHeld = false;
        if (!stamps.TryAdvance(ObjectStamp.Position, positionStamp)) return false;
        isHeld = Body.SetParent(holder, location);
        if (placement is { } way) Body.SetPlacement(way);
        return true;
    }

    /// <summary>Puts the parts down in some way, unless an animation moves them.</summary>
    internal void PutDown(uint? placement)
    {
        if (placement is { } way && Movement?.Animation?.CurrentAnimation is null) Body.SetPlacement(way);
    }
}
