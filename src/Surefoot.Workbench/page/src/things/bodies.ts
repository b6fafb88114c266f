// Bodies that are no players: guards, creatures, a crowd, doors. They come and go as the server lists them.

import * as THREE from "three";
import { type Drawn, PoseTimeline } from "../net/timeline";
import { type Bodies as BodiesFrame, BodyFlag, type BodyPose, BodyType, PoseFlag, type Vec3 } from "../net/wire";
import { isIndoors, toGlobal } from "../net/world";
import { Beast } from "./beast";
import { Crowd } from "./crowd";
import { Door } from "./door";
import { Figure } from "./figure";

/** How far a player reaches for a door, metres; the server decides. */
const reach = 4;

interface Body {
  pose: BodyPose;
  timeline: PoseTimeline;
  drawn: Drawn | null;
  look: Figure | Beast | Door | null;
  plain: THREE.LineSegments;
}

export class Bodies {
  readonly group = new THREE.Group();
  private readonly crowd = new Crowd();
  private readonly all = new Map<number, Body>();
  private readonly outline = new THREE.LineBasicMaterial({ color: 0x35e0ff });
  private crowdChanged = false;
  private plain = false;

  constructor() {
    this.group.add(this.crowd.group);
  }

  /** The outlines of collision shapes as well. */
  set showsPlain(shown: boolean) {
    this.plain = shown;
    for (const body of this.all.values()) body.plain.visible = shown;
  }

  /** All that are near, as last told. */
  get poses(): BodyPose[] {
    return [...this.all.values()].map((body) => body.pose);
  }

  /** People of the crowd drawn. */
  get crowdCount(): number {
    return this.crowd.count;
  }

  /** How far a door near by is swung open as drawn, 0 to 1; null without one. */
  get doorOpened(): number | null {
    for (const { look } of this.all.values()) if (look instanceof Door) return look.opened;
    return null;
  }

  /** The body with this id; null when it is not near. */
  find(id: number): BodyPose | null {
    return this.all.get(id)?.pose ?? null;
  }

  /**
   * The creature that a line of sight meets first; null when it meets none.
   * @param ray relative to the drawing's origin
   */
  creatureOn(ray: THREE.Ray, origin: THREE.Vector3): BodyPose | null {
    const met = new THREE.Vector3();
    let nearest = Number.POSITIVE_INFINITY;
    let found: BodyPose | null = null;
    for (const { pose, drawn } of this.all.values()) {
      if (pose.type === BodyType.Door) continue;
      const at = drawn?.position ?? toGlobal(pose.cell, pose.position);
      const feet = new THREE.Vector3(at.x - origin.x, at.y - origin.y, at.z - origin.z);
      const head = feet.clone().setZ(feet.z + pose.size.z);
      const half = Math.max(pose.size.x, pose.size.y) / 2;
      if (ray.distanceSqToSegment(feet, head, met) > half * half) continue;
      const away = ray.origin.distanceTo(met);
      if (away < nearest) [nearest, found] = [away, pose];
    }
    return found;
  }

  /** The creature nearest to a point of global metres, within this distance; null without one. */
  creatureNear(point: Vec3, within: number): BodyPose | null {
    let nearest = within;
    let found: BodyPose | null = null;
    for (const { pose } of this.all.values()) {
      if (pose.type === BodyType.Door) continue;
      const at = toGlobal(pose.cell, pose.position);
      const away = Math.hypot(at.x - point.x, at.y - point.y, at.z - point.z);
      if (away < nearest) [nearest, found] = [away, pose];
    }
    return found;
  }

  receive(frame: BodiesFrame): void {
    const here = new Set(frame.bodies.map((pose) => pose.body));
    for (const id of [...this.all.keys()]) if (!here.has(id)) this.remove(id);
    for (const pose of frame.bodies) {
      const known = this.all.get(pose.body);
      const body = known ?? this.add(pose);
      if (pose.type === BodyType.Crowd && (!known || !same(known.pose, pose))) this.crowdChanged = true;
      body.pose = pose;
      body.timeline.push({
        teleports: 0,
        flags: (pose.flags & BodyFlag.Airborne) === 0 ? PoseFlag.Contact | PoseFlag.OnWalkable : 0,
        time: frame.time,
        cell: pose.cell,
        position: pose.position,
        yaw: pose.yaw,
        velocity: pose.velocity,
        charge: 0,
        forward: 0,
        sidestep: 0,
      });
    }
  }

  /** Everybody goes: another server speaks now. */
  clear(): void {
    for (const id of [...this.all.keys()]) this.remove(id);
  }

  /** The drawing's origin moved. */
  rebased(): void {
    this.crowdChanged = true;
  }

  /** @param outdoors those outdoors are drawn, too */
  update(time: number, origin: THREE.Vector3, seconds: number, dt: number, outdoors: boolean): void {
    this.crowd.group.visible = outdoors;
    for (const body of this.all.values()) {
      if (!body.look) continue;
      body.drawn = body.timeline.at(time);
      body.look.group.visible = body.drawn !== null && (outdoors || isIndoors(body.pose.cell));
      if (!body.drawn) continue;
      if (body.look instanceof Door) body.look.update(body.drawn, origin, (body.pose.flags & BodyFlag.Open) !== 0, dt);
      else body.look.update(body.drawn, origin, seconds, dt);
    }
    if (this.crowdChanged) this.placeCrowd(origin);
    if (this.plain) for (const body of this.all.values()) placePlain(body, origin);
  }

  /** The door that a player at global metres would open or close, with what would happen; null without one. */
  doorAt(point: Vec3): { name: string; open: boolean } | null {
    let best = reach;
    let found: BodyPose | null = null;
    for (const { pose } of this.all.values()) {
      if (pose.type !== BodyType.Door) continue;
      const at = toGlobal(pose.cell, pose.position);
      const distance = Math.hypot(at.x - point.x, at.y - point.y, at.z - point.z);
      if (distance > best) continue;
      best = distance;
      found = pose;
    }
    return found && { name: found.name, open: (found.flags & BodyFlag.Open) !== 0 };
  }

  private placeCrowd(origin: THREE.Vector3): void {
    this.crowdChanged = false;
    const people = [...this.all.values()].filter(({ pose }) => pose.type === BodyType.Crowd);
    this.crowd.place(
      people.map(({ pose }) => {
        const { x, y, z } = toGlobal(pose.cell, pose.position);
        return { id: pose.body, x: x - origin.x, y: y - origin.y, z: z - origin.z, yaw: pose.yaw };
      }),
    );
  }

  private add(pose: BodyPose): Body {
    const plain = new THREE.LineSegments(outlineOf(pose), this.outline);
    plain.visible = this.plain;
    const body: Body = { pose, timeline: new PoseTimeline(), drawn: null, look: look(pose), plain };
    this.all.set(pose.body, body);
    if (body.look) this.group.add(body.look.group);
    this.group.add(plain);
    return body;
  }

  private remove(id: number): void {
    const body = this.all.get(id);
    if (!body) return;
    this.all.delete(id);
    if (body.pose.type === BodyType.Crowd) this.crowdChanged = true;
    if (body.look) {
      this.group.remove(body.look.group);
      body.look.dispose();
    }
    this.group.remove(body.plain);
    body.plain.geometry.dispose();
  }
}

/** What a body looks like; the crowd is drawn together. */
function look(pose: BodyPose): Figure | Beast | Door | null {
  switch (pose.type) {
    case BodyType.Guard:
      return new Figure(pose.body, pose.name, "guard");
    case BodyType.Wanderer:
      return new Beast(pose.name, pose.size);
    case BodyType.Door:
      return new Door(pose.size);
    default:
      return null;
  }
}

function outlineOf({ type, size }: BodyPose): THREE.BufferGeometry {
  const solid =
    type === BodyType.Door
      ? new THREE.BoxGeometry(size.x, size.y, size.z)
      : new THREE.CylinderGeometry(size.x / 2, size.x / 2, size.z, 12).rotateX(Math.PI / 2);
  return new THREE.EdgesGeometry(solid.translate(0, 0, size.z / 2));
}

function placePlain({ pose, plain }: Body, origin: THREE.Vector3): void {
  const { x, y, z } = toGlobal(pose.cell, pose.position);
  plain.position.set(x - origin.x, y - origin.y, z - origin.z);
  plain.rotation.z = pose.yaw;
}

function same(a: BodyPose, b: BodyPose): boolean {
  const { position: p } = a;
  const { position: q } = b;
  return a.cell === b.cell && p.x === q.x && p.y === q.y && p.z === q.z && a.yaw === b.yaw;
}
