using System.Numerics;
using System.Text.RegularExpressions;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Tests;

public sealed partial class PlacesTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    public static TheoryData<string> Names() => [.. DemoPlaces.All.Select(place => place.Name)];

    [Theory, MemberData(nameof(Names)), Behaviour("demo-world.places.stand-on-the-ground", "spec/05, 4.3 to 4.5")]
    public void Outdoor_places_stand_on_the_triangle_under_them(string name)
    {
        Assert.True(DemoPlaces.TryFind(name, out var place));
        if ((place.CellId & 0xFFFF) >= 0x100 || place.Name is "house-roof" or "platform" or "close-blocks")
            return;
        int x = (int)(place.CellId >> 24), y = (int)((place.CellId >> 16) & 0xFF), cell = (int)(place.CellId & 0xFFFF) - 1;
        Assert.Equal(cell, (8 * (int)MathF.Floor(place.Origin.X / 24)) + (int)MathF.Floor(place.Origin.Y / 24));

        // Interpolates the corner heights itself, straight from the record.
        var block = world.Block(x, y);
        var heights = world.Region.HeightTable;
        int i = cell >> 3, j = cell & 7;
        double Corner(int di, int dj) => heights[block.Heights[LandBlock.IndexOf(i + di, j + dj)]];
        double fx = (place.Origin.X / 24) - i, fy = (place.Origin.Y / 24) - j;
        double sw = Corner(0, 0), se = Corner(1, 0), nw = Corner(0, 1), ne = Corner(1, 1);
        double ground = TerrainTriangle.CutsSouthWestToNorthEast((uint)((8 * x) + i), (uint)((8 * y) + j))
            ? fx >= fy ? sw + (fx * (se - sw)) + (fy * (ne - se)) : sw + (fy * (nw - sw)) + (fx * (ne - nw))
            : fx + fy <= 1 ? sw + (fx * (se - sw)) + (fy * (nw - sw)) : ne + ((1 - fx) * (nw - ne)) + ((1 - fy) * (se - ne));
        Assert.InRange(place.Origin.Z, ground - 0.95, ground + 0.0001);
        if (place.Name is not ("lake-shallows" or "lake-middle" or "river" or "beach" or "lake-shore"))
            Assert.Equal(ground, place.Origin.Z, 3);
    }

    [Fact, Behaviour("demo-world.places.have-unique-plain-names", "design.md, Two commands")]
    public void Names_are_unique_kebab_case_and_each_place_says_what_to_try()
    {
        Assert.Equal(DemoPlaces.All.Length, DemoPlaces.All.Select(place => place.Name).Distinct().Count());
        Assert.All(DemoPlaces.All, place =>
        {
            Assert.Matches(KebabCase(), place.Name);
            Assert.InRange(place.Heading, 0f, 359.99f);
            Assert.NotEmpty(place.Title);
            Assert.EndsWith(".", place.WhatToTry);
        });
        Assert.Equal("meadow", DemoPlaces.All[0].Name);
    }

    [Fact, Behaviour("demo-world.places.are-the-same-for-every-seed", "design.md, Two commands")]
    public void Every_seed_has_the_same_places_by_name()
    {
        foreach (uint seed in new uint[] { 0, 1, 7, 123456789, uint.MaxValue })
            Assert.Equal(DemoPlaces.All.Select(place => place.Name), DemoPlaces.For(seed).Select(place => place.Name));
    }

    [Theory]
    [InlineData(0, 0, 1)]
    [InlineData(90, 1, 0)]
    [InlineData(180, 0, -1)]
    [InlineData(270, -1, 0)]
    [Behaviour("demo-world.places.heading-turns-clockwise-from-north", "spec/05, 4.2")]
    public void A_heading_turns_clockwise_from_north(float heading, float x, float y)
    {
        var place = new NamedPlace("p", "P", 0xA9B40001, Vector3.Zero, heading, "Try.");
        var facing = Vector3.Transform(Vector3.UnitY, place.Orientation);
        Assert.Equal(x, facing.X, 5);
        Assert.Equal(y, facing.Y, 5);
        Assert.Equal(0f, facing.Z, 5);
    }

    [Fact, Behaviour("demo-world.places.unknown-names-have-neighbours", "design.md, decision 7")]
    public void An_unknown_name_is_not_found_and_resembling_names_are_offered()
    {
        Assert.False(DemoPlaces.TryFind("medow", out _));
        Assert.Equal("meadow", DemoPlaces.Resembling("medow").First());
        Assert.True(DemoPlaces.TryFind("Lake-Shore", out var place));
        Assert.Equal("lake-shore", place.Name);
    }

    [Fact, Behaviour("demo-world.places.border-lies-ahead", "design.md, Two commands")]
    public void The_block_border_lies_a_few_steps_ahead_of_its_place()
    {
        Assert.True(DemoPlaces.TryFind("landblock-border", out var place));
        Assert.Equal(90f, place.Heading);
        Assert.InRange(192f - place.Origin.X, 1f, 10f);
    }

    [GeneratedRegex("^[a-z0-9]+(-[a-z0-9]+)*$")]
    private static partial Regex KebabCase();
}
