// Keyboard → the bits of an input frame.

import { Key } from "../net/wire";

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
  private readonly held = new Set<string>();
  private bits = 0;

  /**
   * @param onMove the bits held, whenever they change
   * @param onLost the keyboard went elsewhere: what was held counts as let go
   * @param onCommand a key that is not movement, by its code
   */
  constructor(
    private readonly onMove: (bits: number) => void,
    private readonly onLost: () => void,
    private readonly onCommand: (code: string) => void,
  ) {
    addEventListener("keydown", (event) => this.down(event));
    addEventListener("keyup", (event) => this.up(event));
    // A key released while another window has the focus is never reported.
    addEventListener("blur", () => this.releaseAll());
    document.addEventListener("visibilitychange", () => document.hidden && this.releaseAll());
  }

  releaseAll(): void {
    this.held.clear();
    this.bits = 0;
    this.onLost();
  }

  private down(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
    if (!(event.code in moves)) {
      if (!event.repeat) this.onCommand(event.code);
      return;
    }
    event.preventDefault();
    this.held.add(event.code);
    this.changed();
  }

  private up(event: KeyboardEvent): void {
    if (this.held.delete(event.code)) {
      event.preventDefault();
      this.changed();
    }
  }

  private changed(): void {
    let bits = 0;
    for (const code of this.held) bits |= moves[code];
    if (bits === this.bits) return;
    this.bits = bits;
    this.onMove(bits);
  }
}

function typing(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("textarea, select, input:not([type=range])"));
}
