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

    /// <summary>May a motion act? Not one for another life of the object, nor a repeated or late one. What is newer is stored all the
    /// same.</summary>
    /// <remarks>Retail: CPhysics::SetObjectMovement @0x00509690; specification 08, 4.3 and 09, 5.4.</remarks>
    public bool Accepts(in UpdateMotion motion) =>
        stamps.AgeOf(motion.Instance) == InstanceAge.Current && stamps.TryAcceptMotion(motion.MovementStamp, motion.ServerControlledMove);
}
