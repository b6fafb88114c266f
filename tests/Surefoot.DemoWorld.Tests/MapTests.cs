using System.Xml.Linq;

namespace Surefoot.DemoWorld.Tests;

public sealed class MapTests
{
    [Fact, Behaviour("demo-world.map.names-every-place", "design.md, Two commands")]
    public void The_maps_are_well_formed_and_name_every_place_of_the_land()
    {
        string[] labels = [.. new[] { DemoMap.ToSvg(), DemoMap.TownToSvg(), DemoMap.ParkToSvg() }.SelectMany(Labels)];
        Assert.All(
            DemoPlaces.All.Where(place => !place.Name.StartsWith("dungeon", StringComparison.Ordinal)),
            place => Assert.Contains(place.Name, labels));
        Assert.Contains("A9B4", labels);
    }

    private static IEnumerable<string> Labels(string svg)
        => XDocument.Parse(svg).Descendants().Where(element => element.Name.LocalName == "text").Select(element => element.Value);
}
