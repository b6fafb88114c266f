// A line that stays until the person puts it away.

import { element } from "./elements";

export class Notice {
  private readonly card = element("notice");
  private readonly text = this.card.querySelector("p") as HTMLElement;

  constructor() {
    this.card.querySelector("button")!.addEventListener("click", () => this.hide());
  }

  /** The line, empty when none is shown. */
  get shown(): string {
    return this.card.hidden ? "" : (this.text.textContent ?? "");
  }

  show(text: string): void {
    this.text.textContent = text;
    this.card.hidden = false;
  }

  private hide(): void {
    this.card.hidden = true;
  }
}
