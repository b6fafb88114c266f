using System.Xml.Linq;

namespace Surefoot.DemoWorld.Tests;

public sealed class MapTests
{
    [Fact, Behaviour("demo-world.map.names-every-place", "design.md, Two commands")]
    public void The_map_is_well_formed_and_names_every_place()
    {
        var svg = XDocument.Parse(DemoMap.ToSvg());
        var labels = svg.Descendants().Where(element => element.Name.LocalName == "text").Select(element => element.Value).ToHashSet();
        Assert.All(DemoPlaces.All, place => Assert.Contains(place.Name, labels));
        Assert.Contains("A9B4", labels);
    }
}
