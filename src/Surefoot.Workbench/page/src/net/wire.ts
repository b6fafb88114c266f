// The frames between this page and the server; `Wire/` in the server's source says the same. All numbers are little-endian.

export const wireVersion = 8;

export const Key = {
  Forward: 1,
  Back: 2,
  TurnLeft: 4,
  TurnRight: 8,
  SidestepLeft: 16,
  SidestepRight: 32,
  Walk: 64,
  Jump: 128,
} as const;

/** The pointer's buttons, as the browser numbers them. */
export const Button = { Left: 1, Right: 2 } as const;

export const PoseFlag = {
  Contact: 1,
  OnWalkable: 2,
  Charging: 4,
  StandingLongJump: 8,
  InWater: 16,
  Nowhere: 32,
  Enclosed: 64,
} as const;

export const EventKind = { Jumped: 1, Landed: 2, JumpRefused: 3, RunRateChanged: 4, PlaceRefused: 5 } as const;

export interface Vec3 {
  x: number;
  y: number;
  z: number;
}

/** Somewhere to be: metres in the landblock of the cell, without a height on the ground; radians, counter-clockwise from north. */
export interface Spot {
  cell: number;
  x: number;
  y: number;
  z: number | null;
  yaw: number;
}

/** What a person moves sliders for; burden in burden units. */
export interface Settings {
  runSkill: number;
  jumpSkill: number;
  burden: number;
}

/** How bad the network is over which the page hears of others: milliseconds, milliseconds both ways, percent. */
export interface Network {
  delay: number;
  jitter: number;
  loss: number;
}

export interface Welcome extends Settings {
  kind: "welcome";
  version: number;
  player: number;
  burdenCapacity: number;
  maxSkill: number;
  maxBurden: number;
  places: number;
  /** Seconds from one tick to the next. */
  quantum: number;
}

/**
 * What both one's own pose and another player's say. Position: metres in the landblock of `cell`. Yaw: radians, counter-clockwise from
 * north.
 */
export interface Pose {
  teleports: number;
  flags: number;
  time: number;
  cell: number;
  position: Vec3;
  yaw: number;
  velocity: Vec3;
  charge: number;
  forward: number;
  sidestep: number;
}

export interface OwnPose extends Pose {
  kind: "pose";
  tick: number;
  sequence: number;
  planeNormal: Vec3;
  planeDistance: number;
  speed: number;
  quantum: number;
  runRate: number;
  command: number;
  turn: number;
  players: number;
  /** Counts walks begun, modulo 256. */
  walks: number;
}

export interface OtherPose extends Pose {
  player: number;
}

export interface Others {
  kind: "others";
  time: number;
  players: OtherPose[];
}

export const BodyType = { Guard: 1, Wanderer: 2, Crowd: 3, Door: 4 } as const;

/** What a creature may be asked to do. */
export const Wish = { AsItLikes: 0, Follow: 1, Flee: 2, Stand: 3 } as const;

export const BodyFlag = { Open: 1, WaitsToClose: 2, Airborne: 4 } as const;

/** A body that is no player. Size: extent of its collision shape along its own axes, metres. */
export interface BodyPose {
  body: number;
  type: number;
  flags: number;
  name: string;
  cell: number;
  position: Vec3;
  yaw: number;
  velocity: Vec3;
  scale: number;
  size: Vec3;
}

/** All the bodies near the player. */
export interface Bodies {
  kind: "bodies";
  time: number;
  bodies: BodyPose[];
}

/** Something the player stands on (`footing`) or touches. The normal points from it to the player. */
export interface Touch {
  footing: boolean;
  type: number;
  id: number;
  normal: Vec3;
  name: string;
}

export interface Touches {
  kind: "touches";
  touches: Touch[];
}

/** A part of an object that an animation moves, after a tick: metres in its landblock. */
export interface MovingPart {
  block: number;
  object: number;
  part: number;
  position: Vec3;
  /** Quaternion: x, y, z, w. */
  rotation: [number, number, number, number];
  scale: number;
}

/** All such parts near the player. */
export interface Moving {
  kind: "moving";
  time: number;
  parts: MovingPart[];
}

export interface PlayerEvent {
  kind: "event";
  event: number;
  time: number;
  value: number;
  code: number;
}

/** Where a body is in truth, or another player. */
export interface TruePlace {
  body: number;
  cell: number;
  position: Vec3;
  yaw: number;
}

/** Where all those are in truth of which the page hears by messages; empty when that is no longer asked for. */
export interface Truth {
  kind: "truth";
  time: number;
  places: TruePlace[];
}

/** What the player did last: a command that does the same, and what was done besides; empty when that is nothing. */
export interface Walk {
  kind: "walk";
  command: string;
  leftOut: string;
}

/** Something that the person should read. */
export interface Sentence {
  kind: "sentence";
  text: string;
}

export type ServerFrame = Welcome | OwnPose | Others | PlayerEvent | Bodies | Touches | Moving | Walk | Truth | Sentence;

const lengths = {
  welcome: 30,
  pose: 103,
  othersHeader: 11,
  other: 52,
  event: 18,
  bodiesHeader: 11,
  body: 56,
  touchesHeader: 2,
  touch: 20,
  movingHeader: 11,
  moving: 40,
  walkHeader: 9,
  truthHeader: 11,
  truePlace: 24,
  sentenceHeader: 5,
};

/** Reads a frame of the server; null for one this page does not know. */
export function decode(buffer: ArrayBuffer): ServerFrame | null {
  const read = new Reader(buffer);
  if (buffer.byteLength === 0) return null;
  switch (read.u8()) {
    case 0x81:
      return buffer.byteLength === lengths.welcome ? decodeWelcome(read) : null;
    case 0x82:
      return buffer.byteLength === lengths.pose ? decodePose(read) : null;
    case 0x83:
      return buffer.byteLength >= lengths.othersHeader ? decodeOthers(read, buffer.byteLength) : null;
    case 0x84:
      return buffer.byteLength === lengths.event ? decodeEvent(read) : null;
    case 0x85:
      return buffer.byteLength >= lengths.bodiesHeader ? decodeBodies(read) : null;
    case 0x86:
      return buffer.byteLength >= lengths.touchesHeader ? decodeTouches(read) : null;
    case 0x87:
      return buffer.byteLength >= lengths.movingHeader ? decodeMoving(read, buffer.byteLength) : null;
    case 0x88:
      return buffer.byteLength >= lengths.walkHeader ? decodeWalk(read) : null;
    case 0x89:
      return buffer.byteLength >= lengths.truthHeader ? decodeTruth(read, buffer.byteLength) : null;
    case 0x8a:
      return buffer.byteLength >= lengths.sentenceHeader ? decodeSentence(read) : null;
    default:
      return null;
  }
}

function decodeWelcome(read: Reader): Welcome {
  return {
    kind: "welcome",
    version: read.u8(),
    player: read.u32(),
    runSkill: read.u16(),
    jumpSkill: read.u16(),
    burden: read.u32(),
    burdenCapacity: read.u32(),
    maxSkill: read.u16(),
    maxBurden: read.u32(),
    places: read.u16(),
    quantum: read.f32(),
  };
}

function decodePose(read: Reader): OwnPose {
  return {
    kind: "pose",
    teleports: read.u8(),
    flags: read.u16(),
    tick: read.u32(),
    sequence: read.u32(),
    time: read.f64(),
    cell: read.u32(),
    position: read.vec3(),
    yaw: read.f32(),
    velocity: read.vec3(),
    planeNormal: read.vec3(),
    planeDistance: read.f32(),
    speed: read.f32(),
    charge: read.f32(),
    quantum: read.f32(),
    runRate: read.f32(),
    command: read.u32(),
    forward: read.f32(),
    sidestep: read.f32(),
    turn: read.f32(),
    players: read.u16(),
    walks: read.u8(),
  };
}

function decodeOthers(read: Reader, length: number): Others | null {
  const time = read.f64();
  const count = read.u16();
  if (length !== lengths.othersHeader + count * lengths.other) return null;
  const players: OtherPose[] = [];
  for (let i = 0; i < count; i++) {
    const player = read.u32();
    const teleports = read.u8();
    read.u8();
    const flags = read.u16();
    const charge = read.f32();
    const cell = read.u32();
    const position = read.vec3();
    const yaw = read.f32();
    const velocity = read.vec3();
    players.push({ player, teleports, flags, time, charge, cell, position, yaw, velocity, forward: read.f32(), sidestep: read.f32() });
  }
  return { kind: "others", time, players };
}

function decodeBodies(read: Reader): Bodies | null {
  const time = read.f64();
  const count = read.u16();
  const bodies: BodyPose[] = [];
  for (let i = 0; i < count; i++) {
    if (read.left < lengths.body) return null;
    const body = read.u32();
    const type = read.u8();
    const flags = read.u8();
    const nameLength = read.u8();
    read.u8();
    const cell = read.u32();
    const position = read.vec3();
    const yaw = read.f32();
    const velocity = read.vec3();
    const scale = read.f32();
    const size = read.vec3();
    if (read.left < nameLength) return null;
    bodies.push({ body, type, flags, name: read.text(nameLength), cell, position, yaw, velocity, scale, size });
  }
  return read.left === 0 ? { kind: "bodies", time, bodies } : null;
}

function decodeTouches(read: Reader): Touches | null {
  const count = read.u8();
  const touches: Touch[] = [];
  for (let i = 0; i < count; i++) {
    if (read.left < lengths.touch) return null;
    const footing = read.u8() !== 0;
    const type = read.u8();
    const nameLength = read.u8();
    read.u8();
    const id = read.u32();
    const normal = read.vec3();
    if (read.left < nameLength) return null;
    touches.push({ footing, type, id, normal, name: read.text(nameLength) });
  }
  return read.left === 0 ? { kind: "touches", touches } : null;
}

function decodeMoving(read: Reader, length: number): Moving | null {
  const time = read.f64();
  const count = read.u16();
  if (length !== lengths.movingHeader + count * lengths.moving) return null;
  const parts: MovingPart[] = [];
  for (let i = 0; i < count; i++) {
    const block = read.u16();
    const object = read.u16();
    const part = read.u16();
    read.u16();
    const position = read.vec3();
    const rotation: MovingPart["rotation"] = [read.f32(), read.f32(), read.f32(), read.f32()];
    parts.push({ block, object, part, position, rotation, scale: read.f32() });
  }
  return { kind: "moving", time, parts };
}

function decodeEvent(read: Reader): PlayerEvent {
  return { kind: "event", event: read.u8(), time: read.f64(), value: read.f32(), code: read.u32() };
}

function decodeWalk(read: Reader): Walk | null {
  const command = read.u32();
  const leftOut = read.u32();
  if (read.left !== command + leftOut) return null;
  return { kind: "walk", command: read.text(command), leftOut: read.text(leftOut) };
}

function decodeSentence(read: Reader): Sentence | null {
  const length = read.u32();
  return read.left === length ? { kind: "sentence", text: read.text(length) } : null;
}

function decodeTruth(read: Reader, length: number): Truth | null {
  const time = read.f64();
  const count = read.u16();
  if (length !== lengths.truthHeader + count * lengths.truePlace) return null;
  const places: TruePlace[] = [];
  for (let i = 0; i < count; i++) places.push({ body: read.u32(), cell: read.u32(), position: read.vec3(), yaw: read.f32() });
  return { kind: "truth", time, places };
}

const utf8 = new TextDecoder();

class Reader {
  private readonly view: DataView;
  private at = 0;

  constructor(buffer: ArrayBuffer) {
    this.view = new DataView(buffer);
  }

  /** Bytes not yet read. */
  get left(): number {
    return this.view.byteLength - this.at;
  }

  text(length: number): string {
    this.at += length;
    return utf8.decode(new Uint8Array(this.view.buffer, this.at - length, length));
  }

  u8(): number {
    return this.view.getUint8(this.at++);
  }

  u16(): number {
    this.at += 2;
    return this.view.getUint16(this.at - 2, true);
  }

  u32(): number {
    this.at += 4;
    return this.view.getUint32(this.at - 4, true);
  }

  f32(): number {
    this.at += 4;
    return this.view.getFloat32(this.at - 4, true);
  }

  f64(): number {
    this.at += 8;
    return this.view.getFloat64(this.at - 8, true);
  }

  vec3(): Vec3 {
    return { x: this.f32(), y: this.f32(), z: this.f32() };
  }
}
