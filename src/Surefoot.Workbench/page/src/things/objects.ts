// Objects, buildings, rooms and scenery around the player: the shapes that bodies collide with, plants drawn as plants unless the plain
// shapes are asked for.

import * as THREE from "three";
import { decodeShapes, type MovingShape, type NamedShape, type Shapes } from "../net/shapes";
import { blockSide } from "../net/world";
import type { Box, Cutaway } from "../scene/cutaway";
import { MovingParts } from "./moving";
import { type PlantGroups, Plants } from "./plants";
import { Solids } from "./solids";

const drawRadius = 3;
const keepRadius = 5;
const fetchesAtOnce = 3;

/** How light rooms are: to eyes that are used to their dusk, and from outdoors, where doorways are dark and are seen to be open. */
const roomFromInside = 1.8;
const roomFromOutside = 0.3;

/** Landblocks farther than this have plants of a few triangles. */
const leafyRadius = 1;

interface Block {
  group: THREE.Group;
  /** Rocks as rocks. */
  rocks: THREE.Group;
  plants: PlantGroups;
  shells: Bounds[];
  moving: { shape: MovingShape; drawn: THREE.Group }[];
  /** By cell. */
  rooms: Map<number, Bounds>;
}

/** A box in the landblock, and relative to the drawing's origin. */
interface Bounds {
  low: THREE.Box3;
  world: Box;
}

/** A part that an animation moves, as drawn: in metres of its landblock, turned by a quaternion (x, y, z, w). */
export interface MovingDrawn {
  block: number;
  object: number;
  part: number;
  position: THREE.Vector3Tuple;
  rotation: THREE.Vector4Tuple;
}

export class Objects {
  readonly group = new THREE.Group();
  /** Where the parts are that animations move. */
  readonly moving = new MovingParts();
  private readonly solids: Solids;
  private readonly plants: Plants;
  private readonly blocks = new Map<number, Block | "none" | "asked">();
  private asked = 0;
  private retryAt = 0;
  private center = -1;
  private originX = 0;
  private originY = 0;
  private plain = false;

  constructor(cutaway: Cutaway) {
    this.solids = new Solids(cutaway);
    this.plants = new Plants(cutaway, this.solids.plain);
  }

  /** Triangles drawn. */
  get triangles(): number {
    let sum = 0;
    this.group.traverseVisible((one) => {
      if (!(one instanceof THREE.Mesh)) return;
      const geometry = one.geometry as THREE.BufferGeometry;
      const corners = geometry.index?.count ?? geometry.getAttribute("position").count;
      sum += (corners / 3) * (one instanceof THREE.InstancedMesh ? one.count : 1);
    });
    return sum;
  }

  /** Plants that are drawn as plants. */
  get plantCount(): number {
    let sum = 0;
    if (!this.plain)
      for (const block of this.loaded()) for (const one of block.plants.near.children) sum += (one as THREE.InstancedMesh).count;
    return sum;
  }

  /** Plain collision shapes instead of plants and rocks. */
  get showsPlain(): boolean {
    return this.plain;
  }

  set showsPlain(shown: boolean) {
    this.plain = shown;
    this.chooseAll();
  }

  /**
   * What of the world one sees from where one is.
   * @param feet the player's feet, relative to the drawing's origin
   * @param indoors the player is in a room
   * @param enclosed no land is seen from there: nothing but that room's landblock is drawn
   */
  seeFrom(feet: THREE.Vector3, indoors: boolean, enclosed: boolean, dt: number): void {
    const wanted = indoors ? roomFromInside : roomFromOutside;
    const { look } = this.solids;
    look.light.value += (wanted - look.light.value) * (1 - Math.exp(-7 * dt));
    look.from.value.copy(feet);
    for (const [id, block] of this.blocks) if (typeof block === "object") block.group.visible = !enclosed || id === this.center;
  }

  setOrigin(blockX: number, blockY: number): void {
    this.originX = blockX;
    this.originY = blockY;
    for (const [id, block] of this.blocks) if (typeof block === "object") this.place(block, id);
  }

  /** Fetches what is near the player's landblock and drops what is far. */
  update(block: number): void {
    if (block !== this.center) {
      this.center = block;
      this.drop(block);
      this.chooseAll();
    }
    for (let ring = 0; ring <= drawRadius && this.asked < fetchesAtOnce && performance.now() >= this.retryAt; ring++)
      this.askRing(block, ring);
  }

  /** Moves the parts that animations move to where they are at a moment, seconds of the server's clock. */
  moveParts(time: number): void {
    for (const [id, block] of this.blocks) {
      if (typeof block !== "object") continue;
      for (const { shape, drawn } of block.moving) this.moving.place(id, shape.object, shape.part, time, drawn);
    }
  }

  /** The parts drawn that animations move. */
  get movingDrawn(): MovingDrawn[] {
    const all: MovingDrawn[] = [];
    for (const [id, block] of this.blocks) {
      if (typeof block !== "object") continue;
      for (const { shape, drawn } of block.moving) {
        if (!drawn.visible) continue;
        const { x, y, z, w } = drawn.quaternion;
        all.push({ block: id, object: shape.object, part: shape.part, position: drawn.position.toArray(), rotation: [x, y, z, w] });
      }
    }
    return all;
  }

  /** Boxes around the buildings of a landblock and its neighbours, relative to the origin. */
  *shellsAround(block: number): Iterable<Box> {
    for (let dx = -1; dx <= 1; dx++) {
      for (let dy = -1; dy <= 1; dy++) {
        const near = this.blocks.get((((block >> 8) + dx) << 8) | ((block & 0xff) + dy));
        if (typeof near === "object") for (const shell of near.shells) yield shell.world;
      }
    }
  }

  /** The top of a room, metres; null when the room has not come. */
  topOf(cell: number): number | null {
    const block = this.blocks.get(cell >>> 16);
    return typeof block === "object" ? (block.rooms.get(cell)?.low.max.z ?? null) : null;
  }

  /** Boxes from above around the buildings near a landblock, or around its rooms when only they are seen; relative to the origin. */
  *plan(block: number, enclosed: boolean): Iterable<Box> {
    yield* enclosed ? this.roomsOf(block) : this.shellsAround(block);
  }

  /** Boxes around the rooms of a landblock, relative to the origin. */
  *roomsOf(block: number): Iterable<Box> {
    const here = this.blocks.get(block);
    if (typeof here === "object") for (const { world } of here.rooms.values()) yield world;
  }

  private *loaded(): Iterable<Block> {
    for (const block of this.blocks.values()) if (typeof block === "object") yield block;
  }

  private chooseAll(): void {
    for (const [id, block] of this.blocks) if (typeof block === "object") this.choose(id, block);
  }

  private choose(id: number, block: Block): void {
    const leafy = distance(id, this.center) <= leafyRadius;
    block.rocks.visible = !this.plain;
    block.plants.near.visible = !this.plain && leafy;
    block.plants.far.visible = !this.plain && !leafy;
    block.plants.plain.visible = this.plain;
  }

  private askRing(block: number, ring: number): void {
    for (let dx = -ring; dx <= ring; dx++) {
      for (let dy = -ring; dy <= ring; dy++) {
        if (Math.max(Math.abs(dx), Math.abs(dy)) !== ring || this.asked >= fetchesAtOnce) continue;
        const x = (block >> 8) + dx;
        const y = (block & 0xff) + dy;
        if (x >= 0 && y >= 0 && x < 255 && y < 255 && !this.blocks.has((x << 8) | y)) void this.fetch((x << 8) | y);
      }
    }
  }

  private async fetch(id: number): Promise<void> {
    this.asked++;
    this.blocks.set(id, "asked");
    try {
      const answer = await fetch(`/shapes/${id.toString(16).padStart(4, "0")}`);
      const shapes = answer.status === 200 ? decodeShapes(await answer.arrayBuffer()) : null;
      this.blocks.set(id, "none");
      if (shapes) this.add(id, shapes);
    } catch {
      // The server is away: ask again, but not with every frame.
      this.blocks.delete(id);
      this.retryAt = performance.now() + 1000;
    } finally {
      this.asked--;
    }
  }

  private add(id: number, shapes: Shapes): void {
    const plants = { near: new THREE.Group(), far: new THREE.Group(), plain: new THREE.Group() };
    const block: Block = { group: new THREE.Group(), rocks: new THREE.Group(), plants, shells: [], moving: [], rooms: new Map() };
    const solid = (numbers: Float32Array, to: THREE.Group): void => {
      if (numbers.length > 0) to.add(...this.solids.things(numbers));
    };
    solid(shapes.objects, block.group);
    solid(shapes.rocks, plants.plain);
    this.plants.addTo(plants, shapes.plants);
    if (shapes.rocks.length > 0) block.rocks.add(this.solids.rocks(shapes.rocks));
    for (const shell of shapes.shells) {
      if (shell.triangles.length === 0) continue;
      block.shells.push({ low: boxOf(shell), world: emptyBox() });
      block.group.add(...this.solids.shell(shell.triangles));
    }
    const rooms = shapes.rooms.filter(({ triangles }) => triangles.length > 0).map((shape) => ({ shape, low: boxOf(shape) }));
    for (const { shape, low } of rooms) block.rooms.set(shape.id, { low, world: emptyBox() });
    if (rooms.length > 0) {
      const floors = rooms.map(({ shape, low }) => ({ shape, floor: low.min.z }));
      block.group.add(...this.solids.rooms(floors, shapes.shells.length === 0));
    }
    for (const shape of shapes.moving) {
      const drawn = new THREE.Group();
      // Until it is known where it is.
      drawn.visible = false;
      drawn.add(...this.solids.things(shape.triangles));
      block.moving.push({ shape, drawn });
      block.group.add(drawn);
    }
    block.group.add(block.rocks, plants.near, plants.far, plants.plain);
    this.choose(id, block);
    this.place(block, id);
    this.blocks.set(id, block);
    this.group.add(block.group);
  }

  private place(block: Block, id: number): void {
    block.group.position.set(((id >> 8) - this.originX) * blockSide, ((id & 0xff) - this.originY) * blockSide, 0);
    for (const { low, world } of [...block.shells, ...block.rooms.values()]) {
      world.min.addVectors(low.min, block.group.position);
      world.max.addVectors(low.max, block.group.position);
    }
  }

  private drop(center: number): void {
    for (const [id, block] of this.blocks) {
      if (distance(id, center) <= keepRadius || block === "asked") continue;
      this.blocks.delete(id);
      if (block === "none") continue;
      this.group.remove(block.group);
      block.group.traverse((one) => {
        if (one instanceof THREE.InstancedMesh) one.dispose();
        else if (one instanceof THREE.Mesh || one instanceof THREE.LineSegments) (one.geometry as THREE.BufferGeometry).dispose();
      });
    }
  }
}

/** How many landblocks apart two are, by the longer way. */
function distance(a: number, b: number): number {
  return Math.max(Math.abs((a >> 8) - (b >> 8)), Math.abs((a & 0xff) - (b & 0xff)));
}

function emptyBox(): Box {
  return { min: new THREE.Vector3(), max: new THREE.Vector3() };
}

function boxOf(shape: NamedShape): THREE.Box3 {
  return new THREE.Box3().setFromArray(shape.triangles);
}
