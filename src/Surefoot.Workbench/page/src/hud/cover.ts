// What lies over the world while there is none to play in: at the beginning, and when the server is lost.

import type { ConnectionState } from "../net/connection";
import { element, say } from "./elements";

/** Why the world is covered: the connection's state, or dark: the graphics card is gone. */
export type CoverState = ConnectionState | "dark";

const texts: Record<CoverState, [string, string]> = {
  connecting: ["Connecting…", ""],
  open: ["Loading the land…", ""],
  lost: [
    "The workbench is not answering",
    "What you see is the last picture. It goes on by itself as soon as the server is back; if the server was stopped, " +
      "start it again with ./play or surefoot play.",
  ],
  dark: [
    "The picture is lost",
    "The browser took the graphics card away: the machine slept, its driver started anew, or too many pages draw. " +
      "It goes on by itself when the browser gives it back; if it does not, reload the page.",
  ],
  full: ["No way in yet", "The workbench lets no more players in, or is gone. Trying again…"],
};

export class Cover {
  private readonly cover = element("cover");
  private readonly title = this.cover.querySelector("h2") as HTMLElement;
  private readonly text = this.cover.querySelector("p") as HTMLElement;

  /** Why the world is covered; null when it is not. */
  get shown(): CoverState | null {
    return this.cover.classList.contains("away") ? null : (this.cover.dataset.state as CoverState);
  }

  show(state: CoverState): void {
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
