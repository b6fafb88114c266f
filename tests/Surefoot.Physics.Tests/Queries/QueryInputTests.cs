using System.Numerics;
using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Queries;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Queries;

/// <summary>Questions that cannot be asked, and what a question tells of itself.</summary>
public sealed class QueryInputTests
{
    [Fact, Behaviour("query.contact.unit-normal", "design, decision 7")]
    public void A_contact_whose_normal_is_not_of_unit_length_is_refused()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        SweepInput input = new(Ask.Walker, Ask.At(10, 10, 0), Ask.At(10, 11, 0));
        foreach (Vector3 normal in (Vector3[])[new(0, 0, 2), new(0, 0, 0.9f), Vector3.Zero])
            Assert.ThrowsAny<ArgumentException>(() => query.Sweep(input with { Contact = new Contact(new Plane(normal, 0), Ask.Land) }));
        Assert.True(query.Sweep(input with { Contact = new Contact(new Plane(Vector3.UnitZ, 0), Ask.Land) }).Found);
    }

    [Theory, Behaviour("query.contact.cell", "design, decision 7")]
    [InlineData(0xA9B40000u)]
    [InlineData(0xA9B40041u)]
    [InlineData(0xA9B4FFFEu)]
    public void A_contact_in_the_frame_of_no_block_is_refused(uint id)
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        SweepInput input = new(Ask.Walker, Ask.At(10, 10, 0), Ask.At(10, 11, 0));
        Assert.ThrowsAny<ArgumentException>(() => query.Sweep(input with { Contact = new Contact(new Plane(Vector3.UnitZ, 0), id) }));
    }

    /// <summary>
    /// After a step that was undone retail has a plane of a cell that it no longer knows; a sweep may begin with what one ended with.
    /// </summary>
    [Fact, Behaviour("query.contact.of-an-unknown-cell", "spec/02, 4.11 seeds; spec/03, 4.6 adjust_offset, step 4")]
    public void A_contact_of_an_unknown_cell_is_taken_as_a_sweep_left_it()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Contact ground = new(new Plane(Vector3.UnitZ, 0), 0);
        Assert.True(query.Sweep(new SweepInput(Ask.Walker, Ask.At(10, 10, 0), Ask.At(10, 11, 0)) { Contact = ground }) is
        { Found: true, Contact: { IsWalkable: true } });
    }

    [Fact, Behaviour("query.sliding-normal.of-unit-length", "design, decision 7")]
    public void A_wall_slid_along_has_a_unit_normal_or_none()
    {
        WorldQuery query = Ask.Engine(0xA9B40000).CreateQuery();
        Contact ground = new(new Plane(Vector3.UnitZ, 0), Ask.Land);
        SweepInput input = new(Ask.Walker, Ask.At(10, 10, 0), Ask.At(10, 11, 0)) { Contact = ground };
        foreach (Vector3 normal in (Vector3[])[new(2, 0, 0), new(0.9f, 0, 0), new(1e30f, 0, 0)])
            Assert.ThrowsAny<ArgumentException>(() => query.Sweep(input with { SlidingNormal = normal }));
        foreach (Vector3 normal in (Vector3[])[Vector3.UnitX, Vector3.Zero])
            Assert.True(query.Sweep(input with { SlidingNormal = normal }).Found);
    }

    [Theory, Behaviour("query.mover.bad-input", "design, decision 7")]
    [InlineData(float.NaN, 0.5f, 1f)]
    [InlineData(0.5f, float.PositiveInfinity, 1f)]
    [InlineData(0.5f, 0.5f, 0f)]
    [InlineData(0.5f, 0.5f, float.NaN)]
    [InlineData(-0.1f, 0.5f, 1f)]
    [InlineData(0.5f, -0.1f, 1f)]
    public void A_mover_of_a_shape_has_finite_step_heights_and_a_positive_scale(float up, float down, float scale)
    {
        SetupAsset setup = new() { Spheres = [new Sphere(new Vector3(0, 0, 0.5f), 0.5f)], StepUpHeight = up, StepDownHeight = down };
        Assert.ThrowsAny<ArgumentException>(() => new Mover(setup, scale: scale));
    }

    [Fact, Behaviour("query.mover.tells-what-it-is", "design, style: inputs are named structs")]
    public void A_mover_tells_what_it_was_made_of()
    {
        Mover mover = new(Ask.Walker.Setup, PhysicsState.Gravity | PhysicsState.Static, WeenieTraits.Present | WeenieTraits.Player, 1.5f);
        Assert.Same(Ask.Walker.Setup, mover.Setup);
        Assert.Equal((PhysicsState.Gravity, WeenieTraits.Present | WeenieTraits.Player, 1.5f), (mover.State, mover.Weenie, mover.Scale));
    }

    [Fact, Behaviour("query.shape.reaches-none", "spec/04, 4.5")]
    public void A_sphere_beside_all_parts_of_a_shape_reaches_into_none()
    {
        SetupAsset setup = SetupAsset.FromGfxObj(Ask.Cube);
        Assert.True(ShapeQuery.Overlap(setup, new Sphere(Vector3.Zero, 0.3f)).Overlaps);
        Assert.Equal(ShapeOverlap.None, ShapeQuery.Overlap(setup, new Sphere(new Vector3(50, 0, 0), 0.3f)));
    }

    /// <summary>The rooms of this world have solid leaves: a point behind a wall is solid, and so is a small sphere around it.</summary>
    [Theory, Behaviour("query.overlap.room-is-solid", "spec/04, 4.5; tests/data/worlds/oracle has solid-leaf trees")]
    [InlineData(0x01050104u)]
    [InlineData(0x01050107u)]
    public void A_point_in_the_walls_of_a_room_is_in_something_solid(uint id)
    {
        using DatSet dats = DatSet.Open(Repository.PathOf("tests", "data", "worlds", "oracle"));
        PhysicsEngine engine = new(new PhysicsDataCache(dats));
        Assert.True(engine.World.LoadLandblock(CellIds.BlockOf(id)));
        WorldQuery query = engine.CreateQuery();
        EnvCell room = (EnvCell)engine.World.GetVisible(id)!;
        int solid = 0;
        for (float x = -9.93f; x <= 10; x += 0.47f)
        {
            for (float y = -9.93f; y <= 10; y += 0.47f)
            {
                Vector3 point = room.Position.Frame.LocalToGlobal(new Vector3(x, y, 1.13f));
                PointOverlap found = query.Overlap(new PointInput(id, point));
                if (found.CellId != id) continue;
                SphereOverlap around = query.Overlap(new SphereInput(id, new Sphere(point, 0.01f)));
                Assert.True(found.IsSolid == around.Overlaps, $"{point}: point {found.IsSolid}, sphere {around.Overlaps}");
                if (!found.IsSolid) continue;
                Assert.Equal((TraceSubjectKind.Room, id), (found.Subject.Kind, found.Subject.CellId));
                solid++;
            }
        }

        Assert.True(solid > 0);
    }
}
