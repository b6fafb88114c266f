using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Tests;

/// <summary>The sample of docs/queries.md is here; it compiles, and it runs.</summary>
public sealed class QuerySampleTests(DemoFolder demo) : IClassFixture<DemoFolder>
{
    [Fact]
    [Behaviour("docs.queries.sample-runs", "docs/queries.md")]
    public void The_sample_of_the_page_on_questions_runs_and_is_what_the_page_shows()
    {
        string[] args = [demo.Path];
        // sample
        using var world = Simulation.Open(args[0]);
        Position here = world.Find(Place.Parse("0xA9B50032,156,24")), up = here, ahead = here;
        up.Frame.Origin.Z += 5;
        ahead.Frame.Origin += 2 * here.Frame.YAxis;
        var query = world.Engine.CreateQuery();             // one for each thread that asks
        var human = Mover.OfBody(world.Human);              // made once, asked about often

        ProbeDownResult below = query.ProbeDown(new ProbeDownInput(human, up, Depth: 10));
        SweepResult walk = query.Sweep(new SweepInput(human, below.Position, ahead) { Contact = below.Contact });
        PlaceResult room = query.Place(new PlaceInput(human, ahead));
        SphereOverlap around = query.Overlap(new SphereInput(here.CellId, new Sphere(here.Frame.Origin + Vector3.UnitZ, 0.5f)));
        PointOverlap under = query.Overlap(new PointInput(here.CellId, here.Frame.Origin - Vector3.UnitZ));
        Console.WriteLine($"{below.Depth:0.00} m to the {below.Subject.Kind}, then to {walk.Position}");
        Console.WriteLine($"room: {room.Found}, air: {!around.Overlaps}, in the {under.Subject.Kind}: {under.IsSolid}");

        // sample
        // The human's foot reaches 5 mm below its origin.
        Assert.Equal(5 - 0.005f, below.Depth, 1e-4f);
        Assert.True(below.Found && walk.Found && room.Found && !around.Overlaps && under.IsSolid);
        Assert.Equal(0, walk.Position.HorizontalDistanceTo(ahead), 1e-3);
        Sample.AssertShown("docs/queries.md", "# Asking a world", "QuerySampleTests.cs");
    }
}
