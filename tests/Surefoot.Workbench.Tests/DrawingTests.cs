using System.Globalization;
using System.Text.Json;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>What is seen of the world, in small pictures of the page's own view.</summary>
[Collection(BrowserCollection.Name)]
public sealed class DrawingTests(Browser browser)
{
    private const int Width = 96, Height = 54;

    private const string Renderer =
        "(() => { const gl = document.createElement('canvas').getContext('webgl2');" +
        " return gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL).match('SwiftShader')[0]; })()";

    [Fact]
    [Behaviour("workbench.page.drawn-in-software-begins-plain", "design.md, Who uses it")]
    public async Task Where_the_processor_draws_the_page_begins_without_what_costs_most()
    {
        await using Tab tab = await browser.OpenAsync(options: new() { Scale = 1 });
        Assert.Equal("SwiftShader", (await tab.Read(Renderer)).GetString());
        Assert.True((await tab.Read("document.body.classList.contains('plain')")).GetBoolean(), "no frosted glass");
        Assert.Equal((Browser.Width / 2) + 0.0, await tab.Number("document.getElementById('view').width"));
    }

    [Fact]
    [Behaviour("workbench.page.dungeon-shows-no-land", "design.md, Who uses it")]
    public async Task In_the_dungeon_neither_sky_nor_sea_nor_sun_is_seen_and_outside_they_are()
    {
        await using Tab tab = await browser.OpenAsync("?off=panels");
        Assert.True((await Picture(tab)).Count(IsBlue) > 200, "the sky over the meadow is blue");
        await tab.GoTo("The dungeon");
        await tab.Until("window.surefoot.dark === 1 && window.surefoot.shapes > 0", "it is dark");
        foreach (int turn in new[] { 0, 1, 2 })
        {
            Pixel[] picture = await Picture(tab);
            Assert.DoesNotContain(picture, IsBlue);
            Assert.True(picture.Count(pixel => pixel.Light > 30) > Width * Height / 4, $"turn {turn}: the lantern shows the room");
            await tab.Page.Mouse.MoveAsync(200, 300);
            await tab.Page.Mouse.DownAsync();
            await tab.Page.Mouse.MoveAsync(500, 300, new() { Steps = 3 });
            await tab.Page.Mouse.UpAsync();
        }

        await tab.GoTo("The lake shore");
        await tab.Until("window.surefoot.dark === 0", "it is light again");
        Assert.True((await Picture(tab)).Count(IsBlue) > 200, "sky and lake are blue");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.doorway-reads-as-an-opening", "design.md, Who uses it")]
    public async Task An_open_doorway_is_darker_than_the_wall_around_it()
    {
        await using Tab tab = await browser.OpenAsync("?off=panels&at=At%20a%20house's%20door");
        await tab.Until("window.surefoot.shapes > 0", "the house is drawn");
        Pixel[] picture = await Picture(tab);
        // The doorway is straight ahead, over the player's head; the wall begins a man's width beside it.
        double doorway = Mean(picture, 0.48, 0.52, 0.39, 0.44), left = Mean(picture, 0.33, 0.43, 0.39, 0.44),
            right = Mean(picture, 0.57, 0.67, 0.39, 0.44);
        Assert.True(doorway < 0.55 * left && doorway < 0.55 * right, $"doorway {doorway:F0}, walls {left:F0} and {right:F0}");
    }

    [Theory]
    [Behaviour("workbench.page.rooms-have-patterns", "design.md, Who uses it")]
    [InlineData("In the hall")]
    [InlineData("The hall of pillars")]
    public async Task Floors_and_walls_have_patterns_by_which_a_room_is_read(string place)
    {
        await using Tab tab = await browser.OpenAsync($"?off=panels&at={Uri.EscapeDataString(place)}");
        await tab.Until("window.surefoot.shapes > 0", "the room is drawn");
        int left = 0, right = 0, floor = 0;
        // Shapes are counted when they have come; the room's own may be drawn a moment later.
        for (int look = 0; look < 20 && !(left > 6 && right > 6 && floor > 4); look++)
        {
            if (look > 0) await Task.Delay(500, TestContext.Current.CancellationToken);
            JsonElement rows =
                await tab.Read("window.surefoot.picture(480, 270).map((row) => row.map(([red, green, blue]) => red + green + blue))");
            (left, right) = (Edges(Column(rows, 60)), Edges(Column(rows, 420)));
            floor = Edges([.. rows[255].EnumerateArray().Select(one => one.GetInt32())]);
        }

        Assert.True(left > 6, $"joints along a column of wall and floor at the left: {left}");
        Assert.True(right > 6, $"and at the right: {right}");
        Assert.True(floor > 4, $"joints along a row of the floor: {floor}");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.slope-is-seen-from-its-side", "design.md, Who uses it: slopes")]
    public async Task A_slope_is_looked_at_from_its_side_at_first_and_other_places_from_behind()
    {
        await using Tab tab = await browser.OpenAsync("?off=panels");
        double zoom = await tab.Number("window.surefoot.camera.zoom");
        await tab.GoTo("A slope of 45 degrees");
        await tab.Until("Math.abs(window.surefoot.camera.orbit - 1.22) < 0.01 && window.surefoot.camera.away > 12",
            "the camera is beside the player");
        await tab.Until("window.surefoot.blocks > 20", "the land around is drawn");
        Pixel[] picture = await Picture(tab);
        int left = picture.Where((_, i) => i % Width < Width / 4).Count(IsBlue),
            right = picture.Where((_, i) => i % Width >= Width * 3 / 4).Count(IsBlue);
        Assert.True(left > 100 && right < left / 2,
            $"the sky shows over the level ground at the left ({left}), the slope rises at the right ({right})");
        double yaw = await tab.Number("window.surefoot.pose.yaw");
        Assert.Equal(0, yaw, 0.001);
        await tab.GoTo("The meadow");
        await tab.Until(
            $"window.surefoot.camera.orbit === 0 && window.surefoot.camera.zoom === {zoom.ToString(CultureInfo.InvariantCulture)}",
            "the camera is behind the player again");
    }

    /// <summary>Sky, lake and sea.</summary>
    private static bool IsBlue(Pixel pixel) => pixel.Blue > pixel.Red + 20;

    private static async Task<Pixel[]> Picture(Tab tab)
    {
        JsonElement rows = await tab.Read($"window.surefoot.picture({Width}, {Height})");
        return [
            .. rows.EnumerateArray()
                .SelectMany(row => row.EnumerateArray().Select(one => new Pixel(one[0].GetInt32(), one[1].GetInt32(), one[2].GetInt32())))];
    }

    private static double Mean(Pixel[] picture, double fromX, double toX, double fromY, double toY) =>
        picture.Where(
            (_, i) =>
                i % Width >= fromX * Width && i % Width < toX * Width && i / Width >= fromY * Height &&
                    i / Width < toY * Height).Average(pixel =>
                    pixel.Light);

    private static int[] Column(JsonElement rows, int x) => [.. rows.EnumerateArray().Select(row => row[x].GetInt32())];

    /// <summary>How often the light jumps from one pixel to the next but one.</summary>
    private static int Edges(int[] light) => Enumerable.Range(2, light.Length - 2).Count(i => Math.Abs(light[i] - light[i - 2]) > 12);

    private readonly record struct Pixel(int Red, int Green, int Blue)
    {
        public double Light => (Red + Green + Blue) / 3.0;
    }
}
