namespace Surefoot.Physics.World;

/// <content>The objects that overlap the cell, in the order in which they are tested.</content>
public abstract partial class ObjCell
{
    /// <summary>Room for a few bodies from the start: those that come by must not make the cell allocate.</summary>
    private const int InitialCapacity = 4;

    private Shadow[] shadows = new Shadow[InitialCapacity];
    private int staticCount;

    /// <summary>Number of objects listed.</summary>
    internal int ShadowCount { get; private set; }

    /// <summary>
    /// An object listed here. Statics come first, in the fixed order of <see cref="StaticObject.Order"/>; bodies follow in the order of
    /// coming, disturbed by retail's way of removing: the last one takes the free slot. The order is observable, because a test ends at the
    /// first obstacle.
    /// </summary>
    internal WorldObject ShadowAt(int index) => shadows[index].Object;

    /// <summary>Lists an object; <paramref name="ordinal"/> says which of the object's own shadows this is.</summary>
    /// <remarks>Retail: CObjCell::add_shadow_object @0x0052B280.</remarks>
    internal void AddShadow(WorldObject item, int ordinal)
    {
        if (ShadowCount == shadows.Length) Array.Resize(ref shadows, ShadowCount * 2);
        int index = ShadowCount++;
        if (item is StaticObject { Order: ulong order })
        {
            int slot = staticCount++;
            while (slot > 0 && ((StaticObject)shadows[slot - 1].Object).Order > order) slot--;
            Array.Copy(shadows, slot, shadows, slot + 1, index - slot);
            for (int i = slot + 1; i <= index; i++) shadows[i].Seat(i);
            index = slot;
        }

        shadows[index] = new Shadow(item, ordinal);
        shadows[index].Seat(index);
    }

    /// <summary>Takes an object's shadow off the list.</summary>
    /// <remarks>Retail: CObjCell::remove_shadow_object @0x0052B2D0.</remarks>
    internal void RemoveShadow(int index)
    {
        if (index < staticCount)
        {
            staticCount--;
            ShadowCount--;
            Array.Copy(shadows, index + 1, shadows, index, ShadowCount - index);
            for (int i = index; i < ShadowCount; i++) shadows[i].Seat(i);
        }
        else
        {
            shadows[index] = shadows[--ShadowCount];
            if (index < ShadowCount) shadows[index].Seat(index);
        }

        shadows[ShadowCount] = default;
    }

    /// <summary>The cell goes away: its objects' shadows stay without a cell.</summary>
    /// <remarks>Retail: CObjCell::release_objects @0x0052B490.</remarks>
    internal void ReleaseShadows()
    {
        for (int i = 0; i < ShadowCount; i++) shadows[i].Object.Shadows[shadows[i].Ordinal].Cell = null;
        Array.Clear(shadows, 0, ShadowCount);
        ShadowCount = staticCount = 0;
    }

    /// <summary>One entry: an object, and which of its shadows this is.</summary>
    private readonly record struct Shadow(WorldObject Object, int Ordinal)
    {
        public void Seat(int index) => Object.Shadows[Ordinal].Index = index;
    }
}
