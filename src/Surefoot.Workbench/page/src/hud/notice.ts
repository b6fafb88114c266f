// A line that stays until the person puts it away.

import { element } from "./elements";

export class Notice {
  private readonly card = element("notice");
  private readonly text = this.card.querySelector("p") as HTMLElement;

  /** @param onHide the person has put it away */
  constructor(onHide: () => void) {
    this.card.querySelector("button")!.addEventListener("click", () => {
      this.card.hidden = true;
      onHide();
    });
  }

  /** The line, empty when none is shown. */
  get shown(): string {
    return this.card.hidden ? "" : (this.text.textContent ?? "");
  }

  show(text: string): void {
    this.text.textContent = text;
    this.card.hidden = false;
  }
}
