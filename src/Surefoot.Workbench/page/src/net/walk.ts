// What the player did last: keys and how long, from where, and the way that came of it. It begins anew when the player sets off after a
// rest.

import { writeWalk } from "./walkCommand";
import { Key, type OwnPose, PoseFlag, type Settings, type Spot, type Touch, type Vec3 } from "./wire";
import { toGlobal } from "./world";

/** Standing still without a key for so long is a rest, seconds. */
export const restAfter = 1.5;

/** How long a body that stands is watched for its last quantum, seconds. */
const settle = 0.25;

/** The way is kept as points this far apart, metres; of a long one the beginning is thinned out. */
const pointEvery = 0.2;
const mostPoints = 3000;

/** Kinds of touch that are creatures, doors and players: the command's world is without them. */
const bodies = new Set([6, 7]);

/** Keys held, as an input frame says them, and from when on, seconds of the server's clock. */
interface Leg {
  keys: number;
  from: number;
}

/** What a person did, until a pose says that the server has taken it. */
interface Deed {
  sequence: number;
  held: number;
  /** Runs ahead without a key from now on, or no longer. */
  autoRun: boolean;
}

export class WalkRecord {
  private legs: Leg[] = [];
  private start: Spot | null = null;
  private settings: Settings | null = null;
  private points: Vec3[] = [];
  private length = 0;
  private pose: OwnPose | null = null;
  private deeds: Deed[] = [];
  private held = 0;
  private runsOn = false;
  private time = 0;
  private stillSince = 0;
  private endedAt = 0;
  /** Ticks of the server up to the first key, and up to the end. */
  private firstTick = 0;
  private lastTick = 0;
  private jump: number | null = null;
  private readonly missing = new Set<string>();
  /** What was done since a key whose effect has not come yet. */
  private readonly missingSoon = new Set<string>();

  /**
   * @param current the skills that hold now
   * @param dats folder of the files, to be named in the command; null for the demo world
   */
  constructor(
    private readonly current: () => Settings,
    private readonly dats: () => string | null,
  ) {}

  /** The way from above, global metres. */
  get path(): readonly Vec3[] {
    return this.points;
  }

  /** Metres over ground. */
  get metres(): number {
    return this.length;
  }

  /** Seconds from the first key to the rest, or to now. */
  get seconds(): number {
    return this.legs.length === 0 ? 0 : this.endedAt - this.legs[0].from;
  }

  /** What was done that no script of keys can say. */
  get leftOut(): readonly string[] {
    return [...this.missing];
  }

  /** The command that does the same; null before anything is known of the player. */
  get command(): string | null {
    const { start, settings } = this;
    if (!start || !settings) return null;
    const legs = this.legs.map(({ keys, from }, i) => ({ keys, seconds: (this.legs[i + 1]?.from ?? this.endedAt) - from }));
    return writeWalk(start, settings, legs, this.quantum, this.dats());
  }

  /** Mean quantum, seconds; null before there were any. */
  private get quantum(): number | null {
    const ticks = this.lastTick - this.firstTick;
    return ticks > 0 ? this.seconds / ticks : null;
  }

  /**
   * Keys are held from now on.
   * @param sequence of the input frame that says so
   */
  keys(held: number, sequence: number): void {
    this.deeds.push({ sequence, held, autoRun: false });
  }

  /** The player runs ahead without a key, or no longer; the keys are held as before. */
  autoRun(held: number, sequence: number): void {
    this.deeds.push({ sequence, held, autoRun: true });
  }

  /** Something was done that no script of keys can say. */
  miss(what: string): void {
    if (this.deeds.length > 0) this.missingSoon.add(what);
    else if (!this.isResting(this.time)) this.missing.add(what);
  }

  /** What the player touches now. */
  touch(touches: readonly Touch[]): void {
    if (touches.some(({ type }) => bodies.has(type))) this.miss("who was in the way");
  }

  /**
   * The player jumped: the server tells this before the pose that has taken it.
   * @param extent how far the jump was charged, 0 to 1; a second fills it
   */
  jumped(extent: number): void {
    this.jump = extent;
  }

  receive(pose: OwnPose): void {
    const placed = this.pose === null || pose.teleports !== this.pose.teleports;
    if (placed) {
      this.pose = pose;
      this.time = pose.time;
      this.runsOn = false;
      this.stillSince = pose.time;
      this.begin();
    }
    // What a pose is the first to have taken acted from the tick before on.
    while (this.deeds.length > 0 && isTaken(this.deeds[0].sequence, pose.sequence)) this.act(this.deeds.shift() as Deed);
    if (this.deeds.length === 0) {
      for (const what of this.missingSoon) this.missing.add(what);
      this.missingSoon.clear();
    }
    this.pose = pose;
    this.time = pose.time;
    this.follow(pose);
    const still = this.acting === 0 && pose.speed < 0.01 && (pose.flags & PoseFlag.Contact) !== 0 && Math.abs(pose.velocity.z) < 0.01;
    if (!still) this.stillSince = Number.POSITIVE_INFINITY;
    else if (this.stillSince === Number.POSITIVE_INFINITY) this.stillSince = pose.time;
    if (this.legs.length > 0 && (!still || pose.time - this.stillSince < settle)) {
      this.endedAt = pose.time;
      this.lastTick = pose.tick;
    }
  }

  /** Another life, or another server. */
  clear(): void {
    this.pose = null;
    this.start = null;
    this.legs = [];
    this.points = [];
    this.deeds = [];
    this.missingSoon.clear();
    this.held = 0;
    this.runsOn = false;
    this.jump = null;
  }

  /** The keys that act. */
  private get acting(): number {
    return this.legs.at(-1)?.keys ?? 0;
  }

  private act({ held, autoRun }: Deed): void {
    if (autoRun) this.runsOn = !this.runsOn;
    // A key that goes forward or back ends running without one.
    else if ((held & ~this.held & (Key.Forward | Key.Back)) !== 0) this.runsOn = false;
    this.held = held;
    const keys = held | (this.runsOn ? Key.Forward : 0);
    if (keys === this.acting) return;
    if (keys !== 0 && this.isResting(this.time)) this.begin();
    if (this.legs.length === 0) this.firstTick = this.pose?.tick ?? 0;
    if ((this.acting & ~keys & Key.Jump) !== 0) this.release();
    this.legs.push({ keys, from: this.time });
    this.endedAt = this.time;
    this.stillSince = Number.POSITIVE_INFINITY;
  }

  /** The jump key goes up now. It was charged from the moment of its key on, and not from a tick on: the leg before gives or takes. */
  private release(): void {
    const extent = this.jump;
    this.jump = null;
    if (extent === null) return;
    const { legs } = this;
    let at = legs.length - 1;
    while (at > 0 && (legs[at - 1].keys & Key.Jump) !== 0) at--;
    const from = this.time - extent;
    const charge = legs[at];
    if (extent === 1 && from >= charge.from) return;
    const without = charge.keys & ~Key.Jump;
    if (from > charge.from) {
      if (legs[at - 1]?.keys !== without) legs.splice(at, 0, { keys: without, from: charge.from });
      charge.from = Math.min(from, legs[legs.indexOf(charge) + 1]?.from ?? from);
    } else if (legs[at - 1]?.keys === without) {
      charge.from = Math.max(from, legs[at - 1].from);
    }
  }

  private isResting(now: number): boolean {
    return this.legs.length === 0 || now - this.stillSince >= restAfter;
  }

  private begin(): void {
    const { pose } = this;
    this.legs = [];
    this.points = [];
    this.length = 0;
    this.missing.clear();
    if (!pose) return;
    this.points = [toGlobal(pose.cell, pose.position)];
    this.start = { cell: pose.cell, ...pose.position, yaw: pose.yaw };
    this.settings = this.current();
  }

  private follow(pose: OwnPose): void {
    const here = toGlobal(pose.cell, pose.position);
    const last = this.points.at(-1);
    const way = last ? Math.hypot(here.x - last.x, here.y - last.y) : Number.POSITIVE_INFINITY;
    if (way < pointEvery) return;
    if (last) this.length += way;
    this.points.push(here);
    if (this.points.length > mostPoints) this.points = this.points.filter((_, i) => i % 2 === 0);
  }
}

/** Sequences are 32 bits and begin anew. */
function isTaken(sequence: number, taken: number): boolean {
  return ((taken - sequence) | 0) >= 0;
}
