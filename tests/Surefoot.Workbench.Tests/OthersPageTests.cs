using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>
/// Others on the page: heard of over a network whose sliders make it bad, with ghosts at their true places, and at one's wish.
/// </summary>
[Collection(BrowserCollection.Name)]
public sealed class OthersPageTests(Browser browser)
{
    /// <summary>How far creatures are drawn from where they are in truth, metres; those that have a ghost.</summary>
    private static readonly string Apart =
        $$"""
        (window.surefoot.ghosts.flatMap(({ body, position }) => {
          const seen = window.surefoot.bodies.find((one) => one.body === body && one.type === {{(int)BodyKind.Wanderer}});
          if (!seen || !position) return [];
          const x = (seen.cell >>> 24) * 192 + seen.position.x, y = ((seen.cell >>> 16) & 255) * 192 + seen.position.y;
          return [Math.hypot(position.x - x, position.y - y)];
        }))
        """;

    [Fact]
    [Behaviour("workbench.page.network-sliders-and-true-places", "design.md, Who uses it")]
    public async Task Creatures_lag_behind_their_ghosts_as_the_sliders_say_and_the_address_keeps_it()
    {
        await using Tab tab = await browser.OpenAsync("?at=Creatures%20at%20pasture&net=0,0,10");
        Assert.Equal("10 %", await tab.Page.Locator("output[for=net-loss]").InnerTextAsync());
        Assert.Equal(0, await tab.Number("window.surefoot.ghosts.length"));
        await tab.Page.Keyboard.PressAsync("b");
        await tab.Until($"{Apart}.length === 6", "each creature has a ghost");
        await tab.Page.Locator("#net-delay").FillAsync("1000");
        await tab.Page.Locator("#net-loss").FillAsync("0");
        await tab.Until($"Math.max(...{Apart}) > 0.8", "who walks is seen where it was a second ago");
        await tab.Until("location.search.includes('net=1000,0,0&on=truth')", "the address says so");
        await tab.Page.ReloadAsync();
        await tab.Until("window.surefoot?.ready === true", "the player is drawn again");
        Assert.Equal("1000 ms", await tab.Page.Locator("output[for=net-delay]").InnerTextAsync());
        await tab.Until($"{Apart}.length === 6 && Math.max(...{Apart}) > 0.8", "ghosts and delay are as they were");
        await tab.Page.Locator("#net-delay").FillAsync("0");
        await tab.Until($"{Apart}.length === 6 && Math.max(...{Apart}) < 0.3", "without delay they are seen where they are");
        // With no delay to vary about, every other message is up to a second late.
        await tab.Page.Locator("#net-jitter").FillAsync("1000");
        Assert.Equal("± 1000 ms", await tab.Page.Locator("output[for=net-jitter]").InnerTextAsync());
        await tab.Until("location.search.includes('net=0,1000,0')", "the address says so");
        await tab.Until($"Math.max(...{Apart}) > 0.4", "who walks is seen late now and then");
        await tab.Page.Locator("#toggle-truth").ClickAsync();
        await tab.Until("window.surefoot.ghosts.length === 0", "the ghosts are gone");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.page.creatures-do-as-they-are-asked", "design.md, Who uses it")]
    public async Task A_creature_that_is_clicked_follows_flees_or_stands()
    {
        await using Tab tab = await browser.OpenAsync("?at=Creatures%20at%20pasture");
        IPage page = tab.Page;
        string creatures = $"window.surefoot.bodies.filter((one) => one.type === {(int)BodyKind.Wanderer})";
        await tab.Until($"{creatures}.length === 6", "the creatures are near");
        ILocator card = page.Locator("#creature");
        Assert.False(await card.IsVisibleAsync());
        for (int attempt = 0; attempt < 100 && !await card.IsVisibleAsync(); attempt++)
        {
            // Where no card lies. One that walks may come there, and may have left the point by the time of the click.
            await Task.Delay(200);
            JsonElement at = await tab.Read(
                $"{creatures}.map((one) => window.surefoot.onScreen(one.body))" +
                ".find((one) => one && one.x > 0.42 && one.x < 0.66 && one.y > 0.2 && one.y < 0.9)");
            if (at.ValueKind != JsonValueKind.Object) continue;
            await page.Mouse.ClickAsync(
                (float)(at.GetProperty("x").GetDouble() * Browser.Width), (float)(at.GetProperty("y").GetDouble() * Browser.Height));
        }

        await Assertions.Expect(card).ToContainTextAsync("creature-");
        uint chosen = (uint)await tab.Number("window.surefoot.creature");
        await card.GetByRole(AriaRole.Button, new() { Name = "Follow me" }).ClickAsync();
        Assert.False(await card.IsVisibleAsync());
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());
        string Away() =>
            $"(() => {{ const one = window.surefoot.bodies.find((one) => one.body === {chosen}).position;" +
            " const me = window.surefoot.pose.position; return Math.hypot(one.x - me.x, one.y - me.y); })()";
        await tab.Until($"{Away()} < 2.8", "it comes");

        // The keyboard alone chooses the nearest, which is the one that came. While it stands, nobody is followed.
        await page.Keyboard.PressAsync("x");
        Assert.Equal(chosen, await tab.Number("window.surefoot.creature"));
        await card.GetByRole(AriaRole.Button, new() { Name = "Stand", Exact = true }).ClickAsync();
        string place = $"(({{ x, y }}) => [x, y])(window.surefoot.bodies.find((one) => one.body === {chosen}).position)";
        await tab.Until($"window.surefoot.bodies.find((one) => one.body === {chosen}).velocity.x === 0", "it stands");
        JsonElement stood = await tab.Read(place);
        await page.Keyboard.DownAsync("s");
        await tab.Until($"{Away()} > 5", "the player goes away from it");
        await page.Keyboard.UpAsync("s");
        Assert.Equal(stood.ToString(), (await tab.Read(place)).ToString());
        await page.Keyboard.DownAsync("w");
        await tab.Until($"{Away()} < 2.5", "the player comes back");
        await page.Keyboard.UpAsync("w");

        // Another may have come nearer meanwhile.
        await page.Keyboard.PressAsync("x");
        chosen = (uint)await tab.Number("window.surefoot.creature");
        await Assertions.Expect(card.GetByRole(AriaRole.Button, new() { Name = "Follow me" })).ToBeFocusedAsync();
        await page.Keyboard.PressAsync("Tab");
        await page.Keyboard.PressAsync("Enter");
        await tab.Until($"{Away()} > 10", "it flees");
        // One of the others may walk just there at first, and is chosen then.
        for (int attempt = 0; attempt == 0 || (attempt < 20 && await card.IsVisibleAsync()); attempt++)
        {
            await Task.Delay(300, TestContext.Current.CancellationToken);
            await page.Mouse.ClickAsync(20, Browser.Height / 2);
        }

        Assert.False(await card.IsVisibleAsync(), "a click beside all creatures chooses none");
        Assert.Empty(tab.Complaints);
    }
}
