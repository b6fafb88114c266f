using System.Globalization;
using System.Net;
using System.Numerics;
using System.Text;
using Surefoot.Tool.Walking;

namespace Surefoot.Tool.Output;

/// <summary>A self-contained page with the path of a walk from above and in profile.</summary>
internal static class WalkPicture
{
    private const double PlanSize = 640;
    private const double ProfileWidth = 980;
    private const double ProfileHeight = 260;
    private const double Margin = 46;

    /// <summary>Renders the page.</summary>
    /// <param name="walk">The walk.</param>
    /// <param name="groundHeight">Height of the terrain at a place of the map, null where none is loaded.</param>
    internal static string Render(WalkResult walk, Func<double, double, double?> groundHeight)
    {
        StringBuilder html = new();
        string title = WebUtility.HtmlEncode($"{walk.Place}: {walk.Script}");
        WalkSample last = walk.Samples[^1];
        html.Append(CultureInfo.InvariantCulture, $$"""
            <!doctype html><html lang="en"><head><meta charset="utf-8"><title>{{title}}</title>
            <style>
            body{font:15px/1.5 system-ui,sans-serif;margin:2rem auto;max-width:1040px;color:#22302a;background:#f6f7f4}
            h1{font-size:1.3rem;margin:0 0 .3rem} h2{font-size:1rem;margin:1.6rem 0 .4rem}
            svg{background:#fff;border:1px solid #cdd4ce;border-radius:6px}
            table{border-collapse:collapse} td,th{padding:.15rem .8rem .15rem 0;text-align:left}
            .n{text-align:right;font-variant-numeric:tabular-nums}
            text{font:12px system-ui,sans-serif;fill:#4a5a52}
            </style></head><body><h1>{{title}}</h1>
            <p>Run skill {{walk.RunSkill}}, jump skill {{walk.JumpSkill}}: {{walk.Distance:0.00}} m over ground in {{last.Time:0.00}} s,
            top speed {{walk.TopSpeed:0.00}} m/s, from {{walk.Samples[0].Local.Z:0.00}} m to {{last.Local.Z:0.00}} m high,
            ending in 0x{{last.CellId:X8}}.</p>
            """);
        html.Append("<h2>From above</h2>");
        AppendPlan(html, walk, groundHeight);
        html.Append("<h2>In profile</h2>");
        AppendProfile(html, walk, groundHeight);
        AppendEvents(html, walk);
        html.Append("</body></html>\n");
        return html.ToString();
    }

    private static void AppendPlan(StringBuilder html, WalkResult walk, Func<double, double, double?> groundHeight)
    {
        double minX = walk.Samples.Min(s => s.Map.X), maxX = walk.Samples.Max(s => s.Map.X);
        double minY = walk.Samples.Min(s => s.Map.Y), maxY = walk.Samples.Max(s => s.Map.Y);
        double side = Math.Max(Math.Max(maxX - minX, maxY - minY) * 1.25, 24);
        double left = ((minX + maxX) / 2) - (side / 2), bottom = ((minY + maxY) / 2) - (side / 2), scale = PlanSize / side;
        double X(double x) => (x - left) * scale;
        double Y(double y) => PlanSize - ((y - bottom) * scale);

        html.Append(
            CultureInfo.InvariantCulture,
            $"<svg viewBox=\"0 0 {PlanSize} {PlanSize}\" width=\"{PlanSize}\" height=\"{PlanSize}\" role=\"img\" " +
            $"aria-label=\"path from above\">");
        AppendGround(html, groundHeight, left, bottom, side);
        AppendTrack(html, walk, s => (X(s.Map.X), Y(s.Map.Y)));
        double bar = NiceStep(side / 4);
        html.Append(
            CultureInfo.InvariantCulture,
            $"<path d=\"M14 {PlanSize - 16}h{bar * scale:0.0}\" stroke=\"#22302a\" stroke-width=\"3\"/>" +
            $"<text x=\"14\" y=\"{PlanSize - 22}\">{bar:0.##} m</text><text x=\"{PlanSize - 34}\" y=\"20\">N ↑</text></svg>");
    }

    /// <summary>The terrain as a grid of tiles, lighter where it is higher and where it faces north-west.</summary>
    private static void AppendGround(
        StringBuilder html, Func<double, double, double?> groundHeight, double left, double bottom, double side)
    {
        const int tiles = 64;
        double step = side / tiles, size = PlanSize / tiles;
        double?[,] z = new double?[tiles + 1, tiles + 1];
        double low = double.MaxValue, high = double.MinValue;
        for (int i = 0; i <= tiles; i++)
        {
            for (int j = 0; j <= tiles; j++)
            {
                z[i, j] = groundHeight(left + (i * step), bottom + (j * step));
                if (z[i, j] is not { } h) continue;
                low = Math.Min(low, h);
                high = Math.Max(high, h);
            }
        }

        double range = Math.Max(high - low, 1);
        for (int i = 0; i < tiles; i++)
        {
            for (int j = 0; j < tiles; j++)
            {
                if (z[i, j] is not { } h || z[i + 1, j] is not { } east || z[i, j + 1] is not { } north) continue;
                double shade = Math.Clamp(((h - east) + (north - h)) / step * -0.35, -0.25, 0.25),
                    light = 78 + (14 * (h - low) / range) + (shade * 40);
                html.Append(
                    CultureInfo.InvariantCulture,
                    $"<rect x=\"{i * size:0.#}\" y=\"{PlanSize - ((j + 1) * size):0.#}\" width=\"{size + 0.5:0.#}\" " +
                    $"height=\"{size + 0.5:0.#}\" fill=\"hsl(95 26% {Math.Clamp(light, 20, 97):0}%)\"/>");
            }
        }
    }

    private static void AppendProfile(StringBuilder html, WalkResult walk, Func<double, double, double?> groundHeight)
    {
        double[] along = new double[walk.Samples.Count];
        for (int i = 1; i < along.Length; i++)
        {
            Vector3 d = walk.Samples[i].Map - walk.Samples[i - 1].Map;
            along[i] = along[i - 1] + Math.Sqrt(((double)d.X * d.X) + ((double)d.Y * d.Y));
        }

        double low = walk.Samples.Min(s => s.Map.Z), high = walk.Samples.Max(s => s.Map.Z), length = Math.Max(along[^1], 1);
        double pad = Math.Max((high - low) * 0.15, 0.5);
        (low, high) = (low - pad, high + pad);
        double X(double d) => Margin + (d / length * (ProfileWidth - Margin - 14));
        double Y(double h) => 10 + ((high - h) / (high - low) * (ProfileHeight - 40));

        html.Append(
            CultureInfo.InvariantCulture,
            $"<svg viewBox=\"0 0 {ProfileWidth} {ProfileHeight}\" width=\"{ProfileWidth}\" height=\"{ProfileHeight}\" role=\"img\" " +
            $"aria-label=\"path in profile\">");
        double stepZ = NiceStep((high - low) / 4), stepD = NiceStep(length / 8);
        for (double h = Math.Ceiling(low / stepZ) * stepZ; h <= high; h += stepZ)
            html.Append(
                CultureInfo.InvariantCulture,
                $"<path d=\"M{Margin} {Y(h):0.0}H{ProfileWidth - 14}\" stroke=\"#e3e8e4\"/>" +
                $"<text x=\"4\" y=\"{Y(h) + 4:0.0}\">{h:0.##}</text>");
        for (double d = 0; d <= length; d += stepD)
            html.Append(CultureInfo.InvariantCulture,
                $"<text x=\"{X(d):0.0}\" y=\"{ProfileHeight - 8}\" text-anchor=\"middle\">{d:0.##} m</text>");
        StringBuilder ground = new();
        for (int i = 0; i < along.Length; i++)
            if (groundHeight(walk.Samples[i].Map.X, walk.Samples[i].Map.Y) is { } h)
                ground.Append(CultureInfo.InvariantCulture, $"{(ground.Length == 0 ? 'M' : 'L')}{X(along[i]):0.0} {Y(h):0.0}");
        html.Append(CultureInfo.InvariantCulture, $"<path d=\"{ground}\" fill=\"none\" stroke=\"#8aa07a\" stroke-width=\"2\"/>");
        int index = 0;
        AppendTrack(html, walk, s => (X(along[index++]), Y(s.Map.Z)));
        html.Append("</svg>");
    }

    /// <summary>
    /// The path: green on walkable ground, orange in contact with what is too steep, blue in the air; a dot every second.
    /// </summary>
    private static void AppendTrack(StringBuilder html, WalkResult walk, Func<WalkSample, (double X, double Y)> project)
    {
        string? colour = null;
        StringBuilder dots = new();
        (double X, double Y) before = default;
        double nextDot = 1;
        foreach (WalkSample sample in walk.Samples)
        {
            (double X, double Y) at = project(sample);
            string now = sample.OnWalkable ? "#1f7a3d" : sample.HasContact ? "#d98324" : "#2f6fd0";
            if (colour is not null && colour != now) html.Append("\"/>");
            if (colour is null)
                dots.Append(CultureInfo.InvariantCulture, $"<circle cx=\"{at.X:0.0}\" cy=\"{at.Y:0.0}\" r=\"5\" fill=\"#22302a\"/>");
            (double X, double Y) from = colour is null ? at : before;
            if (colour != now)
            {
                html.Append(
                    CultureInfo.InvariantCulture,
                    $"<path fill=\"none\" stroke-width=\"2.5\" stroke=\"{now}\" d=\"M{from.X:0.0} {from.Y:0.0}");
            }

            html.Append(CultureInfo.InvariantCulture, $"L{at.X:0.0} {at.Y:0.0}");
            colour = now;
            before = at;
            if (sample.Time < nextDot - 1e-6) continue;
            dots.Append(
                CultureInfo.InvariantCulture,
                $"<circle cx=\"{at.X:0.0}\" cy=\"{at.Y:0.0}\" r=\"2.6\" fill=\"#22302a\">" +
                $"<title>{sample.Time:0.0} s, {sample.Speed:0.0} m/s</title></circle>");
            nextDot += 1;
        }

        html.Append("\"/>").Append(dots);
    }

    private static void AppendEvents(StringBuilder html, WalkResult walk)
    {
        html.Append("<p>Green on walkable ground, orange on what is too steep, blue in the air; a dot every second.</p>");
        if (walk.Events.Count == 0) return;
        html.Append("<h2>What happened</h2><table>");
        foreach (WalkEvent e in walk.Events)
            html.Append(CultureInfo.InvariantCulture,
                $"<tr><td class=\"n\">{e.Time:0.000} s</td><td>{WebUtility.HtmlEncode(e.What)}</td></tr>");
        html.Append("</table>");
    }

    private static double NiceStep(double rough)
    {
        double power = Math.Pow(10, Math.Floor(Math.Log10(Math.Max(rough, 1e-6))));
        double ratio = rough / power;
        return power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
    }
}
