// The list of keys. It takes the keyboard when it comes, and gives it back where it was when it goes.

import { element } from "./elements";
import { makeReachable, reach } from "./folds";

export class Help {
  private readonly dialog = element("help");
  private readonly button = element("toggle-help");
  private readonly body = this.dialog.querySelector(".body") as HTMLElement;
  private readonly close = this.dialog.querySelector("button") as HTMLElement;
  private cameFrom: HTMLElement | null = null;

  /** @param toGame gives the keyboard to the game */
  constructor(private readonly toGame: () => void) {
    makeReachable(this.body);
    this.button.addEventListener("click", () => this.toggle());
    this.close.addEventListener("click", () => this.toggle());
    this.dialog.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" && event.code !== "KeyH") return;
      event.preventDefault();
      this.toggle();
    });
  }

  get shown(): boolean {
    return !this.dialog.hidden;
  }

  toggle(): void {
    const shown = this.dialog.hidden;
    this.dialog.hidden = !shown;
    this.button.setAttribute("aria-expanded", String(shown));
    if (shown) {
      reach(this.body);
      this.cameFrom = document.activeElement as HTMLElement | null;
      this.close.focus();
    } else if (this.cameFrom === this.button) {
      this.button.focus();
    } else {
      this.toGame();
    }
  }
}
