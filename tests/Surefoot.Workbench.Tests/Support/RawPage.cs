using System.Buffers.Binary;
using System.Net.WebSockets;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests.Support;

/// <summary>A page without a browser: a real socket that speaks bytes.</summary>
internal sealed class RawPage : IAsyncDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(20);
    private readonly ClientWebSocket socket = new();
    private readonly byte[] buffer = new byte[64 * 1024];

    public uint Id { get; private set; }

    public WebSocketState State => socket.State;

    public static async Task<RawPage> OpenAsync(WorkbenchServer server, string? origin = null)
    {
        RawPage page = new();
        if (origin is not null) page.socket.Options.SetRequestHeader("Origin", origin);
        using CancellationTokenSource limit = new(Patience);
        await page.socket.ConnectAsync(new UriBuilder(server.Address) { Scheme = "ws", Path = "/ws" }.Uri, limit.Token);
        byte[] welcome = await page.ReceiveAsync();
        Assert.Equal(ServerFrames.WelcomeLength, welcome.Length);
        Assert.Equal((byte)FrameKind.Welcome, welcome[0]);
        page.Id = BinaryPrimitives.ReadUInt32LittleEndian(welcome.AsSpan(2));
        return page;
    }

    public async Task SendAsync(params byte[] bytes) => await SendAsync(bytes, WebSocketMessageType.Binary);

    public async Task SendAsync(byte[] bytes, WebSocketMessageType type)
    {
        using CancellationTokenSource limit = new(Patience);
        await socket.SendAsync(bytes, type, true, limit.Token);
    }

    public async Task SendKeysAsync(PlayerKeys keys, uint sequence)
    {
        byte[] bytes = new byte[6];
        bytes[0] = (byte)FrameKind.Input;
        bytes[1] = (byte)keys;
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(2), sequence);
        await SendAsync(bytes);
    }

    /// <summary>The next frame, or none when the server closed.</summary>
    public async Task<byte[]> ReceiveAsync()
    {
        using CancellationTokenSource limit = new(Patience);
        ValueWebSocketReceiveResult result = await socket.ReceiveAsync(buffer.AsMemory(), limit.Token);
        return result.MessageType == WebSocketMessageType.Close ? [] : buffer[..result.Count];
    }

    /// <summary>The next frame of a kind that pleases.</summary>
    public async Task<byte[]> ReceiveAsync(FrameKind kind, Func<byte[], bool>? pleases = null)
    {
        while (true)
        {
            byte[] frame = await ReceiveAsync();
            Assert.NotEmpty(frame);
            if (frame[0] == (byte)kind && (pleases is null || pleases(frame))) return frame;
        }
    }

    public static uint SequenceOf(byte[] pose) => BinaryPrimitives.ReadUInt32LittleEndian(pose.AsSpan(8));

    public static float SpeedOf(byte[] pose) => BinaryPrimitives.ReadSingleLittleEndian(pose.AsSpan(68));

    public static uint CellOf(byte[] pose) => BinaryPrimitives.ReadUInt32LittleEndian(pose.AsSpan(20));

    public async Task CloseAsync()
    {
        using CancellationTokenSource limit = new(Patience);
        await socket.CloseAsync(WebSocketCloseStatus.NormalClosure, null, limit.Token);
    }

    /// <summary>Vanishes without a word.</summary>
    public void Abort() => socket.Abort();

    public ValueTask DisposeAsync()
    {
        socket.Dispose();
        return ValueTask.CompletedTask;
    }
}
