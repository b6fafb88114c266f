using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>The state word and what its changes bring about.</content>
public sealed partial class PhysicsBody
{
    /// <summary>
    /// Stores a new state word. Gravity takes effect at the next commit or change of ground; hiding and showing do at once.
    /// </summary>
    /// <param name="value">
    /// The word, taken as it is: its <see cref="PhysicsState.HasPhysicsBsp"/> decides from now on between the trees of the parts and
    /// cylinders or spheres. Bits that contradict each other or the body's shape are listed in <see cref="PhysicsWorld.LeftOut"/>; the body
    /// keeps its pose.
    /// </param>
    /// <remarks>Retail: CPhysicsObj::set_state @0x00514DD0.</remarks>
    public void SetState(PhysicsState value)
    {
        bool wasHidden = State.Has(PhysicsState.Hidden), isHidden = value.Has(PhysicsState.Hidden),
            hadTrees = State.Has(PhysicsState.HasPhysicsBsp);
        if (value != State) ChangedAt = population.Now;
        State = value;
        ListContradictions();
        if (!KeepsParts) ForgetParts();
        else if (!hadTrees && value.Has(PhysicsState.HasPhysicsBsp)) UpdateParts();
        if (wasHidden != isHidden) SetHidden(isHidden);
    }

    /// <summary>Hides the body, which then neither moves by itself nor collides with anybody's notice, or shows it again.</summary>
    /// <remarks>Retail: CPhysicsObj::set_hidden @0x00514C60.</remarks>
    public void SetHidden(bool on)
    {
        if (on)
        {
            State |= PhysicsState.Hidden;
            DrawHeld(false);
            if (State.Has(PhysicsState.ReportCollisions))
            {
                collisions.ReportEnd(updateTime, force: true);
                State &= ~PhysicsState.ReportCollisions;
            }

            State |= PhysicsState.IgnoreCollisions;
        }
        else
        {
            State &= ~(PhysicsState.Hidden | PhysicsState.IgnoreCollisions);
            DrawHeld(true);
            if (!State.Has(PhysicsState.ReportCollisions))
            {
                State |= PhysicsState.ReportCollisions;
                collisions.ReportStart();
            }
        }

        driver.HandleEnterWorld();
    }

    /// <summary>Makes the body let others through, or solid again as soon as nothing overlaps it.</summary>
    /// <returns>False when it has to wait.</returns>
    /// <remarks>Retail: CPhysicsObj::set_ethereal @0x00511C40.</remarks>
    public bool SetEthereal(bool on)
    {
        if (on != State.Has(PhysicsState.Ethereal)) ChangedAt = population.Now;
        if (on)
        {
            State |= PhysicsState.Ethereal;
            Transient &= ~TransientState.CheckEthereal;
            return true;
        }

        State &= ~PhysicsState.Ethereal;
        if (Parent is not null || Cell is null || !population.Cells.AnyOverlaps(this))
        {
            Transient &= ~TransientState.CheckEthereal;
            return true;
        }

        State |= PhysicsState.Ethereal;
        Transient |= TransientState.CheckEthereal;
        return false;
    }

    /// <summary>Lists what the state word says that cannot be so.</summary>
    internal void ListContradictions()
    {
        if (State.Has(PhysicsState.HasPhysicsBsp) && Setup is not { HasPhysicsBsp: true })
            List("HAS_PHYSICS_BSP, but no part has a collision tree");
        if (State.Has(PhysicsState.HasDefaultAnim) && (Setup is null || Setup.DefaultAnimationId == 0))
            List("HAS_DEFAULT_ANIM, but the setup names no animation");
        if (State.Has(PhysicsState.Static) && State.Has(PhysicsState.Missile | PhysicsState.AlignPath | PhysicsState.Sledding))
            List("STATIC, but MISSILE, ALIGNPATH or SLEDDING as well");

        void List(string reason) =>
            population.Cells.LeftOut.Add(new LeftOutItem(LeftOutKind.StateBit, Setup?.Id ?? 0, reason) { FirstIn = Id });
    }

    /// <inheritdoc/>
    internal override bool Overlaps(WorldObject target)
    {
        if (State.Has(PhysicsState.Static)) return false;
        if (!population.Transitions.TryRent(out Transition? transition)) return false;
        transition.SeedMover(this, transition.SeedContact(this, CurrentSeat));
        transition.Path.InitPath(Cell, hasBegin: true, PositionField, PositionField);
        bool hit = transition.CheckCollisions(target);
        population.Transitions.Return();
        return hit;
    }
}
