using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <content>Whether one can stand where a claim says to stand.</content>
public sealed partial class MovementAuthority
{
    /// <summary>A floor that a body may have sunk into by a rounding, metres.</summary>
    private const float Rounding = 0.02f;

    /// <summary>A body that is where it lands has landed after so many quanta.</summary>
    private const int QuantaToLand = 4;

    /// <summary>Where the shadow stands there is ground for one who is a stair higher or lower, metres.</summary>
    private const float AboutAStep = 0.35f;

    /// <summary>Directions in which an edge is looked for.</summary>
    private const int Sides = 8;

    /// <summary>Who stands on an edge has something so far below, metres.</summary>
    private const float OverAnEdge = 0.5f;

    /// <summary>What one can stand on at a place: where the shadow stands there is ground, and where a body falls onto it.</summary>
    private Contact? FootingAt(in Position place)
    {
        Position raised = place;
        raised.Frame.Origin.Z += Rounding;
        return FootingOf(soft, place) ?? FootingOf(soft, raised) ?? FootingOf(solid, place) ?? FootingBeside(place);
    }

    private static Contact? FootingOf(in BodySeat seat, in Position place) =>
        (seat.Transient & TransientState.OnWalkable) != 0 && Math.Abs(seat.Position.OffsetTo(place).Z) <= AboutAStep
            ? ContactOf(seat)
            : null;

    /// <summary>
    /// One may stand on the edge of something that nobody falls onto; now and then that is believed where something is near.
    /// </summary>
    private Contact? FootingInDoubt(in Position place)
    {
        if (doubts < 1 || !query.ProbeDown(new ProbeDownInput(soft, place, OverAnEdge)).Found) return null;
        doubts--;
        return new Contact(new Plane(0, 0, 1, -place.Frame.Origin.Z), place.CellId);
    }

    /// <summary>A shadow that is about to land there finds what it lands on: an edge that no body falls onto from straight above.</summary>
    private Contact? FootingSoon(in Position place)
    {
        for (int i = 0; i < beliefs.ExplanationCount; i++)
        {
            Explanation one = beliefs.ExplanationAt(i);
            probe.CopyFrom(beliefs[one.Belief], one.Guess.PassesMovers);
            Course.Take(probe, place, one.Approach.Time, one.Guess, TopSpeed);
            for (int quantum = 0; quantum < QuantaToLand && probe.HasCell; quantum++)
            {
                if (FootingOf(probe.Seat, place) is { } found) return found;
                probe.Step(one.Guess.Quantum);
            }
        }

        return null;
    }

    /// <summary>
    /// Who stands on an edge may have his middle beyond it, where nobody falls onto it: some of his foot is over what he stands on.
    /// </summary>
    private Contact? FootingBeside(in Position place)
    {
        for (int i = 0; i < Sides * 2; i++)
        {
            (double sine, double cosine) = Math.SinCos(i % Sides * 2 * Math.PI / Sides);
            double far = i < Sides ? foot / 2 : foot;
            Position beside = place;
            beside.Frame.Origin += new Vector3((float)(sine * far), (float)(cosine * far), Rounding);
            if (CellIds.IsOutdoor(beside.CellId)) beside.AdjustToOutside();
            if (FootingOf(soft, beside) is { } found && Math.Abs(Height(found, beside) - place.Frame.Origin.Z) <= options.StandWithin)
                return found;
        }

        return null;
    }

    /// <summary>Height of the plane that one stands on at a place, metres.</summary>
    private static double Height(in Contact contact, in Position at)
    {
        Vector3 place = at.Frame.Origin + CellIds.BlockOffset(contact.CellId, at.CellId), normal = contact.Plane.Normal;
        return at.Frame.Origin.Z - ((Vector3.Dot(normal, place) + contact.Plane.D) / (double)normal.Z);
    }

    private Contact? FootingOf(Mover mover, in Position place)
    {
        ProbeDownResult below = query.ProbeDown(new ProbeDownInput(mover, place, options.StandWithin));
        if (below is { Found: true, Contact: { IsWalkable: true } contact }) return contact;
        PlaceResult placed = query.Place(new PlaceInput(mover, place, Slides: false));
        return placed is { Found: true, Contact: { IsWalkable: true } floor } && placed.Position.DistanceTo(place) <= options.StandWithin
            ? floor
            : null;
    }

    private static Contact? ContactOf(in BodySeat seat) => (seat.Transient & TransientState.Contact) != 0 && seat.ContactPlaneCellId != 0
        ? new Contact(seat.ContactPlane, seat.ContactPlaneCellId, (seat.Transient & TransientState.WaterContact) != 0)
        : null;
}
