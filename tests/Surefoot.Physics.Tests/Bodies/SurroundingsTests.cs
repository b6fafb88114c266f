using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>
/// What a body that waits looks at: people on flat land, whose cells are 24 m wide. One at x = 23.4 is in the first only.
/// </summary>
public sealed class SurroundingsTests
{
    private const uint Block = 0xA9B40000;
    private const float Radius = 2;

    private readonly PhysicsEngine engine = Ask.Engine(Block);
    private readonly PhysicsBody body;
    private uint last;

    public SurroundingsTests() => body = Stand(23.4f);

    private ulong Hash => body.HashSurroundings(Radius);

    [Theory, Behaviour("body.surroundings.neighbour-cell", "design, server operator: wakes when something near it changes")]
    [InlineData(22.2f)]
    [InlineData(24.6f)]
    public void What_goes_turns_solid_or_steps_aside_near_by_is_noticed_in_the_next_cell_too(float x)
    {
        PhysicsBody other = Stand(x);
        Assert.Equal(1, other.ShadowCount);
        ulong there = Hash;
        Assert.Equal(there, Hash);
        other.SetState(PhysicsState.Default | PhysicsState.Ethereal);
        Assert.NotEqual(there, Hash);
        other.SetState(PhysicsState.Default);
        Assert.Equal(there, Hash);
        Assert.Equal(PlacementResult.OK, other.SetPositionSimple(Ask.At(x, 11, 0.005f), sliding: false));
        Assert.NotEqual(there, Hash);
        Assert.Equal(PlacementResult.OK, other.SetPositionSimple(Ask.At(x, 10, 0.005f), sliding: false));
        Assert.Equal(there, Hash);
        other.LeaveWorld();
        Assert.NotEqual(there, Hash);
    }

    [Fact, Behaviour("body.surroundings.radius", "PhysicsBody.HashSurroundings: metres from surface to surface")]
    public void What_is_farther_than_asked_may_do_what_it_likes()
    {
        ulong alone = Hash;
        // The two radii, and a little more or less than the 2 m.
        float far = (2 * body.Radius) + Radius + 0.02f;
        Stand(23.4f + far);
        Stand(23.4f - far);
        Assert.Equal(alone, Hash);
        Stand(23.4f, 10 + far - 0.04f);
        Assert.NotEqual(alone, Hash);
    }

    [Fact, Behaviour("body.surroundings.allocates-nothing", "design, decision 4")]
    public void To_look_again_allocates_nothing()
    {
        Stand(24.6f);
        ulong first = Hash, different = 0;
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 100; i++) different |= first ^ body.HashSurroundings(Radius);
        Assert.Equal((0, 0ul), (GC.GetAllocatedBytesForCurrentThread() - before, different));
    }

    private PhysicsBody Stand(float x, float y = 10)
    {
        PhysicsBody made = engine.CreateBody(++last, Ask.Walker.Setup);
        Assert.True(made.EnterWorld(Ask.At(x, y, 0.005f)));
        return made;
    }
}
