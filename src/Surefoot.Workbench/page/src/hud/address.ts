// Keeps the page's address up to date: it is a link to what one sees, for oneself after a reload and for others.

import { type Link, writeLink } from "../net/link";

/** Browsers refuse pages that rewrite their address without end. */
const writeEvery = 1000;

export class Address {
  private written = location.search;
  private timer = 0;
  private changed = false;

  /** @param link what the address is to say */
  constructor(private readonly link: () => Link) {}

  /** Something may have changed: written at once, or a second after the last time. */
  touch(): void {
    this.changed = true;
    if (this.timer === 0) this.write();
  }

  private write(): void {
    if (!this.changed) return;
    this.changed = false;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.write();
    }, writeEvery);
    const query = writeLink(this.link());
    if (query === this.written) return;
    this.written = query;
    history.replaceState(null, "", query === "" ? location.pathname : query);
  }
}
