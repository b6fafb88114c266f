using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Workbench.Simulation;

/// <summary>
/// A creature that stands a while, turns to a place near its home, walks there, and stands again. It only says what it wants, as a server's
/// message would; whether it gets there is up to the physics.
/// </summary>
internal sealed class Wanderer
{
    private const double LeastPause = 1, LongestPause = 5;

    // Degrees; a creature turns by about three in a tick.
    private const float Aim = 3f;
    private const float LostTheWay = 30f;
    private const float Arrived = 0.4f;
    private const double LongestTurn = 4, LongestWalk = 20, StuckAfter = 1;
    private const float StuckWithin = 0.3f;

    private readonly PhysicsBody body;
    private readonly MovementManager movement;
    private readonly Position home;
    private readonly float radius;
    private readonly InterpretedMotionState wish = new();
    private ulong rolls;
    private Doing doing = Doing.Standing;
    private double until = double.NaN;
    private Position target;
    private Position mark;
    private double marked;

    /// <summary>A wanderer.</summary>
    /// <param name="body">Its body.</param>
    /// <param name="movement">Its motions.</param>
    /// <param name="home">The middle of where it strays.</param>
    /// <param name="radius">How far it strays, metres.</param>
    /// <param name="seed">Of its ways.</param>
    public Wanderer(PhysicsBody body, MovementManager movement, in Position home, float radius, ulong seed)
    {
        this.body = body;
        this.movement = movement;
        this.home = home;
        this.radius = radius;
        rolls = seed;
    }

    private enum Doing
    {
        Standing,
        Turning,
        Walking,
    }

    /// <summary>Decides what to do next.</summary>
    /// <param name="now">Seconds.</param>
    public void Act(double now)
    {
        if (!body.HasCell) return;
        if (double.IsNaN(until)) until = now + (LongestPause * Roll());
        switch (doing)
        {
            case Doing.Standing when now >= until:
                Choose(now);
                break;
            case Doing.Turning:
                Turn(now);
                break;
            case Doing.Walking:
                Walk(now);
                break;
        }
    }

    private void Choose(double now)
    {
        double way = radius * Math.Sqrt(Roll()), direction = Math.Tau * Roll();
        target = home;
        target.Frame.Origin.X += (float)(way * Math.Sin(direction));
        target.Frame.Origin.Y += (float)(way * Math.Cos(direction));
        doing = Doing.Turning;
        until = now + LongestTurn;
        Want(MotionCommand.Ready, MathF.Sign(OffCourse()));
    }

    private void Turn(double now)
    {
        float off = OffCourse();
        if (MathF.Abs(off) > Aim && MathF.Sign(off) == MathF.Sign(wish.TurnSpeed) && wish.TurnCommand != MotionCommand.None && now < until)
            return;
        doing = Doing.Walking;
        until = now + LongestWalk;
        mark = body.Position;
        marked = now;
        Want(MotionCommand.WalkForward, 0);
    }

    private void Walk(double now)
    {
        if (now - marked >= StuckAfter)
        {
            if (body.Position.HorizontalDistanceTo(mark) < StuckWithin) until = now;
            mark = body.Position;
            marked = now;
        }

        if (now < until && body.Position.HorizontalDistanceTo(target) > Arrived && MathF.Abs(OffCourse()) < LostTheWay) return;
        doing = Doing.Standing;
        until = now + LeastPause + ((LongestPause - LeastPause) * Roll());
        Want(MotionCommand.Ready, 0);
    }

    /// <summary>Degrees to turn right to face the target, −180 to 180.</summary>
    private float OffCourse()
    {
        double off = (body.Position.HeadingTo(target) - body.Position.Frame.Heading + 540) % 360;
        return (float)(off - 180);
    }

    private void Want(MotionCommand forward, int turn)
    {
        wish.ForwardCommand = forward;
        wish.TurnCommand = turn == 0 ? MotionCommand.None : MotionCommand.TurnRight;
        wish.TurnSpeed = turn == 0 ? 1 : turn;
        movement.ApplyUpdate(wish, autonomous: false);
    }

    /// <summary>A number in [0, 1) from the wanderer's own seed (SplitMix64).</summary>
    private double Roll()
    {
        rolls += 0x9E3779B97F4A7C15;
        ulong z = rolls;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53));
    }
}
