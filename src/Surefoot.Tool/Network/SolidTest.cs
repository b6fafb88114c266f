using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Queries;

namespace Surefoot.Tool.Network;

/// <summary>
/// Asks retail's placement test of a drawn body. The test minds leaves that are marked solid, which no sweep does: so players themselves
/// come to places where they could not be put, on the edge of a stairwell as a rule (specification 04, 4.5 and 4.6). A body that the test
/// refuses is where a player may be when it touches no face and its own sweep led there; one that touches a face or was put there is in a
/// solid.
/// </summary>
/// <param name="world">The world of the drawn body.</param>
/// <param name="mover">Its shape.</param>
internal sealed class SolidTest(PhysicsEngine world, Mover mover)
{
    private readonly WorldQuery query = world.CreateQuery();
    private readonly FaceTest faces = new(world.World);
    private readonly List<string> inSolid = [];
    private long blipsBefore;

    /// <summary>How often the drawn body was judged.</summary>
    internal int Judged { get; private set; }

    /// <summary>How often it was refused where its sweep led, and touched nothing.</summary>
    internal int Swept { get; private set; }

    /// <summary>Where it was refused otherwise.</summary>
    internal IReadOnlyList<string> InSolid => inSolid;

    /// <summary>Where the body is drawn in this frame.</summary>
    /// <param name="drawn">The body.</param>
    /// <param name="blips">How often it has been put somewhere.</param>
    /// <param name="time">Seconds.</param>
    internal void Judge(PhysicsBody drawn, long blips, double time)
    {
        Judged++;
        if (!query.Place(new PlaceInput(mover, drawn.Position, Slides: false)).Found)
        {
            string? why = faces.Touches(drawn) ? "touching a face" : blips != blipsBefore ? "put there" : null;
            if (why is null) Swept++;
            else inSolid.Add(FormattableString.Invariant($"{time:0.00} s at {drawn.Position}, {why}"));
        }

        blipsBefore = blips;
    }
}
