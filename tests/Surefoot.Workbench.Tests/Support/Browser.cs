using System.Collections.Concurrent;
using System.Text.Json;
using Microsoft.Playwright;
using Surefoot.Workbench.Simulation;

namespace Surefoot.Workbench.Tests.Support;

/// <summary>The system's Chromium, started once for the tests that need one. It draws in software, so nothing here asks how fast.</summary>
public sealed class Browser : IAsyncLifetime
{
    private static readonly string[] Candidates =
    [
        Environment.GetEnvironmentVariable("SUREFOOT_CHROMIUM") ?? "",
        "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome",
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
        @"C:\Program Files\Google\Chrome\Application\chrome.exe", @"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
    ];

    /// <summary>Size of a page when nothing else is asked for, CSS pixels.</summary>
    internal const int Width = 960, Height = 540;

    private readonly ConcurrentDictionary<(uint Player, uint Tick), PlayerPose> published = new();
    private static readonly string[] Arguments =
    [
        "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
        "--disable-sync",
        "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    ];

    private Tab? lent;
    private IPlaywright? playwright;
    private IBrowser? browser;
    private WorkbenchServer? server;

    /// <summary>A workbench on the demo world, shared by the tests that change nothing about the server itself.</summary>
    internal WorkbenchServer Server => server!;

    /// <summary>What the shared workbench said of its players, by player and tick.</summary>
    internal IReadOnlyDictionary<(uint Player, uint Tick), PlayerPose> Published => published;

    public async ValueTask InitializeAsync()
    {
        if (!Array.Exists(Candidates, File.Exists)) return;
        server = await Worlds.StartAsync();
        server.Loop.PosePublished = (player, tick, pose) => published[(player, tick)] = pose;
        playwright = await Playwright.CreateAsync();
        browser = await LaunchAsync();
    }

    public async ValueTask DisposeAsync()
    {
        if (browser is not null) await browser.DisposeAsync();
        playwright?.Dispose();
        if (server is not null) await server.DisposeAsync();
    }

    /// <summary>Another browser of the same kind.</summary>
    /// <param name="more">More of its arguments.</param>
    internal async Task<IBrowser> LaunchAsync(params string[] more)
    {
        SkipWithout(playwright);
        return await playwright!.Chromium.LaunchAsync(
            new BrowserTypeLaunchOptions
            {
                ExecutablePath = Array.Find(Candidates, File.Exists),
                Headless = true,
                Args = [.. Arguments, .. more],
            });
    }

    /// <summary>A tab on the shared workbench, when its player is drawn.</summary>
    /// <param name="query">What the link says.</param>
    /// <param name="options">What kind of page.</param>
    internal Task<Tab> OpenAsync(string query = "", PageKind? options = null) => OpenAsync(server, query, options);

    /// <summary>
    /// A tab on the shared workbench whose player stands at the start. To open one is dear, so that it is one that another test has used
    /// before, as far as nothing on it tells of that.
    /// </summary>
    internal async Task<Tab> BorrowAsync()
    {
        if (lent is null) lent = await OpenAsync();
        else await lent.BeginAnewAsync();
        lent.IsLent = true;
        return lent;
    }

    /// <summary>A tab on a workbench, when its player is drawn.</summary>
    /// <param name="played">The workbench.</param>
    /// <param name="query">What the link says.</param>
    /// <param name="options">What kind of page.</param>
    internal async Task<Tab> OpenAsync(WorkbenchServer? played, string query = "", PageKind? options = null)
    {
        SkipWithout(browser);
        options ??= new PageKind();
        IPage page = await browser!.NewPageAsync(new BrowserNewPageOptions
        {
            ViewportSize = new() { Width = options.Width, Height = options.Height },
            DeviceScaleFactor = options.Scale,
            HasTouch = options.Touch,
            IsMobile = options.Touch,
            ReducedMotion = options.Motion,
        });
        Tab tab = new(page, played!.Address);
        await tab.Load(query);
        return tab;
    }

    private static void SkipWithout(object? what) => Assert.SkipWhen(
        what is null,
        "There is no Chromium on this machine, so the page was not tried in a browser. " +
        "Install it (Debian: apt-get install chromium) or name one in SUREFOOT_CHROMIUM.");
}

/// <summary>What kind of page.</summary>
internal sealed record PageKind
{
    /// <summary>CSS pixels.</summary>
    public int Width { get; init; } = Browser.Width;

    /// <summary>CSS pixels.</summary>
    public int Height { get; init; } = Browser.Height;

    /// <summary>Pixels drawn for each CSS pixel. Few: what is asked is what is drawn where, and the processor draws it.</summary>
    public float Scale { get; init; } = 0.25f;

    /// <summary>It is a telephone's.</summary>
    public bool Touch { get; init; }

    /// <summary>What the person asks for.</summary>
    public ReducedMotion? Motion { get; init; }
}

/// <summary>Tests in a browser run one after the other: two that draw in software at once would be slow enough to matter.</summary>
[CollectionDefinition(Name)]
public sealed class BrowserCollection : ICollectionFixture<Browser>
{
    public const string Name = "browser";
}

/// <summary>A tab, and what it says of itself.</summary>
internal sealed class Tab : IAsyncDisposable
{
    private readonly List<string> complaints = [];

    private readonly Uri address;

    public Tab(IPage page, Uri address)
    {
        Page = page;
        this.address = address;
        page.Console += (_, message) =>
        {
            if (message.Type == "error") complaints.Add(message.Text);
        };
        page.PageError += (_, error) => complaints.Add(error);
    }

    public IPage Page { get; }

    /// <summary>Errors on the browser's console, a shader that does not compile among them.</summary>
    public IReadOnlyList<string> Complaints => complaints;

    /// <summary>It belongs to all tests: whoever has used it leaves it open.</summary>
    public bool IsLent { get; set; }

    /// <summary>The player is put to the start. A page on which something else is left of what was done is opened anew.</summary>
    public async Task BeginAnewAsync()
    {
        complaints.Clear();
        await Page.EvaluateAsync(
            "() => { window.requestAnimationFrame = window.drawsOn; for (const one of window.waiting) window.drawsOn(one); }");
        const string Untouched =
            """
            window.surefoot?.covered === null && window.surefoot.playing && window.surefoot.notice === "" &&
            window.surefoot.events.length === 0 && document.getElementById("toasts").childElementCount === 0 &&
            document.getElementById("help").hidden && document.getElementById("run-skill").value === "300" &&
            document.getElementById("jump-skill").value === "250" && document.getElementById("burden").value === "0" &&
            ["delay", "jitter", "loss"].every((one) => document.getElementById(`net-${one}`).value === "0") &&
            window.surefoot.creature === null &&
            document.getElementById("goto-box").value === "" &&
            [...document.querySelectorAll("[data-toggle], .fold h2 button")].every((one) =>
              (one.ariaPressed ?? one.ariaExpanded) === String(!["triangles", "shapes", "truth"].includes(one.dataset.toggle))) &&
            window.surefoot.camera.orbit === 0 && window.surefoot.camera.zoom === 6.5 &&
            new URLSearchParams(location.search).size <= 1
            """;
        if (!(await Read($"({Untouched})")).GetBoolean())
        {
            await Load();
            return;
        }

        await Until(
            "window.surefoot.drawn?.teleports === window.surefoot.pose.teleports && window.surefoot.pose.speed === 0 && " +
            "window.surefoot.pose.cell === window.surefoot.places[0].cell",
            "the player stands at the start");
    }

    /// <summary>Opens a link, and waits until its player is drawn.</summary>
    /// <param name="query">What the link says.</param>
    public async Task Load(string query = "")
    {
        await Page.GotoAsync(address.AbsoluteUri + query);
        await Until("window.surefoot?.ready === true", "the player is drawn");
    }

    public async Task<JsonElement> Read(string expression) =>
        JsonDocument.Parse(await Page.EvaluateAsync<string>($"() => JSON.stringify({expression} ?? null)")).RootElement;

    public async Task<double> Number(string expression) => (await Read(expression)).GetDouble();

    public async Task Until(string condition, string what)
    {
        for (int i = 0; i < 600; i++)
        {
            if ((await Read($"({condition}) === true")).GetBoolean()) return;
            await Task.Delay(50);
        }

        Assert.Fail($"Did not happen: {what}. Complaints: {string.Join("; ", complaints)}");
    }

    /// <summary>Goes to a named place by its name.</summary>
    public async Task GoTo(string place)
    {
        await Until("window.surefoot.places.length > 0", "the places are listed");
        double before = await Number("window.surefoot.pose.teleports");
        await Page.Locator("#goto-box").FillAsync(place);
        await Page.Keyboard.PressAsync("Enter");
        uint cell = (uint)await Number($"window.surefoot.places.find((one) => one.name === {JsonSerializer.Serialize(place)}).cell");
        await Until(
            $"window.surefoot.pose.cell >>> 16 === {cell >> 16} && " +
            $"window.surefoot.drawn?.teleports === window.surefoot.pose.teleports && window.surefoot.pose.teleports !== {before}",
            $"the player is at {place}");
    }

    public async ValueTask DisposeAsync()
    {
        if (!IsLent)
        {
            await Page.CloseAsync();
            return;
        }

        foreach (string key in new[] { "w", "a", "s", "d", "q", "e", "r", "Shift", "Space", "ArrowUp" }) await Page.Keyboard.UpAsync(key);
        await Page.Mouse.UpAsync();
        await Page.Mouse.UpAsync(new() { Button = MouseButton.Right });
        await Page.EvaluateAsync("() => window.surefoot.sendRaw([3, 0, 0])");
        // Until the next test takes it, it does not draw: that would cost the others most of a processor.
        await Page.EvaluateAsync(
            """
            () => {
              window.waiting = [];
              window.drawsOn = window.requestAnimationFrame.bind(window);
              window.requestAnimationFrame = (one) => { window.waiting.push(one); return 0; };
            }
            """);
    }
}
