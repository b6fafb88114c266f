// What lies over the world while there is none to play in: at the beginning, and when the server is lost.

import type { ConnectionState } from "../net/connection";
import { element, say } from "./elements";

const texts: Record<ConnectionState, [string, string]> = {
  connecting: ["Connecting…", ""],
  open: ["Loading the land…", ""],
  lost: [
    "The workbench is not answering",
    "What you see is the last picture. It goes on by itself as soon as the server is back; if the server was stopped, start it again with ./play or surefoot play.",
  ],
  full: ["No way in yet", "The workbench lets no more players in, or is gone. Trying again…"],
};

export class Cover {
  private readonly cover = element("cover");
  private readonly title = this.cover.querySelector("h2") as HTMLElement;
  private readonly text = this.cover.querySelector("p") as HTMLElement;

  /** Is it away? */
  get shown(): ConnectionState | null {
    return this.cover.classList.contains("away") ? null : (this.cover.dataset.state as ConnectionState);
  }

  show(state: ConnectionState): void {
    if (this.shown === state) return;
    const [title, text] = texts[state];
    say(this.title, title);
    say(this.text, text);
    this.cover.dataset.state = state;
    this.cover.classList.remove("away");
    this.cover.removeAttribute("aria-hidden");
  }

  lift(): void {
    if (this.shown === null) return;
    this.cover.classList.add("away");
    this.cover.setAttribute("aria-hidden", "true");
  }
}
