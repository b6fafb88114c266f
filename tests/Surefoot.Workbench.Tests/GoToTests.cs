using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The box that takes a place.</summary>
[Collection(BrowserCollection.Name)]
public sealed class GoToTests(Browser browser)
{
    [Fact]
    [Behaviour("workbench.page.box-takes-cell-and-metres", "design.md, Who uses it")]
    public async Task The_box_takes_a_cell_and_metres_and_says_what_is_wrong_with_others()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        ILocator box = page.Locator("#goto-box");
        await page.Keyboard.PressAsync("g");
        await Assertions.Expect(box).ToBeFocusedAsync();
        Assert.Equal("", await box.InputValueAsync());
        await page.Keyboard.TypeAsync("0xA9B5001D, 84.5, 97.25, 20");
        await Assertions.Expect(page.GetByRole(AriaRole.Option)).ToContainTextAsync("Go to 0xA9B5001D, 84.5, 97.25, 20");
        await page.Keyboard.PressAsync("Enter");
        await tab.Until(
            "window.surefoot.pose.cell === 0xA9B5001D && " +
            "Math.hypot(window.surefoot.pose.position.x - 84.5, window.surefoot.pose.position.y - 97.25) < 0.01",
            "the player is there");
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());

        await page.Keyboard.PressAsync("g");
        await page.Keyboard.TypeAsync("0xA9B5FFFF, 1, 2, 3");
        await page.Keyboard.PressAsync("Enter");
        await Assertions.Expect(page.Locator("#goto-error")).ToContainTextAsync("cannot name a cell");
        await Assertions.Expect(box).ToBeFocusedAsync();
        await box.FillAsync("0x00010001, 1, 2, 3");
        await page.Keyboard.PressAsync("Enter");
        await Assertions.Expect(page.Locator("#toasts")).ToContainTextAsync("You cannot be there: this world has no such cell.");
        Assert.Equal(0xA9B5001D, await tab.Number("window.surefoot.pose.cell"));
    }

    [Fact]
    [Behaviour("workbench.page.box-searches-places", "design.md, Who uses it: jump to a named place")]
    public async Task The_box_searches_names_and_hints_with_the_keyboard_and_with_the_pointer()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        ILocator options = page.GetByRole(AriaRole.Option);
        await page.Locator("#goto-box").ClickAsync();
        await Assertions.Expect(options).ToHaveCountAsync((int)await tab.Number("window.surefoot.places.length"));
        await page.Keyboard.TypeAsync("lake");
        await Assertions.Expect(options.First).ToContainTextAsync("The lake shore");
        await Assertions.Expect(options.First).ToHaveAttributeAsync("aria-selected", "true");
        await page.Keyboard.PressAsync("ArrowDown");
        await Assertions.Expect(options.Nth(1)).ToHaveAttributeAsync("aria-selected", "true");
        Assert.Equal(await options.Nth(1).GetAttributeAsync("id"),
            await page.Locator("#goto-box").GetAttributeAsync("aria-activedescendant"));
        await page.Keyboard.PressAsync("ArrowUp");
        await page.Keyboard.PressAsync("Enter");
        await tab.Until(
            "window.surefoot.pose.cell === window.surefoot.places.find((one) => one.name === 'The lake shore').cell",
            "the player is at the lake");
        await Assertions.Expect(page.Locator("#toasts")).ToContainTextAsync("Wade in");

        await page.Keyboard.PressAsync("g");
        await page.Keyboard.TypeAsync("guard");
        await options.Filter(new() { HasText = "Two guards" }).ClickAsync();
        await tab.Until(
            "window.surefoot.pose.cell === window.surefoot.places.find((one) => one.name === 'Two guards').cell",
            "the player is with the guards");
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());

        await page.Keyboard.PressAsync("g");
        await page.Keyboard.TypeAsync("attic");
        await Assertions.Expect(options).ToHaveCountAsync(0);
        await page.Keyboard.PressAsync("Enter");
        await Assertions.Expect(page.Locator("#goto-error")).ToContainTextAsync("no place of this name");
    }
}
