using System.Buffers.Binary;
using System.IO.Compression;
using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text.Json;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Tests.Support;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>The server over real sockets, with a stand-in for the world: what is tested is what carries it.</summary>
public sealed class ServerTests : IAsyncLifetime
{
    private readonly StandInWorld world = new();
    private readonly SkippingClock clock = new();
    private readonly HttpClient http = new();
    private WorkbenchServer server = null!;

    public async ValueTask InitializeAsync() =>
        server = await WorkbenchServer.StartAsync(world, new WorkbenchOptions { Port = 0, MaxPlayers = 4 }, clock: clock);

    public async ValueTask DisposeAsync()
    {
        http.Dispose();
        await server.DisposeAsync();
    }

    [Fact]
    [Behaviour("workbench.server.serves-the-page", "design.md")]
    public async Task The_page_and_all_that_it_names_are_served()
    {
        using HttpResponseMessage page = await http.GetAsync(server.Address);
        Assert.Equal(HttpStatusCode.OK, page.StatusCode);
        Assert.Equal("text/html", page.Content.Headers.ContentType!.MediaType);
        Assert.Contains("default-src 'self'", string.Join(' ', page.Headers.GetValues("Content-Security-Policy")),
            StringComparison.Ordinal);
        string html = await page.Content.ReadAsStringAsync();
        string[] named = [.. html.Split('"').Where(part => part.StartsWith('/') && part.Contains('.', StringComparison.Ordinal))];
        Assert.True(named.Length >= 3, $"script, style and icon are named in the page: {string.Join(", ", named)}");
        foreach (string path in named) Assert.Equal(HttpStatusCode.OK, (await http.GetAsync(new Uri(server.Address, path))).StatusCode);
        Assert.Equal(HttpStatusCode.NotFound, (await http.GetAsync(new Uri(server.Address, "/no-such-file"))).StatusCode);
    }

    [Theory]
    [Behaviour("workbench.server.page-is-compressed", "RFC 9110, 8.4 and 12.5.3")]
    [InlineData("gzip, deflate, br, zstd", "br")]
    [InlineData("gzip, br;q=0", "gzip")]
    [InlineData("gzip", "gzip")]
    [InlineData("identity", null)]
    [InlineData("", null)]
    [InlineData("br;q=zero", null)]
    public async Task Scripts_and_styles_go_over_the_wire_in_a_form_that_the_browser_takes(string accepts, string? encoding)
    {
        string html = await http.GetStringAsync(server.Address);
        string[] named = [.. html.Split('"').Where(part => Path.GetExtension(part) is ".js" or ".css")];
        Assert.Equal(2, named.Length);
        foreach (string path in named)
        {
            byte[] plain = await http.GetByteArrayAsync(new Uri(server.Address, path));
            using HttpRequestMessage ask = new(HttpMethod.Get, new Uri(server.Address, path));
            ask.Headers.TryAddWithoutValidation("Accept-Encoding", accepts);
            using HttpResponseMessage answer = await http.SendAsync(ask);
            byte[] sent = await answer.Content.ReadAsByteArrayAsync();
            Assert.Equal(encoding, answer.Content.Headers.ContentEncoding.SingleOrDefault());
            Assert.Equal("Accept-Encoding", Assert.Single(answer.Headers.Vary));
            Assert.Equal(plain, Unpacked(sent, encoding));
            if (encoding is not null) Assert.True(sent.Length < plain.Length / 2, $"{path}: {sent.Length} of {plain.Length} bytes");

            using HttpRequestMessage again = new(HttpMethod.Get, new Uri(server.Address, path));
            again.Headers.TryAddWithoutValidation("Accept-Encoding", accepts);
            again.Headers.IfNoneMatch.Add(answer.Headers.ETag!);
            Assert.Equal(HttpStatusCode.NotModified, (await http.SendAsync(again)).StatusCode);
        }
    }

    [Fact]
    [Behaviour("workbench.server.sleeps-without-players", "design.md, Who uses it")]
    public async Task Without_a_page_the_server_does_nothing_and_its_worlds_time_stands_still()
    {
        await Eventually.Holds(() => server.Loop.Rests == 1, "the loop sleeps before anyone came");
        await Task.Delay(100);
        Assert.Equal((0, 0), (server.Loop.Turns, world.Advances));
        await using (RawPage page = await RawPage.OpenAsync(server))
        {
            await page.ReceiveAsync(FrameKind.Pose);
            await page.CloseAsync();
        }

        await Eventually.Holds(() => server.Loop.Rests == 2, "the loop sleeps again");
        (long turns, int advances, double rested) = (server.Loop.Turns, world.Advances, world.Now);
        Assert.True(advances > 0, "the world went on while a page was there");
        clock.Skip(TimeSpan.FromHours(1));
        await Task.Delay(100);
        Assert.Equal((turns, advances), (server.Loop.Turns, world.Advances));

        await using RawPage next = await RawPage.OpenAsync(server);
        await next.ReceiveAsync(FrameKind.Pose);
        Assert.True(world.Advances > advances, "the world goes on");
        Assert.InRange(world.FirstAfter(rested) - rested, 0, 1800);
    }

    [Fact]
    [Behaviour("workbench.server.terrain-as-physics-built-it", "design.md")]
    public async Task Terrain_is_heights_words_and_split_directions()
    {
        byte[] bytes = await http.GetByteArrayAsync(new Uri(server.Address, "/terrain/a9b4/0"));
        Assert.Equal(554, bytes.Length);
        Assert.Equal(0xA9B4, BinaryPrimitives.ReadUInt16LittleEndian(bytes));
        Assert.Equal(StandInWorld.Ground, BinaryPrimitives.ReadSingleLittleEndian(bytes.AsSpan(4 + (80 * 4))));
        Assert.Equal(4, BinaryPrimitives.ReadUInt16LittleEndian(bytes.AsSpan(328 + (80 * 2))));
        Assert.Equal([1, 0, 0, 1], bytes[490..494]);
        Assert.Equal(9 * 554, (await http.GetByteArrayAsync(new Uri(server.Address, "/terrain/a9b4/1"))).Length);
        Assert.Empty(await http.GetByteArrayAsync(new Uri(server.Address, "/terrain/0000/1")));
        foreach (string wrong in new[] { "12345/0", "xyzw/0", "-001/0", "a9b/0", "a9b4/9", "a9b4/-1", "a9b4/x" })
            Assert.Equal(HttpStatusCode.NotFound, (await http.GetAsync(new Uri(server.Address, $"/terrain/{wrong}"))).StatusCode);
    }

    [Fact]
    [Behaviour("workbench.server.shapes-that-bodies-meet", "design.md, Who uses it")]
    public async Task Shapes_are_counted_triangles_of_objects_rocks_shells_and_rooms_plants_and_what_moves()
    {
        byte[] bytes = await http.GetByteArrayAsync(new Uri(server.Address, "/shapes/a9b4"));
        Assert.Equal(24 + 8 + 24 + 8 + (3 * 36), bytes.Length);
        Assert.Equal([1, 0, 0, 1, 1, 1], Enumerable.Range(0, 6).Select(i => BinaryPrimitives.ReadInt32LittleEndian(bytes.AsSpan(4 * i))));
        Assert.Equal(0xA9B40100, BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(24)));
        Assert.Equal(1, BinaryPrimitives.ReadInt32LittleEndian(bytes.AsSpan(28)));
        Assert.Equal(
            [1f, 2f, 3f, 0.5f, 4f],
            Enumerable.Range(0, 5).Select(i => BinaryPrimitives.ReadSingleLittleEndian(bytes.AsSpan(32 + (4 * i)))));
        Assert.Equal(
            [0x00020003, 1], Enumerable.Range(0, 2).Select(i => BinaryPrimitives.ReadInt32LittleEndian(bytes.AsSpan(56 + (4 * i)))));
        Assert.Equal(9f, BinaryPrimitives.ReadSingleLittleEndian(bytes.AsSpan(bytes.Length - 4)));
        Assert.Equal(HttpStatusCode.NoContent, (await http.GetAsync(new Uri(server.Address, "/shapes/a9b5"))).StatusCode);
        Assert.Equal(HttpStatusCode.NotFound, (await http.GetAsync(new Uri(server.Address, "/shapes/a9b"))).StatusCode);
    }

    [Fact]
    [Behaviour("workbench.server.occupied-port", "design.md")]
    public async Task An_occupied_port_makes_it_take_the_next_free_one()
    {
        using TcpListener taken = new(IPAddress.Loopback, 0);
        taken.Start();
        int port = ((IPEndPoint)taken.LocalEndpoint).Port;
        await using WorkbenchServer next = await WorkbenchServer.StartAsync(new StandInWorld(), new WorkbenchOptions { Port = port });
        Assert.InRange(next.Address.Port, port + 1, port + 99);
        Assert.Equal(HttpStatusCode.OK, (await http.GetAsync(next.Address)).StatusCode);
    }

    [Theory]
    [Behaviour("workbench.server.refuses-other-sites", "design.md")]
    [InlineData("http://evil.example")]
    [InlineData("http://127.0.0.1:1")]
    [InlineData("null")]
    public async Task A_socket_from_another_site_is_refused(string origin)
    {
        await Assert.ThrowsAsync<WebSocketException>(() => RawPage.OpenAsync(server, origin));
        using HttpRequestMessage rebound = new(HttpMethod.Get,
            new Uri(server.Address, "/places.json"))
        { Headers = { Host = "evil.example" } };
        Assert.Equal(HttpStatusCode.Forbidden, (await http.SendAsync(rebound)).StatusCode);
    }

    [Fact]
    [Behaviour("workbench.player.keys-move-it", "design.md")]
    public async Task Keys_move_the_players_pose_and_the_pose_names_the_input_it_took()
    {
        await using RawPage page = await RawPage.OpenAsync(server);
        byte[] still = await page.ReceiveAsync(FrameKind.Pose);
        Assert.Equal(ServerFrames.PoseLength, still.Length);
        Assert.Equal(0, RawPage.SpeedOf(still));
        await page.SendKeysAsync(PlayerKeys.Forward, 41);
        byte[] moving = await page.ReceiveAsync(FrameKind.Pose, pose => RawPage.SequenceOf(pose) == 41);
        Assert.Equal(10.6f, RawPage.SpeedOf(moving), 3);
        await page.SendAsync(0x03, 1, 0);
        await page.ReceiveAsync(FrameKind.Pose, pose => RawPage.CellOf(pose) == 0xAAB40025 && pose[1] == 1);
    }

    [Fact]
    [Behaviour("workbench.bodies.told-when-changed-and-again", "design.md, Who uses it")]
    public async Task A_page_is_told_of_bodies_at_first_when_one_changed_and_again_after_a_while()
    {
        await using RawPage page = await RawPage.OpenAsync(server);
        byte[] first = await page.ReceiveAsync(FrameKind.Bodies);
        Assert.Equal(ServerFrames.BodiesHeaderLength + ServerFrames.BodyLength + "door".Length, first.Length);
        Assert.Equal(StandInWorld.DoorId, BinaryPrimitives.ReadUInt32LittleEndian(first.AsSpan(ServerFrames.BodiesHeaderLength)));
        Assert.Equal("door"u8, first.AsSpan(first.Length - 4));
        Assert.Equal(BodyFlags.None, FlagsOf(first));
        byte[] again = await page.ReceiveAsync(FrameKind.Bodies);
        Assert.Equal(first[9..], again[9..]);

        await page.SendAsync(0x04);
        await page.ReceiveAsync(FrameKind.Bodies, bodies => FlagsOf(bodies) == BodyFlags.Open);
        await page.SendAsync(0x04);
        await page.ReceiveAsync(FrameKind.Bodies, bodies => FlagsOf(bodies) == BodyFlags.None);
    }

    [Fact]
    [Behaviour("workbench.touches.told-when-changed", "design.md, Who uses it")]
    public async Task A_page_is_told_what_its_player_stands_on_and_touches_and_when_that_changes()
    {
        await using RawPage page = await RawPage.OpenAsync(server);
        byte[] first = await page.ReceiveAsync(FrameKind.Touches);
        Assert.Equal(ServerFrames.TouchesHeaderLength + (2 * ServerFrames.TouchLength) + "door".Length, first.Length);
        Assert.Equal([2, 1, (byte)TouchKind.Ground, 0, 0], first[1..6]);
        await page.SendAsync(0x03, 1, 0);
        await page.ReceiveAsync(FrameKind.Touches, touches => BinaryPrimitives.ReadUInt32LittleEndian(touches.AsSpan(6)) == 0xAAB40025);
    }

    [Fact]
    [Behaviour("workbench.input.malformed-counted-and-dropped", "design.md")]
    public async Task Malformed_frames_are_counted_and_dropped_and_the_page_plays_on()
    {
        await using RawPage page = await RawPage.OpenAsync(server);
        await page.SendAsync();
        await page.SendAsync(0xFF);
        await page.SendAsync(0x01, 1);
        await page.SendAsync(0x02, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0);
        await page.SendAsync(0x03, 0xFF, 0xFF);
        await page.SendAsync(new byte[100_000]);
        await page.SendAsync([0x01, 1, 0, 0, 0, 0], WebSocketMessageType.Text);
        await page.SendKeysAsync(PlayerKeys.Back, 9);
        await page.ReceiveAsync(FrameKind.Pose, pose => RawPage.SequenceOf(pose) == 9 && RawPage.SpeedOf(pose) > 1);
        using JsonDocument stats = JsonDocument.Parse(await http.GetStringAsync(new Uri(server.Address, "/stats.json")));
        Assert.Equal(7, stats.RootElement.GetProperty("malformed").GetInt64());
        Assert.Equal(8, stats.RootElement.GetProperty("received").GetInt64());
    }

    [Fact]
    [Behaviour("workbench.input.flood-keeps-the-newest", "design.md")]
    public async Task A_flood_of_frames_neither_stops_the_world_nor_loses_the_last_key()
    {
        await using RawPage flood = await RawPage.OpenAsync(server);
        await using RawPage calm = await RawPage.OpenAsync(server);
        for (uint i = 1; i <= 20_000; i++) await flood.SendKeysAsync((PlayerKeys)(i & 0x3F), i);
        await flood.SendKeysAsync(PlayerKeys.Forward, 20_001);
        await flood.ReceiveAsync(FrameKind.Pose, pose => RawPage.SequenceOf(pose) == 20_001 && RawPage.SpeedOf(pose) > 1);
        await calm.SendKeysAsync(PlayerKeys.Forward, 1);
        await calm.ReceiveAsync(FrameKind.Pose, pose => RawPage.SequenceOf(pose) == 1);
        Assert.Equal(0, server.Counters.Malformed);
    }

    [Fact]
    [Behaviour("workbench.tabs.share-one-world", "design.md")]
    public async Task Each_tab_has_its_own_player_and_sees_the_others()
    {
        await using RawPage one = await RawPage.OpenAsync(server);
        await using RawPage two = await RawPage.OpenAsync(server);
        Assert.NotEqual(one.Id, two.Id);
        await two.SendKeysAsync(PlayerKeys.Forward, 1);
        byte[] seen = await one.ReceiveAsync(
            FrameKind.Others, others => others.Length > ServerFrames.OthersHeaderLength && VelocityNorth(others) > 1);
        Assert.Equal(ServerFrames.OthersHeaderLength + ServerFrames.OtherLength, seen.Length);
        Assert.Equal(two.Id, BinaryPrimitives.ReadUInt32LittleEndian(seen.AsSpan(ServerFrames.OthersHeaderLength)));
        Assert.Equal(0, RawPage.SpeedOf(await one.ReceiveAsync(FrameKind.Pose)));
    }

    [Theory]
    [Behaviour("workbench.tabs.closed-leaves-nothing", "design.md")]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_closed_tab_leaves_no_player_and_the_others_are_told(bool politely)
    {
        await using RawPage stays = await RawPage.OpenAsync(server);
        await using RawPage goes = await RawPage.OpenAsync(server);
        await stays.ReceiveAsync(FrameKind.Others, others => others.Length > ServerFrames.OthersHeaderLength);
        if (politely) await goes.CloseAsync();
        else goes.Abort();
        await stays.ReceiveAsync(FrameKind.Others, others => others.Length == ServerFrames.OthersHeaderLength);
        Assert.Equal(1, world.PlayerCount);
        Assert.Equal(1, server.Counters.Players);
    }

    [Fact]
    [Behaviour("workbench.tabs.limited", "design.md")]
    public async Task More_tabs_than_seats_are_refused_until_one_is_free()
    {
        RawPage[] pages = await Task.WhenAll(Enumerable.Range(0, 4).Select(_ => RawPage.OpenAsync(server)));
        await Assert.ThrowsAsync<WebSocketException>(() => RawPage.OpenAsync(server));
        await pages[0].CloseAsync();
        await Eventually.Holds(() => server.Counters.Players == 3, "the closed tab's seat is free");
        await using RawPage late = await RawPage.OpenAsync(server);
        foreach (RawPage page in pages) await page.DisposeAsync();
    }

    [Fact]
    [Behaviour("workbench.server.stops-cleanly", "design.md")]
    public async Task Stopping_closes_every_page_and_the_world()
    {
        await using RawPage page = await RawPage.OpenAsync(server);
        await server.DisposeAsync();
        try
        {
            while ((await page.ReceiveAsync()).Length > 0)
            {
            }
        }
        catch (WebSocketException)
        {
            // The connection may go before the goodbye is read.
        }

        Assert.NotEqual(WebSocketState.Open, page.State);
        Assert.True(world.Disposed);
        await Assert.ThrowsAsync<HttpRequestException>(() => http.GetAsync(server.Address));
    }

    private static byte[] Unpacked(byte[] bytes, string? encoding)
    {
        using MemoryStream from = new(bytes), to = new();
        using Stream stream = encoding switch
        {
            "br" => new BrotliStream(from, CompressionMode.Decompress),
            "gzip" => new GZipStream(from, CompressionMode.Decompress),
            _ => from,
        };
        stream.CopyTo(to);
        return to.ToArray();
    }

    private static BodyFlags FlagsOf(byte[] bodies) => (BodyFlags)bodies[ServerFrames.BodiesHeaderLength + 5];

    private static float VelocityNorth(byte[] others) =>
        BinaryPrimitives.ReadSingleLittleEndian(others.AsSpan(ServerFrames.OthersHeaderLength + 36));
}
