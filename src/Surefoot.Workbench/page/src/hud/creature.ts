// A creature that was chosen, and what it may be asked to do.

import type { BodyPose } from "../net/wire";
import { element } from "./elements";

export class CreatureCard {
  private readonly card = element("creature");
  private readonly name = this.card.querySelector("span") as HTMLElement;
  private body: number | null = null;

  /**
   * @param ask the creature is to do one of `Wish`
   * @param toGame gives the keyboard to the game
   */
  constructor(ask: (body: number, wish: number) => void, toGame: () => void) {
    // The game keeps the keyboard: were it to leave, what comes for that would push the card away from under the pointer.
    this.card.addEventListener("mousedown", (event) => event.preventDefault());
    this.card.addEventListener("click", ({ target }) => {
      const button = (target as HTMLElement).closest("button");
      if (!button || this.body === null) return;
      const { wish } = button.dataset;
      if (wish !== undefined) ask(this.body, Number(wish));
      this.hide();
      toGame();
    });
    this.card.addEventListener("keydown", ({ key }) => key === "Escape" && this.hide());
  }

  /** The creature that is chosen; null without one. */
  get chosen(): number | null {
    return this.body;
  }

  /** @param byKey the keyboard goes to what it may be asked */
  choose({ body, name }: BodyPose, byKey: boolean): void {
    this.body = body;
    this.name.textContent = name;
    this.card.hidden = false;
    if (byKey) (this.card.querySelector("button") as HTMLElement).focus();
  }

  hide(): void {
    this.body = null;
    this.card.hidden = true;
  }

  /** It goes with the creature. */
  update(near: (body: number) => boolean): void {
    if (this.body !== null && !near(this.body)) this.hide();
  }
}
