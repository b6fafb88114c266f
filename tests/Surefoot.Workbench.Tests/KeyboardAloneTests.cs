using System.Globalization;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The page with the keyboard alone, with a screen reader, and for eyes that see little or are easily made ill.</summary>
[Collection(BrowserCollection.Name)]
public sealed class KeyboardAloneTests(Browser browser)
{
    [Fact]
    [Behaviour("workbench.page.focused-control-keeps-its-keys", "design.md, Who uses it")]
    public async Task A_focused_slider_takes_the_arrows_and_the_player_stands_until_the_game_has_the_keyboard_again()
    {
        await using Tab tab = await browser.OpenAsync();
        IPage page = tab.Page;
        double yaw = await tab.Number("window.surefoot.pose.yaw");
        await TabTo(page, "run-skill");
        await Press(page, "ArrowRight", "301");
        await Press(page, "ArrowUp", "302");
        await Press(page, "ArrowLeft", "301");
        await Press(page, "Home", "0");
        await Press(page, "End", "1000");
        await page.Keyboard.PressAsync("PageDown");
        Assert.InRange(int.Parse(await Value(page), CultureInfo.InvariantCulture), 500, 990);
        await page.Keyboard.PressAsync("PageUp");
        Assert.Equal("1000", await Value(page));
        await tab.Until("window.surefoot.pose.runRate === 4.5", "the server knows the skill");
        foreach (string key in new[] { "w", "d", "Space", "r", "t" }) await page.Keyboard.PressAsync(key, new() { Delay = 60 });
        double tick = await tab.Number("window.surefoot.pose.tick");
        await tab.Until($"window.surefoot.pose.tick > {tick + 5}", "ticks go by");
        Assert.Equal(0, await tab.Number("window.surefoot.pose.speed"));
        Assert.Equal(yaw, await tab.Number("window.surefoot.pose.yaw"), 1e-6);
        Assert.Equal(0, await tab.Number("window.surefoot.events.filter((one) => one.event === 1).length"));
        Assert.Equal("run-skill", await Focused(page));
        Assert.False((await tab.Read("window.surefoot.triangles")).GetBoolean());

        ILocator back = page.Locator("#back");
        await Assertions.Expect(back).ToBeVisibleAsync();
        await page.Keyboard.PressAsync("Escape");
        await Assertions.Expect(back).ToBeHiddenAsync();
        await page.Keyboard.DownAsync("ArrowUp");
        await tab.Until("window.surefoot.pose.speed > 10", "the arrow moves the player");
        Assert.Equal("1000", await page.Locator("#run-skill").InputValueAsync());
    }

    [Fact]
    [Behaviour("workbench.page.button-keeps-the-focus", "design.md, Who uses it")]
    public async Task Space_presses_a_focused_button_which_keeps_the_focus_and_a_click_on_the_world_plays_on()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        await TabTo(page, "toggle-shapes");
        await page.Keyboard.PressAsync("Space");
        await tab.Until("window.surefoot.plainShapes", "Space presses the button");
        await page.Keyboard.PressAsync("Enter");
        await tab.Until("!window.surefoot.plainShapes", "Enter does, too");
        Assert.Equal("toggle-shapes", await Focused(page));
        Assert.Equal(0, await tab.Number("window.surefoot.bar"));
        await page.Locator("#toggle-triangles").ClickAsync();
        Assert.Equal("toggle-triangles", await Focused(page));
        await page.Mouse.ClickAsync(400, 300);
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());
        await page.Locator("#toggle-triangles").FocusAsync();
        await page.Locator("#back").ClickAsync();
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());
    }

    [Fact]
    [Behaviour("workbench.page.tab-comes-to-the-way-back", "WCAG 2.2, 2.1.1 and 2.4.3")]
    public async Task Tab_comes_from_the_last_control_to_the_way_back_to_the_game_which_Enter_takes()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        await page.Locator("#toggle-truth").FocusAsync();
        await page.Keyboard.PressAsync("Tab");
        Assert.Equal("back", await Focused(page));
        Assert.True(await page.Locator("#back").IsVisibleAsync());
        await page.Keyboard.PressAsync("Shift+Tab");
        Assert.Equal("toggle-truth", await Focused(page));
        await page.Keyboard.PressAsync("Tab");
        await page.Keyboard.PressAsync("Enter");
        Assert.True((await tab.Read("window.surefoot.playing")).GetBoolean());
        Assert.True(await page.Locator("#back").IsHiddenAsync());
    }

    [Fact]
    [Behaviour("workbench.page.keys-are-let-go-when-a-control-takes-the-keyboard", "design.md, Who uses it")]
    public async Task A_key_that_is_down_when_a_control_takes_the_keyboard_counts_as_let_go()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until("window.surefoot.pose.speed > 3", "the player runs");
        await tab.Page.Keyboard.PressAsync("Tab");
        await tab.Until("window.surefoot.pose.speed < 0.01", "the player stands");
        Assert.False((await tab.Read("window.surefoot.playing")).GetBoolean());
    }

    [Fact]
    [Behaviour("workbench.page.every-control-by-keyboard", "design.md, Who uses it")]
    public async Task Tab_reaches_every_control_each_with_a_name_a_role_and_a_focus_that_shows()
    {
        await using Tab tab = await browser.OpenAsync("?run=-1");
        IPage page = tab.Page;
        await tab.Until("window.surefoot.notice !== ''", "the page shows a line that can be put away");
        string[] controls = [.. (await tab.Read(
            "[...document.querySelectorAll('button, input, select, summary, [tabindex]')]" +
            ".filter((one) => one.checkVisibility() && one.tabIndex >= 0).map((one) => one.id || one.parentElement.id)"))
            .EnumerateArray().Select(one => one.GetString()!)];
        Assert.Contains("world", controls);
        Assert.Contains("goto-box", controls);
        Assert.Contains("notice", controls);
        HashSet<string> reached = [];
        for (int i = 0; i < controls.Length + 3; i++)
        {
            await page.Keyboard.PressAsync("Tab");
            JsonElement one = await tab.Read(
                """
                (() => {
                  const one = document.activeElement;
                  const style = getComputedStyle(one);
                  return { id: one.id || one.parentElement?.id, outline: style.outlineStyle, width: parseFloat(style.outlineWidth) };
                })()
                """);
            string id = one.GetProperty("id").GetString()!;
            if (id is "" or "world") continue;
            reached.Add(id);
            Assert.True(one.GetProperty("outline").GetString() == "solid" && one.GetProperty("width").GetDouble() >= 2,
                $"{id} shows no focus");
        }

        Assert.Empty(controls.Where(id => id != "world").Except(reached));
        string tree = await page.Locator("body").AriaSnapshotAsync();
        foreach (string expected in new[]
        {
            "- application \"The world, seen from behind your player\"", "- combobox \"Go to\"", "- group \"What is shown\"",
            "- button \"Mouse turning\" [pressed]",
            "- button \"Physics\" [expanded]", "- button \"Copy as surefoot walk\"", "img \"Map from above",
            "- slider \"Run skill\"", "- slider \"Jump skill\"", "- slider \"Burden\"", "- slider \"Delay\"", "- slider \"Jitter\"",
            "- slider \"Loss\"", "- button \"True places\"",
            "- button \"Put this line away\"", "- heading \"Surefoot\"",
        })
            Assert.Contains(expected, tree, StringComparison.Ordinal);
        Assert.DoesNotContain("- button\n", tree, StringComparison.Ordinal);
        Assert.Contains("percent", await page.Locator("#burden").GetAttributeAsync("aria-valuetext"), StringComparison.Ordinal);
    }

    [Fact]
    [Behaviour("workbench.page.help-takes-and-gives-back-the-keyboard", "design.md, Who uses it")]
    public async Task The_help_takes_the_keyboard_and_gives_it_back_where_it_was()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        await page.Keyboard.PressAsync("h");
        ILocator help = page.GetByRole(AriaRole.Dialog, new() { Name = "Keys" });
        await Assertions.Expect(help).ToBeVisibleAsync();
        await Assertions.Expect(help.GetByRole(AriaRole.Button)).ToBeFocusedAsync();
        await page.Keyboard.PressAsync("Escape");
        await Assertions.Expect(help).ToBeHiddenAsync();
        Assert.Equal("world", await Focused(page));
        await page.Locator("#toggle-help").FocusAsync();
        await page.Keyboard.PressAsync("Enter");
        await page.Keyboard.PressAsync("Enter");
        await Assertions.Expect(help).ToBeHiddenAsync();
        Assert.Equal("toggle-help", await Focused(page));
    }

    [Fact]
    [Behaviour("workbench.page.text-contrast", "WCAG 2.2, 1.4.3: at least 4.5 to 1")]
    public async Task All_text_stands_out_from_its_ground_over_any_picture()
    {
        await using Tab tab = await browser.OpenAsync("?run=-1&on=triangles");
        IPage page = tab.Page;
        await tab.Until("window.surefoot.notice !== ''", "the page shows a line that can be put away");
        await page.EvaluateAsync(Contrast);
        await AssertContrast(tab, "as it opens");
        await tab.GoTo("In the hall");
        await page.Keyboard.DownAsync("Space");
        await tab.Until("window.surefoot.bar > 0.2", "the bar fills");
        await AssertContrast(tab, "with hint and bar");
        await page.Keyboard.UpAsync("Space");
        await page.Locator("#goto-box").FillAsync("door");
        await AssertContrast(tab, "with the list of places and the way back");
        await page.Locator("#goto-box").FillAsync("no such place");
        await page.Keyboard.PressAsync("Enter");
        await AssertContrast(tab, "with an error");
        await page.Keyboard.PressAsync("Escape");
        await page.Keyboard.PressAsync("Escape");
        await page.Keyboard.PressAsync("h");
        await AssertContrast(tab, "with the help");
        await page.EvaluateAsync("() => { document.getElementById('cover').classList.remove('away'); }");
        foreach (string state in new[] { "connecting", "lost", "dark" })
        {
            await page.EvaluateAsync("(state) => { document.getElementById('cover').dataset.state = state; }", state);
            await AssertContrast(tab, $"covered, {state}");
        }

        await page.EvaluateAsync("() => { document.getElementById('no-webgl').hidden = false; document.body.classList.add('touch'); }");
        await AssertContrast(tab, "without a picture");
    }

    [Fact]
    [Behaviour("workbench.page.reduced-motion", "CSS Media Queries 5, 12.1")]
    public async Task Who_asks_for_less_motion_gets_no_sway_no_glide_and_no_animation()
    {
        await using Tab moving = await browser.BorrowAsync();
        Assert.True(await moving.Number("window.surefoot.breeze") > 0);
        await using Tab calm = await browser.OpenAsync(options: new() { Motion = ReducedMotion.Reduce });
        Assert.Equal(0, await calm.Number("window.surefoot.breeze"));
        await calm.GoTo("The lake shore");
        Assert.Equal("none", (await calm.Read("getComputedStyle(document.querySelector('#toasts p')).animationName")).GetString());
        Assert.Equal("0s", (await calm.Read("getComputedStyle(document.getElementById('cover')).transitionDuration")).GetString());
        await calm.Page.Mouse.MoveAsync(450, 200);
        await calm.Page.Mouse.DownAsync();
        await calm.Page.Mouse.MoveAsync(570, 200);
        await calm.Page.Mouse.UpAsync();
        await calm.Until("Math.abs(window.surefoot.camera.orbit) > 0.3", "dragging looks around");
        double frames = await calm.Number("window.surefoot.frames");
        await calm.Page.Keyboard.PressAsync("c");
        await calm.Until($"window.surefoot.frames > {frames + 1}", "a frame goes by");
        Assert.Equal(0, await calm.Number("window.surefoot.camera.orbit"));
    }

    private static async Task TabTo(IPage page, string id)
    {
        for (int i = 0; i < 40 && await Focused(page) != id; i++) await page.Keyboard.PressAsync("Tab");
        Assert.Equal(id, await Focused(page));
    }

    private static Task<string> Focused(IPage page) => page.EvaluateAsync<string>("() => document.activeElement?.id ?? ''");

    private static Task<string> Value(IPage page) => page.Locator("#run-skill").InputValueAsync();

    private static async Task Press(IPage page, string key, string value)
    {
        await page.Keyboard.PressAsync(key);
        Assert.Equal(value, await Value(page));
    }

    private static async Task AssertContrast(Tab tab, string when)
    {
        JsonElement seen = await tab.Read("window.contrasts()");
        Assert.True(seen.GetArrayLength() > 5, $"{when}: there is text");
        foreach (JsonElement one in seen.EnumerateArray())
            Assert.True(one.GetProperty("ratio").GetDouble() >= 4.5,
                $"{when}: {one.GetProperty("text")} has a contrast of {one.GetProperty("ratio")}");
    }

    /// <summary>
    /// The least contrast of each piece of text that shows, over a white, a grey and a black picture: its colour against all grounds behind
    /// it, as the browser would lay them over each other. A gradient counts with each of its colours.
    /// </summary>
    private const string Contrast =
        """
        () => {
          const brush = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
          const rgba = (color) => {
            brush.clearRect(0, 0, 1, 1);
            brush.fillStyle = color;
            brush.fillRect(0, 0, 1, 1);
            const [r, g, b, a] = brush.getImageData(0, 0, 1, 1).data;
            return [r, g, b, a / 255];
          };
          const over = ([r, g, b, a], ground) => [r, g, b].map((one, i) => one * a + ground[i] * (1 - a));
          const light = (color) => {
            const [r, g, b] = color.map((one) => (one / 255 <= 0.04045 ? one / 255 / 12.92 : ((one / 255 + 0.055) / 1.055) ** 2.4));
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
          };
          const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
          const grounds = (element) => {
            let all = [[255, 255, 255], [128, 128, 128], [0, 0, 0]];
            const chain = [];
            for (let one = element; one && one !== document.body; one = one.parentElement) chain.unshift(getComputedStyle(one));
            for (const { backgroundColor, backgroundImage } of chain) {
              all = all.map((ground) => over(rgba(backgroundColor), ground));
              const stops = backgroundImage.match(/rgba?\([^)]*\)/g) ?? [];
              if (stops.length > 0) all = stops.flatMap((stop) => all.map((ground) => over(rgba(stop), ground)));
            }
            return all;
          };
          window.contrasts = () => {
            const found = [];
            const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
            const measure = (element, text, color) => {
              const least = Math.min(...grounds(element).map((ground) => ratio(over(rgba(color), ground), ground)));
              found.push({ text: text.slice(0, 40), ratio: least });
            };
            while (walk.nextNode()) {
              const { parentElement: element, data } = walk.currentNode;
              const visible = element.checkVisibility({ checkOpacity: false, checkVisibilityCSS: true });
              if (data.trim() === "" || !visible || element.closest(".unseen, script")) continue;
              measure(element, data.trim(), getComputedStyle(element).color);
            }
            for (const box of document.querySelectorAll("input[placeholder]"))
              measure(box, box.placeholder, getComputedStyle(box, "::placeholder").color);
            return found;
          };
        }
        """;
}
