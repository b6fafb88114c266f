using System.Runtime.CompilerServices;

namespace Surefoot.Physics.Bodies;

/// <summary>What a stamp of an object counts; the numbers are those of the wire.</summary>
internal enum ObjectStamp
{
    /// <summary>Positions, and being picked up or held.</summary>
    Position = 0,

    /// <summary>Motions.</summary>
    Movement = 1,

    /// <summary>State words.</summary>
    State = 2,

    /// <summary>Velocities.</summary>
    Vector = 3,

    /// <summary>Teleports.</summary>
    Teleport = 4,

    /// <summary>Motions that the object's own player did not ask for.</summary>
    ServerControlledMove = 5,

    /// <summary>Corrections of a player's position.</summary>
    ForcePosition = 6,

    /// <summary>Descriptions.</summary>
    ObjectDescription = 7,

    /// <summary>Lives of the object.</summary>
    Instance = 8,
}

/// <summary>How the instance stamp of a message compares with that of the object it is for.</summary>
internal enum InstanceAge
{
    /// <summary>The message is for the object as it is.</summary>
    Current,

    /// <summary>It is for an earlier life of the object and is dropped.</summary>
    Stale,

    /// <summary>It is for a life of the object that has not begun yet and has to wait.</summary>
    Ahead,
}

/// <summary>
/// The nine stamps of an object, 16 bits each, that say which message is newer. They wrap around. A test that finds a newer stamp stores
/// it, also when the message has no effect after that.
/// </summary>
/// <remarks>Retail: CPhysicsObj::update_times; specification 02, 2.7, 08, 4.3 and 09, 5.2.</remarks>
internal struct MessageStamps : IEquatable<MessageStamps>
{
    /// <summary>Number of stamps.</summary>
    public const int Count = 9;

    private Values values;

    /// <summary>Stamps as CreateObject tells them.</summary>
    /// <param name="stamps">Nine stamps in the order of <see cref="ObjectStamp"/>.</param>
    /// <exception cref="ArgumentException">There are not nine.</exception>
    public MessageStamps(ReadOnlySpan<ushort> stamps)
    {
        if (stamps.Length != Count) throw new ArgumentException("An object has nine stamps.", nameof(stamps));
        stamps.CopyTo(values);
    }

    /// <summary>A stamp.</summary>
    public readonly ushort this[ObjectStamp stamp] => values[(int)stamp];

    /// <summary>Is a stamp newer than the one stored? Exactly half way round the smaller number is.</summary>
    /// <remarks>Retail: CPhysicsObj::is_newer @0x00451AD0.</remarks>
    public static bool IsNewer(ushort stored, ushort incoming) =>
        Math.Abs(incoming - stored) > 0x7FFF ? incoming < stored : stored < incoming;

    /// <summary>Stores a stamp when it is newer, and says whether it was.</summary>
    /// <remarks>Retail: CPhysicsObj::newer_event @0x00451B10.</remarks>
    public bool TryAdvance(ObjectStamp stamp, ushort incoming)
    {
        if (!IsNewer(values[(int)stamp], incoming)) return false;
        values[(int)stamp] = incoming;
        return true;
    }

    /// <summary>Which life of the object a message is for.</summary>
    public readonly InstanceAge AgeOf(ushort instance)
    {
        ushort own = this[ObjectStamp.Instance];
        return instance == own ? InstanceAge.Current : IsNewer(own, instance) ? InstanceAge.Ahead : InstanceAge.Stale;
    }

    /// <summary>
    /// May a position act? A repeated or late one may not, nor one from before a teleport, which leaves the position stamp as it was.
    /// </summary>
    /// <param name="position">Position stamp of the message.</param>
    /// <param name="teleport">Teleport stamp of the message.</param>
    /// <param name="teleported">The teleport stamp is newer: the object was teleported there.</param>
    /// <remarks>Retail: HandleReceivedPosition @0x00453FD0 and the test in CPhysicsObj::MoveOrTeleport @0x00516330.</remarks>
    public bool TryAcceptPosition(ushort position, ushort teleport, out bool teleported)
    {
        teleported = false;
        ushort before = this[ObjectStamp.Position];
        if (!TryAdvance(ObjectStamp.Position, position)) return false;
        if (IsNewer(teleport, this[ObjectStamp.Teleport]))
        {
            values[(int)ObjectStamp.Position] = before;
            return false;
        }

        teleported = TryAdvance(ObjectStamp.Teleport, teleport);
        return true;
    }

    /// <summary>
    /// Does a position of the local player force it there? The position stamp is then taken as it is. A newer correction from before a
    /// teleport does not, and stays stored.
    /// </summary>
    /// <param name="position">Position stamp of the message.</param>
    /// <param name="teleport">Teleport stamp of the message.</param>
    /// <param name="force">Stamp of the correction.</param>
    /// <remarks>Specification 08, 4.4, step 1.</remarks>
    public bool TryAcceptForcedPosition(ushort position, ushort teleport, ushort force)
    {
        if (!TryAdvance(ObjectStamp.ForcePosition, force) || IsNewer(teleport, this[ObjectStamp.Teleport])) return false;
        values[(int)ObjectStamp.Position] = position;
        return true;
    }

    /// <summary>May a motion act? One that a later order of the server overtook may not, but its movement stamp is used up.</summary>
    /// <param name="movement">Movement stamp of the message.</param>
    /// <param name="serverControlledMove">Its stamp of motions that a server ordered.</param>
    /// <remarks>Retail: CPhysics::SetObjectMovement @0x00509690.</remarks>
    public bool TryAcceptMotion(ushort movement, ushort serverControlledMove)
    {
        if (!TryAdvance(ObjectStamp.Movement, movement)) return false;
        if (IsNewer(serverControlledMove, this[ObjectStamp.ServerControlledMove])) return false;
        values[(int)ObjectStamp.ServerControlledMove] = serverControlledMove;
        return true;
    }

    /// <inheritdoc/>
    public readonly bool Equals(MessageStamps other) => ((ReadOnlySpan<ushort>)values).SequenceEqual(other.values);

    /// <inheritdoc/>
    public override readonly bool Equals(object? obj) => obj is MessageStamps other && Equals(other);

    /// <inheritdoc/>
    public override readonly int GetHashCode()
    {
        HashCode hash = default;
        foreach (ushort value in values) hash.Add(value);
        return hash.ToHashCode();
    }

    /// <summary>The same nine stamps.</summary>
    public static bool operator ==(MessageStamps left, MessageStamps right) => left.Equals(right);

    /// <summary>Not the same nine stamps.</summary>
    public static bool operator !=(MessageStamps left, MessageStamps right) => !left.Equals(right);

    [InlineArray(Count)]
    private struct Values
    {
        private ushort first;
    }
}
