using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;

namespace Surefoot.Client.Tests;

public sealed class ShoreTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    [Fact]
    [Behaviour("acceptance.shore-slows-nothing", "spec/05, 4.5; spec/03, 4.4")]
    public void Wading_along_the_shallows_is_as_fast_as_running_on_land()
    {
        DemoWalk walk = new(files, "lake-shallows", new CharacterStats(300, 200));
        walk.Hold(MovementKeys.Forward, 15);
        bool wet = false;
        float speedBefore = 0;
        for (int i = 0; i < 30; i++)
        {
            Vector3 from = walk.Moved;
            walk.Hold(MovementKeys.Forward, 3);
            Vector3 way = walk.Moved - from;
            wet |= (walk.Body.Transient & TransientState.WaterContact) != 0;
            speedBefore += new Vector2(way.X, way.Y).Length();
        }

        Assert.True(wet);
        // 10.6 m/s for three seconds; downhill covers all of it, uphill cos² of the slope, and the bed of the shallows is nearly level.
        Assert.InRange(speedBefore, 0.97f * 31.8f, 1.01f * 31.8f);
    }
}
