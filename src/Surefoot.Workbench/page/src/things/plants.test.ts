import { describe, expect, it } from "vitest";
import { kindOf } from "./plants";

describe("plants", () => {
  it("look like what their collision shape is good for", () => {
    const low = { x: 0, y: 0, z: 0 };
    expect(kindOf({ low, radius: 0.35, height: 4, round: false })).toBe("tree");
    expect(kindOf({ low, radius: 0.3, height: 5, round: false })).toBe("pine");
    expect(kindOf({ low, radius: 0.5, height: 1, round: true })).toBe("shrub");
  });
});
