// Who has the keyboard: the game, or a control of the page. A control keeps it until the person goes back to the game.

import { element } from "./elements";

export class Focus {
  /** The game has lost the keyboard to a control. */
  onLeave: () => void = () => {};

  private readonly back = element("back");
  private wasPlaying = true;

  /** @param surface the world, which takes the keyboard when it is clicked */
  constructor(private readonly surface: HTMLElement) {
    surface.tabIndex = 0;
    this.back.addEventListener("click", () => this.toGame());
    addEventListener("focusin", () => this.look());
    // From one control to another nothing changes: the way back, which may be the other, stays.
    addEventListener("focusout", ({ relatedTarget }) => relatedTarget ?? queueMicrotask(() => this.look()));
    addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !event.defaultPrevented && !this.playing) this.toGame();
    });
    this.toGame();
  }

  /** Keys play. */
  get playing(): boolean {
    const { activeElement } = document;
    return activeElement === null || activeElement === document.body || activeElement === this.surface;
  }

  toGame(): void {
    this.surface.focus({ preventScroll: true });
    this.look();
  }

  private look(): void {
    const { playing } = this;
    if (playing === this.wasPlaying) return;
    this.wasPlaying = playing;
    this.back.hidden = playing;
    if (!playing) this.onLeave();
  }
}
