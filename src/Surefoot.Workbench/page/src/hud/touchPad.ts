// For fingers: a pad that moves the player, half way out at a walk, and a button that charges a jump while it is held.

import { Key } from "../net/wire";
import { element } from "./elements";
import type { Held } from "./held";

/** Shares of the pad's radius: nearer nothing moves, farther one runs. */
const still = 0.25;
const runs = 0.7;

export class TouchPad {
  private readonly pad = element("pad");
  private readonly knob = this.pad.firstElementChild as HTMLElement;
  private readonly jump = element("jump");

  constructor(private readonly held: Held) {
    if (matchMedia("(pointer: coarse)").matches) this.show();
    addEventListener("pointerdown", (event) => event.pointerType === "touch" && this.show());
    follow(this.pad, (event) => this.move(event));
    follow(this.jump, (event) => {
      this.jump.classList.toggle("held", event !== null);
      this.held.set("jump", event === null ? 0 : Key.Jump);
    });
  }

  private show(): void {
    document.body.classList.add("touch");
  }

  private move(event: PointerEvent | null): void {
    const box = this.pad.getBoundingClientRect();
    const radius = box.width / 2;
    const x = event === null ? 0 : (event.clientX - box.left) / radius - 1;
    const y = event === null ? 0 : 1 - (event.clientY - box.top) / radius;
    const out = Math.max(1, Math.hypot(x, y));
    this.knob.style.transform = `translate(${(x / out) * radius * 0.6}px, ${(-y / out) * radius * 0.6}px)`;
    this.held.set("pad", padKeys(x, y));
  }
}

/** The keys that a thumb at a point of the pad holds: x to the right, y up, 1 at the pad's rim. */
export function padKeys(x: number, y: number): number {
  const out = Math.hypot(x, y);
  if (out < still) return 0;
  let keys = out < runs ? Key.Walk : 0;
  // Eight directions: an axis counts from an eighth of a turn's half on.
  const least = out * Math.sin(Math.PI / 8);
  if (y > least) keys |= Key.Forward;
  if (y < -least) keys |= Key.Back;
  if (x > least) keys |= Key.TurnRight;
  if (x < -least) keys |= Key.TurnLeft;
  return keys;
}

/** Tells where a pointer is that went down on an element, and null when it is gone. The element takes no keyboard. */
function follow(surface: HTMLElement, tell: (event: PointerEvent | null) => void): void {
  surface.addEventListener("mousedown", (event) => event.preventDefault());
  surface.addEventListener("contextmenu", (event) => event.preventDefault());
  surface.addEventListener("pointerdown", (event) => {
    surface.setPointerCapture(event.pointerId);
    tell(event);
  });
  surface.addEventListener("pointermove", (event) => surface.hasPointerCapture(event.pointerId) && tell(event));
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) surface.addEventListener(end, () => tell(null));
}
