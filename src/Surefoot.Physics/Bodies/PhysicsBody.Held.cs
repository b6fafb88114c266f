using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>
/// Being held by another body, and holding others. What is held is where its holder has it, goes into cells and out of them with it, has
/// no quanta of its own and is no obstacle.
/// </content>
/// <remarks>Specification 09, 5.11.</remarks>
public sealed partial class PhysicsBody
{
    /// <summary>How many bodies may hold each other in a row, the first and the last included.</summary>
    public const int MostHoldersInARow = 16;

    private PhysicsBody? Holder => (PhysicsBody?)Parent;

    /// <summary>
    /// Has another body hold this one instead of the one that does. It leaves the world, and comes back where its holder is.
    /// </summary>
    /// <param name="holder">Who holds it.</param>
    /// <param name="location">Number of a holding location of the holder's setup.</param>
    /// <returns>
    /// False when the holder has no such location, is this body, or is held by it at any remove, and when more than
    /// <see cref="MostHoldersInARow"/> would hold each other; nothing has changed then.
    /// </returns>
    /// <exception cref="ArgumentException">The holder belongs to another engine.</exception>
    /// <exception cref="InvalidOperationException">One of them was removed from the engine.</exception>
    /// <remarks>Retail: CPhysicsObj::set_parent @0x00515A90. Of rings it refuses only the smallest, and rows end with its stack.</remarks>
    public bool SetParent(PhysicsBody holder, uint location)
    {
        ArgumentNullException.ThrowIfNull(holder);
        if (!ReferenceEquals(holder.population, population))
            throw new ArgumentException("The holder belongs to another engine.", nameof(holder));
        ThrowIfRemoved();
        holder.ThrowIfRemoved();
        if (holder.IsHeldBy(this) || holder.Setup is not { } shape) return false;
        if (holder.HoldersInARow + LongestRow > MostHoldersInARow) return false;
        if (!shape.TryGetHoldingLocation(location, out HoldingLocation place)) return false;

        // It is in the new list before it leaves the old one: with the same holder the first of its two entries goes.
        bool keptParts = holder.KeepsParts;
        HeldObject entry = new(this, location, place.Part, place.Frame);
        holder.Held.Add(entry);
        if (!keptParts) holder.UpdateParts();
        UnsetParent();
        LeaveWorld();
        Parent = holder;
        if (holder.Cell is { } cell)
        {
            ChangeCell(cell);
            holder.UpdateHeld(entry);
            RecalcCrossCells();
        }

        if (holder.State.Has(PhysicsState.Hidden)) State |= PhysicsState.NoDraw;
        return true;
    }

    /// <summary>
    /// Has its holder let go of the body: it stays where it is, in its holder's cell, and falls from there when it is woken.
    /// </summary>
    /// <remarks>Retail: CPhysicsObj::unset_parent @0x00513470.</remarks>
    public void UnsetParent()
    {
        if (Holder is not { } holder) return;
        holder.Held.RemoveAt(holder.Held.FindIndex(entry => ReferenceEquals(entry.Object, this)));
        if (!holder.KeepsParts) holder.ForgetParts();
        if (holder.State.Has(PhysicsState.Hidden)) State &= ~PhysicsState.NoDraw;
        Parent = null;
        updateTime = population.Now;
        ClearTransientStates();
    }

    /// <summary>Lets go of everything that the body holds.</summary>
    /// <remarks>Retail: CPhysicsObj::unparent_children @0x005134E0.</remarks>
    public void UnparentChildren()
    {
        while (HeldCount > 0) HeldBody(0).UnsetParent();
    }

    private PhysicsBody HeldBody(int index) => (PhysicsBody)HeldAt(index);

    /// <summary>This body and those that hold it.</summary>
    private int HoldersInARow => 1 + (Holder?.HoldersInARow ?? 0);

    /// <summary>This body and the longest row of those that it holds.</summary>
    private int LongestRow
    {
        get
        {
            int longest = 0;
            for (int i = 0; i < HeldCount; i++) longest = Math.Max(longest, HeldBody(i).LongestRow);
            return longest + 1;
        }
    }

    private bool IsHeldBy(PhysicsBody other)
    {
        for (PhysicsBody? body = this; body is not null; body = body.Holder)
        {
            if (ReferenceEquals(body, other)) return true;
        }

        return false;
    }

    /// <summary>What is held follows the part that holds it, and what that holds follows it.</summary>
    /// <remarks>Retail: CPhysicsObj::UpdateChildrenInternal @0x00513DA0.</remarks>
    private void UpdateHeld()
    {
        for (int i = 0; i < HeldCount; i++) UpdateHeld(Held[i]);
    }

    /// <remarks>Retail: CPhysicsObj::UpdateChild @0x00512D50.</remarks>
    private void UpdateHeld(in HeldObject entry)
    {
        Frame hand = entry.Part < (uint)PlacedPartCount ? PartFrame((int)entry.Part) : PositionField.Frame;
        ((PhysicsBody)entry.Object).SetFrame(Frame.Combine(hand, entry.Frame));
    }

    /// <remarks>Retail: CPhysicsObj::recalc_cross_cells @0x00515A30.</remarks>
    private void RecalcCrossCells()
    {
        if (Setup is not null && PositionField.CellId != 0) population.Cells.CalcCrossCells(this);
        for (int i = 0; i < HeldCount; i++) HeldBody(i).RecalcCrossCells();
    }

    /// <summary>Whoever the body holds is drawn when the body is.</summary>
    private void DrawHeld(bool on)
    {
        for (int i = 0; i < HeldCount; i++)
        {
            PhysicsBody item = HeldBody(i);
            item.State = on ? item.State & ~PhysicsState.NoDraw : item.State | PhysicsState.NoDraw;
        }
    }
}
