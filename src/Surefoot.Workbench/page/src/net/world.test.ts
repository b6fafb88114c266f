import { describe, expect, it } from "vitest";
import { formatCell, heightInBlock, type TerrainBlock, toGlobal } from "./world";

// One raised corner: vertex (1, 1) is at 24 m, all others at 0.
const peak = (cut: number): TerrainBlock => {
  const heights = new Float32Array(81);
  heights[10] = 24;
  return { block: 0, heights, words: new Uint16Array(81), cuts: new Uint8Array(64).fill(cut) };
};

describe("ground height", () => {
  it("follows the triangles of a cell cut SW–NE", () => {
    expect(heightInBlock(peak(1), 12, 12)).toBeCloseTo(12, 6);
    expect(heightInBlock(peak(1), 20, 4)).toBeCloseTo(4, 6);
  });

  it("follows the triangles of a cell cut SE–NW", () => {
    expect(heightInBlock(peak(0), 12, 12)).toBeCloseTo(0, 6);
    expect(heightInBlock(peak(0), 18, 18)).toBeCloseTo(12, 6);
  });
});

describe("ids", () => {
  it("place a landblock's metres on the map", () => {
    expect(toGlobal(0xa9b40025, { x: 1, y: 2, z: 3 })).toEqual({ x: 0xa9 * 192 + 1, y: 0xb4 * 192 + 2, z: 3 });
    expect(formatCell(0xa9b40025)).toBe("0xA9B40025");
  });
});
