using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Bodies;

/// <summary>The tables of specification 02, 6.</summary>
public class IntegrationTests
{
    private const TransientState Standing = BodyFixture.Standing;
    private const TransientState Ground = Standing | TransientState.Sliding;

    [Fact, Behaviour("body.fall.from-ten-metres", "spec/02, 6.1")]
    public void A_fall_of_ten_metres_lands_hops_and_rests()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 10), Vector3.Zero, TransientState.None);
        Dictionary<int, (float Z, float Vz, TransientState Bits)> expected = new()
        {
            [1] = (10f, -0.326666683f, 0),
            [2] = (9.98366642f, -0.653333366f, 0),
            [3] = (9.95644379f, -0.980000019f, 0),
            [4] = (9.91833305f, -1.30666673f, 0),
            [5] = (9.86933327f, -1.63333344f, 0),
            [10] = (9.46099949f, -3.26666665f, 0),
            [15] = (8.78044319f, -4.9000001f, 0),
            [20] = (7.82766581f, -6.53333426f, 0),
            [30] = (5.105443f, -9.8000021f, 0),
            [40] = (1.29433072f, -13.0666704f, 0),
            [41] = (0.853330612f, -13.3933372f, 0),
            [42] = (0.401441574f, -13.7200041f, 0),
            [43] = (0f, 0.70233345f, Ground),
            [44] = (0.0234111156f, 0.70233345f, 0),
            [45] = (0.0413777865f, 0.375666767f, 0),
            [46] = (0.0484555662f, 0.0490000844f, 0),
            [47] = (0.0430111215f, -0.326666683f, 0),
            [48] = (0.0266777854f, -0.653333366f, 0),
            [49] = (0f, 0.0490000248f, Ground),
            [50] = (0f, 0f, Ground),
            [51] = (0f, 0f, Ground),
        };
        for (int quantum = 1; quantum <= 51; quantum++)
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            if (!expected.TryGetValue(quantum, out var e)) continue;
            Assert.True(Math.Abs(e.Z - f.Z) <= 1e-6, $"quantum {quantum}: z {f.Z:R}, expected {e.Z:R}");
            Assert.Equal((quantum, e.Vz), (quantum, f.Body.Velocity.Z));
            Assert.Equal((quantum, e.Bits), (quantum, f.Body.Transient & ~TransientState.Active));
        }

        Assert.False(f.Body.IsActive);
    }

    [Fact, Behaviour("body.fall.large-quanta", "spec/02, 6.2")]
    public void A_fall_in_quanta_of_a_fifth_of_a_second()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 10), Vector3.Zero, TransientState.None);
        (float Z, float Vz)[] expected =
        [
            (10f, -1.96000004f), (9.41199875f, -3.92000008f), (8.43199921f, -5.88000011f), (7.05999994f, -7.84000015f),
            (5.296f, -9.80000019f),
            (3.13999987f, -11.7600002f), (0.592000008f, -13.7200003f), (0f, 0.784000397f), (0.156800047f, 0.784000397f),
            (0.117600113f, -1.17599964f), (0f, 0.156800032f), (0f, 0f),
        ];
        for (int i = 0; i < expected.Length; i++)
        {
            f.Body.AdvanceQuantum(0.2f);
            Assert.True(Math.Abs(expected[i].Z - f.Z) <= 1e-6, $"quantum {i + 1}: z {f.Z:R}");
            Assert.True(Math.Abs(expected[i].Vz - f.Body.Velocity.Z) <= 1e-6, $"quantum {i + 1}: vz {f.Body.Velocity.Z:R}");
        }
    }

    [Theory, Behaviour("body.landing.hop-threshold", "spec/02, 6.3")]
    [InlineData(0.25f, -2.28666687f, 0.114333f)]
    [InlineData(0.5f, -3.26666665f, 0.163333f)]
    [InlineData(1.0f, -4.57333326f, 0.228667f)]
    [InlineData(1.25f, -5.22666693f, 0.261333f)]
    [InlineData(1.3f, -5.22666693f, 0.261333f)]
    [InlineData(2.0f, -6.53333426f, 0.326667f)]
    [InlineData(5.0f, -10.1266689f, 0.506333f)]
    public void A_landing_gives_back_a_twentieth_of_the_impact(float height, float impact, float bounce)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, height), Vector3.Zero, TransientState.None);
        float before = 0;
        for (int quantum = 0; quantum < 100 && !f.Body.OnWalkable; quantum++)
        {
            before = f.Body.Velocity.Z;
            f.Body.AdvanceQuantum(BodyFixture.Tick);
        }

        Assert.Equal(impact, before + (-9.8f * BodyFixture.Tick), 5);
        Assert.Equal(bounce, f.Body.Velocity.Z, 5);
    }

    [Theory, Behaviour("body.jump.five-metres", "spec/02, 6.4")]
    [InlineData(0f, 30, 4.99949312f, 0.0994923711f)]
    [InlineData(0f, 31, 4.9940486f, -0.326666683f)]
    [InlineData(0f, 60, 0.0994928181f, -9.8000021f)]
    [InlineData(0f, 61, 0f, 0.506333351f)]
    [InlineData(0f, 62, 0.0168778095f, 0.506333351f)]
    [InlineData(0f, 64, 0.0228666998f, -0.326666683f)]
    [InlineData(0f, 66, 0f, 0.0490000248f)]
    [InlineData(4f, 30, 4.99949312f, 0.0994923711f)]
    [InlineData(4f, 31, 4.997365f, -0.227174312f)]
    [InlineData(4f, 60, 0.198984861f, -9.70051003f)]
    [InlineData(4f, 61, 0f, 0.501358986f)]
    [InlineData(4f, 65, 0.0178478658f, -0.478641063f)]
    public void A_jump_follows_the_discrete_integration(float vy, int quanta, float z, float vz)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 0), Vector3.Zero, Standing);
        f.Body.SetOnWalkable(false);
        f.Body.SetVelocity(new Vector3(0, vy, 9.89949512f));
        for (int i = 0; i < quanta; i++) f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.True(Math.Abs(z - f.Z) <= 1e-6, $"z {f.Z:R}, expected {z:R}");
        Assert.Equal(vz, f.Body.Velocity.Z, 6);
    }

    [Fact, Behaviour("body.jump.smallest", "spec/02, 6.5")]
    public void The_smallest_jump_reaches_its_printed_heights()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 0), Vector3.Zero, Standing);
        f.Body.SetOnWalkable(false);
        f.Body.SetVelocity(new Vector3(0, 0, 2.61916018f));
        float[] z = [0.0818608999f, 0.15283291f, 0.212916031f, 0.262110263f, 0.300415605f, 0.327832043f, 0.344359607f, 0.349998266f,
            0.344553828f];
        foreach (float expected in z)
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(expected, f.Z, 6);
        }

        for (int quantum = 10; quantum <= 17; quantum++) f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(0.147000074f, f.Body.Velocity.Z, 6);
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        Assert.Equal(Vector3.Zero, f.Body.Velocity);
    }

    [Theory, Behaviour("body.friction.stops-on-flat-ground", "spec/02, 6.6")]
    [InlineData(1f / 30, 4f, 4.12066221f, 3.6198647f, 28, 5.19215822f, 0.244211063f)]
    [InlineData(1f / 30, 18f, 4.54298019f, 16.2893906f, 43, 9.63554001f, 0.245732635f)]
    [InlineData(0.05f, 4f, 4.17217827f, 3.44356656f, 19, 5.16584158f, 0.232317299f)]
    [InlineData(0.2f, 4f, 4.43942404f, 2.19712114f, 5, 4.92619181f, 0.200000048f)]
    [InlineData(0.2f, 18f, 5.97740936f, 9.88704491f, 8, 8.35087299f, 0.149150461f)]
    public void Friction_stops_a_body(float q, float v0, float y1, float v1, int lastMoving, float yLast, float vLast)
    {
        BodyFixture f = new();
        f.Seat(new(12, 4, 0), new Vector3(0, v0, 0), Standing);
        f.Body.AdvanceQuantum(q);
        Assert.Equal(y1, f.Y, 6);
        Assert.Equal(v1, f.Body.Velocity.Y, 5);
        for (int i = 1; i < lastMoving; i++) f.Body.AdvanceQuantum(q);
        Assert.Equal(yLast, f.Y, 5);
        Assert.Equal(vLast, f.Body.Velocity.Y, 6);
        f.Body.AdvanceQuantum(q);
        Assert.Equal(Vector3.Zero, f.Body.Velocity);
    }

    [Theory, Behaviour("body.friction.single-cases", "spec/02, 6.7")]
    [InlineData(4, 0, 0, 0, 0, 1, false, 3.6198647f, 0, 0)]
    [InlineData(4, 0, 0.24f, 0, 0, 1, false, 3.6198647f, 0, 0)]
    [InlineData(4, 0, 0.25f, 0, 0, 1, false, 4, 0, 0.25f)]
    [InlineData(0, 3, -1, 0, -0.5f, 0.8660254f, false, 0, 1.64431202f, 0.949344039f)]
    [InlineData(0, 3, -1.5f, 0, 0.34202015f, 0.9396926f, false, 0, 2.83359146f, -1.03134298f)]
    [InlineData(0, 1.2f, 0, 0, 0, 1, true, 0, 0, 0)]
    [InlineData(0, 1.3f, 0, 0, 0, 1, true, 0, 1.17645597f, 0)]
    [InlineData(0, 2.4f, -0.5f, 0, 0.1736f, 0.9848f, true, 0, 2.18382096f, -0.384964973f)]
    [InlineData(0, 2.95f, -0.52f, 0, 0.1736f, 0.9848f, true, 0, 2.92813468f, -0.516170025f)]
    [InlineData(0, 2.95f, -0.52f, 0, 0.17f, 0.98544f, true, 0, 2.67133164f, -0.460836202f)]
    public void Friction_of_one_quantum(
        float vx, float vy, float vz, float nx, float ny, float nz, bool sledding, float ex, float ey, float ez)
    {
        BodyFixture f = new(sledding ? PhysicsState.Default | PhysicsState.Sledding : PhysicsState.Default);
        Vector3 v = new(vx, vy, vz);
        f.Seat(new(12, 12, 0), v, Standing, new Plane(nx, ny, nz, 0));
        f.Body.CalcFriction(BodyFixture.Tick, v.LengthSquared());
        Assert.True(Vector3.Distance(new(ex, ey, ez), f.Body.Velocity) < 2e-6, $"{f.Body.Velocity}");
    }

    [Fact, Behaviour("body.sled.flat-ground", "spec/02, 6.7")]
    public void A_sled_on_flat_ground_slows_by_its_own_friction()
    {
        BodyFixture f = new(PhysicsState.Default | PhysicsState.Sledding);
        f.Seat(new(12, 4, 0), new Vector3(0, 5, 0), Standing);
        (float Y, float Vy)[] expected = [(4.15082788f, 4.52483082f), (4.28732204f, 4.09481859f)];
        foreach ((float y, float vy) in expected)
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(y, f.Y, 6);
            Assert.Equal(vy, f.Body.Velocity.Y, 5);
            Assert.Equal(-0.326666683f, f.Body.Velocity.Z, 6);
            Assert.Equal(0f, f.Z, 6);
        }
    }

    [Theory, Behaviour("body.heading.along-the-way", "spec/02, 4.4, step 7; spec/03, 4.1.4")]
    [InlineData(PhysicsState.Missile | PhysicsState.AlignPath, 0.6f, 0.8f)]
    [InlineData(PhysicsState.Sledding, 1f, 0f)]
    public void A_missile_faces_its_way_and_a_sled_the_level_part_of_it(PhysicsState state, float yAxisX, float yAxisZ)
    {
        BodyFixture f = new(state);
        f.Seat(new(12, 12, 10), new Vector3(3, 0, 4), TransientState.None);
        f.Body.AdvanceQuantum(BodyFixture.Tick);
        // The way is worked out from positions stored as float, 0.17 m apart at 12 m.
        Vector3 facing = f.Body.Position.Frame.YAxis, right = f.Body.Position.Frame.XAxis;
        Assert.True(Vector3.Distance(new Vector3(yAxisX, 0, yAxisZ), facing) < 1e-4f, $"faces {facing}");
        Assert.True(Vector3.Distance(-Vector3.UnitY, right) < 1e-4f, $"right {right}");
    }

    [Fact, Behaviour("body.velocity.clamp", "spec/02, 6.8")]
    public void A_velocity_is_set_to_at_most_fifty()
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 200), Vector3.Zero, TransientState.None);
        f.Body.SetVelocity(new(30, 40, 12));
        Assert.Equal(
            new Vector3(BitConverter.UInt32BitsToSingle(0x41E95F7A), BitConverter.UInt32BitsToSingle(0x421B94FC),
                BitConverter.UInt32BitsToSingle(0x413AB2C8)),
            f.Body.Velocity);
        f.Body.SetVelocity(new(0, 0, -60));
        Assert.Equal(new Vector3(0, 0, -50), f.Body.Velocity);
        f.Body.SetVelocity(new(50, 0.1f, 0));
        Assert.Equal(new Vector3(49.999897f, 0.0999998078f, 0), f.Body.Velocity);
        f.Body.SetVelocity(new(0, 0, -49.9f));
        (float Z, float Vz)[] expected = [(198.331238f, -50.2266693f), (196.659119f, -50.3266678f), (194.987f, -50.3266678f)];
        foreach ((float z, float vz) in expected)
        {
            f.Body.AdvanceQuantum(BodyFixture.Tick);
            Assert.Equal(z, f.Z, 5);
            Assert.Equal(vz, f.Body.Velocity.Z, 5);
        }
    }

    [Theory, Behaviour("body.jump.smallest-takeoff", "spec/02, 6.10")]
    [InlineData(1f / 30, 0.326866686f)]
    [InlineData(0.05f, 0.490200013f)]
    [InlineData(0.1f, 0.980200052f)]
    [InlineData(0.2f, 1.96020007f)]
    public void Only_a_velocity_above_one_quantum_of_gravity_takes_off(float q, float smallest)
    {
        Assert.True(TakesOff(smallest));
        Assert.False(TakesOff(smallest - 1e-5f));

        bool TakesOff(float vz)
        {
            BodyFixture f = new();
            f.Seat(new(12, 12, 0), Vector3.Zero, Standing);
            f.Body.SetOnWalkable(false);
            f.Body.SetVelocity(new Vector3(0, 0, vz));
            f.Body.AdvanceQuantum(q);
            return !f.Body.HasContact;
        }
    }

    [Theory, Behaviour("body.quanta.elapsed", "spec/02, 6.11")]
    [InlineData(0.0001, 0, 0.0001)]
    [InlineData(0.001, 1, 0.001)]
    [InlineData(0.02, 1, 0.02)]
    [InlineData(0.2, 1, 0.2)]
    [InlineData(0.21, 1, 0.2)]
    [InlineData(0.23, 1, 0.2)]
    [InlineData(0.24, 2, 0.24)]
    [InlineData(0.4, 2, 0.4)]
    [InlineData(0.43, 2, 0.4)]
    [InlineData(0.45, 3, 0.45)]
    [InlineData(1.99, 10, 1.99)]
    [InlineData(2.0001, 0, 2.0001)]
    public void Elapsed_time_is_cut_into_quanta(double elapsed, int quanta, double advance)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 100), new Vector3(0, 0, -10), TransientState.None);
        QuantumCounter counter = new();
        SteeredPhysicsBody.Of(f.Body).Attach(counter);
        f.Body.UpdateObject(elapsed);
        Assert.Equal(quanta, counter.Count);
        Assert.Equal(advance, f.Body.SimulatedTime, 9);
    }

    [Fact, Behaviour("engine.tick.gate", "spec/02, 6.11")]
    public void The_world_ticks_at_most_thirty_times_a_second()
    {
        PhysicsEngine engine = new(new StubWorld(_ => null));
        Assert.False(engine.Tick(0.0333));
        Assert.True(engine.Tick(0.03334));
        Assert.False(engine.Tick(0.05));
        Assert.Throws<ArgumentException>(() => engine.Tick(double.NaN));
    }

    [Theory, Behaviour("body.public.rejects-nan", "design.md, decision 7")]
    [InlineData(float.NaN)]
    [InlineData(float.PositiveInfinity)]
    public void Numbers_that_are_not_finite_are_refused_and_change_nothing(float bad)
    {
        BodyFixture f = new();
        f.Seat(new(12, 12, 1), Vector3.UnitX, TransientState.None);
        ulong before = f.Engine.HashState();
        Assert.Throws<ArgumentException>(() => f.Body.SetVelocity(new Vector3(bad, 0, 0)));
        Assert.Throws<ArgumentException>(() => f.Body.SetLocalVelocity(new Vector3(0, bad, 0)));
        Assert.Throws<ArgumentException>(() => f.Body.SetOmega(new Vector3(0, 0, bad)));
        Assert.Throws<ArgumentException>(() => f.Body.SetHeading(bad));
        Assert.Throws<ArgumentException>(() => f.Body.SetPosition(new PlacementRequest(new(StubWorld.CellId, new Vector3(bad, 0, 0)))));
        Assert.Throws<ArgumentException>(() => f.Body.EnterWorld(new(StubWorld.CellId, new Vector3(0, 0, bad))));
        Assert.Throws<ArgumentOutOfRangeException>(() => f.Body.AdvanceQuantum(bad));
        Assert.Equal(before, f.Engine.HashState());
    }
}
