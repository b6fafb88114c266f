using System.Net.WebSockets;
using Surefoot.Workbench.Hosting;
using Surefoot.Workbench.Tests.Support;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>One page's queues, against a socket that never lets anything through.</summary>
public sealed class ConnectionTests
{
    [Fact]
    [Behaviour("workbench.page.slow-reader-costs-no-memory", "design.md")]
    public async Task A_page_that_does_not_read_loses_its_oldest_frames_and_holds_no_more_than_a_bounded_queue()
    {
        using ServerCounters counters = new();
        using StuckSocket socket = new();
        PageConnection page = new(socket, counters, 1);
        using CancellationTokenSource stop = new();
        Task running = page.RunAsync(stop.Token);
        page.Welcome([1]);
        await Eventually.Holds(() => socket.Sends == 1, "the welcome is being sent");
        for (int i = 0; i < 1000; i++) page.Send([(byte)FrameKind.Pose]);
        Assert.Equal(1000 - 64, counters.Unsent);
        await stop.CancelAsync();
        await running;
    }

    private sealed class StuckSocket : WebSocket
    {
        private int sends;

        public int Sends => Volatile.Read(ref sends);

        public override WebSocketCloseStatus? CloseStatus => null;

        public override string? CloseStatusDescription => null;

        public override WebSocketState State => WebSocketState.Open;

        public override string? SubProtocol => null;

        public override void Abort()
        {
        }

        public override Task CloseAsync(WebSocketCloseStatus status, string? description, CancellationToken cancellation) =>
            Task.CompletedTask;

        public override Task CloseOutputAsync(WebSocketCloseStatus status, string? description, CancellationToken cancellation) =>
            Task.CompletedTask;

        public override void Dispose()
        {
        }

        public override async Task<WebSocketReceiveResult> ReceiveAsync(ArraySegment<byte> buffer, CancellationToken cancellation)
        {
            await Task.Delay(Timeout.Infinite, cancellation);
            throw new InvalidOperationException();
        }

        public override async Task SendAsync(ArraySegment<byte> buffer, WebSocketMessageType type, bool end, CancellationToken cancellation)
        {
            Interlocked.Increment(ref sends);
            await Task.Delay(Timeout.Infinite, cancellation);
        }
    }
}
