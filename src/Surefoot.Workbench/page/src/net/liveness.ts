// Tells a server that is busy from one that is lost. A server with players says something thirty times a second.

/** Silence after which the server counts as lost, milliseconds. */
export const quietAfter = 2000;

/** Silence after which the connection is given up for a new one, milliseconds. */
export const giveUpAfter = 8000;

/** A page that was asleep this long, milliseconds, has not listened: its silence says nothing of the server. */
const sleptAfter = 1500;

export class Liveness {
  private heardAt: number;
  private lookedAt: number;

  /** @param now milliseconds of a clock that only goes forward */
  constructor(now: number) {
    this.heardAt = this.lookedAt = now;
  }

  /** Something came. */
  heard(now: number): void {
    this.heardAt = now;
  }

  /** To be asked several times a second. */
  look(now: number): "well" | "quiet" | "gone" {
    if (now - this.lookedAt > sleptAfter) this.heardAt = now;
    this.lookedAt = now;
    const silence = now - this.heardAt;
    return silence >= giveUpAfter ? "gone" : silence >= quietAfter ? "quiet" : "well";
  }
}
