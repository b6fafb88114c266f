using System.Globalization;
using System.Numerics;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Tests.Support;

namespace Surefoot.Workbench.Tests;

/// <summary>What stands and lives in the world, as a real browser shows it.</summary>
[Collection(BrowserCollection.Name)]
public sealed class InhabitedPageTests(Browser browser)
{
    [Fact]
    [Behaviour("workbench.browser.creatures-are-drawn", "design.md, Who uses it")]
    public async Task The_crowd_and_the_creatures_are_there_and_the_creatures_walk()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.GoTo("A crowd of a hundred");
        await tab.Until(
            $"window.surefoot.bodies.filter((one) => one.type === {(int)BodyKind.Crowd}).length === 100",
            "the page is told of a hundred people");
        await tab.Until("window.surefoot.drawnThings.crowd === 100", "they are drawn");
        await tab.GoTo("Creatures at pasture");
        string creatures = $"window.surefoot.bodies.filter((one) => one.type === {(int)BodyKind.Wanderer})";
        await tab.Until($"{creatures}.length === 6", "six creatures are near");
        await tab.Until($"{creatures}.some((one) => Math.hypot(one.velocity.x, one.velocity.y) > 0.5)", "one of them walks");
        await tab.Until("window.surefoot.drawnThings.plants > 0", "trees are drawn as trees");
        await tab.Page.Keyboard.PressAsync("v");
        await tab.Until("window.surefoot.plainShapes && window.surefoot.drawnThings.plants === 0",
            "V shows their collision shapes instead");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.windmill-turns", "design.md, Who uses it; spec/02, 4.19")]
    public async Task The_windmills_sails_turn_on_the_page_and_its_tower_stands()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.GoTo("The windmill");
        await tab.Until("window.surefoot.moving.length === 2", "tower and sails are drawn");
        const string sails =
            "window.surefoot.moving.find((one) => one.part === 1).rotation", tower =
                "window.surefoot.moving.find((one) => one.part === 0).rotation";
        double before = await tab.Number($"{sails}[1]");
        await tab.Until($"Math.abs({sails}[1] - {before.ToString(CultureInfo.InvariantCulture)}) > 0.1",
            "the sails have turned about the mill's own y");
        Assert.Equal(0, await tab.Number($"{sails}[0]"));
        Assert.Equal(0, await tab.Number($"{sails}[2]"));
        Assert.Equal(1, await tab.Number($"{tower}[3]"));
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.door-opens-and-closes", "design.md, Who uses it")]
    public async Task F_opens_the_door_at_hand_and_it_closes_by_itself()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.GoTo("A door");
        string door = $"window.surefoot.bodies.find((one) => one.type === {(int)BodyKind.Door})";
        await tab.Until($"{door}?.flags === 0 && window.surefoot.drawnThings.door === 0", "the door is closed");
        await tab.Page.Keyboard.DownAsync("w");
        await tab.Until("window.surefoot.touches.some((one) => one.name === 'door')", "the closed door stops the player");
        await tab.Page.Keyboard.UpAsync("w");
        await tab.Until("window.surefoot.panel.touches.includes('door')", "the panel names it");
        await tab.Until("!document.getElementById('prompt').hidden", "the page says which key opens it");

        await tab.Page.Keyboard.PressAsync("f");
        await tab.Until($"{door}.flags === {(int)BodyFlags.Open}", "the door is open");
        await tab.Until("window.surefoot.drawnThings.door > 0.8", "it is drawn swung open");
        await tab.Until($"{door}.flags === 0", "it closes after a while");
        await tab.Until("window.surefoot.drawnThings.door < 0.1", "it is drawn closed");
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.cutaway-indoors", "design.md, Who uses it")]
    public async Task In_a_house_the_wall_before_the_camera_is_cut_away_and_the_panel_names_the_wall_run_into()
    {
        await using Tab tab = await browser.BorrowAsync();
        await tab.GoTo("In the hall");
        await tab.Until("window.surefoot.cut.opens === 1", "the house is opened around the player");
        await tab.Page.Keyboard.DownAsync("q");
        string cell = (await tab.Read("window.surefoot.panel.cell")).GetString()!;
        await tab.Until($"window.surefoot.panel.touches === 'room {cell} 90°'", "the panel names the room's wall");
        await tab.Page.Keyboard.UpAsync("q");
        Assert.StartsWith($"room {cell}\nslope 0.0", (await tab.Read("window.surefoot.panel.footing")).GetString(),
            StringComparison.Ordinal);

        // Beside the doorway the front wall is between the camera and the player.
        await tab.Until(
            "window.surefoot.pose.speed < 0.01 && " +
            "Math.abs((window.surefoot.drawn.position.x % 192) - window.surefoot.pose.position.x) < 0.05",
            "the player is drawn at the wall");
        Assert.Equal(0, await tab.Number("window.surefoot.seen(false)"));
        Assert.True(await tab.Number("window.surefoot.seen(true)") > 1000);
        Assert.Empty(tab.Complaints);
    }

    [Fact]
    [Behaviour("workbench.browser.cutaway-behind-a-house", "design.md, Who uses it")]
    public async Task Behind_a_house_the_player_is_seen_through_it()
    {
        await using Tab tab = await browser.OpenAsync(options: new() { Scale = 0.5f });
        await tab.GoTo("At a house's door");
        // Half a turn at 0.0055 radians a pixel, in two pulls: the camera comes to be in the house, then beyond it.
        for (int pull = 0; pull < 2; pull++)
        {
            await tab.Page.Mouse.MoveAsync(150, 250);
            await tab.Page.Mouse.DownAsync();
            await tab.Page.Mouse.MoveAsync(435.6f, 250, new() { Steps = 4 });
            await tab.Page.Mouse.UpAsync();
        }

        await tab.Until("Math.abs(Math.abs(window.surefoot.camera.orbit) - Math.PI) < 0.05", "the camera looks the player in the face");
        await tab.Until("window.surefoot.cut.opens === 2", "the house that the camera is in is opened");
        // Half-size pixels double what the page takes a turn of the wheel for.
        await tab.Page.Mouse.WheelAsync(0, 450);
        await tab.Until("window.surefoot.camera.zoom > 20 && window.surefoot.camera.away > 20 && window.surefoot.cut.opens === 0",
            "the camera is beyond the house");
        Assert.Equal(0, await tab.Number("window.surefoot.seen(false)"));
        Assert.True(await tab.Number("window.surefoot.seen(true)") > 10);
    }

    [Fact]
    [Behaviour("workbench.browser.panel-names-the-object-stood-on", "design.md, Who uses it")]
    public async Task On_a_crate_the_panel_names_the_object_under_the_feet()
    {
        WorkbenchPlace before = KnownPlaces.Demo().Single(place => place.Name == "A pile of crates");
        Vector3 above = before.Position + new Vector3(-0.3f, 5, 1.5f);
        await using WorkbenchServer crates =
            await WorkbenchServer.StartAsync(new WorkbenchOptions { Port = 0, Places = [before with { Position = above }] });
        await using Tab tab = await browser.OpenAsync(crates);
        await tab.Until("window.surefoot.touches.some((one) => one.footing)", "the player has landed");
        Assert.Equal((int)TouchKind.Object, await tab.Number("window.surefoot.touches.find((one) => one.footing).type"));
        uint id = (uint)await tab.Number("window.surefoot.touches.find((one) => one.footing).id");
        await tab.Until($"window.surefoot.panel.footing === 'object 0x{id.ToString("X8", CultureInfo.InvariantCulture)}\\nslope 0.0°'",
            "the panel names the crate and its slope");
    }
}
