using System.Globalization;
using System.Numerics;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>
/// The page in a real browser on a real server. Times are the server's, so a slow machine changes how often something is drawn, not what.
/// </summary>
[Collection(BrowserCollection.Name)]
public sealed class BrowserTests(Browser browser)
{
    // spec/01, section 6: run skill 300 without burden.
    private const double RunSpeed = 10.6000004;

    // Seconds; timeline.ts, smoothOver.
    private const double SmoothOver = 0.08;

    [Fact]
    [Behaviour("workbench.browser.run-speed", "design.md")]
    public async Task W_held_two_seconds_moves_the_drawn_player_the_formulas_distance()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until($"window.surefoot.pose.speed > {0.95 * RunSpeed}", "the player runs");
        double start = await tab.Number("window.surefoot.pose.time");
        JsonElement first = await DrawnAfter(tab, start);
        JsonElement last = await DrawnAfter(tab, first.GetProperty("at").GetDouble() + 2);
        await tab.Page.Keyboard.UpAsync("w");
        double seconds = last.GetProperty("at").GetDouble() - first.GetProperty("at").GetDouble();
        Assert.InRange(Flat(first, last), 0.95 * RunSpeed * seconds, 1.05 * RunSpeed * seconds);
        await tab.Until("window.surefoot.pose.speed < 0.01", "the player stands when the key is let go");
        Assert.Empty(tab.Complaints);
    }

    /// <summary>
    /// What is drawn at a time or later, of a moment whose pose has arrived: a page that waits for its server draws the last pose it has.
    /// </summary>
    private static async Task<JsonElement> DrawnAfter(Tab tab, double time)
    {
        const string Drawn = "Object.assign({}, window.surefoot.drawn, { late: window.surefoot.drawn.at > window.surefoot.pose.time })";
        for (int attempt = 0; attempt < 600; attempt++)
        {
            JsonElement drawn = await tab.Read(Drawn);
            if (!drawn.GetProperty("late").GetBoolean() && drawn.GetProperty("at").GetDouble() > time) return drawn;
            await Task.Delay(50);
        }

        throw new TimeoutException("The page never drew a pose it had.");
    }

    [Fact]
    [Behaviour("workbench.browser.left-out", "spec/07, 9.1")]
    public async Task A_world_with_damaged_files_is_played_and_the_panel_says_what_is_left_out()
    {
        DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-damaged");
        try
        {
            DemoWorldBuilder.Write(folder.FullName);
            using (DatFileEditor editor = DatFileEditor.Open(Path.Combine(folder.FullName, DatSet.CellName)))
            {
                editor.Put(0xA8B50100, [0xFF, 0xFF, 0xFF]);
                editor.Complete();
            }

            await using WorkbenchServer damaged = await WorkbenchServer.StartAsync(
                new WorkbenchOptions
                {
                    Port = 0,
                    DatFolder = folder.FullName,
                    Places = [new WorkbenchPlace("Beside the damage", 0xA8B50001, new Vector3(12, 12, float.NaN), 0)],
                });
            await using Tab tab = await browser.OpenAsync(damaged);
            await tab.Until("!document.getElementById('left-out').hidden", "the panel tells of what is left out");
            string panel = (await tab.Read("document.getElementById('left-out').textContent")).GetString()!;
            Assert.Contains("Left out of the world: 1", panel, StringComparison.Ordinal);
            Assert.Contains("Room 0xA8B50100", panel, StringComparison.Ordinal);
            Assert.Empty(tab.Complaints);
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    [Fact]
    [Behaviour("workbench.browser.smooth-between-ticks", "design.md")]
    public async Task Drawn_positions_follow_the_path_between_ticks_of_the_physics()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until($"window.surefoot.pose.speed > {0.95 * RunSpeed}", "the player runs");
        await Task.Delay(400);
        JsonElement samples = await Sample(tab, 40);
        await tab.Page.Keyboard.UpAsync("w");
        uint player = (uint)await tab.Number("window.surefoot.player");
        PlayerPose[] poses =
            [.. browser.Published.Where(one => one.Key.Player == player).Select(one => one.Value).OrderBy(pose => pose.Time)];
        int between = 0;
        foreach (JsonElement drawn in samples.EnumerateArray())
        {
            double at = drawn.GetProperty("at").GetDouble();
            // A busy machine delivers some poses late; what is drawn meanwhile is a guess, and says so.
            if (drawn.GetProperty("late").GetBoolean() || poses[0].Time > at - (SmoothOver / 2) || poses[^1].Time < at + (SmoothOver / 2))
                continue;
            (double x, double y) = MeanOverWindow(poses, at);
            double off = Math.Sqrt(Math.Pow(x - Coordinate(drawn, "x"), 2) + Math.Pow(y - Coordinate(drawn, "y"), 2));
            Assert.True(off < 0.05, $"The player is drawn {off:F3} m off the path at {at:F3} s");
            if (!Array.Exists(poses, pose => Math.Abs(pose.Time - at) < 0.002)) between++;
        }

        Assert.True(between > 3, $"Only {between} of the frames were drawn between two ticks");
    }

    [Fact]
    [Behaviour("workbench.browser.jump", "design.md")]
    public async Task Space_held_one_second_fills_the_bar_and_jumps()
    {
        await using Tab tab = await browser.BorrowAsync();
        double ground = await tab.Number("window.surefoot.drawn.position.z");
        await tab.Page.Keyboard.DownAsync("Space");
        await tab.Until("window.surefoot.bar > 0.05 && window.surefoot.bar < 1", "the bar is filling");
        await tab.Until("window.surefoot.bar === 1", "the bar is full");
        await tab.Page.Keyboard.UpAsync("Space");
        await tab.Until("window.surefoot.drawn.airborne", "the player is in the air");
        await tab.Until($"window.surefoot.drawn.position.z > {Text(ground + 1)}", "the player rises by more than a metre");
        await tab.Until("!window.surefoot.drawn.airborne", "the player lands");
        JsonElement events = await tab.Read("window.surefoot.events.map(one => [one.event, one.value])");
        Assert.Contains(events.EnumerateArray(), one => one[0].GetInt32() == (int)PlayerEventKind.Jumped && one[1].GetDouble() == 1);
        Assert.Contains(events.EnumerateArray(), one => one[0].GetInt32() == (int)PlayerEventKind.Landed);
        Assert.Equal(0, await tab.Number("window.surefoot.bar"));
        Assert.Equal(ground, await tab.Number("window.surefoot.pose.position.z"), 0.01);
    }

    [Fact]
    [Behaviour("workbench.browser.panel-agrees", "design.md")]
    public async Task The_panel_shows_the_servers_numbers_standing_and_running()
    {
        await using Tab tab = await browser.BorrowAsync();
        await ComparePanel(tab);
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Page.Keyboard.DownAsync("d");
        await tab.Until("window.surefoot.pose.speed > 3", "the player moves");
        for (int i = 0; i < 5; i++)
        {
            await ComparePanel(tab);
            await Task.Delay(150);
        }

        await tab.Page.Keyboard.UpAsync("d");
        await tab.Page.Keyboard.UpAsync("w");
    }

    [Fact]
    [Behaviour("workbench.browser.skill-sliders", "design.md")]
    public async Task The_sliders_change_the_speed()
    {
        await using Tab tab = await browser.OpenAsync();
        await tab.Page.Locator("#run-skill").FillAsync("0");
        // Numbers act on the motions that begin after they have arrived; one begun before keeps its rate.
        await tab.Until("window.surefoot.pose.runRate === 1", "the server's numbers arrive");
        await tab.Page.Keyboard.PressAsync("Escape");
        await tab.Page.Keyboard.PressAsync("r");
        await tab.Until("Math.abs(window.surefoot.pose.speed - 4) < 0.2", "skill 0 runs 4 m/s");
        await tab.Page.Locator("#run-skill").FillAsync("300");
        await tab.Until($"Math.abs(window.surefoot.pose.speed - {RunSpeed}) < 0.4", "skill 300 runs 10.6 m/s");
        await tab.Page.Keyboard.PressAsync("Escape");
        await tab.Page.Keyboard.PressAsync("r");
        await tab.Page.Keyboard.DownAsync("Shift");
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until("Math.abs(window.surefoot.pose.speed - 3.12) < 0.2", "Shift walks at 3.12 m/s");
        await tab.Page.Keyboard.UpAsync("Shift");
        await tab.Page.Keyboard.UpAsync("w");
    }

    [Fact]
    [Behaviour("workbench.browser.camera-places-triangles", "design.md")]
    public async Task Mouse_menu_and_keys_do_what_the_help_says()
    {
        await using Tab tab = await browser.OpenAsync();
        IPage page = tab.Page;
        await page.Mouse.MoveAsync(300, 250);
        await page.Mouse.DownAsync();
        await page.Mouse.MoveAsync(400, 250, new MouseMoveOptions { Steps = 4 });
        await page.Mouse.UpAsync();
        await tab.Until("Math.abs(window.surefoot.camera.orbit) > 0.3", "dragging orbits");
        double zoom = await tab.Number("window.surefoot.camera.zoom");
        await page.Mouse.WheelAsync(0, 500);
        await tab.Until($"window.surefoot.camera.zoom > {Text(zoom)}", "the wheel moves the camera");
        await page.Keyboard.PressAsync("c");
        await tab.Until("Math.abs(window.surefoot.camera.orbit) < 0.01", "C looks ahead again");

        await page.Keyboard.PressAsync("t");
        Assert.True((await tab.Read("window.surefoot.triangles")).GetBoolean());
        Assert.True(await page.Locator("#legend").IsVisibleAsync());
        await page.Keyboard.PressAsync("h");
        Assert.True(await page.Locator("#help").IsVisibleAsync());
        await page.Keyboard.PressAsync("Escape");
        Assert.False(await page.Locator("#help").IsVisibleAsync());

        JsonElement places = await tab.Read("window.surefoot.places");
        Assert.True(places.GetArrayLength() > 1);
        await tab.GoTo(places[1].GetProperty("name").GetString()!);
        await tab.Until(
            "Math.hypot(window.surefoot.pose.position.x - window.surefoot.places[1].x, " +
            "window.surefoot.pose.position.y - window.surefoot.places[1].y) < 1",
            "the player is at the place");
        await tab.Until("window.surefoot.blocks > 8", "the land around is drawn");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.right-button-turns-the-player", "spec/09b, 9.7")]
    public async Task The_right_button_turns_the_player_and_the_left_one_orbits_the_camera()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        double yaw = await tab.Number("window.surefoot.pose.yaw");
        await page.Mouse.MoveAsync(150, 250);
        await page.Mouse.DownAsync(new MouseDownOptions { Button = MouseButton.Right });

        // At once, and not as a hand would: where frames are slow, a pointer that moves once a frame rests in between.
        await page.EvaluateAsync(
            """
            () => {
              const view = document.getElementById("view");
              const pointer = [...Array(10).keys()].find((id) => view.hasPointerCapture(id));
              const moved = { pointerId: pointer, buttons: 2, movementX: 10 };
              for (let i = 0; i < 10; i++) view.dispatchEvent(new PointerEvent("pointermove", moved));
            }
            """);
        await tab.Until($"window.surefoot.pose.yaw < {Text(yaw - 0.05)}", "the pointer to the right turns right");
        await tab.Until("window.surefoot.pose.turn === 0", "a pointer that rests turns no more");
        Assert.Equal(0, await tab.Number("window.surefoot.camera.orbit"), 0.01);

        await page.Mouse.DownAsync();
        await tab.Until($"window.surefoot.pose.speed > {0.95 * RunSpeed}", "both buttons run ahead");
        await page.Mouse.UpAsync();
        await page.Mouse.UpAsync(new MouseUpOptions { Button = MouseButton.Right });
        await tab.Until("window.surefoot.pose.speed < 0.01", "without them the player stands");

        yaw = await tab.Number("window.surefoot.pose.yaw");
        await page.Mouse.DownAsync();
        await page.Mouse.MoveAsync(250, 250, new MouseMoveOptions { Steps = 20 });
        await page.Mouse.UpAsync();
        await tab.Until("Math.abs(window.surefoot.camera.orbit) > 0.3", "the left button orbits");
        Assert.Equal(yaw, await tab.Number("window.surefoot.pose.yaw"), 1e-6);
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.mouse-turning-is-an-option", "spec/09b, 9.7")]
    public async Task Mouse_turning_is_on_at_first_and_can_be_switched_off()
    {
        await using Tab tab = await browser.BorrowAsync();
        IPage page = tab.Page;
        Assert.Equal("true", await page.Locator("#toggle-mouse").GetAttributeAsync("aria-pressed"));
        await page.Locator("#toggle-mouse").ClickAsync();
        Assert.Equal("false", await page.Locator("#toggle-mouse").GetAttributeAsync("aria-pressed"));
        double yaw = await tab.Number("window.surefoot.pose.yaw");
        await page.Mouse.MoveAsync(150, 250);
        await page.Mouse.DownAsync(new MouseDownOptions { Button = MouseButton.Right });
        await page.Mouse.MoveAsync(450, 250, new MouseMoveOptions { Steps = 30 });
        await page.Mouse.UpAsync(new MouseUpOptions { Button = MouseButton.Right });
        await tab.Until("Math.abs(window.surefoot.camera.orbit) > 0.3", "the right button looks around, as the left one");
        Assert.Equal(yaw, await tab.Number("window.surefoot.pose.yaw"), 1e-6);
        await page.Keyboard.PressAsync("Escape");
        await page.Keyboard.PressAsync("m");
        Assert.True((await tab.Read("window.surefoot.mouseTurning")).GetBoolean());
    }

    [Fact]
    [Behaviour("workbench.browser.autorun", "spec/09b, 9.6")]
    public async Task R_runs_ahead_until_it_is_pressed_again()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.Page.Keyboard.PressAsync("r");
        await tab.Until($"window.surefoot.pose.speed > {0.95 * RunSpeed}", "the player runs without a key");
        await tab.Page.EvaluateAsync("dispatchEvent(new Event('blur'))");
        double start = await tab.Number("window.surefoot.pose.time");
        await tab.Until($"window.surefoot.pose.time > {Text(start + 0.5)}", "half a second passes");
        Assert.True(await tab.Number("window.surefoot.pose.speed") > 0.95 * RunSpeed);
        await tab.Page.Keyboard.PressAsync("r");
        await tab.Until("window.surefoot.pose.speed < 0.01", "the player stands");
    }

    [Fact]
    [Behaviour("workbench.browser.tabs", "design.md")]
    public async Task Two_tabs_see_each_other_and_a_closed_one_is_gone()
    {
        await using WorkbenchServer own = await Worlds.StartAsync();
        await using Tab one = await browser.OpenAsync(own);
        Tab two = await browser.OpenAsync(own);
        uint id = (uint)await two.Number("window.surefoot.player");
        await one.Until(
            $"window.surefoot.others.some(other => other.player === {id} && other.position !== null)",
            "the first tab draws the second's player");
        JsonElement here = await one.Read("window.surefoot.drawn"), there = await two.Read("window.surefoot.drawn");
        Assert.InRange(Flat(here, there), 0.96, 2.5);
        await two.DisposeAsync();
        await one.Until("window.surefoot.others.length === 0", "the closed tab's player is gone");
        await Eventually.Holds(() => own.Counters.Players == 1, "the server has one player");
    }

    private async Task ComparePanel(Tab tab)
    {
        JsonElement both =
            await tab.Read("({ panel: window.surefoot.panel, tick: window.surefoot.pose.tick, player: window.surefoot.player })");
        JsonElement panel = both.GetProperty("panel");
        PlayerPose pose = browser.Published[(both.GetProperty("player").GetUInt32(), both.GetProperty("tick").GetUInt32())];
        Assert.Equal(both.GetProperty("tick").GetRawText(), Field("tick"));
        Assert.Equal($"0x{pose.CellId:X8}", Field("cell"));
        AssertNumbers(0.006, Field("position"), pose.Position.X, pose.Position.Y, pose.Position.Z);
        AssertNumbers(0.006, Field("speed").Replace("m/s", "", StringComparison.Ordinal), pose.Speed);
        AssertNumbers(0.06, Field("quantum").Replace("ms", "", StringComparison.Ordinal), pose.Quantum * 1000);
        Assert.Equal(pose.Flags.HasFlag(PoseFlags.OnWalkable) ? "yes" : "no", Field("walkable"));
        Assert.True(pose.Flags.HasFlag(PoseFlags.Contact));
        AssertNumbers(0.0006, Field("plane"), pose.ContactPlane.Normal.X, pose.ContactPlane.Normal.Y, pose.ContactPlane.Normal.Z,
            pose.ContactPlane.D);

        string Field(string name) => panel.GetProperty(name).GetString()!;
    }

    private static void AssertNumbers(double tolerance, string shown, params double[] expected)
    {
        double[] numbers = [
            .. shown.Split((char[])[' ', '\n'],
                StringSplitOptions.RemoveEmptyEntries).Select(one => double.Parse(one, CultureInfo.InvariantCulture))];
        Assert.Equal(expected.Length, numbers.Length);
        for (int i = 0; i < expected.Length; i++) Assert.Equal(expected[i], numbers[i], tolerance);
    }

    /// <summary>What the page draws in each of its next frames.</summary>
    private static async Task<JsonElement> Sample(Tab tab, int frames) =>
        JsonDocument.Parse(await tab.Page.EvaluateAsync<string>(
            """
            (frames) => new Promise((done) => {
              const seen = [];
              const take = () => {
                seen.push(window.surefoot.drawn);
                if (seen.length < frames) requestAnimationFrame(take);
                else done(JSON.stringify(seen));
              };
              requestAnimationFrame(take);
            })
            """,
            frames)).RootElement;

    /// <summary>Mean of the path over the window that the page smooths over: the path is the line through the poses.</summary>
    private static (double X, double Y) MeanOverWindow(PlayerPose[] poses, double at)
    {
        const int Points = 100;
        double x = 0, y = 0;
        for (int i = 0; i < Points; i++)
        {
            double time = at + (SmoothOver * (((i + 0.5) / Points) - 0.5));
            int after = Array.FindIndex(poses, pose => pose.Time >= time);
            PlayerPose a = poses[Math.Max(0, after - 1)], b = poses[after];
            double share = b.Time > a.Time ? (time - a.Time) / (b.Time - a.Time) : 0;
            x += Global(a).X + ((Global(b).X - Global(a).X) * share);
            y += Global(a).Y + ((Global(b).Y - Global(a).Y) * share);
        }

        return (x / Points, y / Points);
    }

    private static (double X, double Y) Global(in PlayerPose pose) =>
        (((pose.CellId >> 24) * 192.0) + pose.Position.X, (((pose.CellId >> 16) & 0xFF) * 192.0) + pose.Position.Y);

    private static double Flat(JsonElement a, JsonElement b) =>
        Math.Sqrt(Math.Pow(Coordinate(a, "x") - Coordinate(b, "x"), 2) + Math.Pow(Coordinate(a, "y") - Coordinate(b, "y"), 2));

    private static double Coordinate(JsonElement drawn, string axis) => drawn.GetProperty("position").GetProperty(axis).GetDouble();

    private static string Text(double value) => value.ToString("R", CultureInfo.InvariantCulture);
}
