// The way of the last walk, for the map. The server keeps what was done on it, counts the walks, and says them as commands.

import type { OwnPose, Vec3 } from "./wire";
import { toGlobal } from "./world";

/** The way is kept as points this far apart, metres; of a long one the beginning is thinned out. */
const pointEvery = 0.2;
const mostPoints = 3000;

/** Slower than this, and not turning, one stands: metres a second. */
const still = 0.01;

export class WalkPath {
  private points: Vec3[] = [];
  private length = 0;
  private last: OwnPose | null = null;
  private startedAt = 0;
  private endedAt = 0;

  /** The way from above, global metres. */
  get path(): readonly Vec3[] {
    return this.points;
  }

  /** Metres over ground. */
  get metres(): number {
    return this.length;
  }

  /** Seconds from where it began until the player stood, or to now. */
  get seconds(): number {
    return this.endedAt - this.startedAt;
  }

  receive(pose: OwnPose): void {
    const before = this.last;
    this.last = pose;
    if (!before || pose.walks !== before.walks || pose.teleports !== before.teleports)
      this.begin(before && pose.teleports === before.teleports ? before : pose);
    if (pose.speed >= still || pose.turn !== 0 || Math.abs(pose.velocity.z) >= still) this.endedAt = pose.time;
    this.follow(pose);
  }

  /** Another life, or another server. */
  clear(): void {
    this.last = null;
    this.points = [];
    this.length = 0;
  }

  private begin(from: OwnPose): void {
    this.points = [toGlobal(from.cell, from.position)];
    this.length = 0;
    this.startedAt = this.endedAt = from.time;
  }

  private follow(pose: OwnPose): void {
    const here = toGlobal(pose.cell, pose.position);
    const last = this.points[this.points.length - 1];
    const way = Math.hypot(here.x - last.x, here.y - last.y);
    if (way < pointEvery) return;
    this.length += way;
    this.points.push(here);
    if (this.points.length > mostPoints) this.points = this.points.filter((_, i) => i % 2 === 0);
  }
}
