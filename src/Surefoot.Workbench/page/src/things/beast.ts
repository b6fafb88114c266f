// A creature on four legs that fills its collision shape. Its legs go as fast as it does.

import * as THREE from "three";
import type { Drawn } from "../net/timeline";
import type { Vec3 } from "../net/wire";
import { disposeMeshes, matte } from "./meshes";
import { disposeNameTag, makeNameTag } from "./nameTag";

/** Higher than this it is scaly and horned, metres. */
const largeFrom = 1.5;

export class Beast {
  readonly group = new THREE.Group();
  private readonly body = new THREE.Group();
  private readonly head = new THREE.Group();
  private readonly tail = new THREE.Group();
  private readonly legs: THREE.Group[] = [];
  private readonly tag: THREE.Sprite;
  private readonly legLength: number;
  private phase = 0;
  private pace = 0;

  /**
   * @param name shown over its back
   * @param size of its collision shape, metres
   */
  constructor(name: string, size: Vec3) {
    const large = size.z > largeFrom;
    const hide = matte(large ? 0x4f6b4a : 0x9a7146);
    const belly = matte(large ? 0x8d9a6a : 0xc6a676);
    const dark = matte(large ? 0x2f3f2d : 0x4d3621);
    const bone = matte(0xe2d9c0);
    const width = size.x;
    const height = size.z;
    this.legLength = height * 0.42;

    const length = width * 1.5;
    this.body.position.z = this.legLength + height * 0.22;
    this.body.add(lump(width * 0.72, length, height * 0.5, hide, 0, 0, 0));
    this.body.add(lump(width * 0.56, length * 0.86, height * 0.34, belly, 0, 0, -height * 0.09));
    this.body.add(lump(width * 0.66, length * 0.42, height * 0.5, hide, 0, length * 0.26, height * 0.06));
    this.head.position.set(0, length * 0.5, height * 0.2);
    this.head.add(lump(width * 0.4, width * 0.55, height * 0.27, hide, 0, width * 0.12, 0));
    this.head.add(lump(width * 0.26, width * 0.36, height * 0.17, belly, 0, width * 0.36, -height * 0.03));
    for (const side of [-1, 1]) {
      this.head.add(lump(width * 0.06, width * 0.05, width * 0.06, dark, side * width * 0.14, width * 0.32, height * 0.05));
      const ear = new THREE.Mesh(
        new THREE.ConeGeometry(width * (large ? 0.07 : 0.08), height * (large ? 0.3 : 0.2), 7).rotateX(Math.PI / 2),
        large ? bone : dark,
      );
      ear.position.set(side * width * 0.16, width * 0.05, height * 0.2);
      ear.rotation.y = side * 0.5;
      this.head.add(ear);
    }
    this.body.add(this.head);
    if (large) {
      for (let i = 0; i < 5; i++) {
        const plate = new THREE.Mesh(new THREE.ConeGeometry(width * 0.07, height * 0.16, 5).rotateX(Math.PI / 2), bone);
        plate.position.set(0, length * (0.3 - i * 0.16), height * 0.29);
        this.body.add(plate);
      }
    }
    this.tail.position.set(0, -length * 0.46, height * 0.08);
    const tail = new THREE.Mesh(new THREE.ConeGeometry(width * 0.1, length * 0.55, 8).rotateZ(Math.PI), hide);
    tail.position.y = -length * 0.24;
    this.tail.add(tail);
    this.body.add(this.tail);
    for (const [x, y] of [
      [-1, 1],
      [1, 1],
      [-1, -1],
      [1, -1],
    ]) {
      const leg = new THREE.Group();
      leg.position.set(x * width * 0.22, y * length * 0.3, this.legLength * 1.1);
      const shank = new THREE.Mesh(new THREE.CapsuleGeometry(width * 0.09, this.legLength * 0.82, 4, 10).rotateX(Math.PI / 2), hide);
      shank.position.z = -this.legLength * 0.55;
      leg.add(shank, lump(width * 0.2, width * 0.26, this.legLength * 0.2, dark, 0, width * 0.04, -this.legLength));
      this.legs.push(leg);
      this.group.add(leg);
    }
    this.group.add(this.body);
    this.group.traverse((one) => (one.castShadow = true));
    this.tag = makeNameTag(name);
    this.tag.position.z = height + 0.5;
    this.group.add(this.tag);
  }

  /** Poses it for a moment; `origin` is what drawn positions are relative to. */
  update(drawn: Drawn, origin: THREE.Vector3, seconds: number, dt: number): void {
    this.group.position.set(drawn.position.x - origin.x, drawn.position.y - origin.y, drawn.position.z - origin.z);
    this.group.rotation.z = drawn.yaw;
    const speed = drawn.airborne ? 0 : Math.hypot(drawn.velocity.x, drawn.velocity.y);
    this.pace += (speed - this.pace) * (1 - Math.exp(-8 * dt));
    // Two strides of its legs' length a turn of the phase.
    this.phase = (this.phase + (this.pace * dt * Math.PI) / (this.legLength * 1.6)) % (2 * Math.PI);
    const moving = Math.min(1, this.pace / 0.8);
    for (const [i, leg] of this.legs.entries()) leg.rotation.x = Math.sin(this.phase + (i === 0 || i === 3 ? 0 : Math.PI)) * 0.55 * moving;
    const bob = Math.abs(Math.sin(this.phase)) * 0.04 * this.legLength * moving;
    this.body.position.z = this.legLength * 1.52 + bob;
    this.head.rotation.x = Math.sin(seconds * 0.9) * 0.08 * (1 - moving) + Math.sin(this.phase * 2) * 0.05 * moving;
    this.head.rotation.z = Math.sin(seconds * 0.5) * 0.3 * (1 - moving);
    this.tail.rotation.z = Math.sin(seconds * 1.8) * 0.3;
  }

  dispose(): void {
    disposeNameTag(this.tag);
    disposeMeshes(this.group);
  }
}

function lump(width: number, length: number, height: number, material: THREE.Material, x: number, y: number, z: number): THREE.Mesh {
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(0.5, 18, 12).scale(width, length, height), material);
  mesh.position.set(x, y, z);
  return mesh;
}
