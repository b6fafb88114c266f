// What the server said last, and its clock as guessed from when that came.

import { ServerClock } from "./timeline";
import type { OwnPose, PlayerEvent, ServerFrame, Touch, Welcome } from "./wire";

const keepEvents = 32;

export class Session {
  welcome: Welcome | null = null;
  pose: OwnPose | null = null;
  touches: Touch[] = [];
  readonly events: PlayerEvent[] = [];
  clock = new ServerClock(1 / 30);

  /** @param now seconds of this page's clock */
  receive(frame: ServerFrame, now: number): void {
    switch (frame.kind) {
      case "welcome":
        this.welcome = frame;
        this.clock = new ServerClock(frame.quantum);
        break;
      case "pose":
        this.pose = frame;
        this.clock.arrived(frame.time, now);
        break;
      case "touches":
        this.touches = frame.touches;
        break;
      case "event":
        this.events.push(frame);
        if (this.events.length > keepEvents) this.events.shift();
        break;
    }
  }
}
