// Poses come when the physics ticks; frames are drawn when the screen is ready. A timeline keeps the last poses and answers for any moment
// between them.

import { type Pose, PoseFlag, type Vec3 } from "./wire";
import { toGlobal } from "./world";

/** A player at a moment, in global metres. */
export interface Drawn {
  position: Vec3;
  yaw: number;
  velocity: Vec3;
  charge: number;
  airborne: boolean;
  inWater: boolean;
  forward: number;
  sidestep: number;
  teleports: number;
  /** A pose that should be known by now has not come: where this one is was guessed. */
  late: boolean;
}

interface Entry extends Drawn {
  time: number;
}

const keep = 32;
const longestGuess = 0.1;

/**
 * Seconds over which the drawn path is averaged. Retail hands out ground movement in whole animation frames, so that a runner's strides are
 * unequal; on screen that would be a shiver.
 */
export const smoothOver = 0.08;
const smoothSamples = 8;

export class PoseTimeline {
  private readonly entries: Entry[] = [];

  push(pose: Pose): void {
    const last = this.entries.at(-1);
    if (last && pose.time <= last.time && pose.teleports === last.teleports) return;
    if (last && pose.teleports !== last.teleports) this.entries.length = 0;
    this.entries.push({
      time: pose.time,
      position: toGlobal(pose.cell, pose.position),
      yaw: pose.yaw,
      velocity: pose.velocity,
      charge: pose.charge,
      airborne: (pose.flags & PoseFlag.Contact) === 0,
      inWater: (pose.flags & PoseFlag.InWater) !== 0,
      forward: pose.forward,
      sidestep: pose.sidestep,
      teleports: pose.teleports,
      late: false,
    });
    if (this.entries.length > keep) this.entries.shift();
  }

  /** The pose at a moment, its place and facing averaged over the poses around it. */
  at(time: number): Drawn | null {
    const middle = this.sample(time);
    if (!middle) return null;
    const position = { x: 0, y: 0, z: 0 };
    let turned = 0;
    for (let i = 0; i < smoothSamples; i++) {
      const near = this.sample(time + smoothOver * ((i + 0.5) / smoothSamples - 0.5)) ?? middle;
      position.x += near.position.x / smoothSamples;
      position.y += near.position.y / smoothSamples;
      position.z += near.position.z / smoothSamples;
      turned += wrapAngle(near.yaw - middle.yaw) / smoothSamples;
    }
    return { ...middle, position, yaw: middle.yaw + turned, late: this.entries[this.entries.length - 1].time < time + smoothOver / 2 };
  }

  /** Mean velocity of the last tenth of a second; a single tick's is uneven. */
  private recentVelocity(): Vec3 {
    const last = this.entries[this.entries.length - 1];
    const first = this.entries.find((one) => one.time >= last.time - longestGuess - 0.01) ?? last;
    const seconds = last.time - first.time;
    if (seconds <= 0 || first.airborne !== last.airborne) return last.velocity;
    const { position: a } = first;
    const { position: b } = last;
    return { x: (b.x - a.x) / seconds, y: (b.y - a.y) / seconds, z: (b.z - a.z) / seconds };
  }

  /**
   * The pose at a moment as it came: between two poses on the line that joins them; past the last one, onward at its velocity for a tenth
   * of a second at most.
   */
  private sample(time: number): Drawn | null {
    const entries = this.entries;
    if (entries.length === 0) return null;
    let after = entries.length;
    while (after > 0 && entries[after - 1].time > time) after--;
    if (after === 0) return entries[0];
    const a = entries[after - 1];
    if (after === entries.length) return onward(a, this.recentVelocity(), Math.min(time - a.time, longestGuess));
    const b = entries[after];
    return between(a, b, (time - a.time) / (b.time - a.time));
  }
}

function onward(from: Entry, v: Vec3, seconds: number): Drawn {
  const p = from.position;
  return { ...from, position: { x: p.x + v.x * seconds, y: p.y + v.y * seconds, z: p.z + (from.airborne ? v.z * seconds : 0) } };
}

function between(a: Entry, b: Entry, share: number): Drawn {
  const mix = (from: number, to: number): number => from + (to - from) * share;
  const mixVec = (from: Vec3, to: Vec3): Vec3 => ({ x: mix(from.x, to.x), y: mix(from.y, to.y), z: mix(from.z, to.z) });
  return {
    position: mixVec(a.position, b.position),
    yaw: a.yaw + wrapAngle(b.yaw - a.yaw) * share,
    velocity: mixVec(a.velocity, b.velocity),
    charge: b.charge >= a.charge ? mix(a.charge, b.charge) : b.charge,
    airborne: share < 0.5 ? a.airborne : b.airborne,
    inWater: share < 0.5 ? a.inWater : b.inWater,
    forward: b.forward,
    sidestep: b.sidestep,
    teleports: b.teleports,
    late: false,
  };
}

/** The same angle in (−π, π]. */
export function wrapAngle(angle: number): number {
  const turn = 2 * Math.PI;
  const rest = (((angle + Math.PI) % turn) + turn) % turn;
  return rest === 0 ? Math.PI : rest - Math.PI;
}

/**
 * Guesses the server's clock from when poses arrive. The fastest arrival of the last seconds is the best guess of the offset; how late the
 * others come sets how far behind to draw, so that two poses are there to draw between.
 */
export class ServerClock {
  private readonly arrivals: { at: number; offset: number }[] = [];
  private behind: number;
  private offset = Number.NaN;
  private lastTime = Number.NaN;

  constructor(private readonly quantum: number) {
    this.behind = quantum * 1.5 + smoothOver / 2;
  }

  /** A pose of server time `time` arrived at local time `now`, seconds both. */
  arrived(time: number, now: number): void {
    this.arrivals.push({ at: now, offset: now - time });
    while (this.arrivals[0].at < now - 3) this.arrivals.shift();
    const best = this.arrivals.reduce((least, one) => Math.min(least, one.offset), Infinity);
    const late = this.arrivals.reduce((most, one) => Math.max(most, one.offset), -Infinity) - best;
    this.offset = Number.isNaN(this.offset) || Math.abs(best - this.offset) > 0.25 ? best : this.offset + (best - this.offset) * 0.1;
    const wanted = Math.min(0.25, this.quantum * 1.25 + smoothOver / 2 + late);
    this.behind += (wanted - this.behind) * (wanted > this.behind ? 0.2 : 0.02);
  }

  /** Server time to draw at local time `now`; never runs backwards. */
  drawTime(now: number): number {
    const time = now - this.offset - this.behind;
    this.lastTime = time > this.lastTime || Number.isNaN(this.lastTime) || this.lastTime - time > 0.5 ? time : this.lastTime;
    return this.lastTime;
  }
}
