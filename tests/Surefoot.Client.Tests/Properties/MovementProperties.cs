using System.Numerics;
using CsCheck;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests.Properties;

/// <summary>What holds for every body on every way through the demo world.</summary>
public sealed class MovementProperties(DemoFiles files) : IClassFixture<DemoFiles>
{
    [Fact]
    [Behaviour("properties.ends-outside-every-solid", "design.md, decision 1; spec/03, 4.8.3 and 4.9: the placement insert")]
    public void Any_way_from_a_free_place_ends_outside_every_solid_by_the_test_of_retail()
    {
        Trip.Any.Sample(
            trip => Journey.Visit(files, trip, journey =>
            {
                SolidTest test = new(journey.World);
                Stand stand = test.Judge(journey.Body);
                Assert.Equal(Stand.Free, stand);
                journey.Go(() =>
                {
                    // What is not free is not where a way of this property begins: the trip ends at an exception.
                    if (stand != Stand.Free || journey.Body.IsLost) return;
                    stand = test.Judge(journey.Body);
                    Assert.True(stand != Stand.Inside, $"{journey.Body.Position} is inside something of {test.Culprit?.Id:X8}");
                    if (trip.Who == Traveller.Player)
                    {
                        Assert.True(stand is Stand.Free or Stand.SolidWithoutFaces or Stand.SweptOver,
                            $"{stand} at {journey.Body.Position}");
                    }
                });
            }),
            iter: Fuzz.Cases(4000));
    }

    [Fact]
    [Behaviour("properties.one-sweep-ends-outside-every-solid", "design.md, decision 1; spec/03, 4.6 and 4.9")]
    public void One_sweep_of_any_length_ends_outside_every_solid()
    {
        Gen.Select(Trip.Any, Trip.Ways.Array[1, 8]).Sample(
            (trip, ways) => Journey.Visit(files, trip, journey =>
            {
                PhysicsBody body = journey.Body;
                SolidTest test = new(journey.World);
                WorldQuery query = journey.Engine.CreateQuery();
                foreach (Vector3 way in ways)
                {
                    Position to = body.Position;
                    to.Frame.Origin += way;
                    SweepResult result = query.Sweep(body, to);
                    if (!result.Found || journey.World.GetVisible(result.Position.CellId) is null) continue;
                    Stand stand = test.Judge(body, result.Position, result.Contact is not null);
                    Assert.True(stand != Stand.Inside,
                        $"{way} from {body.Position} ends at {result.Position} inside something of {test.Culprit?.Id:X8}");
                }
            }),
            iter: Fuzz.Cases(3000));
    }

    [Fact]
    [Behaviour("properties.always-finite", "design.md, decision 7")]
    public void Nothing_ever_becomes_infinite_or_no_number()
    {
        Trip.Any.Sample(
            trip => Journey.Visit(files, trip, journey =>
            {
                PhysicsBody body = journey.Body;
                journey.Go(() =>
                {
                    Assert.True(RetailMath.IsFinite(body.Position.Frame.Origin) && RetailMath.IsFinite(body.Velocity),
                        $"at {body.Position}, {body.Velocity} m/s");
                    Assert.True(
                        RetailMath.IsFinite(body.Acceleration) && RetailMath.IsFinite(body.AchievedVelocity) &&
                            RetailMath.IsFinite(body.Omega));
                    Assert.Equal(1, body.Position.Frame.Rotation.Length(), 1e-3);
                    if (!body.HasContact) return;
                    Assert.True(float.IsFinite(body.ContactPlane.D));
                    Assert.Equal(1, body.ContactPlane.Normal.Length(), 1e-3);
                    Assert.True(body.SlidingNormal == Vector3.Zero || Math.Abs(body.SlidingNormal.Length() - 1) < 1e-3);
                });
            }),
            iter: Fuzz.Cases(2000));
    }

    [Fact]
    [Behaviour("properties.no-further-than-asked", "design.md, decision 1; spec/03, 4.4, 4.6, 4.7; spec/04, 4.4, 4.13")]
    public void A_sub_step_leads_no_further_than_asked_plus_the_step_heights()
    {
        Trip.Any.Sample(
            trip => Journey.Visit(files, trip, journey =>
            {
                TraceBuffer trace = new();
                journey.Body.Trace = trace;
                journey.Go(() =>
                {
                    foreach (SubStepMeter.SubStep subStep in SubStepMeter.Read(trace))
                    {
                        if (new Reach(subStep, journey.Body).Excess(journey.World) is { } excess) Assert.Fail($"{excess}: {subStep}");
                    }

                    trace.Clear();
                });
            }),
            iter: Fuzz.Cases(3000));
    }
}
