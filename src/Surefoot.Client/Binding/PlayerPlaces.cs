using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>
/// What a server says of where the local player is: its places, teleports and corrections, and its state word. The player's own simulation
/// is followed otherwise: a place alone ties the body to it by a leash, and its velocity is its own business.
/// </summary>
/// <remarks>Retail: SmartBox::HandleReceivedPosition @0x00453FD0; specification 08, 4.3 and 4.4, and 02, 4.17.</remarks>
internal sealed class PlayerPlaces(PhysicsBody body, MovementManager movement, PlayerObject player, Action<Position>? loadLand)
{
    private bool hasHidden;

    /// <summary>Messages that could not be read, or whose numbers can be meant by nobody.</summary>
    public long UnreadableCount { get; private set; }

    /// <summary>
    /// The player is between two places, or waits to be let into the world: until it has arrived, no key acts and no place is told.
    /// </summary>
    public bool IsInPortalSpace { get; private set; }

    /// <summary>It is at the other end, or will be as soon as the land there is loaded.</summary>
    public bool HasArrived { get; private set; }

    /// <summary>A correction was obeyed: the server waits to be told the place.</summary>
    public bool OwesPosition { get; private set; }

    /// <summary>A teleport was obeyed: the server waits to be told what the player does there.</summary>
    public bool OwesMotion { get; private set; }

    /// <summary>Takes a message about the player's object; others are not looked at.</summary>
    public void OnMessage(in WireMessage message)
    {
        switch (message.Id.Opcode)
        {
            case Opcode.PlayerTeleport when IsReadable(message, out PlayerTeleport teleport):
                if (player.AwaitsTeleport(teleport.Teleport)) EnterPortalSpace(hide: true);
                break;
            case Opcode.UpdatePosition when IsReadable(message, out UpdatePosition update):
                if (IsMeant(update.Guid, update.Pack.Instance)) Place(update.Pack);
                break;
            case Opcode.PositionAndMovement when IsReadable(message, out PositionAndMovement both):
                if (IsMeant(both.Position.Guid, both.Position.Pack.Instance)) Place(both.Position.Pack);
                break;
            case Opcode.SetState when IsReadable(message, out SetState state):
                if (IsMeant(state.Guid, state.Instance)) TakeState(state.State, state.StateStamp);
                break;
            case Opcode.VectorUpdate when IsReadable(message, out VectorUpdate vector):
                if (IsMeant(vector.Guid, vector.Instance)) player.TryAdvance(ObjectStamp.Vector, vector.VectorStamp);
                break;
            case Opcode.ObjDescEvent when IsReadable(message, out ObjDescEvent look):
                if (IsMeant(look.Guid, look.Instance)) player.TryAdvance(ObjectStamp.ObjectDescription, look.ObjDescStamp);
                break;
        }
    }

    /// <summary>Leaves one place for another that the server will tell.</summary>
    public void EnterPortalSpace(bool hide)
    {
        (IsInPortalSpace, HasArrived) = (true, false);
        if (!hide || body.State.Has(PhysicsState.Hidden)) return;
        hasHidden = true;
        body.SetHidden(true);
    }

    /// <summary>The body is where the server wants it, once the land there is loaded.</summary>
    public void Arrive() => HasArrived = IsInPortalSpace;

    /// <summary>The world is entered, and the server knows.</summary>
    public void LeavePortalSpace()
    {
        (IsInPortalSpace, HasArrived) = (false, false);
        if (!hasHidden) return;
        hasHidden = false;
        body.SetHidden(false);
    }

    /// <summary>The place was told, as a correction asks for.</summary>
    public void NotePosition() => OwesPosition = false;

    /// <summary>What the player does was told, as a teleport asks for.</summary>
    public void NoteMotion() => OwesMotion = false;

    /// <summary>A life of the object begins: it is put where it is described, and waits to be let in.</summary>
    /// <remarks>Specification 08, 3.5 and 4.5, step 3.</remarks>
    public void Begin(PhysicsDescription physics)
    {
        EnterPortalSpace(hide: false);
        if (physics.Position is not { Cell: not 0 } told) return;
        if (!WireForms.TryRead(told, out Position place))
        {
            UnreadableCount++;
            return;
        }

        loadLand?.Invoke(place);
        if (body.EnterWorld(place)) Arrive();
    }

    /// <summary>The object is described once more: each part acts by its own stamp.</summary>
    /// <remarks>Specification 08, 4.5, step 2.</remarks>
    public void Refresh(PhysicsDescription physics)
    {
        ObjectStamps stamps = physics.Stamps;
        player.TryAdvance(ObjectStamp.ObjectDescription, stamps.ObjDesc);
        if (physics.Position is { Cell: not 0 } told)
            Place(new PositionPack(told, contact: true, stamps.Instance, stamps.Position, stamps.Teleport, stamps.ForcePosition));
        TakeState(physics.State, stamps.State);
        player.TryAdvance(ObjectStamp.Vector, stamps.Vector);
    }

    private bool IsMeant(uint guid, ushort instance) => guid == player.Id && player.AgeOf(instance) == InstanceAge.Current;

    private void TakeState(uint state, ushort stamp)
    {
        if (!player.TryAdvance(ObjectStamp.State, stamp)) return;
        hasHidden = false;
        body.SetState((PhysicsState)state);
        if (IsInPortalSpace && !HasArrived && !body.State.Has(PhysicsState.Hidden)) LeavePortalSpace();
    }

    private void Place(in PositionPack pack)
    {
        if (!WireForms.TryRead(pack.Position, out Position place))
        {
            UnreadableCount++;
            return;
        }

        if (player.AcceptsForced(pack))
        {
            loadLand?.Invoke(place);
            place.Frame.SetHeading((float)body.Position.Frame.Heading);
            body.SetPositionSimple(place, sliding: true);
            OwesPosition = true;
            return;
        }

        if (!player.Accepts(pack, out bool teleported)) return;
        body.UnsetParent();
        if (movement.Animation?.CurrentAnimation is null) body.SetPlacement(pack.Placement);
        if (teleported)
        {
            loadLand?.Invoke(place);
            body.SetPositionSimple(place, sliding: true);
            body.TeleportHook();
        }

        body.ConstrainTo(
            place, CorrectionDistances.LeashStart(body.Position.CellId), CorrectionDistances.LeashMax(body.Position.CellId));
        if (!teleported) return;
        body.SetVelocity(Vector3.Zero);
        EnterPortalSpace(hide: false);
        Arrive();
        OwesMotion = true;
    }

    private bool IsReadable<T>(in WireMessage message, out T value)
        where T : IMessage<T>
    {
        if (message.TryRead(out value)) return true;
        UnreadableCount++;
        return false;
    }
}
