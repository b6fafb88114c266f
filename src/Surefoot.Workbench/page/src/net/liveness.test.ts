import { describe, expect, it } from "vitest";
import { Liveness } from "./liveness";

/** Looks four times a second, as the page does. */
function lookUntil(liveness: Liveness, from: number, to: number): string {
  let seen = "";
  for (let now = from; now <= to; now += 250) seen = liveness.look(now);
  return seen;
}

describe("a server", () => {
  it("is lost within three seconds of its last word, and given up later", () => {
    const liveness = new Liveness(0);
    liveness.heard(1000);
    expect(lookUntil(liveness, 0, 2500)).toBe("well");
    expect(lookUntil(liveness, 2750, 4000)).toBe("quiet");
    expect(lookUntil(liveness, 4250, 10_000)).toBe("gone");
  });

  it("is back with its next word", () => {
    const liveness = new Liveness(0);
    expect(lookUntil(liveness, 0, 5000)).toBe("quiet");
    liveness.heard(5100);
    expect(liveness.look(5250)).toBe("well");
  });

  it("is not blamed for a page that slept", () => {
    const liveness = new Liveness(0);
    liveness.look(250);
    expect(liveness.look(60_000)).toBe("well");
    expect(lookUntil(liveness, 60_250, 62_500)).toBe("quiet");
  });
});
