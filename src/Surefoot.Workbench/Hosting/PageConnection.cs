using System.Net.WebSockets;
using System.Threading.Channels;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Hosting;

/// <summary>
/// One page's socket. What comes in is checked and queued for the world loop, what the loop says is queued for the page. Both queues are
/// bounded and lose their oldest entry when full: the newest keys and the newest pose are the ones that matter, and neither a flood nor a
/// page that does not read costs memory.
/// </summary>
internal sealed class PageConnection
{
    private const int InboxLength = 128;
    private const int OutboxLength = 64;
    private static readonly TimeSpan SendLimit = TimeSpan.FromSeconds(10);

    private readonly WebSocket socket;
    private readonly ServerCounters counters;
    private readonly int placeCount;
    private readonly Channel<ClientFrame> inbox;
    private readonly Channel<byte[]> outbox;
    private readonly TaskCompletionSource<byte[]> welcome = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public PageConnection(WebSocket socket, ServerCounters counters, int placeCount)
    {
        this.socket = socket;
        this.counters = counters;
        this.placeCount = placeCount;
        inbox = Channel.CreateBounded<ClientFrame>(
            new BoundedChannelOptions(InboxLength)
            {
                FullMode = BoundedChannelFullMode.DropOldest,
                SingleReader = true,
                SingleWriter = true,
            },
            _ => counters.CountOverflowed());
        outbox = Channel.CreateBounded<byte[]>(
            new BoundedChannelOptions(OutboxLength)
            {
                FullMode = BoundedChannelFullMode.DropOldest,
                SingleReader = true,
                SingleWriter = true,
            },
            _ => counters.CountUnsent());
    }

    /// <summary>The next checked frame that the page sent.</summary>
    public bool TryTake(out ClientFrame frame) => inbox.Reader.TryRead(out frame);

    /// <summary>The first frame, which no later one overtakes or displaces.</summary>
    public void Welcome(byte[] frame) => welcome.TrySetResult(frame);

    /// <summary>Queues a frame for the page.</summary>
    public void Send(byte[] frame) => outbox.Writer.TryWrite(frame);

    /// <summary>Ends the connection from the server's side, after what is queued.</summary>
    public void End()
    {
        outbox.Writer.TryComplete();
        welcome.TrySetCanceled();
    }

    /// <summary>Runs until the page goes, the server stops, or <see cref="End"/>.</summary>
    public async Task RunAsync(CancellationToken stopping)
    {
        using CancellationTokenSource ended = CancellationTokenSource.CreateLinkedTokenSource(stopping);
        Task sending = SendAsync(ended.Token);
        Task receiving = ReceiveAsync(ended.Token);
        await Task.WhenAny(sending, receiving).ConfigureAwait(false);
        await CloseAsync().ConfigureAwait(false);
        await ended.CancelAsync().ConfigureAwait(false);
        await Settle(sending).ConfigureAwait(false);
        await Settle(receiving).ConfigureAwait(false);
    }

    private static async Task Settle(Task task)
    {
        try
        {
            await task.ConfigureAwait(false);
        }
        catch (Exception gone) when (gone is OperationCanceledException or WebSocketException or IOException or ObjectDisposedException)
        {
            // A page that vanishes mid-frame is as usual as one that says goodbye.
        }
    }

    private async Task SendAsync(CancellationToken ended)
    {
        await SendOne(await welcome.Task.WaitAsync(ended).ConfigureAwait(false), ended).ConfigureAwait(false);
        await foreach (byte[] frame in outbox.Reader.ReadAllAsync(ended).ConfigureAwait(false))
            await SendOne(frame, ended).ConfigureAwait(false);
    }

    private async Task SendOne(byte[] frame, CancellationToken ended)
    {
        using CancellationTokenSource limit = CancellationTokenSource.CreateLinkedTokenSource(ended);
        limit.CancelAfter(SendLimit);
        await socket.SendAsync(frame.AsMemory(), WebSocketMessageType.Binary, endOfMessage: true, limit.Token).ConfigureAwait(false);
        counters.CountSent();
    }

    private async Task ReceiveAsync(CancellationToken ended)
    {
        // One byte more than the longest frame, so that a longer message shows without being kept.
        byte[] buffer = new byte[WireLimits.LongestClientFrame + 1];
        while (true)
        {
            int length = 0;
            bool tooLong = false;
            ValueWebSocketReceiveResult part;
            do
            {
                if (length == buffer.Length)
                {
                    tooLong = true;
                    length = 0;
                }

                part = await socket.ReceiveAsync(buffer.AsMemory(length), ended).ConfigureAwait(false);
                if (part.MessageType == WebSocketMessageType.Close) return;
                length += part.Count;
            }
            while (!part.EndOfMessage);

            counters.CountReceived();
            bool whole = !tooLong && length <= WireLimits.LongestClientFrame && part.MessageType == WebSocketMessageType.Binary;
            if (whole && ClientFrame.TryParse(buffer.AsSpan(0, length), placeCount, out ClientFrame frame)) inbox.Writer.TryWrite(frame);
            else counters.CountMalformed();
        }
    }

    private async Task CloseAsync()
    {
        using CancellationTokenSource limit = new(TimeSpan.FromSeconds(1));
        try
        {
            if (socket.State is WebSocketState.Open or WebSocketState.CloseReceived)
                await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, null, limit.Token).ConfigureAwait(false);
        }
        catch (Exception gone) when (
            gone is OperationCanceledException or WebSocketException or IOException or ObjectDisposedException or InvalidOperationException)
        {
            socket.Abort();
        }
    }
}
