using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The page where nothing can be drawn.</summary>
[Collection(BrowserCollection.Name)]
public sealed class NoPictureTests(Browser browser)
{
    [Fact]
    [Behaviour("workbench.page.without-webgl-explains", "design.md, Errors")]
    public async Task Without_WebGL_the_page_says_what_is_missing_what_helps_and_what_works_without()
    {
        await using IBrowser blind = await browser.LaunchAsync("--disable-3d-apis");
        IPage page = await blind.NewPageAsync();
        List<string> errors = [];
        page.PageError += (_, error) => errors.Add(error);
        await page.GotoAsync(browser.Server.Address.AbsoluteUri);
        ILocator explained = page.Locator("#no-webgl");
        await Assertions.Expect(explained).ToBeVisibleAsync();
        foreach (string part in new[] { "WebGL 2", "Chrome, Edge", "Firefox", "Safari", "remote desktop", "surefoot walk" })
            await Assertions.Expect(explained).ToContainTextAsync(part);
        foreach (string other in new[] { "#cover", "#hud", "#view" }) await Assertions.Expect(page.Locator(other)).ToBeHiddenAsync();
        await Assertions.Expect(explained.GetByRole(AriaRole.Button, new() { Name = "Try again" })).ToBeFocusedAsync();
        Assert.Empty(errors);
    }

    [Fact]
    [Behaviour("workbench.page.lost-picture-is-covered", "design.md, Errors")]
    public async Task A_graphics_card_that_goes_is_covered_until_it_is_back()
    {
        await using Tab tab = await browser.OpenAsync();
        const string Extension =
            "(window.taken ??= document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context'))";
        await tab.Page.EvaluateAsync($"() => {Extension}.loseContext()");
        await tab.Until("window.surefoot.covered === 'dark'", "the page says that the picture is lost");
        await Assertions.Expect(tab.Page.Locator("#cover")).ToContainTextAsync("The picture is lost");
        await tab.Page.EvaluateAsync($"() => {Extension}.restoreContext()");
        await tab.Until("window.surefoot.ready === true", "the cover goes");
        Assert.True(await tab.Number("window.surefoot.seen(true)") > 100);
    }
}
