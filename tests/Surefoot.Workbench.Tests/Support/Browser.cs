using System.Text.Json;
using Microsoft.Playwright;

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

    private IPlaywright? playwright;
    private IBrowser? browser;

    public async ValueTask InitializeAsync()
    {
        string? path = Array.Find(Candidates, File.Exists);
        if (path is null) return;
        playwright = await Playwright.CreateAsync();
        browser = await playwright.Chromium.LaunchAsync(new BrowserTypeLaunchOptions
        {
            ExecutablePath = path,
            Headless = true,
            Args =
            [
                "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
                "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            ],
        });
    }

    public async ValueTask DisposeAsync()
    {
        if (browser is not null) await browser.DisposeAsync();
        playwright?.Dispose();
    }

    /// <summary>A tab on the workbench, when its player is drawn.</summary>
    internal async Task<Tab> OpenAsync(WorkbenchServer server)
    {
        Assert.SkipWhen(browser is null, "There is no Chromium on this machine, so the page was not tried in a browser. Install it (Debian: apt-get install chromium) or name one in SUREFOOT_CHROMIUM.");
        IPage page = await browser!.NewPageAsync(new BrowserNewPageOptions { ViewportSize = new ViewportSize { Width = 800, Height = 450 }, DeviceScaleFactor = 0.5f });
        Tab tab = new(page);
        await page.GotoAsync(server.Address.AbsoluteUri);
        await tab.Until("window.surefoot?.ready === true", "the player is drawn");
        return tab;
    }
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

    public async ValueTask DisposeAsync() => await Page.CloseAsync();
}
