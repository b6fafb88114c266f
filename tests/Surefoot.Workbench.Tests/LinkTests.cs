using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The page's address as a link, and what the page does when its server goes.</summary>
[Collection(BrowserCollection.Name)]
public sealed class LinkTests(Browser browser)
{
    private const string Everything = "?run=800&jump=100&burden=3000&at=0xA9B5001D,84.5,97.25,20,90&on=triangles,shapes&off=mouse,panels";

    // spec/01, section 6: run skill 300 without burden.
    private const double RunSpeed = 10.6000004;

    [Fact]
    [Behaviour("workbench.page.link-carries-skills-place-and-toggles", "design.md, Who uses it")]
    public async Task A_link_opens_with_its_skills_place_and_toggles_and_a_reload_keeps_them()
    {
        await using Tab tab = await browser.OpenAsync(Everything);
        await AssertAsLinked(tab);
        await tab.Page.ReloadAsync();
        await tab.Until("window.surefoot?.ready === true", "the player is drawn again");
        await AssertAsLinked(tab);
        Assert.Equal("", (await tab.Read("window.surefoot.notice")).GetString());
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.address-follows-the-player", "design.md, Who uses it")]
    public async Task The_address_says_where_the_player_went_and_what_was_set_so_that_others_can_open_it()
    {
        await using Tab tab = await browser.OpenAsync();
        await tab.Page.Keyboard.PressAsync("t");
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until("window.surefoot.pose.position.y > 40", "the player runs north");
        await tab.Page.Keyboard.UpAsync("w");
        await tab.Until("window.surefoot.pose.speed < 0.01", "the player stands");
        await tab.Page.Locator("#run-skill").FillAsync("450");
        const string Address =
            "[new URLSearchParams(location.search).get('run'), new URLSearchParams(location.search).get('on'), " +
            "Number(new URLSearchParams(location.search).get('at')?.split(',')[2])]";
        await tab.Until(
            $"{Address}[0] === '450' && {Address}[1] === 'triangles' && Math.abs({Address}[2] - window.surefoot.pose.position.y) < 0.001",
            "the address says so");
        JsonElement here = await tab.Read("window.surefoot.pose.position");
        await using Tab other = await browser.OpenAsync(new Uri(tab.Page.Url).Query);
        JsonElement there = await other.Read("window.surefoot.pose.position");
        Assert.InRange(Distance(here, there), 0.96, 2.5);
        Assert.True((await other.Read("window.surefoot.triangles")).GetBoolean());
        Assert.Equal("450", await other.Page.Locator("#run-skill").InputValueAsync());
    }

    [Fact]
    [Behaviour("workbench.page.link-to-a-named-place", "design.md, Who uses it: jump to a named place")]
    public async Task A_link_may_name_a_place()
    {
        await using Tab tab = await browser.OpenAsync("?at=in%20the%20hall");
        Assert.Equal(0xA8B50100, await tab.Number("window.surefoot.pose.cell"));
        Assert.Contains("Walk through the doorways", await tab.Page.Locator("#toasts").InnerTextAsync(), StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("workbench.page.bad-link-opens-the-start", "design.md, Errors")]
    public async Task A_link_with_impossible_values_opens_the_start_and_one_line_says_what_was_ignored()
    {
        (string Query, string[] Said)[] links =
        [
            // What the page finds wrong; spot.test.ts and link.test.ts have all of that.
            ("?run=1001&jump=-1&burden=many&on=walls&colour=%3Cb%3Ered&at=0xA9B50032,NaN,2,3",
                ["run=1001", "jump=-1", "burden=many", "on=walls", "colour=<b>red", "at=0xA9B50032,NaN,2,3", "not a finite number"]),
            ("?at=Atlantis", ["at=Atlantis", "no place of this name"]),
            // What the server does; its refusals and their words are those of the box.
            ("?at=0xA9B50032,156,24,-500", ["at=0xA9B50032,156,24,-500", "under the ground"]),
        ];
        await using Tab tab = await browser.OpenAsync(links[0].Query);
        foreach ((string query, string[] said) in links)
        {
            if (query != links[0].Query) await tab.Load(query);
            await AssertIgnored(tab, said);
        }

        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.lost-server-covers-the-picture", "design.md, Errors")]
    public async Task A_server_that_stops_is_covered_and_one_that_is_back_finds_the_player_as_it_was()
    {
        WorkbenchServer first = await Worlds.StartAsync();
        await using Tab tab = await browser.OpenAsync(first, Everything);
        await first.DisposeAsync();
        await tab.Until("window.surefoot.covered === 'lost'", "the page says that the server is lost");
        ILocator cover = tab.Page.Locator("#cover");
        await Assertions.Expect(cover).ToBeVisibleAsync();
        await Assertions.Expect(cover).ToContainTextAsync("not answering");
        LocatorBoundingBoxResult box = (await cover.BoundingBoxAsync())!;
        Assert.Equal((0f, 0f, (float)Browser.Width, (float)Browser.Height), (box.X, box.Y, box.Width, box.Height));
        await FramesGoBy(tab, 2);
        double frozen = await tab.Number("window.surefoot.drawnAt");
        await FramesGoBy(tab, 5);
        Assert.Equal(frozen, await tab.Number("window.surefoot.drawnAt"));

        await using WorkbenchServer second = await WorkbenchServer.StartAsync(new WorkbenchOptions { Port = first.Address.Port });
        Assert.Equal(first.Address, second.Address);
        await tab.Until("window.surefoot.ready === true", "the cover goes");
        await Assertions.Expect(cover).ToBeHiddenAsync();
        await AssertAsLinked(tab);
    }

    [Fact]
    [Behaviour("workbench.page.silent-server-covers-the-picture", "design.md, Errors")]
    public async Task A_server_that_says_nothing_is_covered_until_it_speaks()
    {
        StandInWorld world = new();
        await using WorkbenchServer server = await WorkbenchServer.StartAsync(world, new WorkbenchOptions { Port = 0 });
        await using Tab tab = await browser.OpenAsync(server);
        world.Gate.Reset();
        await tab.Until("window.surefoot.covered === 'lost'", "the page says that the server is lost");
        world.Gate.Set();
        await tab.Until("window.surefoot.ready === true", "the cover goes");
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until($"window.surefoot.pose.speed > {Text(0.9 * RunSpeed)}", "the player obeys again");
    }

    /// <summary>The player is at the start with the usual skills, and one line, which can be put away, says why.</summary>
    private async Task AssertIgnored(Tab tab, string[] said)
    {
        await tab.Until("window.surefoot.notice !== ''", "a line says so");
        string line = (await tab.Read("window.surefoot.notice")).GetString()!;
        Assert.StartsWith("Ignored in the link: ", line, StringComparison.Ordinal);
        Assert.All(said, part => Assert.Contains(part, line, StringComparison.Ordinal));
        Assert.Equal(1, await tab.Page.Locator("#notice p").CountAsync());
        Assert.Equal(0, await tab.Page.Locator("#toasts p.refused").CountAsync());
        Vector3 start = browser.Server.Places[0].Position;
        double off = await tab.Number(
            $"Math.hypot(window.surefoot.pose.position.x - {Text(start.X)}, window.surefoot.pose.position.y - {Text(start.Y)})");
        Assert.InRange(off, 0, 2.5);
        Assert.Equal("300", await tab.Page.Locator("#run-skill").InputValueAsync());

        await tab.Page.Locator("#notice button").ClickAsync();
        Assert.False(await tab.Page.Locator("#notice").IsVisibleAsync());
    }

    private static async Task AssertAsLinked(Tab tab)
    {
        Assert.Contains("at=0xA9B5001D", tab.Page.Url, StringComparison.Ordinal);
        Assert.Equal(0xA9B5001D, await tab.Number("window.surefoot.pose.cell"));
        Assert.InRange(await tab.Number("Math.hypot(window.surefoot.pose.position.x - 84.5, window.surefoot.pose.position.y - 97.25)"), 0,
            0.01);
        Assert.Equal(90, await tab.Number("-window.surefoot.pose.yaw * 180 / Math.PI"), 0.001);
        Assert.Equal("800", await tab.Page.Locator("#run-skill").InputValueAsync());
        Assert.Equal("100", await tab.Page.Locator("#jump-skill").InputValueAsync());
        Assert.Equal("3000", await tab.Page.Locator("#burden").InputValueAsync());
        // spec/01, 4.1: run skill 800 runs at 4.5 times the walk's pace at most.
        await tab.Until("window.surefoot.pose.runRate === 4.5", "the server knows the skills");
        JsonElement shown = await tab.Read("[window.surefoot.triangles, window.surefoot.plainShapes, window.surefoot.mouseTurning]");
        Assert.Equal("[true,true,false]", shown.GetRawText());
        Assert.False(await tab.Page.Locator("#panel").IsVisibleAsync());
        Assert.Equal("true", await tab.Page.Locator("#toggle-shapes").GetAttributeAsync("aria-pressed"));
    }

    private static async Task FramesGoBy(Tab tab, int count)
    {
        double frames = await tab.Number("window.surefoot.frames");
        await tab.Until($"window.surefoot.frames > {Text(frames + count)}", "frames go by");
    }

    private static double Distance(JsonElement a, JsonElement b) =>
        Math.Sqrt(new[] { "x", "y", "z" }.Sum(axis => Math.Pow(a.GetProperty(axis).GetDouble() - b.GetProperty(axis).GetDouble(), 2)));

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
