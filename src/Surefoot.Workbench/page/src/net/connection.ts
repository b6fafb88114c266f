// The socket: sends what the person asks, hands out what the server says, and comes back by itself when the server does.

import {
  decode,
  encodeAutoRun,
  encodeFocusLost,
  encodeGoto,
  encodeInput,
  encodeMouseTurning,
  encodePointer,
  encodeSettings,
  encodeUse,
  type ServerFrame,
  wireVersion,
} from "./wire";

export type ConnectionState = "connecting" | "open" | "lost" | "full";

export class Connection {
  /** Frames received since the page was opened. */
  frames = 0;

  private socket: WebSocket | null = null;
  private sequence = 0;
  private everOpen = false;

  constructor(
    private readonly onFrame: (frame: ServerFrame) => void,
    private readonly onState: (state: ConnectionState) => void,
  ) {}

  open(): void {
    this.onState(this.everOpen ? "lost" : "connecting");
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/ws`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.everOpen = true;
      this.onState("open");
    };
    socket.onmessage = (message) => this.receive(message.data as ArrayBuffer);
    socket.onclose = () => {
      this.socket = null;
      this.onState(this.everOpen ? "lost" : "full");
      setTimeout(() => this.open(), 1000);
    };
    this.socket = socket;
  }

  sendKeys(keys: number): void {
    this.sequence = (this.sequence + 1) >>> 0;
    this.send(encodeInput(keys, this.sequence));
  }

  sendSettings(runSkill: number, jumpSkill: number, burden: number): void {
    this.send(encodeSettings(runSkill, jumpSkill, burden));
  }

  sendGoto(place: number): void {
    this.send(encodeGoto(place));
  }

  sendUse(): void {
    this.send(encodeUse());
  }

  sendPointer(buttons: number, right: number): void {
    this.send(encodePointer(buttons, right));
  }

  sendMouseTurning(on: boolean): void {
    this.send(encodeMouseTurning(on));
  }

  sendAutoRun(): void {
    this.send(encodeAutoRun());
  }

  sendFocusLost(): void {
    this.send(encodeFocusLost());
  }

  /** Sends bytes as they are; for tests of the server. */
  sendRaw(bytes: ArrayBuffer): void {
    this.send(bytes);
  }

  private send(bytes: ArrayBuffer): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(bytes);
  }

  private receive(data: ArrayBuffer): void {
    const frame = decode(data);
    if (!frame) return;
    this.frames++;
    // A server that was updated while this page stayed open speaks other frames: fetch its page.
    if (frame.kind === "welcome" && frame.version !== wireVersion) location.reload();
    this.onFrame(frame);
  }
}
