using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>Something that an object holds.</summary>
/// <param name="Object">What is held.</param>
/// <param name="Location">Number of the holding location of the holder's setup.</param>
/// <param name="Part">Index of the part that it follows; one that there is not for the holder itself.</param>
/// <param name="Frame">Where it is, seen from that part, metres; the holder's scale is not in it.</param>
internal readonly record struct HeldObject(WorldObject Object, uint Location, uint Part, Frame Frame);

/// <content>What the object holds.</content>
public partial class WorldObject
{
    private List<HeldObject>? held;

    /// <summary>Number of objects that it holds.</summary>
    public int HeldCount => held?.Count ?? 0;

    /// <summary>One of the objects that it holds, the one held longest at 0.</summary>
    /// <param name="index">0 to <see cref="HeldCount"/> less one.</param>
    public WorldObject HeldAt(int index) => Held[index].Object;

    /// <summary>How it holds them.</summary>
    private protected List<HeldObject> Held => held ??= [];
}
