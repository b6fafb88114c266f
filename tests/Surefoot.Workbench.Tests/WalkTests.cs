using System.Globalization;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The last walk: as a command, and on the map.</summary>
[Collection(BrowserCollection.Name)]
public sealed class WalkTests(Browser browser)
{
    [Fact]
    [Behaviour("workbench.page.copies-the-walk-as-a-command", "design.md, The tool")]
    public async Task The_copied_command_walks_the_way_that_was_just_walked()
    {
        await using Tab tab = await browser.OpenAsync("?run=150&jump=300&at=The%20runway");
        IPage page = tab.Page;
        await page.Context.GrantPermissionsAsync(["clipboard-read", "clipboard-write"]);
        // What was done before a rest is not part of it.
        await Hold(page, "s", 300);
        await tab.Until("window.surefoot.pose.speed === 0", "the player stands");
        await Task.Delay(2000);

        await page.Keyboard.DownAsync("w");
        await Task.Delay(1200);
        await Hold(page, "d", 500);
        await Task.Delay(300);
        await Hold(page, "Space", 600);
        await tab.Until("window.surefoot.drawn.airborne", "the player jumps");
        await tab.Until("!window.surefoot.drawn.airborne", "the player lands");
        await page.Keyboard.UpAsync("w");
        await tab.Until("window.surefoot.pose.speed === 0", "the player stands");
        JsonElement end = await tab.Read("window.surefoot.pose");
        double extent = await tab.Number("window.surefoot.events.find((one) => one.event === 1).value");

        await page.Keyboard.PressAsync("k");
        await Assertions.Expect(page.Locator("#toasts")).ToContainTextAsync("Copied: surefoot walk");
        string command = await page.EvaluateAsync<string>("() => navigator.clipboard.readText()");
        Assert.StartsWith("surefoot walk --at 0xA7B4", command, StringComparison.Ordinal);
        Assert.Contains(" --run 150 --jump 300 --quantum 35.15625 ", command, StringComparison.Ordinal);
        Assert.DoesNotContain("S ", command, StringComparison.Ordinal);

        JsonElement walk = await Command.JsonAsync(command);
        JsonElement last = walk.GetProperty("samples").EnumerateArray().Last();
        JsonElement there = last.GetProperty("position"), here = end.GetProperty("position");
        Assert.Equal($"{end.GetProperty("cell").GetUInt32():X8}", last.GetProperty("cell").GetString());
        string[] axes = ["x", "y", "z"];
        Assert.Equal(axes.Select(axis => here.GetProperty(axis).GetSingle()), there.EnumerateArray().Select(one => one.GetSingle()));
        Assert.Equal(end.GetProperty("yaw").GetSingle(), (float)(-last.GetProperty("heading").GetDouble() * Math.PI / 180));
        // The map's way leaves out less than the distance of two of its points.
        double way = await tab.Number("window.surefoot.walk.metres");
        Assert.True(way > 10, $"{way} m");
        Assert.InRange(walk.GetProperty("distance").GetDouble(), way - 0.01, way + 0.2);
        IEnumerable<string> events = walk.GetProperty("events").EnumerateArray().Select(one => one.GetProperty("what").GetString()!);
        string jump = Assert.Single(events, what => what.StartsWith("sends Jump", StringComparison.Ordinal));
        Assert.Contains(string.Create(CultureInfo.InvariantCulture, $"extent {extent:0.000},"), jump, StringComparison.Ordinal);
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.says-what-a-command-cannot", "design.md, The tool")]
    public async Task What_no_script_of_keys_can_say_is_said_beside_the_command()
    {
        await using Tab tab = await browser.OpenAsync();
        IPage page = tab.Page;
        await page.Context.GrantPermissionsAsync(["clipboard-read", "clipboard-write"]);
        await page.Keyboard.DownAsync("w");
        await tab.Until("window.surefoot.pose.speed > 5", "the player runs");
        await page.Mouse.MoveAsync(450, 200);
        await page.Mouse.DownAsync(new() { Button = MouseButton.Right });
        await page.Mouse.MoveAsync(510, 200, new() { Steps = 4 });
        await page.Mouse.UpAsync(new() { Button = MouseButton.Right });
        await page.Keyboard.UpAsync("w");
        await page.Locator("#copy-walk").ClickAsync();
        await Assertions.Expect(page.Locator("#toasts")).ToContainTextAsync("It does without what the mouse did.");
    }

    [Fact]
    [Behaviour("workbench.page.closed-clipboard-shows-the-command", "design.md, Errors")]
    public async Task Where_the_clipboard_is_closed_the_command_is_shown_to_be_copied_by_hand()
    {
        await using Tab tab = await browser.OpenAsync();
        await tab.Page.EvaluateAsync(
            "() => { navigator.clipboard.writeText = () => Promise.reject(new DOMException('no', 'NotAllowedError')); }");
        await tab.Page.Keyboard.PressAsync("k");
        await tab.Until("window.surefoot.notice.includes('Copy this: surefoot walk --at 0xA9B5')", "the command is shown");
    }

    [Fact]
    [Behaviour("workbench.page.map-shows-the-way", "design.md, Who uses it")]
    public async Task The_map_shows_ground_houses_and_the_way_and_widens_with_it()
    {
        await using Tab tab = await browser.OpenAsync(
            "?at=At%20a%20house's%20door", new() { Width = 1280, Height = 720, Scale = 1 });
        await tab.Until("window.surefoot.shapes > 0 && window.surefoot.blocks > 8", "the land is drawn");
        ILocator map = tab.Page.Locator("#map-view");
        await Assertions.Expect(map).ToBeVisibleAsync();
        await Assertions.Expect(map).ToHaveAttributeAsync(
            "aria-label", "Map from above, north up, 48 metres across, with the way of the last walk: 0 metres");
        // The house stands north of its door, level ground lies in the south; the player is in the middle.
        await tab.Until($"{Reading(0.5, 0.3)}[0] > {Reading(0.5, 0.9)}[0] + 40", "the house is lighter than the meadow");
        await tab.Until($"{Reading(0.5, 0.9)}[1] > {Reading(0.5, 0.9)}[2] + 30", "the meadow is green");
        await tab.Until($"{Reading(0.5, 0.5)}.every((one) => one > 200)", "the player is white");

        await tab.Page.Keyboard.DownAsync("s");
        await tab.Until("window.surefoot.walk.metres > 8", "the player walks back");
        await tab.Page.Keyboard.UpAsync("s");
        await tab.Until($"{Row(0.42)}.some(([red, , blue]) => red > 200 && blue < 140)", "the way is drawn before who walks backwards");
        await Assertions.Expect(tab.Page.Locator("#map-way")).ToContainTextAsync(" m in ");

        await tab.GoTo("The runway");
        await tab.Until("window.surefoot.walk.metres === 0", "another place begins another walk");
        await tab.Page.Keyboard.PressAsync("r");
        await tab.Until("window.surefoot.walk.across > 48", "the map widens with the way");
        await tab.Page.Keyboard.PressAsync("r");
        Assert.Empty(tab.Complaints);
    }

    /// <summary>Colour of a point of the map, as shares of its width and height: red, green, blue.</summary>
    private static string Reading(double x, double y) => string.Create(
        CultureInfo.InvariantCulture,
        $$"""
        (() => {
          const map = document.getElementById("map-view");
          const { data } = map.getContext("2d").getImageData(Math.round(map.width * {{x}}), Math.round(map.height * {{y}}), 1, 1);
          return [...data.slice(0, 3)];
        })()
        """);

    /// <summary>Colours of the map along the middle of a row.</summary>
    private static string Row(double y) => $"[{string.Join(", ", Enumerable.Range(-4, 9).Select(i => Reading(0.5 + (i * 0.01), y)))}]";

    private static async Task Hold(IPage page, string key, int milliseconds)
    {
        await page.Keyboard.DownAsync(key);
        await Task.Delay(milliseconds);
        await page.Keyboard.UpAsync(key);
    }
}
