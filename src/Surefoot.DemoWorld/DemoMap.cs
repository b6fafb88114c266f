using System.Globalization;
using System.Numerics;
using System.Text;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Buildings;
using Surefoot.DemoWorld.Land;
using Surefoot.DemoWorld.Placement;
using Surefoot.DemoWorld.Things;

namespace Surefoot.DemoWorld;

/// <summary>Drawn maps of the demo world: self-contained SVG.</summary>
/// <remarks>Shaded terrain, roads, block borders with their ids, slopes beyond the walkable limit in red, what stands around, and the
/// named places as dots with their names; pointing at a dot shows what to try there.</remarks>
public static class DemoMap
{
    private const int Margin = 40;
    private const float WalkableNormalZ = 0.66417414f;

    private static readonly View Whole = new("The demo world", 0, 0, 64, 64, 12);
    private static readonly View Town = new("The town", 13, 33, 24, 39, 70);
    private static readonly View Park = new("The obstacle park", 33, 33, 41, 38, 110);

    /// <summary>The whole land. Places in the town and the park are dots without a name; those have maps of their own.</summary>
    /// <param name="seed">The world's seed.</param>
    public static string ToSvg(uint seed = DemoWorldBuilder.DefaultSeed)
        => Draw(Whole, WorldPlan.Create(seed), place => !Crowded(place), detailed: false);

    /// <summary>The town, with the outlines of what stands there.</summary>
    /// <param name="seed">The world's seed.</param>
    public static string TownToSvg(uint seed = DemoWorldBuilder.DefaultSeed) =>
        Draw(Town, WorldPlan.Create(seed), _ => true, detailed: true);

    /// <summary>The obstacle park, with the outlines of what stands there.</summary>
    /// <param name="seed">The world's seed.</param>
    public static string ParkToSvg(uint seed = DemoWorldBuilder.DefaultSeed) =>
        Draw(Park, WorldPlan.Create(seed), _ => true, detailed: true);

    private static bool Crowded(NamedPlace place)
    {
        var (x, y) = PositionOf(place.CellId, place.Origin);
        bool detailed = Town.Contains(x / 24, y / 24) || Park.Contains(x / 24, y / 24);
        return detailed && place.Name is not ("town" or "steps-20");
    }

    private static string Draw(View view, WorldPlan plan, Func<NamedPlace, bool> named, bool detailed)
    {
        int width = ((view.East - view.West) * view.Scale) + (2 * Margin), height = ((view.North - view.South) * view.Scale) + (2 * Margin);
        var svg = new StringBuilder();
        svg.Append(CultureInfo.InvariantCulture,
            $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n");
        svg.Append(CultureInfo.InvariantCulture, $"<title>{view.Title}</title>\n");
        svg.Append(CultureInfo.InvariantCulture,
            $"<rect width=\"{width}\" height=\"{height}\" fill=\"{Hex(TerrainKinds.ColourOf(TerrainKind.WaterDeepSea), 1)}\"/>\n");
        AppendCells(svg, view, plan.Terrain);
        AppendRoads(svg, view, plan.Terrain);
        AppendBlocks(svg, view);
        if (detailed)
            AppendThings(svg, view, plan);
        AppendPlaces(svg, view, plan.Places, named);
        svg.Append("</svg>\n");
        return svg.ToString();
    }

    // One path for each colour, so that the file stays small.
    private static void AppendCells(StringBuilder svg, View view, DemoTerrain terrain)
    {
        var fills = new SortedDictionary<string, StringBuilder>(StringComparer.Ordinal);
        for (int column = view.West; column < view.East; column++)
        {
            for (int row = view.South; row < view.North; row++)
            {
                string colour = CellColour(terrain, column, row);
                if (!fills.TryGetValue(colour, out var path))
                    fills[colour] = path = new StringBuilder();
                path.Append(CultureInfo.InvariantCulture,
                    $"M{view.X(column):0} {view.Y(row + 1):0}h{view.Scale}v{view.Scale}h-{view.Scale}z");
            }
        }

        svg.Append("<g shape-rendering=\"crispEdges\">\n");
        foreach (var (colour, path) in fills)
            svg.Append(CultureInfo.InvariantCulture, $"<path fill=\"{colour}\" d=\"{path}\"/>\n");
        svg.Append("</g>\n");
    }

    private static string CellColour(DemoTerrain terrain, int column, int row)
    {
        var ground = terrain.GroundAt((column + 0.5) * 24.0, (row + 0.5) * 24.0);
        if (ground.Normal.Z < WalkableNormalZ)
            return "#b0574a";
        var kind = terrain.Kind(column, row);

        // Light from the north-west, in steps so that few colours are needed.
        double light = TerrainKinds.IsWater(kind)
            ? 1.0
            : 0.55 + (0.55 * ((-0.5 * ground.Normal.X) + (0.5 * ground.Normal.Y) + (0.75 * ground.Normal.Z)));
        return Hex(TerrainKinds.ColourOf(kind), Math.Round(Math.Clamp(light, 0.6, 1.15) * 16.0) / 16.0);
    }

    private static void AppendRoads(StringBuilder svg, View view, DemoTerrain terrain)
    {
        svg.Append(CultureInfo.InvariantCulture,
            $"<path fill=\"none\" stroke=\"#c9ab7c\" stroke-width=\"{view.Scale / 3}\" stroke-linecap=\"round\" d=\"");
        for (int column = view.West; column < view.East; column++)
        {
            for (int row = view.South; row < view.North; row++)
            {
                (int Column, int Row)[] ahead = [(column + 1, row), (column, row + 1), (column + 1, row + 1), (column + 1, row - 1)];
                foreach ((int toColumn, int toRow) in ahead)
                {
                    // A diagonal beside a straight connection would only draw a triangle.
                    bool joined = terrain.IsRoad(column, row) && terrain.IsRoad(toColumn, toRow);
                    bool straight = toColumn == column || toRow == row;
                    if (joined && (straight || !(terrain.IsRoad(toColumn, row) || terrain.IsRoad(column, toRow))))
                        svg.Append(CultureInfo.InvariantCulture,
                            $"M{view.X(column):0} {view.Y(row):0}L{view.X(toColumn):0} {view.Y(toRow):0}");
                }
            }
        }

        svg.Append("\"/>\n");
    }

    private static void AppendBlocks(StringBuilder svg, View view)
    {
        svg.Append("<g stroke=\"#00000055\" fill=\"none\">\n");
        for (int i = 0; i <= DemoTerrain.LandBlocks; i++)
        {
            if (i * 8 >= view.West && i * 8 <= view.East)
                svg.Append(CultureInfo.InvariantCulture,
                    $"<path d=\"M{view.X(i * 8):0} {view.Y(view.South):0}V{view.Y(view.North):0}\"/>\n");
            if (i * 8 >= view.South && i * 8 <= view.North)
                svg.Append(CultureInfo.InvariantCulture, $"<path d=\"M{view.X(view.West):0} {view.Y(i * 8):0}H{view.X(view.East):0}\"/>\n");
        }

        svg.Append("</g>\n<g font-size=\"9\" fill=\"#00000088\">\n");
        foreach (var (x, y) in DemoTerrain.Blocks)
        {
            var (column, row) = DemoTerrain.OriginOf(x, y);
            if (column >= view.West && column < view.East && row >= view.South && row < view.North)
                svg.Append(CultureInfo.InvariantCulture,
                    $"<text x=\"{view.X(column) + 3:0}\" y=\"{view.Y(row) - 4:0}\">{x:X2}{y:X2}</text>\n");
        }

        svg.Append("</g>\n");
    }

    // Outlines from above: of each shape the upward faces, turned and moved to where it stands.
    private static void AppendThings(StringBuilder svg, View view, WorldPlan plan)
    {
        DatRecord[] records = [.. ObstacleShapes.All(), .. NatureShapes.All(), .. Windmill.All(), House.Shell()];
        var shapes = records.OfType<GfxObj>().ToDictionary(shape => shape.Id);
        svg.Append("<g fill=\"#6b5a48\" fill-opacity=\"0.75\" stroke=\"#2a221a\" stroke-width=\"0.5\">\n");
        foreach (var (blockId, thing) in plan.Things)
        {
            // Of the windmill the part that stands still.
            if (!shapes.TryGetValue(thing.ObjectId == DemoIds.WindmillSetup ? Windmill.Tower : thing.ObjectId, out var shape))
                continue;
            svg.Append("<path d=\"");
            foreach (var polygon in shape.DrawingPolygons)
            {
                var corners = polygon.Vertices.Select(index => shape.Vertices.Vertices[index]).ToList();
                if (corners[0].Normal.Z < 0.01f)
                    continue;
                for (int i = 0; i < corners.Count; i++)
                {
                    var (x, y) = PositionOf(blockId, thing.Frame.Origin + Vector3.Transform(corners[i].Position, thing.Frame.Rotation));
                    svg.Append(CultureInfo.InvariantCulture, $"{(i == 0 ? "M" : "L")}{view.X(x / 24):0.#} {view.Y(y / 24):0.#}");
                }

                svg.Append('z');
            }

            svg.Append("\"/>\n");
        }

        svg.Append("</g>\n<g fill=\"#d9c24a\" stroke=\"#2a221a\" stroke-width=\"0.5\">\n");
        foreach (var spawn in plan.Spawns)
        {
            var (x, y) = PositionOf(spawn.CellId, spawn.Origin);
            if (view.Contains(x / 24, y / 24))
                svg.Append(CultureInfo.InvariantCulture,
                    $"<circle cx=\"{view.X(x / 24):0.#}\" cy=\"{view.Y(y / 24):0.#}\" r=\"1.5\"><title>{spawn.Name}</title></circle>\n");
        }

        svg.Append("</g>\n");
    }

    private static void AppendPlaces(StringBuilder svg, View view, IEnumerable<NamedPlace> places, Func<NamedPlace, bool> named)
    {
        var labels = new LabelPlacer();
        var dots = places.Select(place => (Place: place, At: PositionOf(place.CellId, place.Origin)))
            .Where(dot => view.Contains(dot.At.X / 24, dot.At.Y / 24))
            .Select(dot => (dot.Place, X: view.X(dot.At.X / 24), Y: view.Y(dot.At.Y / 24))).ToList();
        foreach (var (_, x, y) in dots)
            labels.Block(x - 4, y - 4, 8, 8);
        svg.Append("<g font-size=\"10\" fill=\"#101010\" stroke=\"#ffffffcc\" stroke-width=\"2.5\" paint-order=\"stroke\">\n");
        foreach (var (place, x, y) in dots)
        {
            svg.Append(CultureInfo.InvariantCulture,
                $"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"3\"><title>{place.Title}. {place.WhatToTry}</title></circle>");
            if (IsYardSlope(place))
            {
                // Twelve in a row: slanted, over the terrace behind them.
                svg.Append(CultureInfo.InvariantCulture,
                    $"<text x=\"{x + 5:0.#}\" y=\"{y - 5:0.#}\" transform=\"rotate(-60 {x:0.#} {y:0.#})\">{place.Name}</text>");
            }
            else if (named(place))
            {
                var (left, baseline) = labels.Place(x, y, place.Name.Length);
                svg.Append(CultureInfo.InvariantCulture, $"<text x=\"{left:0.#}\" y=\"{baseline:0.#}\">{place.Name}</text>");
            }

            svg.Append('\n');
        }

        svg.Append("</g>\n");
    }

    private static bool IsYardSlope(NamedPlace place) => SlopeYard.Slopes.Any(slope => slope.Name == place.Name);

    // Metres from the land's south-west corner.
    private static (double X, double Y) PositionOf(uint cellId, Vector3 origin)
    {
        var (column, row) = DemoTerrain.OriginOf((int)(cellId >> 24), (int)((cellId >> 16) & 0xFF));
        return ((column * 24.0) + origin.X, (row * 24.0) + origin.Y);
    }

    private static string Hex(DatColor colour, double light)
    {
        static int Channel(byte value, double light) => (int)Math.Clamp(Math.Round(value * light), 0, 255);
        return $"#{Channel(colour.Red, light):x2}{Channel(colour.Green, light):x2}{Channel(colour.Blue, light):x2}";
    }

    // A rectangle of the land in grid units, and how many pixels a cell has.
    private sealed record View(string Title, int West, int South, int East, int North, int Scale)
    {
        public bool Contains(double column, double row) => column >= West && column < East && row >= South && row < North;

        public double X(double column) => Margin + ((column - West) * Scale);

        public double Y(double row) => Margin + ((North - row) * Scale);
    }
}
