using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.Tests.Assets;
using Surefoot.Physics.Tests.Motion;
using Surefoot.Physics.World;
using StaticRecord = Surefoot.Dats.Records.StaticObject;

namespace Surefoot.Physics.Tests.World;

/// <summary>
/// A ramp of slope 0.8 ends at y = 0, z = 0; half a metre on a wall carries a floor at z = 0.6. A human who runs up (+y) steps onto the
/// lip as soon as his foot overlaps it: no footing is asked while stepping up. From then on it is. The ramp carries half a foot until
/// y = 0.24·cos 38.66° = 0.187, the floor from y = 0.5 − 0.24 = 0.26 on. A stride that ends between the two is stopped by a precipice
/// slide, and so is every later one.
/// </summary>
public sealed class StickyLipTests
{
    private const uint Mesh = 0x01000030, Cell = 0xA9B4001C;
    private const float Tick = 1f / 30, Slope = 0.8f, WallY = 0.5f, FloorZ = 0.6f, Width = 4, Stride = 4f / 30;

    /// <summary>Where the end of the ramp is in the block: well above the ground, so that who falls through is found there.</summary>
    private static readonly Vector3 Origin = new(84, 84, 40);

    private static readonly SetupAsset Human = new()
    {
        Spheres = [new Sphere(new Vector3(0, 0, 0.48f), 0.48f), new Sphere(new Vector3(0, 0, 1.35f), 0.48f)],
        Height = 1.835f,
        Radius = 0.48f,
        StepUpHeight = 0.6f,
        StepDownHeight = 1.5f,
    };

    private readonly PhysicsEngine engine = new(
        new WorldRecords().Ground(info: true).Add(Scene(), new LandBlockInfo
        {
            Id = WorldRecords.Info,
            Objects = [new StaticRecord(Mesh, WorldRecords.At(Origin.X, Origin.Y, Origin.Z))],
        }).World());

    private readonly MotionTableAsset table = HumanoidTable.Create();

    [Fact]
    [Behaviour("edge.lip.stops-a-stride", "spec/03, 4.7, step_up, step_down 4 and edge_slide C")]
    public void A_runner_steps_onto_a_lip_from_afar_and_the_next_stride_is_stopped_at_its_edge()
    {
        PhysicsBody runner = Begin(speed: 4, start: -1.566f);
        TraceBuffer trace = runner.Trace = new TraceBuffer();
        Vector3 lip = default;
        for (int i = 0; i < 40 && Responses(trace, TransitionResponse.StepUp).Length == 0; i++) lip = Next(runner);
        float stepUp = Assert.Single(Responses(trace, TransitionResponse.StepUp));
        Assert.Equal(0.06f, stepUp, 0.01f);
        Assert.Equal(stepUp, lip.Y);
        Assert.Equal(FloorZ, lip.Z, 1e-4f);
        Assert.True(runner.OnWalkable);
        Assert.Empty(Responses(trace, TransitionResponse.PrecipiceSlide));

        Assert.Equal(lip, Next(runner));
        float precipice = Assert.Single(Responses(trace, TransitionResponse.PrecipiceSlide));
        Assert.Equal(0.19f, precipice, 0.01f);
        Assert.Equal(lip.Y + Stride, precipice, 1e-3f);
        for (int i = 0; i < 30; i++) Assert.Equal(lip, Next(runner));
        Assert.True(runner.OnWalkable);
    }

    [Fact]
    [Behaviour("edge.lip.by-speed-and-phase", "spec/03, 4.7; spec/01b, 4: a run moves in whole frames, none, one or two a quantum")]
    public void Of_many_runs_more_than_half_come_over_the_lip_and_the_rest_stick_to_it()
    {
        int over = 0;
        for (int k = 0; k < 25; k++)
        {
            float speed = 0.5f + (0.25f * k);
            for (int phase = 0; phase < 9; phase++)
            {
                PhysicsBody runner = Begin(speed, -1.5f - (phase * Stride / 9));
                Vector3 place = default;
                for (int quanta = (int)(40 * 4 / speed); quanta > 0 && place.Y < 1; quanta--)
                {
                    place = Next(runner);
                    Assert.True(runner.OnWalkable && place.Z > -1.5f,
                        $"at {speed} m/s, phase {phase}, the runner is in the air at {place}");
                }

                Assert.Equal(FloorZ, place.Z, 1e-3f);
                if (place.Y >= 1) over++;
                else Assert.InRange(place.Y, 0, 0.19f);
                engine.RemoveBody(runner);
            }
        }

        Assert.InRange(over, 113, 224);
    }

    /// <summary>Puts a human onto the ramp and lets him run.</summary>
    private PhysicsBody Begin(float speed, float start)
    {
        PhysicsBody body = engine.CreateBody(1, Human);
        MovementManager movement = new(body, table, weenie: null);
        SteeredPhysicsBody.Of(body).Attach(movement);
        Assert.True(body.EnterWorld(new Position(Cell, Origin + new Vector3(0, start, (Slope * start) + 0.2f))));
        for (int i = 0; i < 60 && !body.OnWalkable; i++) body.AdvanceQuantum(Tick);
        Assert.True(body.OnWalkable);
        Assert.Equal(start, Place(body).Y, 1e-4f);
        Assert.Equal(MotionError.None, movement.Animation!.DoMotion(MotionCommand.RunForward, speed / 4));
        return body;
    }

    private static Vector3 Next(PhysicsBody body)
    {
        body.AdvanceQuantum(Tick);
        return Place(body);
    }

    private static Vector3 Place(PhysicsBody body) => body.Position.Frame.Origin - Origin;

    /// <summary>Ramp, wall and floor in one leaf.</summary>
    private static GfxObj Scene() => new()
    {
        Id = Mesh,
        Flags = GfxObjFlags.HasPhysics,
        Vertices = Records.Vertices(
            new(-Width, -8, -8 * Slope), new(Width, -8, -8 * Slope), new(Width, 0, 0), new(-Width, 0, 0),
            new(-Width, WallY, 0), new(Width, WallY, 0), new(Width, WallY, FloorZ), new(-Width, WallY, FloorZ),
            new(Width, 12, FloorZ), new(-Width, 12, FloorZ)),
        PhysicsPolygons =
        [
            new DatPolygon { Vertices = [0, 1, 2, 3] }, new DatPolygon { Vertices = [4, 5, 6, 7] },
            new DatPolygon { Vertices = [7, 6, 8, 9] },
        ],
        PhysicsTree = new BspTree { Nodes = [new BspNode { Sphere = new(new Vector3(0, 2, -3), 16), Polygons = [0, 1, 2] }] },
    };

    /// <summary>At which y a body stepped up, or precipice slides began.</summary>
    private static float[] Responses(TraceBuffer trace, TransitionResponse response) =>
    [
        .. trace.Entries.ToArray()
            .Where(
                e =>
                    e.Kind == TraceKind.Responded && e.Response == response &&
                        (e.Succeeded || response == TransitionResponse.PrecipiceSlide))
            .Select(e => e.Origin.Y - Origin.Y),
    ];
}
