import { describe, expect, it } from "vitest";
import { decodeShapes } from "./shapes";

// One triangle of an object, none of rocks, one shell of one triangle, one room of two, one tree, part 2 of object 3 that moves, of one.
function sample(): ArrayBuffer {
  const view = new DataView(new ArrayBuffer(24 + 2 * 8 + 24 + 8 + 5 * 36));
  [1, 0, 1, 1, 1, 1, 0x01000100, 1, 0xa9b40100, 2].forEach((value, i) => void view.setUint32(i * 4, value, true));
  [1, 2, 3, 0.5, 4].forEach((value, i) => void view.setFloat32(40 + i * 4, value, true));
  [0x00020003, 1].forEach((value, i) => void view.setUint32(64 + i * 4, value, true));
  for (let i = 0; i < 45; i++) view.setFloat32(72 + i * 4, i, true);
  return view.buffer;
}

describe("shapes of a landblock", () => {
  it("are read group by group", () => {
    const shapes = decodeShapes(sample())!;
    expect([...shapes.objects]).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    expect(shapes.rocks.length).toBe(0);
    expect(shapes.shells.map((one) => [one.id, one.triangles[0], one.triangles.length])).toEqual([[0x01000100, 9, 9]]);
    expect(shapes.rooms.map((one) => [one.id, one.triangles[0], one.triangles.length])).toEqual([[0xa9b40100, 18, 18]]);
    expect(shapes.moving.map((one) => [one.object, one.part, one.triangles[0], one.triangles.length])).toEqual([[3, 2, 36, 9]]);
    expect(shapes.plants).toEqual([{ low: { x: 1, y: 2, z: 3 }, radius: 0.5, height: 4, round: false }]);
  });

  it("are refused when the length is wrong", () => {
    const whole = sample();
    for (let length = 0; length < whole.byteLength; length++) expect(decodeShapes(whole.slice(0, length))).toBeNull();
  });
});
