import { describe, expect, it } from "vitest";
import { edgesOf } from "./edges";

const endsOf = (triangles: Float32Array): Float32Array => edgesOf(triangles).ends;

/** Two triangles of an upright wall at y = 0. */
const wall = (left: number, right: number, low: number, high: number): number[] => [
  ...[left, 0, low, right, 0, low, right, 0, high],
  ...[left, 0, low, right, 0, high, left, 0, high],
];

/** Whether an edge with these ends, on the wall, is among them. */
function has(edges: Float32Array, a: [number, number], b: [number, number]): boolean {
  for (let at = 0; at < edges.length; at += 6) {
    const ends = [`${edges[at]},${edges[at + 2]}`, `${edges[at + 3]},${edges[at + 5]}`];
    if (ends.includes(a.join()) && ends.includes(b.join())) return true;
  }
  return false;
}

describe("edges of shapes", () => {
  it("are the outline of a face, and not the cut through it", () => {
    const edges = endsOf(new Float32Array(wall(0, 4, 0, 3)));
    expect(edges.length / 6).toBe(4);
    expect(has(edges, [0, 0], [4, 3])).toBe(false);
  });

  it("frame a doorway, and leave out the seams of the wall around it", () => {
    const edges = endsOf(new Float32Array([...wall(0, 1, 0, 3), ...wall(2, 3, 0, 3), ...wall(1, 2, 2, 3)]));
    expect(has(edges, [1, 2], [2, 2])).toBe(true);
    expect(has(edges, [1, 2], [1, 3])).toBe(false);
    // The jamb is the lower part of a side that goes on as a seam.
    expect(has(edges, [1, 0], [1, 2])).toBe(true);
    expect(has(edges, [2, 0], [2, 2])).toBe(true);
    expect(has(edges, [0, 0], [0, 3])).toBe(true);
  });

  it("are where faces meet at an angle", () => {
    const floor = [0, 0, 0, 4, 0, 0, 4, 4, 0];
    const ramp = (rise: number): number[] => [0, 0, 0, 4, 0, 0, 4, -4, rise];
    expect(has(endsOf(new Float32Array([...floor, ...ramp(4)])), [0, 0], [4, 0])).toBe(true);
    expect(endsOf(new Float32Array([...floor, 4, 0, 0, 0, 0, 0, 4, -4, 0.1])).length / 6).toBe(4);
  });

  it("know the faces that meet at them", () => {
    const { faceA, faceB } = edgesOf(new Float32Array([0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 0, 0, 4, 0, 0, 4, 0, 4]));
    const first = [faceA.slice(0, 3), faceB.slice(0, 3)].map((face) => [...face].map((one) => one + 0).join());
    expect(first.sort()).toEqual(["0,-1,0", "0,0,1"]);
  });
});
