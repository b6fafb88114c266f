using Surefoot.Physics.Bodies;
using Surefoot.Protocol.Messages;

namespace Surefoot.Client;

/// <summary>The local player's object as its server knows it: the id, and the stamps of what was heard of it last.</summary>
internal sealed class PlayerObject(uint id, ObjectStamps stamps)
{
    private MessageStamps stamps = WireForms.Of(stamps);

    /// <summary>Id of the object.</summary>
    public uint Id => id;

    /// <summary>The stamps that go with what is told about its movement.</summary>
    public MovementStamps Sent => new(
        stamps[ObjectStamp.Instance], stamps[ObjectStamp.ServerControlledMove], stamps[ObjectStamp.Teleport],
        stamps[ObjectStamp.ForcePosition]);

    /// <summary>The object is described anew: its stamps are those of the description.</summary>
    public void TakeStamps(in ObjectStamps value) => stamps = WireForms.Of(value);

    /// <summary>Which life of the object a message is for.</summary>
    public InstanceAge AgeOf(ushort instance) => stamps.AgeOf(instance);

    /// <summary>Is a stamp newer than the one stored? It is stored then.</summary>
    public bool TryAdvance(ObjectStamp stamp, ushort value) => stamps.TryAdvance(stamp, value);

    /// <summary>May a motion act? Not one for another life of the object, nor a repeated or late one. What is newer is stored all the
    /// same.</summary>
    /// <remarks>Retail: CPhysics::SetObjectMovement @0x00509690; specification 08, 4.3 and 09, 5.4.</remarks>
    public bool Accepts(in UpdateMotion motion) =>
        stamps.AgeOf(motion.Instance) == InstanceAge.Current && stamps.TryAcceptMotion(motion.MovementStamp, motion.ServerControlledMove);

    /// <summary>Does a position force the player there?</summary>
    /// <remarks>Specification 08, 4.4, step 1.</remarks>
    public bool AcceptsForced(in PositionPack pack) =>
        stamps.TryAcceptForcedPosition(pack.PositionStamp, pack.Teleport, pack.ForcePosition);

    /// <summary>May a position act, and is it a teleport?</summary>
    /// <remarks>Specification 08, 4.4, steps 2, 3 and 5.</remarks>
    public bool Accepts(in PositionPack pack, out bool teleported) =>
        stamps.TryAcceptPosition(pack.PositionStamp, pack.Teleport, out teleported);

    /// <summary>Is the announcement of a teleport about one that has not been overtaken? Nothing is stored.</summary>
    /// <remarks>Specification 08, 4.3 (PlayerTeleport).</remarks>
    public bool AwaitsTeleport(ushort teleport) => !MessageStamps.IsNewer(teleport, stamps[ObjectStamp.Teleport]);
}
