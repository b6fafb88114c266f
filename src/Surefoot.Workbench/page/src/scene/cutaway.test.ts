import * as THREE from "three";
import { describe, expect, it } from "vitest";
import { Cutaway } from "./cutaway";

const house = { min: new THREE.Vector3(0, 0, 0), max: new THREE.Vector3(8, 12, 6.5) };
const at = (x: number, y: number, z: number): THREE.Vector3 => new THREE.Vector3(x, y, z);

describe("the cutaway", () => {
  it("opens the shell around a player indoors, also in a cellar, and leaves out the floors above", () => {
    const cutaway = new Cutaway();
    cutaway.update(at(4, -2, 2), at(4, 3, 0.1), true, 3, [house]);
    expect(cutaway.opens).toBe(1);
    expect(cutaway.ceiling).toBeCloseTo(2.7, 6);
    cutaway.update(at(4, -2, -1), at(4, 3, -3.2), true, -0.2, [house]);
    expect(cutaway.opens).toBe(1);
  });

  it("opens a building that only the camera is in, and none otherwise", () => {
    const cutaway = new Cutaway();
    cutaway.update(at(4, 3, 2), at(4, -3, 0), false, null, [house]);
    expect(cutaway.opens).toBe(2);
    cutaway.update(at(4, -8, 2), at(4, -3, 0), false, null, [house]);
    expect(cutaway.opens).toBe(0);
    expect(cutaway.ceiling).toBeGreaterThan(1e6);
    cutaway.update(at(4, 3, 9), at(4, 6, 6.5), false, null, [house]);
    expect(cutaway.opens).toBe(0);
  });

  it("does nothing while it is off", () => {
    const cutaway = new Cutaway();
    cutaway.enabled = false;
    cutaway.update(at(4, -2, 2), at(4, 3, 0.1), true, 3, [house]);
    expect(cutaway.opens).toBe(0);
    expect(cutaway.ceiling).toBeGreaterThan(1e6);
  });
});
