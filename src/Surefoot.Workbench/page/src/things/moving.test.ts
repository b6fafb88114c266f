import * as THREE from "three";
import { describe, expect, it } from "vitest";
import type { MovingPart } from "../net/wire";
import { MovingParts } from "./moving";

const half = Math.SQRT1_2;
const part = (x: number, rotation: MovingPart["rotation"], scale = 1): MovingPart => ({
  block: 0xa8b5,
  object: 1,
  part: 2,
  position: { x, y: 0, z: 0 },
  rotation,
  scale,
});

describe("a part that an animation moves", () => {
  it("is drawn between the places it was told to be at", () => {
    const parts = new MovingParts();
    parts.receive({ kind: "moving", time: 1, parts: [part(10, [0, 0, 0, 1])] });
    parts.receive({ kind: "moving", time: 2, parts: [part(20, [0, half, 0, half], 3)] });
    const drawn = new THREE.Object3D();
    expect(parts.place(0xa8b5, 1, 2, 1.5, drawn)).toBe(true);
    expect(drawn.position.x).toBe(15);
    expect(drawn.scale.x).toBe(2);
    // Half of a quarter of a turn about y.
    expect(drawn.quaternion.y).toBeCloseTo(Math.sin(Math.PI / 8), 6);

    // Before the first and after the last it stands still.
    parts.place(0xa8b5, 1, 2, 0, drawn);
    expect(drawn.position.x).toBe(10);
    parts.place(0xa8b5, 1, 2, 9, drawn);
    expect(drawn.position.x).toBe(20);
  });

  it("is hidden when nothing is known of it", () => {
    const parts = new MovingParts();
    const drawn = new THREE.Object3D();
    parts.receive({ kind: "moving", time: 1, parts: [part(10, [0, 0, 0, 1])] });
    expect(parts.place(0xa8b5, 1, 3, 1, drawn)).toBe(false);
    expect(drawn.visible).toBe(false);
    expect(parts.place(0xa8b5, 1, 2, 1, drawn)).toBe(true);
    parts.receive({ kind: "moving", time: 2, parts: [] });
    expect(parts.place(0xa8b5, 1, 2, 1, drawn)).toBe(false);
    expect(parts.count).toBe(0);
  });
});
