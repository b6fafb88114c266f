using System.Globalization;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>The page on small and enlarged windows, and under fingers.</summary>
[Collection(BrowserCollection.Name)]
public sealed class LayoutTests(Browser browser)
{
    // spec/01, section 6: run skill 300 without burden; the walk's own pace.
    private const double RunSpeed = 10.6000004, WalkSpeed = 3.12;

    /// <summary>Windows, and what is left of them at 200 %: CSS pixels are twice as large then.</summary>
    private static readonly (string Name, int Width, int Height)[] Desks =
    [
        ("a desk", 1280, 720), ("the same at 200 %", 640, 360), ("half a screen", 960, 1080), ("half a screen at 200 %", 480, 540),
        ("a small old window", 800, 450),
    ];

    private static readonly (string Name, int Width, int Height)[] Telephones =
    [
        ("a telephone", 360, 640), ("the smallest telephone", 320, 568), ("a telephone on its side", 640, 320),
    ];

    [Theory]
    [Behaviour("workbench.page.fits-any-window", "WCAG 2.2, 1.4.4 and 1.4.10")]
    [InlineData(false)]
    [InlineData(true)]
    public async Task Nothing_is_cut_or_hidden_in_any_window(bool touch)
    {
        await using Tab tab = await browser.OpenAsync("?on=triangles", new() { Width = 1280, Height = 720, Scale = 0.5f, Touch = touch });
        // A closed clipboard has the page show a line, as often as it is asked to copy.
        await tab.Page.EvaluateAsync("() => { navigator.clipboard.writeText = () => Promise.reject(new DOMException('no')); }");
        foreach ((string window, int width, int height) in touch ? Telephones : Desks)
        {
            // From a large window a small one finds the cards folded, as it does when the page is opened in it.
            await tab.Page.SetViewportSizeAsync(1280, 720);
            await tab.Page.SetViewportSizeAsync(width, height);
            await tab.Until($"innerWidth === {width} && innerHeight === {height}", "the window has its size");
            double frames = await tab.Number("window.surefoot.frames");
            await tab.Until($"window.surefoot.frames > {Text(frames + 2)}", "the page has seen it");
            await AssertNothingIsCut(tab, window, width, height);
        }
    }

    private static async Task AssertNothingIsCut(Tab tab, string window, int width, int height)
    {
        IPage page = tab.Page;
        await page.Keyboard.PressAsync("k");
        await tab.Until("window.surefoot.notice !== ''", "the page shows a line that can be put away");
        await AssertFits(tab, $"{window}, at first");
        if (await page.Locator("#menu").IsVisibleAsync())
        {
            await page.Locator("#menu").ClickAsync();
            await AssertFits(tab, $"{window}, with the menu");
            await page.Locator("#menu").ClickAsync();
        }

        // A line takes room until it is put away.
        await page.Locator("#notice button").ClickAsync();
        foreach (string title in new[] { "panel-title", "sliders-title", "map-title" })
        {
            ILocator button = page.Locator($"#{title}");
            if (await button.GetAttributeAsync("aria-expanded") == "false") await button.ClickAsync();
            await AssertFits(tab, $"{window}, {title} open");
            await AssertReachable(tab, await button.EvaluateAsync<string>("(one) => one.getAttribute('aria-controls')"), window);
        }

        await page.Keyboard.PressAsync("Escape");
        await page.Keyboard.PressAsync("h");
        JsonElement help = await tab.Read("document.getElementById('help').getBoundingClientRect()");
        Assert.True(
            help.GetProperty("left").GetDouble() >= 0 && help.GetProperty("top").GetDouble() >= 0 &&
            help.GetProperty("right").GetDouble() <= width
                && help.GetProperty("bottom").GetDouble() <= height,
            $"{window}: the help fits");
        await page.EvaluateAsync("() => { document.querySelector('#help .body').id = 'help-body'; }");
        await AssertReachable(tab, "help-body", window);
        await page.Keyboard.PressAsync("Escape");
        foreach (ILocator open in await page.Locator(".compact .fold [aria-expanded=true]").AllAsync()) await open.ClickAsync();
        await page.Keyboard.PressAsync("Escape");
    }

    [Fact]
    [Behaviour("workbench.page.touch-plays", "design.md, Who uses it")]
    public async Task Fingers_move_walk_jump_and_look()
    {
        await using Tab tab = await browser.OpenAsync(
            options: new() { Width = 640, Height = 360, Touch = true });
        LocatorBoundingBoxResult pad = (await tab.Page.Locator("#pad").BoundingBoxAsync())!,
            jump = (await tab.Page.Locator("#jump").BoundingBoxAsync())!;
        (double x, double y) = (pad.X + (pad.Width / 2), pad.Y + (pad.Height / 2));
        double radius = pad.Width / 2;
        ICDPSession fingers = await tab.Page.Context.NewCDPSessionAsync(tab.Page);

        await Touch(fingers, "touchStart", (x, y));
        await Touch(fingers, "touchMove", (x, y - radius));
        await tab.Until($"window.surefoot.pose.speed > {Text(0.95 * RunSpeed)}", "at the rim the player runs");
        await Touch(fingers, "touchMove", (x, y - (radius / 2)));
        await tab.Until($"Math.abs(window.surefoot.pose.speed - {Text(WalkSpeed)}) < 0.2", "half way out the player walks");
        double yaw = await tab.Number("window.surefoot.pose.yaw");
        await Touch(fingers, "touchMove", (x + radius, y));
        await tab.Until($"window.surefoot.pose.yaw < {Text(yaw - 0.1)}", "to the right the player turns right");
        await Touch(fingers, "touchMove", (x, y - radius));

        (double X, double Y) thumb = (jump.X + (jump.Width / 2), jump.Y + (jump.Height / 2));
        await Touch(fingers, "touchStart", (x, y - radius), thumb);
        await tab.Until("window.surefoot.bar > 0.1", "the held button charges while the pad moves");
        await Touch(fingers, "touchEnd");
        await tab.Until("window.surefoot.events.some((one) => one.event === 1)", "the player jumps when it is let go");
        await tab.Until("window.surefoot.pose.speed < 0.01", "the player stands when the pad is let go");

        double orbit = await tab.Number("window.surefoot.camera.orbit");
        await Touch(fingers, "touchStart", (300, 180));
        await Touch(fingers, "touchMove", (360, 180));
        await Touch(fingers, "touchMove", (420, 180));
        await tab.Until($"Math.abs(window.surefoot.camera.orbit - {Text(orbit)}) > 0.3", "a finger that drags looks around");
        await Touch(fingers, "touchEnd");
        double zoom = await tab.Number("window.surefoot.camera.zoom");
        await Touch(fingers, "touchStart", (300, 180), (340, 180));
        await Touch(fingers, "touchMove", (260, 180), (380, 180));
        await tab.Until($"window.surefoot.camera.zoom < {Text(zoom * 0.6)}", "two fingers that part come closer");
        await Touch(fingers, "touchEnd");
        Assert.Empty(tab.Complaints);
    }

    private static async Task Touch(ICDPSession fingers, string type, params (double X, double Y)[] points) =>
        await fingers.SendAsync("Input.dispatchTouchEvent", new Dictionary<string, object>
        {
            ["type"] = type,
            ["touchPoints"] = points.Select(
                (point, id) => new Dictionary<string, object> { ["x"] = point.X, ["y"] = point.Y, ["id"] = id }).ToArray(),
        });

    /// <summary>No card reaches out of the window or lies on another, and no text on a card is cut.</summary>
    private static async Task AssertFits(Tab tab, string when)
    {
        JsonElement wrong = await tab.Read(
            """
            (() => {
              const wrong = [];
              const cards = ["top", "panel", "sliders", "map", "notice", "legend", "back", "prompt", "pad", "jump"]
                .map((id) => document.getElementById(id)).filter((one) => one?.checkVisibility());
              const boxes = cards.map((one) => [one.id, one.getBoundingClientRect()]);
              for (const [id, box] of boxes) {
                if (box.left < 0 || box.top < 0 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5)
                  wrong.push(`${id} reaches out of the window`);
                for (const [other, there] of boxes) {
                  const apart = box.right <= there.left + 0.5 || there.right <= box.left + 0.5 ||
                    box.bottom <= there.top + 0.5 || there.bottom <= box.top + 0.5;
                  if (id < other && !apart) wrong.push(`${id} and ${other} lie on each other`);
                }
              }
              for (const card of cards) {
                for (const one of [card, ...card.querySelectorAll("*")]) {
                  if (!one.checkVisibility() || one.matches("input, .body, #goto-list")) continue;
                  if (one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).overflowX !== "visible")
                    wrong.push(`${one.id || one.tagName} in ${card.id} is cut`);
                }
                const body = card.querySelector(".body");
                if (body?.checkVisibility() && body.scrollWidth > body.clientWidth + 1) wrong.push(`${card.id} scrolls sideways`);
                if (body?.checkVisibility() && body.clientHeight < 40) wrong.push(`${card.id} shows ${body.clientHeight} pixels`);
              }
              return wrong;
            })()
            """);
        Assert.True(wrong.GetArrayLength() == 0, $"{when}: {wrong}");
    }

    /// <summary>The last thing in a card's body can be scrolled into the window.</summary>
    private static async Task AssertReachable(Tab tab, string body, string when)
    {
        JsonElement last = await tab.Read(
            $$"""
            (() => {
              const body = document.getElementById("{{body}}");
              const all = [...body.querySelectorAll("dd, output, p, td, button")].filter((one) => one.checkVisibility());
              const last = all.at(-1);
              last.scrollIntoView({ block: "nearest" });
              const box = last.getBoundingClientRect();
              const hit = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
              return {
                inside: box.bottom <= innerHeight + 1 && box.top >= -1,
                hit: last.contains(hit) || hit?.contains(last) === true,
                keyboard: body.scrollHeight <= body.clientHeight + 1 || body.tabIndex === 0,
              };
            })()
            """);
        Assert.True(last.GetProperty("inside").GetBoolean() && last.GetProperty("hit").GetBoolean(),
            $"{when}: the end of {body} can be seen");
        Assert.True(last.GetProperty("keyboard").GetBoolean(), $"{when}: {body} scrolls by keyboard");
    }

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
