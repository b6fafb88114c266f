// The socket: sends what the person asks, hands out what the server says, and comes back by itself when the server does.

import { Liveness } from "./liveness";
import { decode, type ServerFrame, wireVersion } from "./wire";

/** Lost: the server was there and has said nothing for a while, or the socket has broken. */
export type ConnectionState = "connecting" | "open" | "lost" | "full";

const lookEvery = 100;
const retryAfter = 1000;

export class Connection {
  /** Frames received since the page was opened. */
  frames = 0;

  private socket: WebSocket | null = null;
  private liveness = new Liveness(performance.now());
  private everOpen = false;
  private told: ConnectionState = "connecting";

  constructor(
    private readonly onFrame: (frame: ServerFrame) => void,
    private readonly onState: (state: ConnectionState) => void,
  ) {}

  get state(): ConnectionState {
    return this.told;
  }

  open(): void {
    setInterval(() => this.look(), lookEvery);
    this.dial();
  }

  send(bytes: ArrayBuffer): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(bytes);
  }

  private dial(): void {
    this.tell(this.everOpen ? "lost" : "connecting");
    this.liveness = new Liveness(performance.now());
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/ws`);
    socket.binaryType = "arraybuffer";
    socket.onmessage = (message) => this.receive(message.data as ArrayBuffer);
    socket.onclose = () => this.closed();
    this.socket = socket;
  }

  /** The socket is no use any more: another one is tried. */
  private closed(): void {
    const { socket } = this;
    if (!socket) return;
    socket.onmessage = socket.onclose = null;
    socket.close();
    this.socket = null;
    this.tell(this.everOpen ? "lost" : "full");
    setTimeout(() => this.dial(), retryAfter);
  }

  private look(): void {
    const seen = this.liveness.look(performance.now());
    if (seen === "gone") this.closed();
    else if (seen === "quiet" && this.told === "open") this.tell("lost");
  }

  private receive(data: ArrayBuffer): void {
    this.liveness.heard(performance.now());
    const frame = decode(data);
    if (!frame) return;
    this.frames++;
    // A server that was updated while this page stayed open speaks other frames: fetch its page.
    if (frame.kind === "welcome" && frame.version !== wireVersion) location.reload();
    this.everOpen = true;
    this.tell("open");
    this.onFrame(frame);
  }

  private tell(state: ConnectionState): void {
    if (state === this.told) return;
    this.told = state;
    this.onState(state);
  }
}
