// Pointer → the buttons and movement of a pointer frame, while its right button turns the player.

import { Button } from "../net/wire";

const both = Button.Left | Button.Right;

export class Pointer {
  /** The right button turns the player; else it looks around, as the left one does. */
  turnsPlayer = true;
  private held = 0;

  /**
   * @param surface where a button must go down to count; whoever draws there captures the pointer
   * @param onChange the buttons held, and counts to the right: when one of them changed
   */
  constructor(
    private readonly surface: HTMLElement,
    private readonly onChange: (buttons: number, right: number) => void,
  ) {
    for (const kind of ["pointerdown", "pointermove", "pointerup", "pointercancel", "lostpointercapture"] as const) {
      surface.addEventListener(kind, (event) => this.handle(event));
    }
  }

  private handle(event: PointerEvent): void {
    if (!this.turnsPlayer) return;
    const buttons = this.surface.hasPointerCapture(event.pointerId) ? event.buttons & both : 0;
    const right = event.type === "pointermove" && (buttons & Button.Right) !== 0 ? event.movementX : 0;
    if (buttons === this.held && right === 0) return;
    this.held = buttons;
    this.onChange(buttons, right);
  }
}
