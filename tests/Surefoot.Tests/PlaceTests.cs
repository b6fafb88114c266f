using System.Numerics;
using CsCheck;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Tests;

public class PlaceTests
{
    [Fact]
    [Behaviour("door.place.forms", "README, Embed it")]
    public void A_place_is_read_in_each_of_its_forms()
    {
        Assert.Equal(new Place(new Position(0xA9B40019, new Vector3(84, 7.1f, 0)), OnGround: true), Place.Parse("0xA9B40019,84,7.1"));
        Assert.Equal(new Place(new Position(0xA9B40019, new Vector3(84, 7.1f, 94))), Place.Parse("0xa9b40019, 84, 7.1, 94"));
        Assert.Equal(90f, Place.Parse("0xA9B40019,84,7.1,94,90").Position.Frame.Heading, 1e-3f);

        // As the game prints it for /loc: the rotation is w, x, y, z.
        Place printed = Place.Parse("0xA9B40019 [84.000000 7.100000 94.005005] 0.707107 0.000000 0.000000 -0.707107");
        Assert.Equal((0xA9B40019, new Vector3(84, 7.1f, 94.005005f)), (printed.Position.CellId, printed.Position.Frame.Origin));
        Assert.Equal(90f, printed.Position.Frame.Heading, 1e-3f);
        Assert.False(printed.OnGround);
    }

    [Theory]
    [Behaviour("door.place.says-what-is-wrong", "design, decision 7")]
    [InlineData("", "a place is")]
    [InlineData("meadow", "a place is")]
    [InlineData("0xA9B40019,84", "a place is")]
    [InlineData("0xA9B40019,84,7,1,2,3", "a place is")]
    [InlineData("A9B40019,84,7,1", "a place is")]
    [InlineData("0xA9B40019,84,north,1", "north is not a finite number")]
    [InlineData("0xA9B40019,84,NaN,1", "NaN is not a finite number")]
    [InlineData("0xA9B40019,84,1e99,1", "1e99 is not a finite number")]
    [InlineData("0xA9B4FFFF,1,1,1", "0xA9B40001")]
    [InlineData("0xA9B40041,1,1,1", "cannot name a cell")]
    [InlineData("0xA9B40100,1,1", "needs its height")]
    [InlineData("0xA9B40019 [1 1 1] 0 0 0 0", "rotation")]
    public void Words_that_are_no_place_are_refused_with_the_reason(string text, string reason) =>
        Assert.Contains(reason, Assert.Throws<FormatException>(() => Place.Parse(text)).Message, StringComparison.Ordinal);

    [Fact]
    [Behaviour("door.place.any-words", "design, decision 7")]
    public void No_words_do_anything_but_be_read_or_be_refused() =>
        Gen.OneOf(Gen.String, Gen.String[Gen.Char["0xA9B4[], .-1e"], 0, 40]).Sample(
            text =>
            {
                try
                {
                    Assert.True(Place.Parse(text).Position.Frame.IsValid);
                }
                catch (FormatException e)
                {
                    Assert.NotEmpty(e.Message);
                }
            },
            iter: Fuzz.Cases(2000));

    [Fact]
    [Behaviour("door.place.prints-what-it-reads", "README, Embed it")]
    public void A_place_is_printed_in_a_form_that_is_read()
    {
        foreach (string text in (string[])["0xA9B40019,84,7.1", "0xA9B40019,84,7.1,94.25"])
            Assert.Equal((text, Place.Parse(text)), (Place.Parse(text).ToString(), Place.Parse(Place.Parse(text).ToString())));
    }

    [Fact]
    [Behaviour("door.place.is-a-position", "README, Embed it")]
    public void A_position_is_a_place()
    {
        Place place = new Position(0xA9B40019, new Frame(Vector3.One, Quaternion.Identity));
        Assert.Equal((0xA9B40019, false), (place.Position.CellId, place.OnGround));
    }
}
