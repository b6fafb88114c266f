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
    internal Task<Tab> OpenAsync(string query = "", BrowserNewPageOptions? options = null) => OpenAsync(server, query, options);

    /// <summary>A tab on a workbench, when its player is drawn.</summary>
    /// <param name="played">The workbench.</param>
    /// <param name="query">What the link says.</param>
    /// <param name="options">What kind of page.</param>
    internal async Task<Tab> OpenAsync(WorkbenchServer? played, string query = "", BrowserNewPageOptions? options = null)
    {
        SkipWithout(browser);
        options ??= new BrowserNewPageOptions();
        options.ViewportSize ??= new ViewportSize { Width = Width, Height = Height };
        // Few pixels: what is asked is what is drawn where, and the processor draws it.
        options.DeviceScaleFactor ??= 0.25f;
        IPage page = await browser!.NewPageAsync(options);
        Tab tab = new(page);
        await page.GotoAsync(played!.Address.AbsoluteUri + query);
        await tab.Until("window.surefoot?.ready === true", "the player is drawn");
        return tab;
    }

    private static void SkipWithout(object? what) => Assert.SkipWhen(
        what is null,
        "There is no Chromium on this machine, so the page was not tried in a browser. " +
        "Install it (Debian: apt-get install chromium) or name one in SUREFOOT_CHROMIUM.");
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

    public Tab(IPage page)
    {
        Page = page;
        page.Console += (_, message) =>
        {
            if (message.Type == "error") complaints.Add(message.Text);
        };
        page.PageError += (_, error) => complaints.Add(error);
    }

    public IPage Page { get; }

    /// <summary>Errors on the browser's console, a shader that does not compile among them.</summary>
    public IReadOnlyList<string> Complaints => complaints;

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

    public async ValueTask DisposeAsync() => await Page.CloseAsync();
}
