// What the world does without because its files cannot be read: a line in the panel that opens to the list.

import { fetchLeftOut } from "../net/leftOut";

export class LeftOutPanel {
  private readonly details = document.getElementById("left-out") as HTMLDetailsElement;
  private readonly summary = this.details.querySelector("summary") as HTMLElement;
  private readonly list = this.details.querySelector("ul") as HTMLElement;
  private block = -1;

  /** The player is in this cell: a new landblock may have brought something to tell. */
  enter(cell: number): void {
    if (cell >>> 16 === this.block) return;
    this.block = cell >>> 16;
    void fetchLeftOut().then(({ total, lines }) => {
      this.details.hidden = total === 0;
      this.summary.textContent = `Left out of the world: ${total}`;
      this.list.replaceChildren(
        ...lines.map((line) => {
          const item = document.createElement("li");
          item.textContent = line;
          return item;
        }),
      );
    });
  }
}
