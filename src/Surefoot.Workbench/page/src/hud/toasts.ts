// Short messages that go by themselves: what happened to the player.

import { placeRefusals } from "../net/entrance";
import { EventKind, type PlayerEvent } from "../net/wire";
import { element } from "./elements";

// Errors of the motion interpreter, as it numbers them.
const jumpRefusals: Record<number, string> = {
  0x24: "You are not on the ground.",
  0x47: "You cannot jump now.",
  0x48: "You cannot jump from this position.",
  0x49: "You carry too much to jump.",
};

const most = 3;

// Milliseconds; style/messages.css fades as long.
const showFor = 2600;
const hintFor = 7000;

export class Toasts {
  private readonly toasts = element("toasts");

  show(text: string, look: "" | "refused" | "hint" = ""): void {
    const line = document.createElement("p");
    line.textContent = text;
    line.className = look;
    // By the clock, and not when an animation ends: there may be none.
    setTimeout(() => line.remove(), look === "hint" ? hintFor : showFor);
    this.toasts.append(line);
    while (this.toasts.childElementCount > most) this.toasts.firstElementChild!.remove();
  }

  showEvent(event: PlayerEvent): void {
    switch (event.event) {
      case EventKind.Jumped:
        this.show(`Jumped at ${Math.round(event.value * 100)} %`);
        break;
      case EventKind.Landed:
        if (event.value > 3) this.show(`Landed at ${event.value.toFixed(1)} m/s`);
        break;
      case EventKind.JumpRefused:
        this.show(jumpRefusals[event.code] ?? `Refused (0x${event.code.toString(16)})`, "refused");
        break;
      case EventKind.RunRateChanged:
        this.show(`Run rate ${event.value.toFixed(3)}: ${(event.value * 4).toFixed(2)} m/s`);
        break;
      case EventKind.PlaceRefused:
        this.show(`You cannot be there: ${placeRefusals[event.code] ?? "nobody can"}.`, "refused");
        break;
    }
  }
}
