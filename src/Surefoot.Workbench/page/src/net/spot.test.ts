import { describe, expect, it } from "vitest";
import { type Place, readDestination } from "./places";
import { formatSpot, parseSpot, single } from "./spot";

describe("a place in words", () => {
  it("is a cell and metres in the forms of the command", () => {
    const meadow = { cell: 0xa9b50032, x: 156, y: 24.5, z: 20, yaw: 0 };
    expect(parseSpot("0xA9B50032,156,24.5")).toEqual({ spot: { ...meadow, z: null } });
    expect(parseSpot(" a9b50032  156, 24.5 20 ")).toEqual({ spot: meadow });
    expect(parseSpot("0xA9B50032,156,24.5,20,90")).toEqual({ spot: { ...meadow, yaw: -Math.PI / 2 } });
    const printed = parseSpot("0xA9B50032 [156.000000 24.500000 20.000000] 0.707107 0.000000 0.000000 -0.707107");
    expect(printed).toMatchObject({ spot: { cell: 0xa9b50032, z: 20 } });
    expect("spot" in printed && printed.spot.yaw).toBeCloseTo(-Math.PI / 2, 6);
  });

  it("is refused with a reason when it is none", () => {
    for (const [text, reason] of [
      ["", "a cell and metres"],
      ["0xFFFFFFFFF,1,2,3", "a cell and metres"],
      ["0xA9B4FFFF,1,2,3", "cannot name a cell"],
      ["0xA9B40000,1,2,3", "cannot name a cell"],
      ["0xA9B40041,1,2,3", "cannot name a cell"],
      ["0xA9B40001,1,two,3", "two is not a finite number"],
      ["0xA9B40001,1,1e39,3", "1e39 is not a finite number"],
      ["0xA9B40001,NaN,1,3", "NaN is not a finite number"],
      ["0xA9B40001,1", "two, three or four"],
      ["0xA9B40001,1,2,3,4,5", "two, three or four"],
      ["0xA9B40100,1,2", "needs its height"],
      ["0xA9B40001,1,2,3,0,0,0,0", "the rotation has no length"],
    ])
      expect(parseSpot(text)).toEqual({ error: expect.stringContaining(reason) });
  });

  it("is written as it is read", () => {
    const spot = { cell: 0x01200100, x: Math.fround(96.005), y: -0.25, z: Math.fround(20.105), yaw: -Math.PI / 2 };
    expect(formatSpot(spot)).toBe("0x01200100,96.005,-0.25,20.105,90");
    expect(parseSpot(formatSpot(spot))).toEqual({ spot: { ...spot, x: 96.005, z: 20.105 } });
    expect(formatSpot({ ...spot, z: null })).toBe("0x01200100,96.005,-0.25");
  });

  it("has the shortest numbers that are the same in single precision", () => {
    for (const value of [0, 1, -1, 0.1, 16777216, 1 / 3, 188.2355, 1e-7, 3.4e38, -123.456]) {
      const text = single(value);
      expect(Math.fround(Number(text))).toBe(Math.fround(value));
    }
    expect(single(Math.fround(0.1))).toBe("0.1");
    expect(single(Math.fround(188.2355))).toBe("188.2355");
    expect(single(-0)).toBe("0");
  });

  it("may be the name of a place, in any case", () => {
    const places = [{ name: "The meadow" }, { name: "0xA9B40001,1,2" }] as Place[];
    expect(readDestination("the MEADOW ", places)).toEqual({ place: 0 });
    expect(readDestination("0xA9B40001,1,2", places)).toEqual({ place: 1 });
    expect(readDestination("0xA9B40001,1,3", places)).toMatchObject({ spot: { y: 3 } });
    expect(readDestination("the attic", places)).toEqual({ error: "there is no place of this name" });
  });
});
