// Keyboard → the bits of an input frame. Keys play while the world has the keyboard; a control that has it keeps them.

import { Key } from "../net/wire";
import type { Focus } from "./focus";
import type { Held } from "./held";

const moves: Record<string, number> = {
  KeyW: Key.Forward,
  ArrowUp: Key.Forward,
  KeyS: Key.Back,
  ArrowDown: Key.Back,
  KeyA: Key.TurnLeft,
  ArrowLeft: Key.TurnLeft,
  KeyD: Key.TurnRight,
  ArrowRight: Key.TurnRight,
  KeyQ: Key.SidestepLeft,
  KeyE: Key.SidestepRight,
  ShiftLeft: Key.Walk,
  ShiftRight: Key.Walk,
  Space: Key.Jump,
};

export class Keyboard {
  private readonly down = new Set<string>();

  /**
   * @param focus who has the keyboard
   * @param held takes the bits of the keys that are down
   * @param onLost the keyboard went elsewhere: what was down counts as let go
   * @param onCommand a key that is not movement, by its code
   */
  constructor(
    private readonly focus: Focus,
    private readonly held: Held,
    private readonly onLost: () => void,
    private readonly onCommand: (code: string) => void,
  ) {
    addEventListener("keydown", (event) => this.pressed(event));
    addEventListener("keyup", (event) => this.released(event));
    // A key released while another window has the focus is never reported.
    addEventListener("blur", () => this.releaseAll());
    document.addEventListener("visibilitychange", () => document.hidden && this.releaseAll());
    focus.onLeave = () => this.releaseAll();
  }

  releaseAll(): void {
    this.down.clear();
    this.held.clear();
    this.onLost();
  }

  private pressed(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.focus.playing) return;
    if (!(event.code in moves)) {
      // A letter that opens a box is not to be written into it.
      if (event.code !== "Tab" && event.key.length === 1) event.preventDefault();
      if (!event.repeat) this.onCommand(event.code);
      return;
    }
    event.preventDefault();
    this.down.add(event.code);
    this.changed();
  }

  private released(event: KeyboardEvent): void {
    if (this.down.delete(event.code)) {
      event.preventDefault();
      this.changed();
    }
  }

  private changed(): void {
    let bits = 0;
    for (const code of this.down) bits |= moves[code];
    this.held.set("keyboard", bits);
  }
}
