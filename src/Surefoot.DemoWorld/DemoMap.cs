using System.Globalization;
using System.Text;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld;

/// <summary>A drawn map of the demo world.</summary>
public static class DemoMap
{
    private const int Scale = 12;
    private const int Margin = 40;
    private const int Cells = DemoTerrain.LandBlocks * 8;
    private const float WalkableNormalZ = 0.66417414f;

    /// <summary>The map of a seed's world as a self-contained SVG: shaded terrain, roads, block borders with their ids, slopes beyond
    /// the walkable limit in red, and the named places as dots with their names.</summary>
    /// <param name="seed">The world's seed.</param>
    public static string ToSvg(uint seed = DemoWorldBuilder.DefaultSeed)
    {
        var terrain = DemoTerrain.Create(seed);
        int side = (Cells * Scale) + (2 * Margin);
        var svg = new StringBuilder();
        svg.Append(CultureInfo.InvariantCulture, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {side} {side}\" font-family=\"sans-serif\">\n");
        svg.Append("<title>The demo world</title>\n");
        svg.Append(CultureInfo.InvariantCulture, $"<rect width=\"{side}\" height=\"{side}\" fill=\"{Hex(TerrainKinds.ColourOf(TerrainKind.WaterDeepSea), 1)}\"/>\n");
        AppendCells(svg, terrain);
        AppendRoads(svg, terrain);
        AppendBlocks(svg);
        AppendPlaces(svg, DemoPlaces.For(seed));
        svg.Append("</svg>\n");
        return svg.ToString();
    }

    // One path for each colour, so that the file stays small.
    private static void AppendCells(StringBuilder svg, DemoTerrain terrain)
    {
        var fills = new SortedDictionary<string, StringBuilder>(StringComparer.Ordinal);
        for (int column = 0; column < Cells; column++)
        {
            for (int row = 0; row < Cells; row++)
            {
                string colour = CellColour(terrain, column, row);
                if (!fills.TryGetValue(colour, out var path))
                    fills[colour] = path = new StringBuilder();
                path.Append(CultureInfo.InvariantCulture, $"M{X(column)} {Y(row + 1)}h{Scale}v{Scale}h-{Scale}z");
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
        double light = TerrainKinds.IsWater(kind) ? 1.0 : 0.55 + (0.55 * ((-0.5 * ground.Normal.X) + (0.5 * ground.Normal.Y) + (0.75 * ground.Normal.Z)));
        return Hex(TerrainKinds.ColourOf(kind), Math.Round(Math.Clamp(light, 0.6, 1.15) * 16.0) / 16.0);
    }

    private static void AppendRoads(StringBuilder svg, DemoTerrain terrain)
    {
        svg.Append("<path fill=\"none\" stroke=\"#c9ab7c\" stroke-width=\"4\" stroke-linecap=\"round\" d=\"");
        for (int column = 0; column < Cells; column++)
        {
            for (int row = 0; row < Cells; row++)
            {
                foreach (var (toColumn, toRow) in new[] { (column + 1, row), (column, row + 1), (column + 1, row + 1), (column + 1, row - 1) })
                {
                    // A diagonal beside a straight connection would only draw a triangle.
                    bool joined = toRow >= 0 && terrain.IsRoad(column, row) && terrain.IsRoad(toColumn, toRow);
                    bool straight = toColumn == column || toRow == row;
                    if (joined && (straight || !(terrain.IsRoad(toColumn, row) || terrain.IsRoad(column, toRow))))
                        svg.Append(CultureInfo.InvariantCulture, $"M{X(column)} {Y(row)}L{X(toColumn)} {Y(toRow)}");
                }
            }
        }

        svg.Append("\"/>\n");
    }

    private static void AppendBlocks(StringBuilder svg)
    {
        svg.Append("<g stroke=\"#00000055\" fill=\"none\">\n");
        for (int i = 0; i <= DemoTerrain.LandBlocks; i++)
            svg.Append(CultureInfo.InvariantCulture, $"<path d=\"M{X(i * 8)} {Y(0)}V{Y(Cells)}M{X(0)} {Y(i * 8)}H{X(Cells)}\"/>\n");
        svg.Append("</g>\n<g font-size=\"9\" fill=\"#00000088\">\n");
        for (int i = 0; i < DemoTerrain.LandBlocks; i++)
        {
            for (int j = 0; j < DemoTerrain.LandBlocks; j++)
                svg.Append(CultureInfo.InvariantCulture, $"<text x=\"{X(i * 8) + 3}\" y=\"{Y(j * 8) - 4}\">{DemoTerrain.FirstBlockX + i:X2}{DemoTerrain.FirstBlockY + j:X2}</text>\n");
        }

        svg.Append("</g>\n");
    }

    private static void AppendPlaces(StringBuilder svg, IReadOnlyList<NamedPlace> places)
    {
        var labels = new LabelPlacer();
        var dots = places.Select(place => (Place: place, At: DotOf(place))).ToList();
        foreach (var (_, at) in dots)
            labels.Block(at.X - 4, at.Y - 4, 8, 8);
        svg.Append("<g font-size=\"10\" fill=\"#101010\" stroke=\"#ffffffcc\" stroke-width=\"2.5\" paint-order=\"stroke\">\n");
        foreach (var (place, (x, y)) in dots)
        {
            svg.Append(CultureInfo.InvariantCulture, $"<circle cx=\"{x:0.#}\" cy=\"{y:0.#}\" r=\"3\"><title>{place.Title}. {place.WhatToTry}</title></circle>");
            if (IsYardSlope(place))
            {
                // Twelve in a row: slanted, over the terrace behind them.
                svg.Append(CultureInfo.InvariantCulture, $"<text x=\"{x + 5:0.#}\" y=\"{y - 5:0.#}\" transform=\"rotate(-60 {x:0.#} {y:0.#})\">{place.Name}</text>\n");
                continue;
            }

            var (left, baseline) = labels.Place(x, y, place.Name.Length);
            svg.Append(CultureInfo.InvariantCulture, $"<text x=\"{left:0.#}\" y=\"{baseline:0.#}\">{place.Name}</text>\n");
        }

        svg.Append("</g>\n");
    }

    private static bool IsYardSlope(NamedPlace place) => SlopeYard.Slopes.Any(slope => slope.Name == place.Name);

    private static (double X, double Y) DotOf(NamedPlace place)
    {
        var (column, row) = DemoTerrain.OriginOf((int)(place.CellId >> 24), (int)((place.CellId >> 16) & 0xFF));
        return (X(column) + (place.Origin.X / 24.0 * Scale), Y(row) - (place.Origin.Y / 24.0 * Scale));
    }

    private static int X(int column) => Margin + (column * Scale);

    private static int Y(int row) => Margin + ((Cells - row) * Scale);

    private static string Hex(DatColor colour, double light)
    {
        static int Channel(byte value, double light) => (int)Math.Clamp(Math.Round(value * light), 0, 255);
        return $"#{Channel(colour.Red, light):x2}{Channel(colour.Green, light):x2}{Channel(colour.Blue, light):x2}";
    }
}
