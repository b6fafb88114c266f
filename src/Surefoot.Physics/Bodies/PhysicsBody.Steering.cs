using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>
/// What a server makes of the body: corrections, sticking, a leash. The managers behind them are made when the first is asked for.
/// </content>
public sealed partial class PhysicsBody
{
    /// <summary>
    /// Distance from the local player as the last tick found it, metres; the greatest number before the first tick with a player.
    /// </summary>
    public float PlayerDistance { get; private set; } = float.MaxValue;

    /// <summary>Moves or turns to a place or an object by itself.</summary>
    public bool IsMovingTo => driver.IsMovingTo;

    /// <summary>Follows positions that a server told.</summary>
    /// <remarks>Retail: CPhysicsObj::IsInterpolating @0x0050EB50.</remarks>
    public bool IsInterpolating => driver.IsInterpolating;

    /// <summary>Id of the object the body sticks to, 0 for none.</summary>
    /// <remarks>Retail: CPhysicsObj::get_sticky_object_id @0x0050EAF0.</remarks>
    public uint StickyObjectId => driver.StickyObjectId;

    /// <summary>Follows a position that a server told, at twice the running speed; one too far away is jumped to.</summary>
    /// <param name="place">Where the body is to be.</param>
    /// <param name="keepHeading">Keeps the body's own heading on the way and there.</param>
    /// <exception cref="ArgumentException">The position is not finite or its id cannot name a cell.</exception>
    public void InterpolateTo(in Position place, bool keepHeading = false)
    {
        ThrowIfBad(place);
        driver.InterpolateTo(place, keepHeading);
    }

    /// <summary>Forgets the positions to follow.</summary>
    /// <remarks>Retail: CPhysicsObj::StopInterpolating @0x0050EB40.</remarks>
    public void StopInterpolating() => driver.StopInterpolating();

    /// <summary>Ties a leash: while the body has contact, its own motion is braked after some path and then held.</summary>
    /// <param name="place">Where it is tied; the way from there to the body counts as path.</param>
    /// <param name="start">Path from which on it brakes, metres.</param>
    /// <param name="max">Path after which it holds, metres.</param>
    /// <exception cref="ArgumentException">The position or a distance is not finite, or the id cannot name a cell.</exception>
    public void ConstrainTo(in Position place, float start, float max)
    {
        ThrowIfBad(place);
        if (!float.IsFinite(start) || !float.IsFinite(max))
            throw new ArgumentException("A length of a leash is not finite.", nameof(start));
        driver.ConstrainTo(place, start, max);
    }

    /// <summary>Unties the leash.</summary>
    public void Unconstrain() => driver.Unconstrain();

    /// <summary>Stays next to an object, facing it, for a second; nothing when there is no such object.</summary>
    public void StickToObject(uint id) => driver.StickToObject(id);

    /// <summary>Lets go of what the body sticks to.</summary>
    /// <remarks>Retail: CPhysicsObj::unstick_from_object @0x0050EAE0.</remarks>
    public void Unstick() => driver.Unstick();

    /// <summary>Ends a move-to or turn-to under way.</summary>
    public void CancelMoveTo() => driver.CancelMoveTo();

    /// <summary>
    /// Does what a server's position says: teleports, follows, or is put there when far from the local player; then ties the leash anew.
    /// </summary>
    /// <param name="place">Where the body is to be.</param>
    /// <param name="teleported">The teleport stamp of the message is newer than the one known.</param>
    /// <param name="contact">The body touches the ground there.</param>
    /// <exception cref="ArgumentException">The position is not finite or its id cannot name a cell.</exception>
    public PositionUpdate MoveOrTeleport(in Position place, bool teleported, bool contact)
    {
        ThrowIfBad(place);
        return driver.MoveOrTeleport(place, teleported, contact);
    }
}
