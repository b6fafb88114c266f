// Where the parts of objects are that animations move, for any moment between the ticks that told it.

import * as THREE from "three";
import type { Moving, MovingPart } from "../net/wire";

/** Longer than the page draws behind the server. */
const keep = 16;

interface Entry {
  time: number;
  position: THREE.Vector3;
  rotation: THREE.Quaternion;
  scale: number;
}

export class MovingParts {
  private readonly told = new Map<string, Entry[]>();

  /** Everything is forgotten: another server speaks now. */
  clear(): void {
    this.told.clear();
  }

  /** Parts that are known. */
  get count(): number {
    return this.told.size;
  }

  /** What is not told of any more is far away, or gone. */
  receive(frame: Moving): void {
    const here = new Set(frame.parts.map(keyOf));
    for (const key of [...this.told.keys()]) if (!here.has(key)) this.told.delete(key);
    for (const part of frame.parts) {
      const entries = this.told.get(keyOf(part)) ?? [];
      const last = entries.at(-1);
      if (last && frame.time <= last.time) continue;
      const { x, y, z } = part.position;
      entries.push({
        time: frame.time,
        position: new THREE.Vector3(x, y, z),
        rotation: new THREE.Quaternion(...part.rotation),
        scale: part.scale,
      });
      if (entries.length > keep) entries.shift();
      this.told.set(keyOf(part), entries);
    }
  }

  /**
   * Puts a part of a landblock's object, drawn in that landblock's frame, where it is at a moment; false, and hidden, when nothing is known
   * of it.
   */
  place(block: number, object: number, part: number, time: number, drawn: THREE.Object3D): boolean {
    const entries = this.told.get(keyOf({ block, object, part }));
    drawn.visible = entries !== undefined;
    if (!entries) return false;
    let after = entries.length;
    while (after > 0 && entries[after - 1].time > time) after--;
    const a = entries[Math.max(after - 1, 0)];
    const b = entries[Math.min(after, entries.length - 1)];
    const share = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
    drawn.position.lerpVectors(a.position, b.position, share);
    drawn.quaternion.slerpQuaternions(a.rotation, b.rotation, share);
    drawn.scale.setScalar(a.scale + (b.scale - a.scale) * share);
    return true;
  }
}

function keyOf({ block, object, part }: Pick<MovingPart, "block" | "object" | "part">): string {
  return `${block}/${object}/${part}`;
}
