import { describe, expect, it } from "vitest";
import type { Touch } from "../net/wire";
import { describeFooting, describeTouches } from "./touches";

const touch = (more: Partial<Touch>): Touch => ({
  footing: false,
  type: 3,
  id: 0xa8b50100,
  normal: { x: 0, y: 0, z: 1 },
  name: "",
  ...more,
});

describe("the panel's words", () => {
  it("name what is stood on, with its slope", () => {
    expect(describeFooting([touch({ footing: true })])).toBe("room 0xA8B50100\nslope 0.0°");
    expect(describeFooting([touch({ footing: true, type: 1, normal: { x: 0.5, y: 0, z: Math.sqrt(0.75) } })])).toBe(
      "ground 0xA8B50100\nslope 30.0°",
    );
    expect(describeFooting([touch({})])).toBe("nothing");
  });

  it("name what is touched, a body by its name", () => {
    const wall = touch({ normal: { x: 1, y: 0, z: 0 } });
    const guard = touch({ type: 6, id: 0x80000001, name: "guard-west", normal: { x: 0, y: 1, z: 0 } });
    expect(describeTouches([touch({ footing: true }), wall, guard])).toBe("room 0xA8B50100 90°\nguard-west 0x80000001 90°");
    expect(describeTouches([touch({ footing: true })])).toBe("nothing");
    expect(describeTouches([1, 2, 3, 4, 5, 6].map(() => wall)).split("\n")[4]).toBe("and 2 more");
  });
});
