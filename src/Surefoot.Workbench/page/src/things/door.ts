// A door: a panel of the size of its collision shape, hung at its left edge. Open, it stands aside, where it stops nobody.

import * as THREE from "three";
import type { Drawn } from "../net/timeline";
import type { Vec3 } from "../net/wire";
import { disposeMeshes, matte } from "./meshes";

const openAngle = 1.75;

export class Door {
  readonly group = new THREE.Group();
  private readonly hinge = new THREE.Group();
  private angle = 0;

  /** @param size of its collision shape, metres */
  constructor(size: Vec3) {
    const wood = matte(0x7a5230);
    const dark = matte(0x54371f);
    const iron = matte(0x33363a);
    const put = (width: number, depth: number, height: number, material: THREE.Material, x: number, z: number): void => {
      const box = new THREE.Mesh(new THREE.BoxGeometry(width, depth, height), material);
      box.position.set(x, 0, z);
      box.castShadow = box.receiveShadow = true;
      this.hinge.add(box);
    };
    const boards = 5;
    for (let i = 0; i < boards; i++) {
      const width = size.x / boards;
      put(width - 0.012, size.y, size.z - 0.02, i % 2 === 0 ? wood : dark, (i + 0.5) * width, size.z / 2);
    }
    for (const z of [0.16, 0.5, 0.84]) put(size.x * 0.96, size.y + 0.03, 0.09, iron, size.x / 2, size.z * z);
    const knob = new THREE.Mesh(new THREE.TorusGeometry(0.07, 0.017, 8, 18).rotateX(Math.PI / 2), iron);
    for (const side of [-1, 1]) {
      const ring = knob.clone();
      ring.position.set(size.x * 0.88, side * (size.y / 2 + 0.04), size.z * 0.45);
      this.hinge.add(ring);
    }
    this.hinge.position.x = -size.x / 2;
    this.group.add(this.hinge);
  }

  /** How far it is swung open, 0 to 1. */
  get opened(): number {
    return this.angle / openAngle;
  }

  update(drawn: Drawn, origin: THREE.Vector3, open: boolean, dt: number): void {
    this.group.position.set(drawn.position.x - origin.x, drawn.position.y - origin.y, drawn.position.z - origin.z);
    this.group.rotation.z = drawn.yaw;
    this.angle += ((open ? openAngle : 0) - this.angle) * (1 - Math.exp(-9 * dt));
    if (!open && this.angle < 0.002) this.angle = 0;
    this.hinge.rotation.z = this.angle;
  }

  dispose(): void {
    disposeMeshes(this.group);
  }
}
