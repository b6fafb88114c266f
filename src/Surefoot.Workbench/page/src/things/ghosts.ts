// Where others are in truth: a ghost each, beside what is drawn of them by the messages that come.

import * as THREE from "three";
import { type Drawn, PoseTimeline } from "../net/timeline";
import { PoseFlag, type Truth, type Vec3 } from "../net/wire";
import { isIndoors } from "../net/world";

/** A player's size, metres. */
const human: Vec3 = { x: 0.7, y: 0.7, z: 1.83 };

interface Ghost {
  timeline: PoseTimeline;
  cell: number;
  drawn: Drawn | null;
  group: THREE.Group;
}

export class Ghosts {
  readonly group = new THREE.Group();
  private readonly all = new Map<number, Ghost>();
  private readonly trunk = new THREE.CylinderGeometry(0.5, 0.5, 1, 16).rotateX(Math.PI / 2).translate(0, 0, 0.5);
  private readonly nose = new THREE.ConeGeometry(0.12, 0.4, 8).translate(0, 0.6, 0.8);
  private readonly mist = new THREE.MeshBasicMaterial({ color: 0xff4fd8, transparent: true, opacity: 0.38, depthWrite: false, fog: false });

  /** Where they are as drawn in the last frame: global metres. */
  get places(): { body: number; position: Vec3 | null }[] {
    return [...this.all].map(([body, { drawn }]) => ({ body, position: drawn?.position ?? null }));
  }

  /**
   * Who is not listed is gone.
   * @param sizeOf extent of a body; null for a player
   */
  receive(frame: Truth, sizeOf: (body: number) => Vec3 | null): void {
    const here = new Set(frame.places.map(({ body }) => body));
    for (const id of [...this.all.keys()]) if (!here.has(id)) this.remove(id);
    for (const { body, cell, position, yaw } of frame.places) {
      const ghost = this.all.get(body) ?? this.add(body, sizeOf(body) ?? human);
      ghost.cell = cell;
      const still = { teleports: 0, flags: PoseFlag.Contact, velocity: { x: 0, y: 0, z: 0 }, charge: 0, forward: 0, sidestep: 0 };
      ghost.timeline.push({ time: frame.time, cell, position, yaw, ...still });
    }
  }

  clear(): void {
    for (const id of [...this.all.keys()]) this.remove(id);
  }

  /** @param outdoors those outdoors are drawn, too */
  update(time: number, origin: THREE.Vector3, outdoors: boolean): void {
    for (const ghost of this.all.values()) {
      ghost.drawn = ghost.timeline.at(time);
      ghost.group.visible = ghost.drawn !== null && (outdoors || isIndoors(ghost.cell));
      if (!ghost.drawn) continue;
      const { x, y, z } = ghost.drawn.position;
      ghost.group.position.set(x - origin.x, y - origin.y, z - origin.z);
      ghost.group.rotation.z = ghost.drawn.yaw;
    }
  }

  private add(body: number, size: Vec3): Ghost {
    const group = new THREE.Group();
    const trunk = new THREE.Mesh(this.trunk, this.mist);
    const nose = new THREE.Mesh(this.nose, this.mist);
    group.add(trunk, nose);
    group.scale.set(size.x, size.y, size.z);
    this.group.add(group);
    const ghost: Ghost = { timeline: new PoseTimeline(), cell: 0, drawn: null, group };
    this.all.set(body, ghost);
    return ghost;
  }

  private remove(body: number): void {
    const ghost = this.all.get(body);
    if (!ghost) return;
    this.all.delete(body);
    this.group.remove(ghost.group);
  }
}
