using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <content>The quanta of a body: proposing a position, integrating velocity, trying it.</content>
public sealed partial class PhysicsBody
{
    /// <summary>Acceleration of gravity, m/s².</summary>
    public const float Gravity = -9.8f;

    internal const double MinQuantum = 1.0 / 30;
    internal const double MaxQuantum = 1.0 / 5;
    internal const double HugeQuantum = 2.0;
    private const double ActivityRadius = 96.0;

    private const double SmallVelocitySquared = 0.0625;
    private const double MaxVelocitySquared = 2500.0;
    private const double FrictionCutOff = 0.25;
    private const double SledSlowSquared = 1.5625;
    private const double SledFastSquared = 6.25;
    private const double SledSlopeZ = 0.984807753012208;
    private const float SledSlipperyFriction = 0.2f;

    /// <summary>Brings the body to <paramref name="now"/> in quanta of at most 0.2 s.</summary>
    /// <param name="now">Seconds.</param>
    /// <remarks>
    /// Retail: CPhysicsObj::update_object @0x00515D10. A remainder of at most 1/30 s is kept for the next call; more than 2 s at once are
    /// lost, not simulated.
    /// </remarks>
    internal void UpdateObject(double now)
    {
        if (Parent is not null || Cell is null || State.Has(PhysicsState.Frozen))
        {
            Transient &= ~TransientState.Active;
            return;
        }

        if (population.Player is { } player)
        {
            double distance = player.Position.DistanceTo(PositionField);
            PlayerDistance = (float)distance;
            if (distance > ActivityRadius) Transient &= ~TransientState.Active;
            else SetActive(true);
        }

        double simulated = updateTime, elapsed = now - updateTime;
        if (!(elapsed > RetailMath.Epsilon) || !(elapsed <= HugeQuantum))
        {
            updateTime = now;
            return;
        }

        if (elapsed <= MaxQuantum)
        {
            simulated += elapsed;
            RunQuantum((float)elapsed, simulated);
        }
        else
        {
            do
            {
                simulated += MaxQuantum;
                RunQuantum((float)MaxQuantum, simulated);
                elapsed -= MaxQuantum;
            }
            while (elapsed > MaxQuantum);

            if (elapsed > MinQuantum)
            {
                simulated += elapsed;
                RunQuantum((float)elapsed, simulated);
            }
        }

        updateTime = simulated;
    }

    /// <summary>Advances the body by one quantum now, whatever the engine's clock says: for replays and tests.</summary>
    /// <param name="quantum">Seconds, more than 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">The quantum is not a positive finite number.</exception>
    public void AdvanceQuantum(float quantum) => AdvanceQuantum(quantum, sweepWithoutSpheres: false);

    /// <summary>The same.</summary>
    /// <param name="quantum">Seconds, more than 0.</param>
    /// <param name="sweepWithoutSpheres">
    /// Let a body without spheres move by the dummy sphere of its transition. In a tick such a body stays where it is (specification 02,
    /// 4.4, step 5); recorded walks leave that rule out.
    /// </param>
    internal void AdvanceQuantum(float quantum, bool sweepWithoutSpheres)
    {
        if (!(quantum > 0) || !float.IsFinite(quantum))
            throw new ArgumentOutOfRangeException(nameof(quantum), quantum, "A quantum is a positive number of seconds.");
        updateTime += quantum;
        RunQuantum(quantum, updateTime, sweepWithoutSpheres);
    }

    private void RunQuantum(float quantum, double simulatedTime, bool sweepWithoutSpheres = false)
    {
        LastQuantum = quantum;
        PreviousPosition = PositionField;
        UpdateObjectInternal(quantum, simulatedTime, sweepWithoutSpheres);
    }

    /// <summary>One quantum: propose, try, commit or refuse.</summary>
    /// <remarks>Retail: CPhysicsObj::UpdateObjectInternal @0x005156B0.</remarks>
    private void UpdateObjectInternal(float quantum, double simulatedTime, bool sweepWithoutSpheres)
    {
        if (!IsActive || Cell is null) return;
        if (Has(TransientState.CheckEthereal)) SetEthereal(false);

        Position proposal = new(PositionField.CellId, UpdatePositionInternal(quantum, simulatedTime));
        if (!sweepWithoutSpheres && (Setup is null || Setup.Spheres.Length == 0))
        {
            if (!driver.HasMotions && OnWalkable) Transient &= ~TransientState.Active;
            TurnOnly(proposal.Frame);
        }
        else if (RetailMath.NearlyEqual(proposal.Frame.Origin, PositionField.Frame.Origin))
        {
            TurnOnly(proposal.Frame);
        }
        else
        {
            FaceTheWay(ref proposal.Frame);
            TryProposal(proposal, quantum, simulatedTime);
        }

        driver.EndQuantum(simulatedTime);
    }

    private void TryProposal(in Position proposal, float quantum, double simulatedTime)
    {
        if (!population.Transitions.TryRent(out Transition? transition, Trace))
        {
            TurnOnly(proposal.Frame);
            return;
        }

        bool found = transition.Sweep(this, CurrentSeat, Cell, proposal);
        population.Transitions.Return();
        TakeStop(transition);
        if (!found || (population.RefuseLeavingCells && transition.Path.CurrCell is null))
        {
            TurnOnly(proposal.Frame);
            return;
        }

        Vector3 moved = PositionField.OffsetTo(transition.Path.CurrPos);
        double inverse = 1.0 / quantum;
        AchievedVelocity =
            new Vector3((float)(inverse * moved.X), (float)((float)inverse * (double)moved.Y), (float)((float)inverse * (double)moved.Z));
        Commit(transition, simulatedTime);
    }

    /// <summary>Keeps the place and takes the orientation.</summary>
    private void TurnOnly(Frame frame)
    {
        frame.Origin = PositionField.Frame.Origin;
        SetFrame(frame);
        AchievedVelocity = Vector3.Zero;
    }

    /// <summary>Missiles face along their way, sleds along their velocity.</summary>
    private void FaceTheWay(ref Frame frame)
    {
        if (State.Has(PhysicsState.AlignPath))
        {
            frame.SetVectorHeading(RetailMath.Normalize(frame.Origin - PositionField.Frame.Origin));
        }
        else if (State.Has(PhysicsState.Sledding) && !RetailMath.IsZero(velocity))
        {
            Vector3 level = new(velocity.X, velocity.Y, 0);
            frame.SetHeading(RetailMath.Length(level) < RetailMath.Epsilon ? 0f : (float)Frame.HeadingOf(level));
        }
    }

    /// <summary>Where the body wants to be after a quantum: its own motion, a server's correction, then its velocity.</summary>
    /// <remarks>Retail: CPhysicsObj::UpdatePositionInternal @0x00512C30.</remarks>
    private Frame UpdatePositionInternal(float quantum, double simulatedTime)
    {
        Frame offset = Frame.Identity;
        bool hidden = State.Has(PhysicsState.Hidden);
        if (!hidden)
        {
            driver.AccumulateRootMotion(quantum, ref offset);
            offset.Origin = RetailMath.Scale(offset.Origin, OnWalkable ? Scale : 0.0);
        }

        driver.AdjustOffset(ref offset, quantum);
        Frame proposal = Frame.Combine(PositionField.Frame, offset);
        if (!hidden) UpdatePhysicsInternal(quantum, ref proposal);
        ProcessHooks(simulatedTime);
        return proposal;
    }

    /// <summary>Clamps, brakes and integrates the velocity into the proposal.</summary>
    /// <remarks>
    /// Retail: CPhysicsObj::UpdatePhysicsInternal @0x00510700. The order (stop before moving, accelerate after) makes a jump lose its last
    /// ±0.25 m/s at the apex: load-bearing.
    /// </remarks>
    private void UpdatePhysicsInternal(float q, ref Frame frame)
    {
        float speedSquared = (float)RetailMath.LengthSquared(velocity);
        if (speedSquared <= 0)
        {
            if (!driver.HasMotions && OnWalkable) Transient &= ~TransientState.Active;
        }
        else
        {
            if (speedSquared > MaxVelocitySquared)
            {
                velocity = RetailMath.Scale(RetailMath.Normalize(velocity), MaxVelocity);
                speedSquared = (float)MaxVelocitySquared;
            }

            CalcFriction(q, speedSquared);
            if (speedSquared - SmallVelocitySquared < RetailMath.Epsilon) velocity = Vector3.Zero;

            Vector3 v = velocity, a = Acceleration, o = frame.Origin;
            double dq = q;
            frame.Origin = new Vector3(
                (float)((float)((dq * v.X) + (float)((float)(a.X * 0.5 * dq) * dq)) + (double)o.X),
                (float)((dq * v.Y) + (float)(a.Y * 0.5 * dq * dq) + o.Y),
                (float)((float)((float)(dq * v.Z) + ((float)(a.Z * 0.5) * dq * dq)) + (double)o.Z));
        }

        // A body at rest in the air only gains velocity in its first quantum.
        velocity = new Vector3(
            (float)(((double)q * Acceleration.X) + velocity.X),
            (float)(((double)q * Acceleration.Y) + velocity.Y),
            (float)((float)((double)q * Acceleration.Z) + (double)velocity.Z));
        frame.RotateGlobal(RetailMath.Scale(omega, q));
    }

    /// <summary>Removes the velocity into the ground and lets the rest decay.</summary>
    /// <remarks>Retail: CPhysicsObj::calc_friction @0x0050EE70.</remarks>
    internal void CalcFriction(float q, float speedSquared)
    {
        if (!OnWalkable) return;
        Vector3 n = contactPlane.Normal;
        double dot = RetailMath.Dot(velocity, n);
        if (dot >= FrictionCutOff) return;
        velocity = new Vector3(
            (float)(velocity.X - (dot * n.X)), (float)(velocity.Y - (dot * n.Y)), (float)((double)velocity.Z - (float)(dot * n.Z)));
        velocity = RetailMath.Scale(velocity, Math.Pow(1.0 - FrictionNow(speedSquared, n.Z), q));
    }

    private float FrictionNow(float speedSquared, float normalZ)
    {
        if (!State.Has(PhysicsState.Sledding)) return Friction;
        if (speedSquared < SledSlowSquared) return 1f;
        return speedSquared < SledFastSquared || SledSlopeZ <= normalZ ? Friction : SledSlipperyFriction;
    }
}
