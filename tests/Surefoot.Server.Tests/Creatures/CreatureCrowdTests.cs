using Surefoot.Physics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Creatures;

/// <summary>Many driven creatures after one target.</summary>
public sealed class CreatureCrowdTests(DemoGround ground) : IClassFixture<DemoGround>, ICreatureListener
{
    private const int Count = 200, Groups = 20;
    private const int Stretch = 120, Longest = 1800, LeastOrders = 20;
    private const uint First = 0x80000000;
    private const double FrameTime = (1.0 / 30) + 1e-9;

    private long motions, positions, arrivals;

    void ICreatureListener.OnMotion(CreatureDriver creature, in UpdateMotion message) => motions++;

    void ICreatureListener.OnPosition(CreatureDriver creature, in UpdatePosition message) => positions++;

    void ICreatureListener.OnArrived(CreatureDriver creature) => arrivals++;

    void ICreatureListener.OnGivenUp(CreatureDriver creature, MotionError error) => Assert.Fail($"gave up: {error}");

    void ICreatureListener.OnStuck(CreatureDriver creature)
    {
    }

    void ICreatureListener.OnTriesAgain(CreatureDriver creature)
    {
    }

    [Theory]
    [Behaviour("creature.crowd.allocates-nothing", "design, decision 4: move-to, sticky, targets with their voyeurs, and the drivers")]
    [InlineData(CreatureGoal.Follow)]
    [InlineData(CreatureGoal.Stick)]
    [InlineData(CreatureGoal.Flee)]
    [InlineData(CreatureGoal.FaceObject)]
    public void Two_hundred_creatures_after_one_target_allocate_nothing(CreatureGoal goal)
    {
        PhysicsEngine engine = ground.EngineAt("meadow");
        CreatureDriver[] creatures = [.. Enumerable.Range(0, Groups).SelectMany(group => SpawnGroup(engine, group))];
        int frames = 0;
        for (; frames < 10; frames++) Frame();
        foreach (CreatureDriver one in creatures) Aim(one);

        // Lists grow to what they need and then hold; a step, an order or a message that allocated would leave no stretch quiet.
        int quiet = 0;
        long orders = 0, told = 0;
        for (; quiet < Stretch; frames++)
        {
            Assert.True(frames < Longest, $"{goal}: something is allocated again and again");
            if (quiet == 0) (orders, told) = (motions, positions);
            long before = GC.GetAllocatedBytesForCurrentThread();
            Frame();
            quiet = GC.GetAllocatedBytesForCurrentThread() == before ? quiet + 1 : 0;
        }

        Assert.True(motions - orders >= LeastOrders && positions - told >= Count, $"{motions - orders}, {positions - told}");
        Assert.True(arrivals > 0);
        Assert.Contains(creatures, one => goal == CreatureGoal.Stick ? one.Body.StickyObjectId == TargetOf(one) : one.Body.IsMovingTo);

        void Frame()
        {
            engine.Tick((frames + 1) * FrameTime);
            foreach (CreatureDriver one in creatures)
            {
                one.Update();
                if (frames > 10 && goal == CreatureGoal.FaceObject && one.Goal == CreatureGoal.None) Aim(one);
            }
        }

        void Aim(CreatureDriver one) => Assert.True(goal switch
        {
            CreatureGoal.Follow => one.Follow(TargetOf(one)),
            CreatureGoal.Stick => one.StickTo(TargetOf(one)),
            CreatureGoal.Flee => one.FleeFrom(TargetOf(one)),
            _ => one.TurnTo(TargetOf(one)),
        });
    }

    private static uint TargetOf(CreatureDriver one) => one.Body.Id & ~0xFFu;

    /// <summary>Somebody who runs round and round, so that the others always have somewhere to go, and they.</summary>
    private IEnumerable<CreatureDriver> SpawnGroup(PhysicsEngine engine, int group)
    {
        uint id = First + ((uint)group << 8);
        (float right, float ahead) = ((24 * (group % 5)) - 48, 24 * (group / 5));
        PhysicsBody target = ground.Spawn(engine, id, DemoGround.At("meadow", right, ahead));
        InterpretedMotionState round = new()
        {
            ForwardCommand = MotionCommand.RunForward,
            ForwardSpeed = 1,
            TurnCommand = MotionCommand.TurnRight,
            TurnSpeed = 0.5f,
        };
        engine.MovementOf(target)!.ApplyUpdate(round, autonomous: false);
        for (uint i = 1; i <= Count / Groups; i++)
        {
            PhysicsBody body = ground.Spawn(engine, id + i, DemoGround.At("meadow", right + (2 * (i % 5)) - 5, ahead + 3 + (2 * (i / 5))));
            yield return new CreatureDriver(engine, body, this, new CreatureDriverOptions { RunRate = 2 });
        }
    }
}
